#include "seamount/tiles/steps_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <sstream>

#include "seamount/io/read_options.h"
#include "seamount/recipe/step_work.h"
#include "seamount/recipe/value_stream.h"
#include "seamount/tiles/tiled_ways.h"
#include "seamount/tiles/windows.h"

namespace seamount::tiles {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

}  // namespace

StepsRun::StepsRun(World& world, const TileOptions& options, const RunContext& run)
    : world_(world), options_(options), run_(run), cache_(options.cache_folder) {
  const recipe::Plan& plan = world_.plan();
  for (size_t i = 0; i < plan.steps.size(); ++i) {
    if (!plan.steps[i].needed) continue;
    if (plan.steps[i].defect) std::rethrow_exception(plan.steps[i].defect);
    reports_[i] = {world_.step(i).id, world_.step(i).op->name, 0.0, false, {}};
  }
}

void StepsRun::finish(const std::vector<OutputOf>& wanted) {
  for (;;) {
    try {
      prepare_all();
      make(wanted);
      break;
    } catch (const MeetsUnknown& met) {  // it fills them as run_step() would, from everything
      forced_.insert(met.step);
      run_.say(fmt::format("{}: some cells have no value; it fills them, for which it looks at everything",
                           recipe::step_name(world_.step(met.step))));
    }
  }
  say_tile_notes();
}

void StepsRun::prepare_all() {
  locals_.clear();
  const auto frame_of = [this](const OutputOf& output) -> const GridFrame& { return this->frame_of(output); };
  for (const auto& [step, report] : reports_) {
    run_.check_cancelled();
    if (all_there(step)) continue;
    const auto found = forced_.contains(step) ? std::nullopt : locality(world_, step, frame_of);
    if (found) {
      make(found->wholes);
      if (find_tiled_way(world_.step(step)) != nullptr && !world_.fit(found->wholes)) {
        run_whole(step);
        continue;
      }
      if (found->measured) make({found->inputs.front().from});
      if (auto local = local_step(world_, step, *found, frame_of, run_)) {
        locals_.emplace(step, std::move(*local));
        continue;
      }
    }
    run_whole(step);
  }
}

const GridFrame& StepsRun::frame_of(const OutputOf& output) const {
  const auto local = locals_.find(output.first);
  return local != locals_.end() && !world_.has(output) ? local->second.frame : world_.frame(output);
}

/// Every output that somebody reads.
bool StepsRun::all_there(size_t step) const {
  const auto& ports = world_.plan().steps[step].ports;
  return done_.contains(step) && std::all_of(ports.begin(), ports.end(), [&](const std::string& port) {
           return world_.has({step, port});
         });
}

std::optional<StepsRun::Need> StepsRun::need_of(size_t index) const {
  constexpr double kScratch = 8 * sizeof(float), kReading = 2 * sizeof(float);  // of a cell, that operators use besides
  const recipe::Step& step = world_.step(index);
  GridFrame frame = world_.recipe().domain;
  double bytes_a_cell = 0;
  bool rasters = false, first = true;
  const auto add = [&](const recipe::Port& port) {
    if (is_raster(*port.kind)) bytes_a_cell += static_cast<double>(cell_bytes(*port.kind));
  };
  for (const recipe::Port& port : step.op->in) {
    const auto source = step.in.find(port.name);
    if (source == step.in.end() || !is_raster(*port.kind)) continue;
    if (source->second.from_file()) return std::nullopt;
    if (first) frame = frame_of(world_.output_of(source->second));
    first = false;
    rasters = true;
    add(port);
  }
  for (const recipe::Port& port : step.op->out) {
    rasters = rasters || is_raster(*port.kind);
    add(port);
  }
  const TiledWay* way = find_tiled_way(step);
  const bool read = first && !world_.plan().steps[index].files.empty();
  if (read) {
    const auto size = way != nullptr && way->size != nullptr ? way->size(world_, index) : std::nullopt;
    if (!size) return std::nullopt;
    frame = *size;
  }
  if (!rasters) return std::nullopt;
  const Reach reach = step.op->reach ? step.op->reach(step.params, frame.cell_m) : Reach{};
  std::string why = reach.why;
  if (way != nullptr) why = way->refusal(step, world_.plan().steps[index]);
  return Need{static_cast<double>(frame.cells()) * (bytes_a_cell + (read ? kReading : kScratch)), frame,
              "looks at everything" + (why.empty() ? "" : " (" + why + ")"),
              read && frame.cells() > io::ReadOptions{}.max_cells};
}

