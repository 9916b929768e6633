#include "seamount/io/geopackage.h"

#include <gdal_priv.h>
#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "seamount/base/error.h"

namespace seamount::io {
namespace {

struct Closer {
  void operator()(sqlite3* database) const { sqlite3_close(database); }
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using Database = std::unique_ptr<sqlite3, Closer>;
using Statement = std::unique_ptr<sqlite3_stmt, Closer>;

Database open_database(const char* name) {
  sqlite3* opened = nullptr;
  sqlite3_open_v2(name, &opened, SQLITE_OPEN_READONLY | SQLITE_OPEN_NOMUTEX | SQLITE_OPEN_URI, nullptr);
  Database database(opened);
  if (!database) throw std::bad_alloc();
  int off = 0;
  constexpr int kPatienceMs = 2000;
  sqlite3_busy_timeout(opened, kPatienceMs);
  sqlite3_db_config(opened, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, &off);
  sqlite3_db_config(opened, SQLITE_DBCONFIG_DEFENSIVE, 1, &off);
  return database;
}

/// SQLite's name for a file. As immutable it can be read where its folder is read-only, though it has a write-ahead
/// log.
std::string uri_of(const std::string& path, bool immutable) {
  std::string uri = "file:";
  for (const char c : std::filesystem::absolute(path).string())
    uri += c == '%' ? "%25" : c == '?' ? "%3f" : c == '#' ? "%23" : std::string(1, c);
  return uri + (immutable ? "?immutable=1" : "");
}

/// Null if SQLite does not accept the text.
Statement prepare(sqlite3* database, const std::string& sql) {
  sqlite3_stmt* prepared = nullptr;
  sqlite3_prepare_v2(database, sql.c_str(), static_cast<int>(sql.size()), &prepared, nullptr);
  return Statement(prepared);
}

std::string text_of(const Statement& row, int column) {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(row.get(), column));
  return text == nullptr ? std::string() : text;
}

std::string quoted(const std::string& name) {
  std::string text = "\"";
  for (const char c : name) text += c == '"' ? "\"\"" : std::string(1, c);
  return text + "\"";
}

/// Finds virtual tables in the statements of a schema by letting SQLite itself read them.
class VirtualTables {
 public:
  VirtualTables() : scratch_(open_database(":memory:")) {
    sqlite3_set_authorizer(scratch_.get(), &VirtualTables::note, &module_);
  }

  /// The module of the virtual table that a statement makes, in lower case; empty: it makes none.
  std::string module_of(const std::string& sql) {
    module_.clear();
    prepare(scratch_.get(), sql);
    std::transform(module_.begin(), module_.end(), module_.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return module_;
  }

 private:
  static int note(void* found, int action, const char*, const char* name, const char*, const char*) {
    if (action != SQLITE_CREATE_VTABLE) return SQLITE_OK;
    *static_cast<std::string*>(found) = name == nullptr ? "?" : name;
    return SQLITE_DENY;
  }

  std::string module_;
  Database scratch_;
};

/// What a layer's query may do: read. Everything else, recursion too, is denied.
int may_read(void*, int action, const char*, const char* function, const char*, const char*) {
  if (action == SQLITE_SELECT || action == SQLITE_READ) return SQLITE_OK;
  if (action != SQLITE_FUNCTION || function == nullptr) return SQLITE_DENY;
  constexpr std::array<std::string_view, 2> kDenied = {"load_extension", "fts3_tokenizer"};
  return std::find(kDenied.begin(), kDenied.end(), function) == kDenied.end() ? SQLITE_OK : SQLITE_DENY;
}

/// Interrupts a query when the user asks for it, or when it has done too much.
class Budget {
 public:
  Budget(sqlite3* database, const RunContext& run) : database_(database), run_(run) {
    sqlite3_progress_handler(database_, kSteps, &Budget::spend, this);
  }
  ~Budget() { sqlite3_progress_handler(database_, 0, nullptr, nullptr); }
  Budget(const Budget&) = delete;
  Budget& operator=(const Budget&) = delete;

 private:
  static int spend(void* self) {
    auto& budget = *static_cast<Budget*>(self);
    const bool cancelled = budget.run_.cancelled != nullptr && budget.run_.cancelled->load(std::memory_order_relaxed);
    return cancelled || --budget.left_ <= 0 ? 1 : 0;
  }

