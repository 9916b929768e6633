#include "seamount/server/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "seamount/io/atomic_file.h"
#include "seamount/recipe/recipe.h"
#include "seamount/server/edit_json.h"

namespace seamount::server {
namespace {

constexpr size_t kRecentEvents = 2000;
constexpr int kLongestJournal = 500;  // lines, before a snapshot takes their place

/// Revisions of different sessions never meet: a window that was left over from one before is out of date.
uint64_t revision_to_begin_with() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return 1000 * static_cast<uint64_t>(std::chrono::duration_cast<std::chrono::milliseconds>(now).count());
}

}  // namespace

std::unique_ptr<Session> Session::open_file(const std::string& file, const SessionOptions& options, EventHub& hub) {
  const std::string folder = std::filesystem::path(file).parent_path().string();
  const std::string text = recipe::read_recipe_text(file);
  auto journal = std::make_unique<Journal>(options.state_folder, file);
  auto remembered = journal->read(folder, *options.registry);
  std::string notice;
  if (remembered && remembered->saved_text != text && remembered->document.text() != text) {
    notice = fmt::format("the file was changed by another program; edits of the last session are kept in {}",
                         journal->put_aside());
    remembered.reset();
  }
  recipe::Document document =
      remembered ? std::move(remembered->document) : recipe::Document(text, file, folder, *options.registry);
  std::unique_ptr<Session> session(new Session(std::move(document), file, text, std::move(journal), options, hub));
  session->notice_ = notice;
  return session;
}

std::unique_ptr<Session> Session::resume_unsaved(const SessionOptions& options, EventHub& hub) {
  auto journal = Journal::newest_unsaved(options.state_folder);
  auto remembered = journal ? journal->read(options.folder, *options.registry) : std::nullopt;
  if (!remembered) return nullptr;
  return std::unique_ptr<Session>(
      new Session(std::move(remembered->document), "", remembered->saved_text, std::move(journal), options, hub));
}

std::unique_ptr<Session> Session::open_text(const std::string& text, const SessionOptions& options, EventHub& hub) {
  recipe::Document document(text, "unsaved", options.folder, *options.registry);
  auto journal = Journal::of_unsaved(options.state_folder);
  return std::unique_ptr<Session>(new Session(std::move(document), "", text, std::move(journal), options, hub));
}

Session::Session(recipe::Document document, std::string file, std::string saved_text, std::unique_ptr<Journal> journal,
                 const SessionOptions& options, EventHub& hub)
    : options_(options),
      hub_(hub),
      first_revision_(revision_to_begin_with() - document.revision()),
      file_(std::move(file)),
      saved_text_(std::move(saved_text)),
      saved_json_(OrderedJson::parse(saved_text_)),
      journal_(std::move(journal)) {
  journal_->begin(document, saved_text_);
  recipe::EngineOptions engine{.threads = options.threads, .cache_folder = options.cache_folder};
  engine.changed = [this] { look_for_results(); };
  engine_ = std::make_unique<recipe::Engine>(std::move(document), std::move(engine));
  publisher_ = std::make_unique<Background>(1, [this] { publish_results(); });
}

Session::~Session() {
  engine_->cancel();
  retire();
  engine_.reset();
}

void Session::retire() {
  {
    const std::lock_guard lock(results_);
    stopping_ = true;
    wake_.notify_all();
  }
  publisher_.reset();
}

OrderedJson Session::document_json() const {
  const std::lock_guard lock(editing_);
  OrderedJson json;
  engine_->look([&](const recipe::Document& document) {
    OrderedJson history = OrderedJson::array();
    for (const auto& record : document.history())
      history.push_back({{"label", record.label}, {"window", record.author}});
    json = {{"revision", first_revision_ + document.revision()},
            {"file", file_.empty() ? "" : std::filesystem::path(file_).lexically_relative(options_.folder).string()},
            {"folder", options_.folder},
            {"saved", document.json() == saved_json_},
            {"recipe", document.json()},
            {"text", document.text()},
            {"history", history},
            {"done", document.done()},
            {"missing", write_diagnostics(document.missing())},
            {"notice", notice_}};
  });
  return json;
}

void Session::check_base(const Asker& asker) const {
  const uint64_t now = revision();
  if (asker.base == now) return;
  std::vector<std::string> missed;
  const bool known =
      !recent_.empty() && recent_.front().first <= asker.base + 1 && asker.base < now && asker.base >= first_revision_;
  if (known) {
    for (const auto& [revision, event] : recent_) {
      if (revision > asker.base) missed.push_back(event);
    }
  }
  throw OutOfDate(std::move(missed));
}

