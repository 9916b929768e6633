#include "seamount/tiles/chain.h"

#include <algorithm>
#include <atomic>
#include <limits>

#include "seamount/base/error.h"
#include "seamount/tiles/spread.h"
#include "seamount/tiles/windows.h"

namespace seamount::tiles {
namespace {

/// The tile's place before a message; cancelling stays cancelling, and files name themselves.
[[noreturn]] void rethrow_with_tile(const std::string& tile) {
  try {
    throw;
  } catch (const Cancelled&) {
    throw;
  } catch (const IoError&) {
    throw;
  } catch (const InvalidArgument& error) {
    throw InvalidArgument(tile, error.what());
  } catch (const IncompatibleInputs& error) {
    throw IncompatibleInputs(tile + ": " + error.what());
  } catch (const std::exception& error) {
    throw Error(tile + ": " + error.what());
  }
}

}  // namespace

Chain::Chain(World& world, const std::map<size_t, LocalStep>& steps, std::vector<OutputOf> wanted)
    : world_(world), all_(steps), wanted_(std::move(wanted)) {
  for (const OutputOf& output : wanted_) {
    add(output.first);
    stored_.push_back(world_.on_disk(output, all_.at(output.first).frame));
  }
  std::sort(order_.begin(), order_.end());  // a recipe's steps stand after those that they need
  for (const size_t step : order_) {
    for (const LocalStep::Input& one : all_.at(step).inputs) last_use_[one.from.first] = step;
  }
}

void Chain::add(size_t step) {
  if (std::find(order_.begin(), order_.end(), step) != order_.end()) return;
  order_.push_back(step);
  for (const LocalStep::Input& one : all_.at(step).inputs) {
    if (!world_.has(one.from)) add(one.from.first);
  }
}

recipe::Value Chain::input(const OutputOf& from, const Rect& rect, const std::map<size_t, Rect>& needed,
                           const Values& made) const {
  const auto found = made.find(from);
  if (found == made.end()) return world_.window(from, rect);
  const Rect& all = needed.at(from.first);
  return window_of(found->second, {rect.column - all.column, rect.row - all.row, rect.width, rect.height});
}

Chain::Windows Chain::windows_for(int tile) const {
  Windows found;
  auto& [needed, run_on] = found;
  for (size_t i = 0; i < wanted_.size(); ++i)
    needed[wanted_[i].first] = united(needed[wanted_[i].first], stored_[i]->layout().tile(tile));
  for (auto step = order_.rbegin(); step != order_.rend(); ++step) {
    const LocalStep& local = all_.at(*step);
    run_on[*step] = with_reach(needed[*step], local.reach, local.frame);
    for (const LocalStep::Input& one : local.inputs)
      needed[one.from.first] = united(needed[one.from.first], run_on[*step]);
  }
  return found;
}

/// What making a tile takes, about: a raster of every step, and what operators use besides.
double Chain::bytes_for(int tile) const {
  constexpr double kScratch = 8 * sizeof(float);  // of a cell
  double cells = 0;
  for (const auto& [step, on] : windows_for(tile).run_on) cells = std::max(cells, static_cast<double>(on.cells()));
  return cells * (kScratch + sizeof(float) * static_cast<double>(order_.size()));
}

void Chain::make_tile(int tile, const Say& say, const RunContext& run) const {
  const auto [needed, run_on] = windows_for(tile);
  Values made;
  for (const size_t step : order_) {
    run.check_cancelled();
    const LocalStep& local = all_.at(step);
    const Rect& on = run_on.at(step);
    std::vector<recipe::Value> windows;
    for (const LocalStep::Input& one : local.inputs) windows.push_back(input(one.from, on, needed, made));
    const RunContext own{run.threads, {}, run.cancelled, [&](const std::string& line) { say(step, line); }};
    for (auto& [port, value] : local.run(world_, on, windows, own)) {
      const Rect& part = needed.at(step);
      made[{step, port}] = window_of(value, {part.column - on.column, part.row - on.row, part.width, part.height});
    }
    std::erase_if(made, [&](const auto& item) {
      const bool wanted = std::find(wanted_.begin(), wanted_.end(), item.first) != wanted_.end();
      const auto last = last_use_.find(item.first.first);
      return !wanted && (last == last_use_.end() || last->second <= step);
    });
  }
  for (size_t i = 0; i < wanted_.size(); ++i) {
    const Rect rect = stored_[i]->layout().tile(tile);
    const Rect& all = needed.at(wanted_[i].first);
    stored_[i]->write(
        tile, window_of(made.at(wanted_[i]), {rect.column - all.column, rect.row - all.row, rect.width, rect.height}));
  }
}

void Chain::run(const Say& say, const RunContext& run) {
  const Layout layout = stored_.front()->layout();
  constexpr size_t kNone = std::numeric_limits<int64_t>::max();
  std::atomic<size_t> unknown{kNone};
  const auto make = [&](int tile, const RunContext& own) {
    const bool there =
        std::all_of(stored_.begin(), stored_.end(), [&](const auto& raster) { return raster->has(tile); });
    try {
      if (!there) make_tile(tile, say, own);
    } catch (const MeetsUnknown& met) {
      unknown = met.step;
      return false;
    } catch (...) {
      rethrow_with_tile(layout.name(tile));
    }
    return true;
  };
  const int middle = layout.rows() / 2 * layout.columns() + layout.columns() / 2;
  spread(world_.ranks(), run, layout.count(), at_once(bytes_for(middle), world_.memory_bytes(), run), make);
  const auto met = static_cast<size_t>(lowest(world_.ranks(), static_cast<int64_t>(unknown.load())));
  if (met != kNone) throw MeetsUnknown{met};
  for (size_t i = 0; i < wanted_.size(); ++i) world_.keep_tiles(wanted_[i], stored_[i]);
}

}  // namespace seamount::tiles