  static constexpr int kSteps = 10'000;  // of SQLite's machine, between two calls
  sqlite3* database_;
  const RunContext& run_;
  int left_ = 5'000;  // a few seconds in all
};

class Check {
 public:
  Check(const std::string& path, const RunContext& run)
      : path_(path), run_(run), database_(open_database(uri_of(path, false).c_str())) {}

  void all() {
    const int problem = first_problem();
    if (problem == SQLITE_NOTADB) return;
    if (problem == SQLITE_CANTOPEN) database_ = open_database(uri_of(path_, true).c_str());
    check_virtual_tables();
    sqlite3_set_authorizer(database_.get(), may_read, nullptr);
    check_layers("SELECT name FROM sqlite_master WHERE name LIKE 'gpkg%' AND name = tbl_name");
    check_layers(
        "SELECT m.name FROM sqlite_master m, gpkg_contents c "
        "WHERE lower(m.name) = lower(c.table_name) AND m.name = m.tbl_name");
  }

 private:
  int first_problem() {
    return prepare(database_.get(), "SELECT 1 FROM sqlite_master") ? SQLITE_OK : sqlite3_errcode(database_.get());
  }

  /// The rows of a query of ours. Throws IoError if there is an error in them.
  std::vector<std::vector<std::string>> rows_of(const std::string& sql, int columns) {
    const Statement statement = prepare(database_.get(), sql);
    const Budget budget(database_.get(), run_);
    std::vector<std::vector<std::string>> rows;
    int result = statement ? sqlite3_step(statement.get()) : sqlite3_errcode(database_.get());
    for (; result == SQLITE_ROW; result = sqlite3_step(statement.get())) {
      rows.emplace_back();
      for (int i = 0; i < columns; ++i) rows.back().push_back(text_of(statement, i));
    }
    run_.check_cancelled();
    if (result != SQLITE_DONE) throw IoError(path_, std::string("cannot be read: ") + sqlite3_errmsg(database_.get()));
    return rows;
  }

  void check_virtual_tables() {
    VirtualTables tables;
    for (const auto& row : rows_of("SELECT name, sql FROM sqlite_master", 2)) {
      constexpr std::array<std::string_view, 6> kTrusted = {"", "rtree", "rtree_i32", "fts3", "fts4", "fts5"};
      const std::string module = tables.module_of(row[1]);
      if (std::find(kTrusted.begin(), kTrusted.end(), module) == kTrusted.end())
        throw IoError(path_, "its virtual table '" + row[0] + "' of the kind '" + module +
                                 "' cannot be trusted: such a table may read other files");
    }
  }

  void check_layers(const std::string& names) {
    for (const auto& row : rows_of(names, 1)) check_layer(row[0]);
  }

  void check_layer(const std::string& name) {
    const Statement rows = prepare(database_.get(), "SELECT * FROM " + quoted(name));
    if (!rows) {
      const std::string why = sqlite3_errmsg(database_.get());
      // A view of a table that is gone is no danger, only of no use.
      if (why.starts_with("no such table") || why.starts_with("no such column")) return;
      throw IoError(path_, "its layer '" + name + "' cannot be trusted: " + why);
    }
    const Budget budget(database_.get(), run_);
    if (sqlite3_step(rows.get()) != SQLITE_INTERRUPT) return;
    run_.check_cancelled();
    throw IoError(path_, "its layer '" + name + "' has no first row after a long time");
  }

  const std::string& path_;
  const RunContext& run_;
  Database database_;
};

}  // namespace

void check_geopackage(const std::string& path, const RunContext& run) { Check(path, run).all(); }

void watch_queries(GDALDataset& dataset, const RunContext& run) {
  constexpr int kSteps = 100'000;
  auto* database = static_cast<sqlite3*>(dataset.GetInternalHandle("SQLITE_HANDLE"));
  if (database == nullptr || run.cancelled == nullptr) return;
  const auto stop = [](void* flag) { return static_cast<const std::atomic<bool>*>(flag)->load() ? 1 : 0; };
  sqlite3_progress_handler(database, kSteps, stop, const_cast<std::atomic<bool>*>(run.cancelled));
}

}  // namespace seamount::io