std::string Session::edit(const Asker& asker, const std::vector<recipe::Edit>& edits, const std::string& gesture,
                          const std::string& label, bool ends) {
  const std::lock_guard lock(editing_);
  check_base(asker);
  const std::vector<recipe::Change> changes = engine_->edit(edits, gesture, label, asker.window, ends);
  std::string event = announce(asker, changes, label);
  if (!changes.empty()) remember([&](Journal& journal) { journal.edit(edits, gesture, label, asker.window); });
  return event;
}

std::string Session::replace_text(const Asker& asker, const std::string& text) {
  const recipe::Document next(text, "the text", document_folder(), *options_.registry);
  std::vector<recipe::Edit> edits;
  engine_->look([&](const recipe::Document& document) { edits = differences(document.json(), next.json()); });
  return edit(asker, edits, "", "recipe text edited");
}

std::string Session::document_folder() const {
  std::string folder;
  engine_->look([&](const recipe::Document& document) { folder = document.folder(); });
  return folder;
}

std::string Session::undo(const Asker& asker) { return travel(asker, true); }
std::string Session::redo(const Asker& asker) { return travel(asker, false); }

std::string Session::travel(const Asker& asker, bool back) {
  const std::lock_guard lock(editing_);
  check_base(asker);
  std::vector<recipe::Change> changes;
  std::string label;
  if (!(back ? engine_->undo() : engine_->redo())) return "";
  engine_->look([&](const recipe::Document& document) {
    const auto& record = document.history()[back ? document.done() : document.done() - 1];
    changes = back ? inverse(record.changes) : record.changes;
    label = record.label;
  });
  std::string event = announce(asker, changes, label);
  remember([&](Journal& journal) { back ? journal.undo() : journal.redo(); });
  return event;
}

void Session::remember(const std::function<void(Journal&)>& write) {
  write(*journal_);
  if (journal_->length() < kLongestJournal) return;
  engine_->look([&](const recipe::Document& document) { journal_->begin(document, saved_text_); });
}

std::string Session::announce(const Asker& asker, const std::vector<recipe::Change>& changes,
                              const std::string& label) {
  OrderedJson event;
  uint64_t revision = 0;
  engine_->look([&](const recipe::Document& document) {
    revision = first_revision_ + document.revision();
    event = {{"event", "document"},
             {"revision", revision},
             {"window", asker.window},
             {"changes", write_changes(changes)},
             {"label", label},
             {"done", document.done()},
             {"undone", document.history().size() - document.done()},
             {"saved", document.json() == saved_json_},
             {"missing", write_diagnostics(document.missing())}};
  });
  std::string text = one_line(event);
  if (changes.empty()) return text;
  recent_.emplace_back(revision, text);
  if (recent_.size() > kRecentEvents) recent_.pop_front();
  hub_.publish(text);
  pass_wishes_on();
  return text;
}

std::vector<recipe::Diagnostic> Session::check(const std::string& text) const {
  try {
    const recipe::Document document(text, "the text", document_folder(), *options_.registry);
    return document.missing();
  } catch (const recipe::RecipeError& error) {
    return error.diagnostics();
  }
}

std::string Session::save(const Asker& asker, const std::string& file) {
  const std::lock_guard lock(editing_);
  engine_->look([&](const recipe::Document& document) {
    const std::string text = document.text();
    io::write_text(file, text);
    saved_json_ = document.json();
    saved_text_ = text;
    if (file == file_) {
      journal_->saved(text);
      return;
    }
    auto journal = std::make_unique<Journal>(options_.state_folder, file);
    journal->begin(document, text);
    journal_->remove();
    journal_ = std::move(journal);
    file_ = file;
  });
  std::string event = announce(asker, {}, "saved");
  hub_.publish(event);
  return event;
}

std::unique_ptr<Session> Session::save_elsewhere(const std::string& file) {
  const std::lock_guard lock(editing_);
  recipe::Document document = engine_->document().moved_to(file);
  const std::string text = document.text();
  io::write_text(file, text);
  auto journal = std::make_unique<Journal>(options_.state_folder, file);
  std::unique_ptr<Session> there(new Session(std::move(document), file, text, std::move(journal), options_, hub_));
  journal_->remove();
  return there;
}

recipe::Document Session::with_outputs(const OrderedJson& outputs) const {
  recipe::Document document = engine_->document();
  document.apply(recipe::SetValue{"/outputs", outputs});
  return document;
}

}  // namespace seamount::server
