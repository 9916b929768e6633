#include "seamount/ops/erosion/balance.h"

#include <algorithm>
#include <cmath>

namespace seamount::erosion {
namespace {

/// Thickness of a layer as a run takes it.
double thickness(const ScalarField* layer, size_t cell) {
  return layer == nullptr || layer->empty() ? 0.0 : std::max(0.0, static_cast<double>(layer->data()[cell]));
}

double change_m(const Before& before, const Eroded& after, size_t cell) {
  return static_cast<double>(after.terrain.data()[cell]) - static_cast<double>(before.terrain.data()[cell]);
}

/// Cells by change of height; without lines where nothing changed.
Plot change_plot(const Before& before, const Eroded& after, const RunContext& run) {
  constexpr int kBins = 60;
  Plot plot{PlotKind::histogram, "change of height (m)", "share of the cells", false, false, {{}}};
  double low = 0, high = 0;
  for (size_t i = 0; i < after.terrain.size(); ++i) {
    if (i % 65536 == 0) run.check_cancelled();
    low = std::min(low, change_m(before, after, i));
    high = std::max(high, change_m(before, after, i));
  }
  if (low >= high) return plot;
  const double width = (high - low) / kBins;
  PlotLine& line = plot.lines.front();
  line.y.assign(kBins, 0.0);
  for (int k = 0; k < kBins; ++k) line.x.push_back(low + (k + 0.5) * width);
  for (size_t i = 0; i < after.terrain.size(); ++i) {
    if (i % 65536 == 0) run.check_cancelled();
    const auto bin = static_cast<size_t>((change_m(before, after, i) - low) / width);
    line.y[std::min<size_t>(bin, kBins - 1)] += 1.0 / static_cast<double>(after.terrain.size());
  }
  return plot;
}

}  // namespace

Balance balance(const Before& before, const Eroded& after, const RunParams& params) {
  double sunk = 0, on_land = 0, under_water = 0;  // in metres times cells
  for (size_t i = 0; i < after.terrain.size(); ++i) {
    const double loose = thickness(&after.debris, i) + thickness(&after.sediment, i) - thickness(before.debris, i) -
                         thickness(before.sediment, i);
    const bool wet = static_cast<double>(after.terrain.data()[i]) < params.sea_m || after.lake.data()[i] > 0.0F;
    (wet ? under_water : on_land) += loose;
    sunk -= change_m(before, after, i);
  }
  const double area = after.terrain.cell_m() * after.terrain.cell_m();
  Balance volumes{.on_land = on_land * area,
                  .under_water = under_water * area,
                  .exported = after.ledger.exported,
                  .uplifted = after.ledger.uplifted,
                  .picked_up = after.ledger.eroded};
  const double gone = sunk * area + volumes.uplifted;  // from the map
  volumes.worn = gone + volumes.on_land + volumes.under_water;
  volumes.error = gone - volumes.exported;
  return volumes;
}

Report balance_report(const Before& before, const Eroded& after, const RunParams& params, const RunContext& run) {
  run.check_cancelled();
  const Balance volumes = balance(before, after, params);
  const double share = volumes.picked_up > 0 ? volumes.error / volumes.picked_up : 0.0;
  const auto measure = [](const char* name, double value) { return Measure{name, "m3", {value}}; };
  Descriptor mass{"balance",
                  "Mass balance",
                  "Bedrock worn is what now lies on land and under water as debris and sediment, more than before, and "
                  "what left over the border; the error is what rounding adds. The plot shows how far the ground rose "
                  "or sank.",
                  change_plot(before, after, run),
                  {measure("bedrock_worn", volumes.worn),
                   measure("deposited_on_land", volumes.on_land),
                   measure("deposited_under_water", volumes.under_water),
                   measure("left_over_border", volumes.exported),
                   measure("uplifted", volumes.uplifted),
                   measure("picked_up", volumes.picked_up),
                   measure("error", volumes.error),
                   {"error_of_picked_up", "", {share}}},
                  std::nullopt};
  return {"Erosion", {"terrain"}, {std::move(mass)}};
}

}  // namespace seamount::erosion
