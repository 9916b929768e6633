#include "seamount/recipe/engine.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>

#include "seamount/base/background.h"
#include "seamount/recipe/engine_view.h"
#include "seamount/recipe/output_files.h"
#include "seamount/recipe/standing.h"
#include "seamount/recipe/step_times.h"

namespace seamount::recipe {
namespace {

using Clock = std::chrono::steady_clock;

/// How long an export takes to notice that it should stop.
constexpr int kPollMilliseconds = 5;

/// A full result that takes less is not preceded by a coarse one, once a gesture is over.
constexpr double kSoon_s = 0.25;

Digest key_of(const Digest& step, const std::string& port) {
  return Hasher().number(step.high).number(step.low).text(port).digest();
}

std::vector<std::string> step_ids(const OrderedJson& root) {
  std::vector<std::string> ids;
  for (const OrderedJson& step : root.at("steps")) ids.push_back(step.at("id").get<std::string>());
  return ids;
}

}  // namespace

class Engine::Work {
 public:
  Work(Document document, EngineOptions options)
      : options_(std::move(options)),
        document_(std::move(document)),
        scheduler_({.threads = options_.threads,
                    .cache_folder = options_.cache_folder,
                    .memory_bytes = options_.memory_bytes,
                    .changed = [this] { look_for_results(); }}),
        planner_(1, [this] { plan_on_request(); }) {}

  ~Work() {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
    scheduler_.pursue({});
    wake_.notify_all();
  }
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;

  std::vector<Change> edit(const std::vector<Edit>& edits, const std::string& gesture, const std::string& label,
                           const std::string& author, bool ends) {
    const std::lock_guard lock(mutex_);
    std::vector<Change> changes = document_.apply(edits, gesture, label, author);
    const bool is_over = ends && !gesture_.empty();  // a hand may rest before it lets go: nothing changes then
    if (!changes.empty() || is_over) request(ends ? "" : gesture);
    return changes;
  }

  bool travel(bool (Document::*there)()) {
    const std::lock_guard lock(mutex_);
    const bool moved = (document_.*there)();
    if (moved) request("");
    return moved;
  }

  Document document() const {
    const std::lock_guard lock(mutex_);
    return document_;
  }

  void look(const std::function<void(const Document&)>& look) const {
    const std::lock_guard lock(mutex_);
    look(document_);
  }

  uint64_t revision() const {
    const std::lock_guard lock(mutex_);
    return document_.revision();
  }

  void want(std::vector<Source> sources, Quality quality) {
    const std::lock_guard lock(mutex_);
    wanted_ = std::move(sources);
    quality_ = quality;
    std::erase_if(latest_, [&](const auto& item) {
      return std::find(wanted_.begin(), wanted_.end(), item.first) == wanted_.end();
    });
    request("");
  }

  void refresh() {
    const std::lock_guard lock(mutex_);
    scheduler_.forget_failures();
    request("");
  }

  void cancel() {
    const std::lock_guard lock(mutex_);
    paused_ = true;
    pursue();
  }

  bool wait_until(Clock::time_point deadline) {
    while (true) {
      {
        std::unique_lock lock(mutex_);
        if (!wake_.wait_until(lock, deadline, [&] { return planned_ == requested_; })) return false;
        if (paused_ || std::none_of(views_.begin(), views_.end(), [&](const View& view) { return waiting(view); }))
          return true;
      }
      if (Clock::now() >= deadline) return false;
      const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
      scheduler_.wait_for(static_cast<int>(std::clamp<int64_t>(left, 1, 50)));  // a new request may come meanwhile
    }
  }

  std::optional<Finished> value(const Source& source) {
    const std::lock_guard lock(mutex_);
    collect();
    const auto found = latest_.find(source);
    return found == latest_.end() ? std::nullopt : std::optional(found->second.finished);
  }

  uint64_t bytes() const { return scheduler_.bytes_in_memory(); }

  EngineState state() const;
  ExecuteReport write_outputs(const Document& document, const std::string& folder, const RunContext& run);

 private:
  /// Asks the planner for plans of what is now wanted. REQUIRES: the lock is held.
  void request(const std::string& gesture) {
    gesture_ = gesture;
    paused_ = false;
    ++requested_;
    wake_.notify_all();
  }

  void plan_on_request() {
    std::unique_lock lock(mutex_);
    while (!stopping_) {
      if (planned_ == requested_) {
        wake_.wait(lock);
      } else {
        plan(lock);
      }
    }
  }

