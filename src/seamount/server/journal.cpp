#include "seamount/server/journal.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <span>

#include "seamount/base/hash.h"
#include "seamount/io/atomic_file.h"
#include "seamount/server/edit_json.h"

namespace seamount::server {
namespace {

namespace fs = std::filesystem;

constexpr size_t kHashDigits = 32;
constexpr const char* kEnding = ".journal";
constexpr const char* kUnsaved = "unsaved-";
constexpr size_t kUnsavedKept = 20;  // of documents that were begun and left

std::string hash_of(std::string_view text) { return hash_bytes(std::as_bytes(std::span(text))).hex(); }

std::string line_of(const OrderedJson& record) {
  const std::string text = one_line(record);
  return hash_of(text) + " " + text + "\n";
}

/// The records of a journal, up to the first line that is not as it was written.
std::vector<OrderedJson> records_of(const std::string& text) {
  std::vector<OrderedJson> records;
  for (size_t begin = 0; begin < text.size();) {
    const size_t end = text.find('\n', begin);
    if (end == std::string::npos || end < begin + kHashDigits + 1) break;
    const std::string_view content =
        std::string_view(text).substr(begin + kHashDigits + 1, end - begin - kHashDigits - 1);
    if (hash_of(content) != text.substr(begin, kHashDigits)) break;
    records.push_back(OrderedJson::parse(content));
    begin = end + 1;
  }
  return records;
}

OrderedJson history_json(const recipe::Document& document) {
  OrderedJson list = OrderedJson::array();
  for (const auto& record : document.history())
    list.push_back({{"gesture", record.gesture},
                    {"label", record.label},
                    {"author", record.author},
                    {"changes", write_changes(record.changes)}});
  return list;
}

std::vector<recipe::Document::Record> read_history(const OrderedJson& json) {
  std::vector<recipe::Document::Record> history;
  for (const OrderedJson& item : json) {
    recipe::Document::Record record{item.at("gesture"), {}, item.at("label"), item.at("author")};
    for (const OrderedJson& change : item.at("changes")) {
      const auto value = [&](const char* name) {
        return change.contains(name) ? std::optional(change[name]) : std::nullopt;
      };
      record.changes.push_back({change.at("pointer"), change.at("index"), value("before"), value("after")});
    }
    history.push_back(std::move(record));
  }
  return history;
}

/// Does again what a record says.
void replay(Remembered& remembered, const OrderedJson& record) {
  if (record.contains("edits")) {
    remembered.document.apply(read_edits(record["edits"]), record.at("gesture"), record.at("label"),
                              record.at("author"));
  } else if (record.contains("undo")) {
    remembered.document.undo();
  } else if (record.contains("redo")) {
    remembered.document.redo();
  } else if (record.contains("saved")) {
    remembered.saved_text = record["saved"].get<std::string>();
  }
}

}  // namespace

std::string default_state_folder() {
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return std::string(value != nullptr ? value : "");
  };
  if (const std::string state = variable("XDG_STATE_HOME"); !state.empty()) return state + "/seamount";
  if (const std::string home = variable("HOME"); !home.empty()) return home + "/.local/state/seamount";
  return (fs::temp_directory_path() / "seamount-state").string();
}

Journal::Journal(Named, std::string path, std::string file) : path_(std::move(path)), file_(std::move(file)) {
  std::error_code error;
  fs::create_directories(fs::path(path_).parent_path(), error);
}

Journal::Journal(const std::string& folder, const std::string& file)
    : Journal(Named{}, (fs::path(folder) / (hash_of(file) + kEnding)).string(), file) {
  if (!lock()) throw IoError(file, "is open in another studio");
}

std::unique_ptr<Journal> Journal::of_unsaved(const std::string& folder) {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  for (int64_t i = std::chrono::duration_cast<std::chrono::milliseconds>(now).count();; ++i) {
    const fs::path path = fs::path(folder) / fmt::format("{}{:014}{}", kUnsaved, i, kEnding);
    std::unique_ptr<Journal> journal(new Journal(Named{}, path.string(), ""));
    std::error_code error;
    if (!fs::exists(path, error) && journal->lock()) return journal;
  }
}

