#include "seamount/io/file_digest.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <atomic>
#include <cstdlib>

#include "seamount/io/gdal_call.h"
#include "seamount/io/raster.h"
#include "seamount/io/test_files.h"

namespace seamount::io {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::HasSubstr;

TEST(Companions, EveryFileThatADriverOpensInAnyLetterCase) {
  const TestFolder folder;
  const std::vector<std::pair<std::string, std::vector<std::string>>> families = {
      {"a.gpkg", {"a.gpkg-wal", "a.gpkg-journal", "a.gpkg.aux.xml"}},
      {"b.SHP", {"b.shx", "B.DBF", "b.prj", "b.CPG", "b.qix", "b.sbn", "b.sbx"}},
      {"c.tif", {"c.tfw", "c.TFW", "c.tifw", "c.wld", "c.prj", "c.tif.ovr", "c.tif.msk", "c.tif.aux.xml", "c.aux.xml"}},
      {"d.png", {"d.pgw", "d.pngw", "d.png.json", "d.PNG.JSON"}},
      {"e.jpg", {"e.jgw", "e.jpgw"}},
      {"f.asc", {"f.prj", "f.PRJ"}}};
  for (const auto& [file, companions] : families) {
    write_text(folder(file), "x");
    const Digest alone = file_digest(folder(file));
    for (const std::string& companion : companions) {
      write_text(folder(companion), "x");
      EXPECT_THAT(companions_of(folder(file)), Contains(folder(companion)));
      const Digest with = file_digest(folder(file));
      EXPECT_NE(with, alone) << companion;
      write_text(folder(companion), "y");
      EXPECT_NE(file_digest(folder(file)), with) << companion;
      fs::remove(folder(companion));
      EXPECT_EQ(file_digest(folder(file)), alone) << companion;
    }
  }
}

TEST(Companions, StrangersDoNotBelong) {
  const TestFolder folder;
  write_text(folder("a.tif"), "x");
  for (const char* name : {"a.png", "a.json", "a.tif.bak", "b.tfw", "aa.tif", "a.gpkg-wal", "a", "a.tif~"})
    write_text(folder(name), "x");
  write_text(folder("a.prj"), "");
  fs::create_directories(folder("a.tif.ovr"));
  EXPECT_TRUE(companions_of(folder("a.tif")).empty());
}

TEST(Companions, ThoseBesideTheFileThatALinkLeadsTo) {
  const TestFolder folder;
  write_text(folder("real/a.gpkg"), "x");
  write_text(folder("real/a.gpkg-wal"), "x");
  fs::create_symlink("real/a.gpkg", folder("b.gpkg"));
  EXPECT_THAT(companions_of(folder("b.gpkg")), Contains(HasSubstr("real/a.gpkg-wal")));
}

/// GDAL's own list of a raster's files.
TEST(Companions, WhatGdalSaysThatItReads) {
  const TestFolder folder;
  write_heights(test_terrain(GridFrame::centred(8, 6, 10)), folder("a.tif"), {});
  write_heights(test_terrain(GridFrame::centred(8, 6, 10)), folder("b.asc"), {});
  for (const char* name : {"a.tfw", "a.tif.aux.xml", "a.tif.ovr", "a.tif.msk", "b.prj", "b.asc.aux.xml"})
    write_text(folder(name), "10\n0\n0\n-10\n0\n0\n");
  for (const char* name : {"a.tif", "b.asc"}) {
    const GdalCall call(name);
    const DatasetPtr dataset(
        static_cast<GDALDataset*>(GDALOpenEx(folder(name).c_str(), GDAL_OF_RASTER, nullptr, nullptr, nullptr)));
    ASSERT_TRUE(dataset) << name;
    const CPLStringList files(dataset->GetFileList());
    ASSERT_GT(files.size(), 0);
    for (int i = 0; i < files.size(); ++i) {
      if (files[i] == folder(name)) continue;
      EXPECT_THAT(companions_of(folder(name)), Contains(std::string(files[i])));
    }
  }
}

TEST(FileSnapshot, SeesEveryWayToChangeAFile) {
  const TestFolder folder;
  const std::string path = folder("a.tif");
  const auto changed = [&](const auto& change) {
    write_text(path, "one");
    const FileSnapshot before(path);
    EXPECT_TRUE(before.still_valid());
    change();
    return !before.still_valid();
  };
  EXPECT_TRUE(changed([&] { write_text(path, "two"); }));
  EXPECT_TRUE(changed([&] { fs::resize_file(path, 2); }));
  EXPECT_TRUE(changed([&] { fs::remove(path); }));
  EXPECT_TRUE(changed([&] { write_text(folder("a.tfw"), "1"); }));
  EXPECT_TRUE(changed([&] { fs::remove(folder("a.tfw")); }));
  EXPECT_TRUE(changed([&] {  // in place, same size, and its old time put back
    struct stat old = {};
    ::stat(path.c_str(), &old);
    std::FILE* file = std::fopen(path.c_str(), "r+b");
    std::fputs("two", file);
    std::fclose(file);
    const timespec times[2] = {old.st_atim, old.st_mtim};
    ::utimensat(AT_FDCWD, path.c_str(), times, 0);
  }));
}

TEST(FileSnapshot, ReadingChangesNothing) {
  const TestFolder folder;
  write_heights(test_terrain(GridFrame::centred(8, 6, 10)), folder("a.tif"), {});
  const FileSnapshot before(folder("a.tif"));
  (void)read_heights(folder("a.tif"));
  EXPECT_TRUE(before.still_valid());
}

TEST(FileSnapshot, RegularFilesOnly) {
  const TestFolder folder;
  ::mkfifo(folder("pipe.tif").c_str(), 0600);
  fs::create_symlink(folder("loop.tif"), folder("loop.tif"));
  EXPECT_EQ(error_of([] { FileSnapshot("/dev/zero"); }), "/dev/zero: is not a regular file");
  EXPECT_EQ(error_of([&] { FileSnapshot(folder("pipe.tif")); }), folder("pipe.tif") + ": is not a regular file");
  EXPECT_EQ(error_of([&] { FileSnapshot(folder("loop.tif")); }),
            folder("loop.tif") + ": cannot be read: Too many levels of symbolic links");
  EXPECT_EQ(error_of([&] { FileSnapshot(folder("none.tif")); }), folder("none.tif") + ": no such file");
}

TEST(FileSnapshot, CanBeCancelled) {
  const TestFolder folder;
  write_text(folder("a"), "x");
  const std::atomic<bool> cancelled{true};
  RunContext run;
  run.cancelled = &cancelled;
  EXPECT_THROW(FileSnapshot(folder("a"), run), Cancelled);
}

}  // namespace
}  // namespace seamount::io
