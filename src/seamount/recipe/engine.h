// A document that stays alive: edits go in, results come out, and in between only what follows from a change is
// computed, in the background. What the studio's server stands on, and any program that shows a terrain while it is
// being made.
//
//   Engine engine(Document::read("kauai.json"), {.changed = [&] { window.refresh(); }});
//   engine.want({{"reef", "terrain", ""}}, Quality::coarse_then_full);
//   engine.edit(set_parameter("reef", "subsidence", 0.4), "drag 17");   // as often as the slider moves
//   if (const auto shown = engine.value({"reef", "terrain", ""})) draw(shown->value);
//
// Results are the bytes of `run`. Every member may be called from any thread; two engines do not know of each other.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "seamount/base/hash.h"
#include "seamount/recipe/document.h"
#include "seamount/recipe/executor.h"
#include "seamount/recipe/value.h"

namespace seamount::recipe {

/// How well what is wanted is computed. coarse: on few cells, fit for a view that follows a pen. A domain that has few
/// cells anyway is computed in full at once.
enum class Quality { coarse, full, coarse_then_full };

struct EngineOptions {
  int threads = 0;                                     ///< 0: all processors
  std::string cache_folder = Cache::default_folder();  ///< empty: nothing is kept on disk
  uint64_t memory_bytes = uint64_t{1} << 30;           ///< for results that are not in use
  int coarse_cells = 256;                              ///< along the longer side of a coarse result
  /// Called after the state or a value has changed (for progress of a step, at most every 50 ms), from the
  /// engine's threads, one call at a time. It may call any member but wait(), and returns soon.
  std::function<void()> changed = {};
};

/// How a step stands at the newest revision, at full quality.
enum class Standing {
  fresh,       ///< its result is known
  stale,       ///< its result is not known, and nobody wants it
  queued,      ///< it will be computed
  running,     ///< it is being computed
  failed,      ///< it could not be computed: `message`
  blocked,     ///< a step that it needs failed or is incomplete: `message`
  incomplete,  ///< an input is open: `message`
  bypassed,
};

struct StepState {
  std::string id;
  std::string op;
  Standing standing = Standing::stale;
  double fraction = 0.0;  ///< of a running step
  double seconds = 0.0;   ///< that the result took, or reading it from the cache
  bool cached = false;    ///< the result was read from the cache on disk
  std::string message;
  std::vector<std::string> notes;  ///< what the operator said about its result
};

struct EngineState {
  uint64_t revision = 0;         ///< of the document that the steps below belong to
  bool settled = false;          ///< all that is wanted is computed or has failed
  bool coarse = false;           ///< a coarse result is being computed, the full one waits
  double fraction = 0.0;         ///< of what is wanted
  std::vector<StepState> steps;  ///< in the document's order
};

/// A result, and what it is a result of.
struct Finished {
  Value value;
  uint64_t revision = 0;
  bool coarse = false;
  Digest key;  ///< of everything that the result depends on, its step and port included: same key, same value
};

class Engine {
 public:
  explicit Engine(Document document, EngineOptions options = {});
  /// Stops what is running and waits for it.
  ~Engine();
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  // The document. Each change makes out-of-date work stop at once; within a gesture the coarse result that is being
  // computed is still finished, so that a view follows the pen however fast edits come. `ends`: a gesture is over with
  // these edits; what will be there in full in a quarter of a second then gets no coarse result before it. Throws what
  // Document throws.
  std::vector<Change> edit(const Edit& edit, const std::string& gesture = "");
  std::vector<Change> edit(const std::vector<Edit>& edits, const std::string& gesture = "",
                           const std::string& label = "", const std::string& author = "", bool ends = false);
  bool undo();
  bool redo();
  Document document() const;
  /// Calls look(document) while nobody changes it; it calls no member of the engine. Cheaper than a copy, whose history
  /// may be long.
  void look(const std::function<void(const Document&)>& look) const;
  uint64_t revision() const;

  /// Says what is wanted from now on; nothing, to begin with. Sources that the document does not have are passed over
  /// for as long as it does not.
  void want(std::vector<Source> sources, Quality quality);

  /// Looks again at the files that steps read, and tries failed steps once more.
  void refresh();

  /// Stops computing until the next edit, want() or refresh(). Returns at once.
  void cancel();

  /// Waits until all that is wanted of the newest revision is computed, has failed or was cancelled.
  void wait();
  /// The same for a while at most. False: it was over first.
  bool wait_for(int milliseconds);

  EngineState state() const;

  /// The newest finished result of something wanted: of an earlier revision or coarse until the next one is there.
  /// Nothing if none was ever finished since it has been wanted.
  std::optional<Finished> value(const Source& source) const;

  /// Bytes of results in memory, those in use included.
  uint64_t bytes_in_memory() const;

  /// Computes what the document's outputs need and writes them: the same files as `run`, with the engine's results.
  /// Throws what execute() throws, RecipeError for an incomplete document.
  ExecuteReport write_outputs(const std::string& folder, const RunContext& run);
  /// The same for another document, such as this one with other outputs: what they have in common is computed once.
  ExecuteReport write_outputs(const Document& document, const std::string& folder, const RunContext& run);

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

}  // namespace seamount::recipe