std::unique_ptr<Journal> Journal::newest_unsaved(const std::string& folder) {
  std::vector<fs::path> paths;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(kUnsaved) && name.ends_with(kEnding)) paths.push_back(entry.path());
  }
  std::sort(paths.rbegin(), paths.rend());
  for (size_t i = kUnsavedKept; i < paths.size(); ++i) fs::remove(paths[i], error);
  for (const fs::path& path : paths) {
    std::unique_ptr<Journal> journal(new Journal(Named{}, path.string(), ""));
    if (journal->lock()) return journal;
  }
  return nullptr;
}

/// The system lets go of the lock when this process ends, however it does.
bool Journal::lock() {
  lock_ = ::open((path_ + ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  return lock_ >= 0 && ::flock(lock_, LOCK_EX | LOCK_NB) == 0;
}

Journal::~Journal() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (lock_ < 0) return;
  if (::flock(lock_, LOCK_EX | LOCK_NB) == 0) ::unlink((path_ + ".lock").c_str());
  ::close(lock_);
}

std::optional<Remembered> Journal::read(const std::string& document_folder, const recipe::Registry& registry) const {
  std::error_code error;
  if (!fs::is_regular_file(path_, error)) return std::nullopt;
  try {
    const std::vector<uint8_t> bytes = io::read_file(path_);
    const std::vector<OrderedJson> records = records_of({bytes.begin(), bytes.end()});
    if (records.empty()) return std::nullopt;
    const OrderedJson& snapshot = records.front();
    const std::string file = snapshot.at("file");
    Remembered remembered{
        file, snapshot.at("saved"),
        recipe::Document(snapshot.at("text"), file.empty() ? "unsaved" : file, document_folder, registry)};
    remembered.document.take_history(read_history(snapshot.at("history")), snapshot.at("done"));
    for (size_t i = 1; i < records.size(); ++i) replay(remembered, records[i]);
    return remembered;
  } catch (const std::exception&) {  // written by another version, say
    return std::nullopt;
  }
}

void Journal::begin(const recipe::Document& document, const std::string& saved_text) {
  const OrderedJson snapshot = {{"journal", 1},
                                {"file", file_},
                                {"saved", saved_text},
                                {"text", document.text()},
                                {"done", document.done()},
                                {"history", history_json(document)}};
  io::write_text(path_, line_of(snapshot));
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = ::open(path_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  if (descriptor_ < 0) throw WriteError(path_, "cannot be opened again");
  length_ = 0;
}

void Journal::edit(const std::vector<recipe::Edit>& edits, const std::string& gesture, const std::string& label,
                   const std::string& author) {
  OrderedJson list = OrderedJson::array();
  for (const recipe::Edit& edit : edits) list.push_back(write_edit(edit));
  append({{"edits", list}, {"gesture", gesture}, {"label", label}, {"author", author}});
}

void Journal::undo() { append({{"undo", true}}); }
void Journal::redo() { append({{"redo", true}}); }
void Journal::saved(const std::string& text) { append({{"saved", text}}); }

void Journal::append(const OrderedJson& record) {
  const std::string line = line_of(record);
  const off_t end = ::lseek(descriptor_, 0, SEEK_END);
  for (size_t at = 0; at < line.size();) {
    const ssize_t written = ::write(descriptor_, line.data() + at, line.size() - at);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) {  // a full disk: what was begun is taken back, so that later lines are read
      [[maybe_unused]] const int ignored = ::ftruncate(descriptor_, end);
      throw WriteError(path_, "cannot be written: is the disk full?");
    }
    at += static_cast<size_t>(written);
  }
  if (::fdatasync(descriptor_) != 0) throw WriteError(path_, "cannot be brought to the disk");
  ++length_;
}

std::string Journal::put_aside() {
  std::error_code error;
  if (!fs::exists(path_, error)) return "";
  for (int i = 1; i < 1000; ++i) {
    const std::string aside = fmt::format("{}.{}", path_, i);
    if (fs::exists(aside, error)) continue;
    fs::rename(path_, aside, error);
    return error ? "" : aside;
  }
  return "";
}

void Journal::remove() {
  std::error_code error;
  fs::remove(path_, error);
}

}  // namespace seamount::server