  void plan(std::unique_lock<std::mutex>& lock) {
    const uint64_t request = requested_;
    View full{document_.revision(), false, gesture_, {}, nullptr};
    View coarse{document_.revision(), true, gesture_, {}, nullptr};
    const std::vector<Source> wanted = wanted_;
    const auto recipe = std::make_shared<const Recipe>(document_.recipe());
    const bool has_coarse = std::max(recipe->domain.width, recipe->domain.height) > options_.coarse_cells;
    const bool wants_coarse = has_coarse && quality_ != Quality::full;
    const bool wants_full = !has_coarse || quality_ != Quality::coarse;
    const auto coarse_recipe =
        wants_coarse ? std::make_shared<const Recipe>(document_.recipe(options_.coarse_cells)) : nullptr;
    std::vector<std::string> ids = step_ids(document_.json());
    lock.unlock();  // files are read for their digests
    make_view(full, recipe, wants_full ? wanted : std::vector<Source>());
    if (coarse_recipe) make_view(coarse, coarse_recipe, wanted);
    lock.lock();
    collect();  // how long steps took that have just been finished
    std::vector<View> views;
    if (coarse_recipe && !(wants_full && gesture_.empty() && comes_soon(full))) {
      if (const View* going_on = coarse_in_flight()) views.push_back(*going_on);
      views.push_back(coarse);
    }
    views.push_back(full);
    views_ = std::move(views);
    ids_ = std::move(ids);
    planned_ = request;
    pursue();
    wake_.notify_all();
    lock.unlock();
    look_for_results();
    lock.lock();
  }

  void make_view(View& view, const std::shared_ptr<const Recipe>& recipe, const std::vector<Source>& wanted) {
    view.sources = find_sources(*recipe, wanted);
    std::vector<Source> targets;
    for (const auto& [asked, source] : view.sources) targets.push_back(source);
    view.plan = std::make_shared<const Plan>(make_plan(recipe, targets, files_));
  }

  /// Whether a full result needs no coarse one before it, which would only take time from it.
  bool comes_soon(const View& full) const {
    const auto seconds = times_.expected(*full.plan, scheduler_.ahead(*full.plan));
    return seconds && *seconds < kSoon_s;
  }

  /// The coarse result that is being computed for the gesture that still goes on: a view follows the pen only if it is
  /// finished however many edits come meanwhile.
  const View* coarse_in_flight() const {
    const auto goes_on = [&](const View& view) {
      return view.coarse && !gesture_.empty() && view.gesture == gesture_ && waiting(view);
    };
    const auto found = std::find_if(views_.begin(), views_.end(), goes_on);
    return found == views_.end() ? nullptr : &*found;
  }

  bool waiting(const View& view) const { return scheduler_.outcome(*view.plan) == Outcome::waiting; }

  /// Tells the scheduler what matters now. REQUIRES: the lock is held.
  void pursue() {
    std::vector<std::shared_ptr<const Plan>> plans;
    if (!paused_) {
      for (const View& view : views_) plans.push_back(view.plan);
    }
    plans.insert(plans.end(), exports_.begin(), exports_.end());
    scheduler_.pursue(std::move(plans));
  }

  /// Keeps the newest result of what is wanted, and tells the owner.
  void look_for_results() {
    {
      const std::lock_guard lock(mutex_);
      collect();
    }
    if (!options_.changed) return;
    const std::lock_guard lock(calling_);
    options_.changed();
  }

  void collect() {
    for (const View& view : views_) {
      for (const auto& [asked, source] : view.sources) keep_newest(view, asked, source);
      if (!view.coarse) times_.learn(*view.plan, scheduler_);
    }
  }

  void keep_newest(const View& view, const Source& asked, const Source& source) {
    if (std::find(wanted_.begin(), wanted_.end(), asked) == wanted_.end()) return;
    const PlannedStep& planned = view.plan->steps[view.plan->index_of.at(source.step)];
    const auto known = latest_.find(asked);
    if (planned.defect || (known != latest_.end() && !known->second.gives_way_to(view, planned.key))) return;
    const auto values = scheduler_.values(planned.key);
    if (!values) return;
    if (const auto value = values->find(source.port); value != values->end())
      latest_[asked] = {{value->second, view.revision, view.coarse, key_of(planned.key, source.port)}, planned.key};
  }

