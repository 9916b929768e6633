// Multigrid for transport.h. Cell-centred agglomeration with rediscretised diffusion: Mohr and Wienands 2004, Wesseling
// 1988; sweeps that follow the flow: Hackbusch 1997; unknowns weighted by the solution: iterative aggregation and
// disaggregation of Markov chains (Koury, McAllister and Stewart 1984; De Sterck et al. 2008); cells held at 0 left out
// of the coarse levels: Kornhuber 1994.
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/base/flush_denormals.h"
#include "seamount/base/parallel.h"
#include "seamount/base/text.h"
#include "seamount/geom/solve/transport.h"
#include "seamount/geom/solve/transport_check.h"
#include "seamount/geom/solve/transport_level.h"
#include "seamount/geom/solve/transport_sweeps.h"

namespace seamount::geom {
namespace transport {
namespace {

/// A copy in which what flows into a cell held at 0 is lost, and such cells have no equation.
Level without_held_cells(Level level) {
  for (int y = 0; y < level.height; ++y) {
    Cell* row = level.row(y);
    for (Cell* cell = row; cell < row + level.width; ++cell) {
      if (cell->value > 0.0F) continue;
      const auto lose = [&](std::ptrdiff_t step, float rate, float back) {
        cell[step].loss += rate;
        level.wall[static_cast<size_t>(cell + step - level.cells.data())] += std::min(rate, back);
      };
      lose(-1, cell->west * cell->diagonal, cell[-1].east * cell[-1].diagonal);
      lose(1, cell->east * cell->diagonal, cell[1].west * cell[1].diagonal);
      lose(-level.stride, cell->north * cell->diagonal, cell[-level.stride].south * cell[-level.stride].diagonal);
      lose(level.stride, cell->south * cell->diagonal, cell[level.stride].north * cell[level.stride].diagonal);
      cell->west = cell->east = cell->north = cell->south = cell->right = 0.0F;
    }
  }
  return level;
}

std::vector<Level> coarser_levels(int width, int height) {
  std::vector<Level> levels;
  while (width > 2 || height > 2) {
    width = (width + 1) / 2;
    height = (height + 1) / 2;
    levels.emplace_back(width, height);
  }
  return levels;
}

/// Improves levels[0].value by one cycle; levels[1] and on are for corrections of it. `thorough`: twice the sweeps.
void cycle(std::span<Level> levels, bool thorough) {
  Level& level = levels[0];
  if (levels.size() == 1) {
    for (int k = 0; k < 8; ++k) sweep_south(level, false), sweep_north(level, false);
    return;
  }
  sweep_south(level, false);
  if (thorough) sweep_north(level, false);
  restrict_residuals(level, false, levels[1]);
  cycle(levels.subspan(1), thorough);
  add_signed_correction(levels[1], level);
  if (thorough) sweep_south(level, false);
  sweep_north(level, false);
}

/// How far a solution has come.
struct Progress {
  bool reached = false;  ///< the tolerance
  bool slow = false;     ///< cycles help little, or not at all
  double error = 0.0;    ///< estimated, as a share of the largest concentration
};

/// What coarse unknowns mean to the fine cells in them.
enum class Unknowns : unsigned char {
  cells,       ///< the same change to each: enough where concentrations vary smoothly
  free_cells,  ///< the same, but for cells held at 0
  shares,      ///< the same share of each one's concentration: where material gathers in narrow places
};

class Solver {
 public:
  Solver(Level finest, bool absorbing, const RunContext& run)
      : run_(run), absorbing_(absorbing), corrections_(coarser_levels(finest.width, finest.height)) {
    levels_.push_back(std::move(finest));
    for (Level& level : coarser_levels(levels_[0].width, levels_[0].height)) levels_.push_back(std::move(level));
    for (size_t k = 1; k < levels_.size(); ++k) coarsen(levels_[k - 1], nullptr, kFurtherWall, levels_[k]);
  }

  const Level& solution() const { return levels_[0]; }

  Progress solve(const SteadyOptions& options) {
    if (!gathers_little()) return start_and_cycle(options, Unknowns::shares);
    const Progress first = start_and_cycle(options, absorbing_ ? Unknowns::free_cells : Unknowns::cells);
    if (first.reached) return first;
    const std::vector<Cell> kept = levels_[0].cells;
    const Progress second = start_and_cycle(options, Unknowns::shares);
    if (second.reached || second.error < first.error) return second;
    levels_[0].cells = kept;
    return first;
  }

