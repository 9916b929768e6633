#include "seamount/io/geopackage.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <atomic>
#include <ctime>
#include <future>

#include "seamount/io/test_files.h"
#include "seamount/io/vector.h"

namespace seamount::io {
namespace {

using ::testing::HasSubstr;

/// A GeoPackage with one island, to which SQL is added.
std::string geopackage(const TestFolder& folder, const std::string& sql) {
  const std::string path = folder("coast.gpkg");
  Drawing drawing;
  drawing.areas.push_back({"isle", {{{{0, 0}, {100, 0}, {100, 80}}, {}}}, {}});
  write_drawing(drawing, path);
  sqlite3* database = nullptr;
  EXPECT_EQ(sqlite3_open(path.c_str(), &database), SQLITE_OK);
  char* problem = nullptr;
  EXPECT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, &problem), SQLITE_OK) << (problem ? problem : "");
  sqlite3_close(database);
  return path;
}

/// Registers a view as the only layer.
std::string with_view(const std::string& select) {
  return "CREATE VIEW shown AS " + select +
         "; UPDATE gpkg_geometry_columns SET table_name = 'shown';"
         "UPDATE gpkg_contents SET table_name = 'shown', identifier = 'shown';";
}

std::string refusal(const std::string& sql) {
  const TestFolder folder;
  const std::string path = geopackage(folder, sql);
  return error_of([&] { (void)read_drawing(path); });
}

TEST(GeoPackage, OrdinaryOnesAreRead) {
  EXPECT_EQ(refusal(""), "");
  EXPECT_EQ(refusal("CREATE TRIGGER log AFTER INSERT ON areas BEGIN UPDATE areas SET name = 'x'; END;"
                    "CREATE TABLE layer_styles (id INTEGER PRIMARY KEY, styleQML TEXT);"
                    "CREATE VIEW of_a_table_that_is_gone AS SELECT * FROM gone;"),
            "");
  EXPECT_EQ(refusal(with_view("SELECT fid, geom, upper(name) AS name FROM areas WHERE name LIKE 'i%'")), "");
}

TEST(GeoPackage, AVirtualTableThatReadsOtherFilesIsRefusedAndTheOtherFileIsNotOpened) {
  const TestFolder folder;
  write_text(folder("secret.txt"), "a:b\n");
  const std::string row =
      "INSERT INTO sqlite_master VALUES ('table', 'vt', 'vt', 0, "
      "'CREATE VIRTUAL TABLE vt USING VirtualText(''" +
      folder("secret.txt") + "'', UTF8)');";
  const std::string path =
      geopackage(folder, with_view("SELECT fid, geom, (SELECT group_concat(COL001) FROM vt) AS name FROM areas") +
                             "PRAGMA writable_schema = ON;" + row);
  EXPECT_EQ(error_of([&] { (void)read_drawing(path); }),
            path +
                ": its virtual table 'vt' of the kind 'virtualtext' cannot be trusted: such a table may read other "
                "files");
}

TEST(GeoPackage, AnEndlessViewIsRefused) {
  EXPECT_THAT(refusal(with_view("WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) "
                                "SELECT a.fid, a.geom, a.name FROM n, areas a")),
              HasSubstr("its layer 'shown' cannot be trusted: "));
  EXPECT_THAT(refusal("ALTER TABLE gpkg_contents RENAME TO kept; CREATE VIEW gpkg_contents AS "
                      "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT kept.* FROM n, kept"),
              HasSubstr("its layer 'gpkg_contents' cannot be trusted: "));
}

TEST(GeoPackage, AViewMayUseOnlyWhatSqliteItselfKnows) {
  EXPECT_THAT(refusal(with_view("SELECT fid, geom, load_extension('x') AS name FROM areas")),
              HasSubstr("cannot be trusted: "));
  EXPECT_THAT(refusal(with_view("SELECT fid, geom, BlobFromFile('/etc/passwd') AS name FROM areas")),
              HasSubstr("cannot be trusted: no such function: BlobFromFile"));
}

/// Rows that a product of many tables looks through in vain.
TEST(GeoPackage, ALongQueryCanBeCancelled) {
  const TestFolder folder;
  const std::string path =
      geopackage(folder,
                 "CREATE TABLE many AS WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n LIMIT "
                 "2000) SELECT i FROM n;" +
                     with_view("SELECT fid, geom, name FROM areas UNION ALL SELECT p.i, NULL, 'x' FROM many "
                               "p, many q, many r, many s WHERE p.i + q.i + r.i + s.i < 0"));
  std::atomic<bool> cancelled{false};
  RunContext run;
  run.cancelled = &cancelled;
  const std::future<void> user = std::async(std::launch::async, [&] {
    const timespec pause{0, 200'000'000};
    ::nanosleep(&pause, nullptr);
    cancelled = true;
  });
  EXPECT_THROW((void)read_drawing(path, {}, run), Cancelled);
}

}  // namespace
}  // namespace seamount::io