/// In a way of its own, where it does not fit as a whole.
bool StepsRun::run_tiled(size_t index) {
  const recipe::Step& step = world_.step(index);
  const TiledWay* way = find_tiled_way(step);
  if (way == nullptr || !way->refusal(step, world_.plan().steps[index]).empty()) return false;
  const auto need = need_of(index);
  if (!need || (world_.fits(need->bytes, need->frame) && !need->too_many)) return false;
  make(sources_of(index));
  const auto start = Clock::now();
  const RunContext own{run_.threads, [&](double fraction) { report(fraction, 1); }, run_.cancelled,
                       [&](const std::string& line) { say(index, line); }};
  try {
    if (way->spread)
      way->run(world_, index, own);
    else
      run_way_by_first(*way, index, own);
  } catch (const NeedsWhole& needs) {
    world_.check_fits(need->bytes, recipe::step_name(step), "looks at everything (" + needs.why + ")", need->frame);
    return false;
  } catch (...) {
    recipe::rethrow_with_step(step);
  }
  done_.insert(index);
  reports_[index].seconds += seconds_since(start);
  return true;
}

void StepsRun::run_way_by_first(const TiledWay& way, size_t step, const RunContext& run) {
  Ranks& ranks = world_.ranks();
  std::string needs_whole;
  if (ranks.first()) {
    try {
      way.run(world_, step, run);
    } catch (const NeedsWhole& needs) {
      needs_whole = needs.why.empty() ? "the raster says so" : needs.why;
    }
  }
  needs_whole = ranks.share(needs_whole);
  if (!needs_whole.empty()) throw NeedsWhole{needs_whole};
  world_.share_kept(step);
}

std::vector<OutputOf> StepsRun::sources_of(size_t step) const {
  std::vector<OutputOf> sources;
  for (const auto& [port, source] : world_.step(step).in) {
    if (!source.from_file()) sources.push_back(world_.output_of(source));
  }
  return sources;
}

recipe::Values StepsRun::inputs_of(size_t step) const {
  recipe::Values in;
  for (const auto& [port, source] : world_.step(step).in) {
    if (!source.from_file()) in[port] = world_.whole(world_.output_of(source));
  }
  return in;
}

/// Rank 0 has the values.
void StepsRun::keep(size_t step, const recipe::Values& values) {
  if (world_.ranks().first()) {
    for (const std::string& port : world_.plan().steps[step].ports) {
      if (!world_.has({step, port})) world_.keep({step, port}, values.at(port));
    }
  }
  world_.share_kept(step);
  done_.insert(step);
  report(0.0, 0);
}

bool StepsRun::load(size_t step) {
  const recipe::Operator& op = *world_.step(step).op;
  if (!op.cached) return false;
  std::optional<recipe::Values> values;
  if (world_.ranks().first()) values = cache_.load(world_.plan().steps[step].key, op.out, *world_.recipe().registry);
  if (!agreed(world_.ranks(), values.has_value())) return false;
  for (const std::string& line : cache_.notes(world_.plan().steps[step].key)) say(step, line);
  reports_[step].cached = true;
  keep(step, values.value_or(recipe::Values()));
  return true;
}