 private:
  /// What comes into a cell is at most twice what leaves it at equal concentrations.
  bool gathers_little() const {
    float most = 0.0F;
    for (const Cell& cell : levels_[0].cells)
      most = std::max(most, (cell.west + cell.east) + (cell.north + cell.south));
    return most <= 2.0F;
  }

  /// From nothing, coarsest level first, then cycles of the finest.
  Progress start_and_cycle(const SteadyOptions& options, Unknowns unknowns) {
    for (size_t k = 1; k < levels_.size(); ++k) restrict_sources(levels_[k - 1], levels_[k]);
    for (Cell& cell : levels_.back().cells) cell.value = 0.0F;
    for (size_t k = levels_.size(); k-- > 0;) {
      if (k + 1 < levels_.size()) prolong(levels_[k + 1], levels_[k]);
      improve(k, unknowns, true);
    }
    Progress progress;
    double last_change = 0.0;
    for (int n = 0; n < options.max_cycles && !progress.reached; ++n) {
      const double change = change_of_a_cycle(unknowns, n % kKept == 0);
      // Errors shrink by about the factor by which changes do; the first cycles flatter.
      const double factor = n > 0 ? std::max(0.3, change / std::max(1e-30, last_change)) : 0.9;
      progress.error = factor < 0.98 ? change * factor / (1.0 - factor) : 50.0 * change;
      progress.reached = progress.error <= options.tolerance || change < kRounding;
      last_change = change;
      run_.report(static_cast<double>(n + 1) / options.max_cycles);
      if (n > 0 && factor > 0.5 && unknowns == Unknowns::cells) break;
    }
    return progress;
  }

  /// Largest change by one cycle of the finest level, as a share of the largest value.
  double change_of_a_cycle(Unknowns unknowns, bool anew) {
    Level& finest = levels_[0];
    before_.resize(finest.cells.size());
    for (size_t i = 0; i < before_.size(); ++i) before_[i] = finest.cells[i].value;
    improve(0, unknowns, anew);
    float moved = 0.0F, largest = 1e-30F;
    for (size_t i = 0; i < before_.size(); ++i) {
      moved = std::max(moved, std::abs(finest.cells[i].value - before_[i]));
      largest = std::max(largest, finest.cells[i].value);
    }
    return static_cast<double>(moved) / static_cast<double>(largest);
  }

  /// One cycle on level k, whose coarser levels are done with. `anew`: what the last cycle made may no longer fit.
  void improve(size_t k, Unknowns unknowns, bool anew) {
    Level& level = levels_[k];
    run_.check_cancelled();
    if (k + 1 == levels_.size()) {
      for (int n = 0; n < 8; ++n) sweep_south(level, absorbing_), sweep_north(level, absorbing_);
      return;
    }
    const bool thorough = unknowns != Unknowns::cells;
    sweep_south(level, absorbing_);
    if (thorough) sweep_north(level, absorbing_);
    if (unknowns == Unknowns::cells) {
      const std::span<Level> coarse = std::span(levels_).subspan(k + 1);
      restrict_residuals(level, false, coarse[0]);
      cycle(coarse, thorough);
      add_correction(coarse[0], nullptr, level);
    } else {
      const bool shares = unknowns == Unknowns::shares;
      const std::span<Level> coarse = std::span(corrections_).subspan(k);
      if (weigh(level, shares, anew)) make_corrections(level, shares, coarse);
      restrict_residuals(level, absorbing_, coarse[0]);
      cycle(coarse, thorough);
      add_correction(coarse[0], weights_.data(), level);
    }
    if (thorough) sweep_south(level, absorbing_);
    sweep_north(level, absorbing_);
  }

  /// What the coarse unknowns mean to each cell; whether that changed. `anew`: it is not what it was for another level,
  /// or long ago.
  bool weigh(const Level& level, bool shares, bool anew) {
    const bool first = anew || weights_.size() != level.cells.size();
    if (shares && !first && !absorbing_) return false;
    weights_.resize(level.cells.size());
    float largest = 0.0F;
    if (shares)
      for (const Cell& cell : level.cells) largest = std::max(largest, cell.value);
    const float scale = largest > 0.0F ? 1.0F / largest : 0.0F, smallest = absorbing_ ? 0.0F : 1e-12F;
    bool changed = first;
    for (size_t i = 0; i < weights_.size(); ++i) {
      const float value = level.cells[i].value;
      const float weight = shares ? std::max(value * scale, smallest) : (value > 0.0F ? 1.0F : 0.0F);
      changed = changed || weight != weights_[i];
      weights_[i] = weight;
    }
    return changed;
  }

