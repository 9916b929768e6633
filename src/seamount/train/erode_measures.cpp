#include "seamount/train/erode_measures.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/parallel.h"
#include "seamount/ops/learned/erode.h"
#include "seamount/ops/learned/erode_planes.h"
#include "seamount/train/erode_pairs.h"

namespace seamount::train {
namespace {

constexpr double kLeastChange_m = 1e-3;  ///< of a terrain that says anything

struct Off {
  double size = 0, mean = 0;
};

/// |a - b| and a - b, means over all cells.
Off off(const HeightField& a, const HeightField& b) {
  Off sum;
  for (size_t i = 0; i < a.size(); ++i) {
    const double by = static_cast<double>(a.data()[i]) - static_cast<double>(b.data()[i]);
    sum.size += std::abs(by);
    sum.mean += by;
  }
  const auto cells = static_cast<double>(a.size());
  return {sum.size / cells, sum.mean / cells};
}

ErodeMeasure measure(const learned::Network& network, const ErodePair& pair, Seed seed, const RunContext& run) {
  ErodeMeasure out{.cell_m = pair.before.cell_m(), .years = pair.years};
  out.change_m = off(pair.before, pair.after).size;
  if (out.change_m < kLeastChange_m) return out;
  learned::ErodeParams params;
  params.years = pair.years;
  const Off made = off(learned::erode(pair.before, nullptr, params, network, run), pair.after);
  const learned::ErodePlanes planes(pair.before, pair.years, params.sea_m, run);
  HeightField estimate = pair.before;
  for (size_t i = 0; i < estimate.size(); ++i)
    estimate.data()[i] += static_cast<float>(planes.unit_m()) * planes.base().data()[i];
  out.off = made.size / out.change_m;
  out.drift = made.mean / out.change_m;
  out.estimate = off(estimate, pair.after).size / out.change_m;
  out.seeds = off(eroded(pair.before, pair.years, seed, run), pair.after).size / out.change_m;
  return out;
}

}  // namespace

std::vector<ErodeMeasure> measure_erosion(const learned::Network& network, const std::vector<GroundTile>& tiles,
                                          int count, Seed seed, const RunContext& run) {
  std::vector<ErodeMeasure> measures(static_cast<size_t>(count));
  parallel_blocks(run, count, 1, [&](int64_t n, int64_t) {
    RunContext quiet;
    quiet.threads = 1;
    quiet.cancelled = run.cancelled;
    const auto index = static_cast<uint64_t>(n);
    const ErodePair pair = make_erode_pair(tiles, index, seed.derive("measured"), quiet);
    measures[static_cast<size_t>(n)] = measure(network, pair, seed.derive("other", index), quiet);
  });
  std::erase_if(measures, [](const ErodeMeasure& one) { return one.change_m < kLeastChange_m; });
  return measures;
}

ErodeMeasure mean_of(const std::vector<ErodeMeasure>& measures) {
  ErodeMeasure mean;
  for (const ErodeMeasure& one : measures) {
    for (const auto member : {&ErodeMeasure::cell_m, &ErodeMeasure::years, &ErodeMeasure::change_m, &ErodeMeasure::off,
                              &ErodeMeasure::estimate, &ErodeMeasure::seeds, &ErodeMeasure::drift})
      mean.*member += one.*member / static_cast<double>(measures.size());
  }
  return mean;
}

}  // namespace seamount::train