  const EngineOptions options_;
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  Document document_;
  std::vector<Source> wanted_;
  Quality quality_ = Quality::full;
  std::string gesture_;
  uint64_t requested_ = 1, planned_ = 0;  ///< counted; the planner is behind while they differ
  bool paused_ = false;
  bool stopping_ = false;
  std::vector<View> views_;  ///< in order of urgency; the last one is the full one of the newest revision
  std::vector<std::string> ids_;
  std::vector<std::shared_ptr<const Plan>> exports_;
  std::map<Source, Latest> latest_;
  StepTimes times_;
  FileSnapshots files_;
  std::mutex calling_;
  Scheduler scheduler_;  // the threads of these two use all of the above
  Background planner_;
};

EngineState Engine::Work::state() const {
  const std::lock_guard lock(mutex_);
  EngineState state;
  if (views_.empty()) return state;
  const View& full = views_.back();
  const Plan& plan = *full.plan;
  state.revision = full.revision;
  state.settled = planned_ == requested_ &&
                  (paused_ || std::none_of(views_.begin(), views_.end(), [&](const View& v) { return waiting(v); }));
  state.coarse = !paused_ && std::any_of(views_.begin(), views_.end(),
                                         [&](const View& view) { return view.coarse && waiting(view); });
  state.fraction = scheduler_.fraction(full.plan->targets.empty() ? *views_.front().plan : plan);
  const std::vector<bool> ahead = scheduler_.ahead(plan);
  std::map<std::string, StepState> by_id;
  std::map<std::string, std::string> broken;  // steps without a result to come, and why
  for (size_t i = 0; i < plan.steps.size(); ++i) {
    StepState step = state_of(plan, i, scheduler_.progress(plan.steps[i].key), ahead[i], paused_);
    for (const size_t from : plan.steps[i].reads) {
      const std::string& id = plan.recipe->steps[from].id;
      const bool open = step.standing == Standing::queued || step.standing == Standing::stale;
      if (!open || !broken.contains(id)) continue;
      step.standing = Standing::blocked;
      step.message = broken[id];
    }
    if (step.standing == Standing::failed || step.standing == Standing::blocked) broken[step.id] = step.message;
    by_id[step.id] = std::move(step);
  }
  for (const Step& step : plan.recipe->bypassed)
    by_id[step.id] = {.id = step.id, .op = step.op->name, .standing = Standing::bypassed};
  for (const std::string& id : ids_) state.steps.push_back(std::move(by_id[id]));
  return state;
}

ExecuteReport Engine::Work::write_outputs(const Document& document, const std::string& folder, const RunContext& run) {
  const std::vector<Diagnostic> missing = document.missing();
  if (!missing.empty()) throw RecipeError(document.file(), missing);
  const auto recipe = std::make_shared<const Recipe>(document.recipe());
  check_nothing_overwritten(*recipe, folder);
  const auto plan = std::make_shared<const Plan>(make_plan(recipe, output_sources(*recipe), files_));
  const auto take_up = [&](bool on) {
    const std::lock_guard lock(mutex_);
    if (on) exports_.push_back(plan);
    if (!on) std::erase(exports_, plan);
    pursue();
  };
  take_up(true);
  ExecuteReport report;
  try {
    while (scheduler_.outcome(*plan) == Outcome::waiting) {
      run.check_cancelled();
      run.report(0.9 * scheduler_.fraction(*plan));
      scheduler_.wait_for(kPollMilliseconds);
    }
    if (const auto failure = scheduler_.failure(*plan)) std::rethrow_exception(failure);
    std::map<Source, Value> values;
    for (const Source& source : output_sources(*recipe))
      values[source] = scheduler_.values(plan->steps[plan->index_of.at(source.step)].key)->at(source.port);
    report.steps = scheduler_.reports(*plan);
    report.outputs = write_outputs_from(*recipe, folder, values, run.part(0.9, 1.0));
  } catch (...) {
    take_up(false);
    throw;
  }
  take_up(false);
  return report;
}

Engine::Engine(Document document, EngineOptions options)
    : work_(std::make_unique<Work>(std::move(document), std::move(options))) {}
Engine::~Engine() = default;

std::vector<Change> Engine::edit(const Edit& edit, const std::string& gesture) {
  return work_->edit({edit}, gesture, "", "", false);
}
std::vector<Change> Engine::edit(const std::vector<Edit>& edits, const std::string& gesture, const std::string& label,
                                 const std::string& author, bool ends) {
  return work_->edit(edits, gesture, label, author, ends);
}
bool Engine::undo() { return work_->travel(&Document::undo); }
bool Engine::redo() { return work_->travel(&Document::redo); }
Document Engine::document() const { return work_->document(); }
void Engine::look(const std::function<void(const Document&)>& look) const { work_->look(look); }
uint64_t Engine::revision() const { return work_->revision(); }
void Engine::want(std::vector<Source> sources, Quality quality) { work_->want(std::move(sources), quality); }
void Engine::refresh() { work_->refresh(); }
void Engine::cancel() { work_->cancel(); }
void Engine::wait() { work_->wait_until(Clock::time_point::max()); }
bool Engine::wait_for(int milliseconds) {
  return work_->wait_until(Clock::now() + std::chrono::milliseconds(milliseconds));
}
EngineState Engine::state() const { return work_->state(); }
std::optional<Finished> Engine::value(const Source& source) const { return work_->value(source); }
uint64_t Engine::bytes_in_memory() const { return work_->bytes(); }
ExecuteReport Engine::write_outputs(const std::string& folder, const RunContext& run) {
  return work_->write_outputs(work_->document(), folder, run);
}
ExecuteReport Engine::write_outputs(const Document& document, const std::string& folder, const RunContext& run) {
  return work_->write_outputs(document, folder, run);
}

}  // namespace seamount::recipe