  /// The equations of the corrections for these weights; cells held at 0 are left out.
  void make_corrections(const Level& level, bool shares, std::span<Level> coarse) {
    const bool held = absorbing_ && std::any_of(level.cells.begin(), level.cells.end(), [](const Cell& cell) {
                        return cell.diagonal > 0.0F && !(cell.value > 0.0F);
                      });
    if (held) free_ = without_held_cells(level);
    const float wall_share = shares ? kSameWall : kFurtherWall;
    coarsen(held ? *free_ : level, weights_.data(), wall_share, coarse[0]);
    for (size_t k = 1; k < coarse.size(); ++k) coarsen(coarse[k - 1], nullptr, wall_share, coarse[k]);
  }

  static constexpr int kKept = 4;            ///< cycles for which equations of weighted unknowns are kept
  static constexpr double kRounding = 1e-6;  ///< changes that float arithmetic makes where nothing is left to gain

  const RunContext& run_;
  bool absorbing_;
  std::vector<Level> levels_;       ///< of the solution; while a level is improved, the coarser ones correct it
  std::vector<Level> corrections_;  ///< the same shapes from level 1 on, for weighted unknowns
  std::vector<float> weights_, before_;
  std::optional<Level> free_;
};

double largest_speed(const VectorField& flow) {
  float largest = 0.0F;
  for (const ScalarField* part : {&flow.x, &flow.y})
    for (const float v : part->cells()) largest = std::max(largest, std::abs(v));
  return static_cast<double>(largest);
}

/// Rates are brought to about 1 and concentrations to the largest source's, so that no unit overflows.
struct Scales {
  double rate = 0.0, value = 0.0;  ///< both 0: nothing comes in
};

Scales scales_of(const Transport& transport) {
  float most = 0.0F;
  for (const float v : transport.source->cells()) most = std::max(most, v);
  const double cell = transport.source->cell_m();
  const double speed = transport.flow != nullptr ? largest_speed(*transport.flow) : 0.0;
  double fastest = transport.decay_per_s + 4.0 * transport.diffusivity_m2_s / (cell * cell) + 4.0 * speed / cell;
  if (!(fastest > 0.0)) fastest = 1.0;
  double source = static_cast<double>(most) / fastest;
  if (transport.around != nullptr) {
    for (const float v : transport.around->cells()) source = std::max(source, static_cast<double>(v));
  }
  return {1.0 / fastest, source};
}

}  // namespace
}  // namespace transport

ScalarField steady_state(const Transport& transport, const RunContext& run, const SteadyOptions& options) {
  transport::check_transport(transport);
  if (!(options.tolerance > 0.0)) throw InvalidArgument("tolerance", "is not above 0");
  const GridFrame& frame = transport.source->frame();
  const transport::Scales scales = transport::scales_of(transport);
  if (transport.source->empty() || scales.value == 0.0) return ScalarField(frame, 0.0F);
  const FlushDenormals flush;
  transport::Level finest = transport::assemble(transport, scales.rate, static_cast<float>(1.0 / scales.value));
  transport::check_outflow(finest, transport);
  const bool absorbing =
      std::any_of(transport.source->cells().begin(), transport.source->cells().end(), [](float v) { return v < 0.0F; });
  transport::Solver solver(std::move(finest), absorbing, run);
  const transport::Progress progress = solver.solve(options);
  if (!progress.reached) {
    run.say("materials: after " + std::to_string(options.max_cycles) + " cycles about " +
            format_number(100.0 * progress.error) + " % of the largest concentration is still uncertain");
  }
  ScalarField out(frame);
  const auto unit = static_cast<float>(scales.value);
  for (int y = 0; y < frame.height; ++y) {
    const transport::Cell* row = solver.solution().row(y);
    for (int x = 0; x < frame.width; ++x) out(x, y) = unit * row[x].value;
  }
  return out;
}

std::vector<ScalarField> steady_states(std::span<const Transport> transports, const RunContext& run,
                                       const SteadyOptions& options) {
  std::vector<ScalarField> states(transports.size());
  parallel_blocks(run, static_cast<int64_t>(transports.size()), 1, [&](int64_t begin, int64_t) {
    RunContext one = run;
    one.progress = nullptr;
    one.threads = 1;
    states[static_cast<size_t>(begin)] = steady_state(transports[static_cast<size_t>(begin)], one, options);
  });
  return states;
}

}  // namespace seamount::geom
