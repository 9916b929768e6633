// The document that the studio has open: edits by its windows, safe in a journal before they are acknowledged, and its
// results as they are computed, told to the windows as events.
//
// One server orders all edits. A window says which revision it knows; where others were faster it is told what it has
// missed, and asks again. Undo and redo are those of the document, whoever edited.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "seamount/base/background.h"
#include "seamount/recipe/engine.h"
#include "seamount/server/edit_json.h"
#include "seamount/server/event_hub.h"
#include "seamount/server/journal.h"

namespace seamount::server {

/// A request rests on a revision that is no longer the newest.
class OutOfDate : public Error {
 public:
  explicit OutOfDate(std::vector<std::string> events)
      : Error("the document was changed by another window"), missed(std::move(events)) {}
  /// The document events since, as JSON; empty if they are no longer known: the whole document has to be asked for.
  std::vector<std::string> missed;
};

struct SessionOptions {
  const recipe::Registry* registry = nullptr;
  std::string state_folder;  ///< of journals
  std::string folder;        ///< of documents; canonical
  int threads = 0;
  std::string cache_folder;
};

/// Who asks, and on which revision it rests.
struct Asker {
  std::string window;
  uint64_t base = 0;
};

class Session {
 public:
  /// Opens a document file (absolute) as its journal left it, else as it is. Throws IoError, RecipeError.
  static std::unique_ptr<Session> open_file(const std::string& file, const SessionOptions& options, EventHub& hub);
  /// The newest document that was never saved, as its journal left it; nothing if there is none.
  static std::unique_ptr<Session> resume_unsaved(const SessionOptions& options, EventHub& hub);
  /// A new document from a recipe's text; earlier unsaved ones keep their journals for a while.
  static std::unique_ptr<Session> open_text(const std::string& text, const SessionOptions& options, EventHub& hub);

  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  uint64_t revision() const { return first_revision_ + engine_->revision(); }

  /// The answer to GET /api/document.
  OrderedJson document_json() const;

  // Each returns its document event, which all windows get, once it is safe. Throws OutOfDate, RecipeError,
  // InvalidArgument; WriteError where the edit is in force but the journal could not be written.
  std::string edit(const Asker& asker, const std::vector<recipe::Edit>& edits, const std::string& gesture,
                   const std::string& label, bool ends = false);
  std::string replace_text(const Asker& asker, const std::string& text);
  /// "" where there is nothing to take back, or to do again.
  std::string undo(const Asker& asker);
  std::string redo(const Asker& asker);

  /// What is wrong with a text that might become the document's.
  std::vector<recipe::Diagnostic> check(const std::string& text) const;

  /// Writes the document to a file (absolute) of its folder, which it has from then on. Throws WriteError.
  std::string save(const Asker& asker, const std::string& file);
  /// The same into another folder: a session on that file with the same history, whose names of files lead from there;
  /// it takes the place of this one, whose document is as it was saved last. Throws WriteError.
  std::unique_ptr<Session> save_elsewhere(const std::string& file);
  /// Where the document's relative names begin.
  std::string document_folder() const;

  /// What a window shows; all windows' wishes are computed.
  void want(const std::string& window, const std::vector<std::string>& sources, recipe::Quality quality);

  /// A result that was announced under this key; nothing if it is gone.
  std::optional<recipe::Value> value(const std::string& key) const;

  /// Tells the windows nothing from now on: another session takes its place.
  void retire();

  void cancel() { engine_->cancel(); }
  void refresh() { engine_->refresh(); }
  /// The document as it is now, with other outputs.
  recipe::Document with_outputs(const OrderedJson& outputs) const;
  recipe::Engine& engine() { return *engine_; }
  const std::string& file() const { return file_; }

 private:
  struct Wish {
    std::vector<std::string> sources;
    recipe::Quality quality = recipe::Quality::full;
  };

  Session(recipe::Document document, std::string file, std::string saved_text, std::unique_ptr<Journal> journal,
          const SessionOptions& options, EventHub& hub);

  void check_base(const Asker& asker) const;
  std::string travel(const Asker& asker, bool back);
  std::string announce(const Asker& asker, const std::vector<recipe::Change>& changes, const std::string& label);
  /// Calls write() for a line of the journal; begins the journal anew where it has become long.
  void remember(const std::function<void(Journal&)>& write);
  void pass_wishes_on();
  std::vector<recipe::Source> wanted_sources() const;
  void let_go(const std::string& key);
  void look_for_results();
  void publish_results();
  void publish_value(const std::string& name, const recipe::Finished& finished);

  const SessionOptions options_;
  EventHub& hub_;
  const uint64_t first_revision_;
  mutable std::mutex editing_;
  std::string file_;
  std::string saved_text_;  // of the file as it was read or saved last
  OrderedJson saved_json_;  // the same
  std::string notice_;      // what the user should know of how it was opened
  std::unique_ptr<Journal> journal_;
  std::deque<std::pair<uint64_t, std::string>> recent_;  // document events by revision

  mutable std::mutex results_;
  std::condition_variable wake_;
  bool look_ = false, stopping_ = false;
  std::map<std::string, Wish> wishes_;  // by window
  std::vector<std::string> wanted_;     // of all windows
  recipe::Quality quality_ = recipe::Quality::full;
  std::vector<recipe::Source> passed_on_;                        // what the engine was told to compute
  std::map<std::string, uint64_t> told_;                         // the revision of what was published last, by source
  std::map<std::string, std::deque<std::string>> keys_;          // of each source, the newest last
  std::map<std::string, std::pair<recipe::Value, int>> values_;  // by key, and how many sources have it

  std::unique_ptr<recipe::Engine> engine_;
  std::unique_ptr<Background> publisher_;
};

}  // namespace seamount::server