void StepsRun::run_whole(size_t step) {
  if (load(step) || run_tiled(step)) return;
  if (const auto need = need_of(step))
    world_.check_fits(need->bytes, recipe::step_name(world_.step(step)), need->why, need->frame);
  make(sources_of(step));
  const auto start = Clock::now();
  recipe::Values made;
  if (world_.ranks().first()) made = computed(step);
  keep(step, made);
  reports_[step].seconds += seconds_since(start);
}

recipe::Values StepsRun::computed(size_t step) {
  const RunContext own{run_.threads, [&](double fraction) { report(fraction, 1); }, run_.cancelled,
                       [&](const std::string& line) { say(step, line); }};
  const recipe::PlannedStep& planned = world_.plan().steps[step];
  recipe::Values made = recipe::run_step(world_.recipe(), world_.step(step), inputs_of(step), own);
  for (const auto& file : planned.files) {
    if (!file->still_valid()) throw IoError(file->path(), "was written to while it was read; run again");
  }
  if (world_.step(step).op->cached) cache_.store(planned.key, made, reports_[step].notes);
  return made;
}

void StepsRun::make(const std::vector<OutputOf>& wanted) {
  std::vector<OutputOf> left;
  for (const OutputOf& output : wanted) {
    if (!world_.has(output) && std::find(left.begin(), left.end(), output) == left.end()) left.push_back(output);
  }
  while (!left.empty()) {
    const GridFrame frame = frame_of(left.front());
    const auto others = std::stable_partition(left.begin(), left.end(),
                                              [&](const OutputOf& output) { return frame_of(output) == frame; });
    Chain chain(world_, locals_, std::vector<OutputOf>(left.begin(), others));
    left.erase(left.begin(), others);
    run_chain(chain);
  }
}

void StepsRun::run_chain(Chain& chain) {
  const auto start = Clock::now();
  RunContext own = run_;
  own.progress = [&](double fraction) { report(fraction, chain.steps().size()); };
  chain.run(
      [&](size_t step, const std::string& line) {
        const std::lock_guard lock(saying_);
        ++tile_notes_[{step, line}];
      },
      own);
  const double seconds = seconds_since(start) / static_cast<double>(chain.steps().size());
  for (const size_t step : chain.steps()) {
    reports_[step].seconds += seconds;  // a chain's steps share their time
    done_.insert(step);
  }
}

void StepsRun::say(size_t step, const std::string& line) {
  reports_[step].notes.push_back(line);
  run_.say("step '" + world_.step(step).id + "': " + line);
}

/// What all ranks' tiles have said, and on how many of them.
void StepsRun::say_tile_notes() {
  std::ostringstream mine;
  recipe::Writer writer(mine);
  for (const auto& [note, count] : tile_notes_) {
    writer.plain(static_cast<uint64_t>(note.first));
    writer.text(note.second);
    writer.plain(static_cast<int64_t>(count));
  }
  tile_notes_.clear();
  for (const std::string& of_rank : world_.ranks().gather(mine.str())) {
    std::istringstream bytes(of_rank);
    recipe::Reader reader(bytes);
    while (reader.left() > 0) {
      const auto step = reader.plain<uint64_t>();
      const std::string line = reader.text();
      tile_notes_[{step, line}] += reader.plain<int64_t>();
    }
  }
  for (const auto& [note, count] : tile_notes_)
    say(note.first, fmt::format("{} ({} {})", note.second, count, count == 1 ? "tile" : "tiles"));
}

void StepsRun::report(double fraction_of_next, size_t steps) {
  const auto all = static_cast<double>(reports_.size());
  run_.report(std::min(1.0, (static_cast<double>(done_.size()) + fraction_of_next * static_cast<double>(steps)) / all));
}

std::vector<recipe::StepReport> StepsRun::reports() const {
  std::vector<recipe::StepReport> all;
  for (const auto& [step, report] : reports_) all.push_back(report);
  return all;
}

}  // namespace seamount::tiles
