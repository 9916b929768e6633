// What every operator claims of how far it looks, held against a run of the whole: equal bytes, cell by cell, for tiles
// of odd sizes on a frame whose cells and corner are no round numbers.
#include <gtest/gtest.h>

#include <cstring>
#include <set>

#include "seamount/geom/scalar/noise.h"
#include "seamount/recipe/kinds.h"
#include "seamount/recipe/registry.h"
#include "seamount/tiles/layout.h"
#include "seamount/tiles/tiled_ways.h"
#include "seamount/tiles/windows.h"

namespace seamount::tiles {
namespace {

using recipe::Json, recipe::Operator, recipe::Value, recipe::Values;
namespace kinds = recipe::kinds;

struct Case {
  const char* op;
  const char* params;
  bool local = true;
};

// clang-format off
const std::vector<Case> kCases = {
    {"terrain.noise", R"({"kind": "smooth"})"},
    {"terrain.noise", R"({"kind": "ridged", "wavelength_m": 900, "octaves": 12})"},
    {"terrain.noise", R"({"kind": "mountains", "wavelength_m": 4600})"},
    {"terrain.noise", R"({"kind": "mountains", "wavelength_m": 700, "gain": 0.7})"},
    {"terrain.smooth", R"({"radius_m": 200})"},
    {"terrain.smooth", R"({"radius_m": 10, "strength": -1.5})"},
    {"terrain.smooth", R"({"radius_m": 1000, "strength": 0.4})"},
    {"terrain.terrace", "{}"},
    {"terrain.blend", R"({"mode": "max", "smooth_m": 30})"},
    {"terrain.blend", R"({"mode": "add", "strength": 0.3})"},
    {"terrain.mask", "{}"},
    {"terrain.mask", R"({"criteria": [{"tool": "height", "low_m": 20}, {"tool": "noise"}, {"tool": "value", "low": 0.4, "falloff": 0.2}]})"},
    {"terrain.mask", R"({"criteria": [{"tool": "slope", "low_deg": 10, "scale_m": 0}]})"},
    {"terrain.mask", R"({"criteria": [{"tool": "slope", "low_deg": 4, "scale_m": 31}]})"},
    {"terrain.mask", R"({"criteria": [{"tool": "slope", "low_deg": 2, "scale_m": 500}, {"tool": "aspect", "scale_m": 90}]})"},
    {"terrain.mask", R"({"criteria": [{"tool": "curvature", "scale_m": 200}], "low": 1, "high": 7})"},
    {"terrain.mask", R"({"criteria": [{"tool": "curvature", "bend": "plan", "scale_m": 700}], "invert": true})"},
    {"terrain.mask", R"({"criteria": [{"tool": "region", "region": "reef", "low_m": -90, "high_m": 200, "falloff_m": 400}]})"},
    {"terrain.mask", R"({"criteria": [{"tool": "area", "falloff_m": 900}], "combine": "min"})"},
    {"terrain.mask", R"({"criteria": [{"tool": "line", "falloff_m": 2000}], "combine": "max"})"},
    {"terrain.mask", R"({"criteria": [{"tool": "depth"}]})", false},
    {"terrain.layers", R"({"low_m": -20, "low_error_m": 30, "high_m": 60, "high_error_m": 20, "variation": 0})"},
    {"terrain.layers", R"({"low_m": -20, "low_error_m": 30, "high_m": 60, "high_error_m": 20, "variation": 0.7})"},
    {"terrain.layers", "{}"},
    {"render.layers", R"({"layers": {"low_m": -20, "low_error_m": 30, "high_m": 60, "high_error_m": 20, "variation": 0}})"},
    {"render.layers", R"({"style": "volcano"})"},
    {"render.layers", R"({"style": "great_barrier_reef", "layers": {"high_error_m": 9}})"},
    {"terrain.sculpt", R"({"strokes": [
      {"tool": "raise", "points": [[-9000, 8000], [100.5, 3000], [9500, 8200], [20000, 9999]], "radius_m": 900, "height_m": 120, "pressure": [0.2, 1, 0.7, 0.4]},
      {"tool": "roughen", "points": [[-9000, 1000], [9000, 3000]], "radius_m": 2500, "amplitude_m": 60, "wavelength_m": 700},
      {"tool": "flatten", "points": [[-5000, 5000]], "radius_m": 1500, "height_m": 30},
      {"tool": "ramp", "points": [[-3000, -5000], [6000.3, -2000]], "radius_m": 700, "start_m": 10, "end_m": 90, "hardness": 0.3},
      {"tool": "lower", "points": [[0, 0], [0.1, 0.1]], "radius_m": 4},
      {"tool": "erase", "points": [[-7000, 7000], [3000, -7000]], "radius_m": 400, "strength": 0.8}]})"},
    {"terrain.sculpt", R"({"strokes": [{"tool": "smooth", "points": [[0, 0]]}]})", false},
    {"terrain.sculpt", R"({"strokes": [{"tool": "ramp", "points": [[0, 0]], "start_m": 3}]})", false},
    {"terrain.paint", R"({"strokes": [
      {"tool": "brush", "points": [[-9000, 8000], [100.5, 3000], [9500, 8200]], "radius_m": 1900, "value": 0.7, "opacity": 0.9},
      {"tool": "area", "polygons": [[[-6000, -4000], [3000, -7000.5], [5000, 6000]]], "value": -2, "opacity": 0.6, "feather_m": 800},
      {"tool": "area", "polygons": [[[-9500, -8000], [-7000, -8000], [-7500, 9000]]], "value": 5},
      {"tool": "erase", "points": [[-7000, 7000], [3000, -7000]], "radius_m": 600}]})"},
    {"terrain.paint", R"({"base": 3, "unknown": true, "strokes": [{"tool": "brush", "points": [[-2000, 0], [0, 900]], "radius_m": 900}]})"},
    {"classify.paint", R"({"strokes": [
      {"tool": "region", "region": "beach", "points": [[-9000, 8000], [100.5, 3000], [9500, 8200]], "radius_m": 1900},
      {"tool": "area", "region": "reef", "polygons": [[[-6000, -4000], [3000, -7000.5], [5000, 6000]]]},
      {"tool": "sink", "points": [[-4000, 4000], [0, 0], [1000, 6000]], "radius_m": 2500, "subsidence": 0.6},
      {"tool": "erase", "points": [[-7000, 7000], [3000, -7000]], "radius_m": 600}]})"},
    {"terrain.compose", R"({"places": [[900, -700], [4000, 2500], [-5200, 1500]], "turns_deg": [0, 40, 111], "scales": [0.7, 1.1, 0.9], "raises_m": [5], "outside_m": -40})"},
    {"terrain.compose", R"({"places": [[900, -700]]})", false},
    {"terrain.compose", R"({"outside_m": 3})", false},
    {"terrain.resample", R"({"centre": false, "beyond": "edge"})"},
    {"terrain.resample", R"({"centre": false, "beyond": "edge", "scale": 1.7})"},
    {"terrain.resample", "{}", false},
    {"erosion.refine", R"({"gather_cells": 8, "sea_m": -20})"},
    {"island.archipelago", R"({"places": [[900, -700], [4000, 2500], [-5200, 1500]], "turns_deg": [0, 40, 111], "scales": [0.7, 1.1, 0.9]})"},
};
// clang-format on

/// Larger than what is looked at, so that something is left to go wrong.
GridFrame wide_frame() { return {701, 523, 30.87, -9876.54321, 8765.4321, {}}; }

HeightField hills(const GridFrame& frame, uint64_t seed) {
  HeightField made = geom::fbm_grid(frame, Seed{seed}, {.wavelength_m = 2600, .cell_m = frame.cell_m}, {});
  for (float& z : made.cells()) z *= 300.0F;
  return made;
}

LabelMap regions(const HeightField& terrain) {
  LabelMap labels(terrain.frame());
  for (size_t i = 0; i < labels.size(); ++i) {
    const float z = terrain.cells()[i];
    labels.cells()[i] = z > 10 ? Region::mountain : z > 0 ? Region::beach : z > -40 ? Region::lagoon : Region::reef;
  }
  return labels;
}

seamount::Drawing drawing() {
  seamount::Drawing made;
  made.areas = {{"park", {{{{-4000, -3000}, {2500.5, -4000}, {5000, 1000}, {-1000, 4444}}, {}}}}};
  made.lines = {{{{-9000, 4000}, {-100, 30}, {9000, -5000}}, 0, false}};
  return made;
}

/// A value for every input, on `frame`; what is laid on the domain has cells of its own.
Values inputs_of(const Operator& op, const GridFrame& frame) {
  const bool own_cells =
      op.name == "island.archipelago" || op.name == "terrain.resample" || op.name == "terrain.compose";
  const HeightField terrain = hills(own_cells ? GridFrame::centred(160, 150, 41.7) : frame, 1);
  // Of what was eroded: a little smaller than the terrain, so that it has to go on.
  const GridFrame large{std::max(1, frame.width / 5),
                        std::max(1, frame.height / 5),
                        4.9 * frame.cell_m,
                        frame.west_m + 7.7,
                        frame.north_m,
                        {}};
  const bool coarse = op.name == "erosion.refine";
  Values in;
  uint64_t seed = 7;
  for (const recipe::Port& port : op.in) {
    if (own_cells && port.name.find('_') != std::string::npos) continue;  // copies of the first
    if (port.kind == &kinds::Labels::kind()) in[port.name] = Value::of<kinds::Labels>(regions(terrain));
    if (port.kind == &kinds::Drawing::kind()) in[port.name] = Value::of<kinds::Drawing>(drawing());
    if (port.kind == &kinds::Terrain::kind())
      in[port.name] = Value::of<kinds::Terrain>(port.name == "terrain" ? terrain : hills(coarse ? large : frame, 2));
    if (port.kind != &kinds::Field::kind()) continue;
    ScalarField field = geom::fbm_grid(coarse ? large : frame, Seed{seed++}, {.wavelength_m = 1500}, {});
    for (float& v : field.cells()) v = (0.8F + v) * (port.name == "flow" ? 1e6F : 1.0F);
    in[port.name] = Value::of<kinds::Field>(std::move(field));
  }
  return in;
}

/// One way of cutting and a case: the outputs of the tile from a window that looks `reach` far.
class Trial {
 public:
  Trial(const Case& given, const GridFrame& frame)
      : op_(*recipe::standard_registry().find_operator(given.op)), frame_(frame), in_(inputs_of(op_, frame)) {
    recipe::Diagnostics diagnostics;
    params_ = op_.complete(Json::parse(given.params), {"", diagnostics});
    EXPECT_TRUE(diagnostics.empty()) << given.params;
    settled_ = params_;
    if (op_.settled && !op_.reach(params_, frame.cell_m).local()) {
      const auto cells = in_.at("terrain").get<kinds::Terrain>().cells();
      const auto [low, high] = std::minmax_element(cells.begin(), cells.end());
      settled_ = op_.settled(params_, *low, *high);
    }
    whole_ = op_.run(params_, in_, {frame_, true, Seed{5}, folder_, {}});
  }

  Reach reach() const { return op_.reach(settled_, frame_.cell_m); }
  const Values& whole() const { return whole_; }

  Values tile(const Rect& rect, const Reach& reach) const {
    const Rect run_on = with_reach(rect, reach, frame_);
    Values in;
    for (const auto& [name, value] : in_) {
      const recipe::Port& port = *op_.find_in(name);
      const bool cut = is_raster(value.kind()) && port.placing == recipe::Placing::cells;
      in[name] = cut ? window_of(value, run_on) : value;
    }
    const GridFrame domain = frame_.window(run_on.column, run_on.row, run_on.width, run_on.height);
    Values out = op_.run(settled_, in, {domain, true, Seed{5}, folder_, {}, &frame_});
    for (auto& [name, value] : out)
      value = window_of(value, {rect.column - run_on.column, rect.row - run_on.row, rect.width, rect.height});
    return out;
  }

 private:
  const Operator& op_;
  GridFrame frame_;
  Values in_, whole_;
  Json params_, settled_;
  std::string folder_;
};

bool same_bytes(const Value& a, const Value& b) {
  const size_t bytes = static_cast<size_t>(a.frame()->cells()) * cell_bytes(a.kind());
  return a.frame()->cells() == b.frame()->cells() && std::memcmp(cells_of(a), cells_of(b), bytes) == 0;
}

/// The first tile that differs; -1 if none does.
int first_difference(const Trial& trial, const Reach& reach, const GridFrame& frame, int size) {
  const Layout layout(frame, size);
  for (int i = 0; i < layout.count(); ++i) {
    const Rect rect = layout.tile(i);
    for (const auto& [name, value] : trial.tile(rect, reach)) {
      if (!same_bytes(value, window_of(trial.whole().at(name), rect))) return i;
    }
  }
  return -1;
}

class ReachTest : public ::testing::TestWithParam<Case> {};

TEST_P(ReachTest, TilesHaveTheBytesOfTheWhole) {
  const GridFrame frame = wide_frame();
  const Trial trial(GetParam(), frame);
  const Reach reach = trial.reach();
  ASSERT_EQ(reach.local(), GetParam().local);
  if (!reach.local()) {
    EXPECT_FALSE(reach.why.empty());
    return;
  }
  ASSERT_LT(reach.cells, frame.height / 2) << "the frame is too small to show anything";
  for (const int size : {701, 333, 128, 97}) {
    if (size < 128 && reach.cells > 150) continue;  // most of the time would go into what lies around them
    EXPECT_EQ(first_difference(trial, reach, frame, size), -1) << GetParam().params << " in tiles of " << size;
  }
}

TEST_P(ReachTest, RoundAndTinyRastersToo) {
  if (!GetParam().local) return;
  for (const auto& [width, height] : {std::pair{64, 50}, {1, 17}, {29, 1}, {1, 1}}) {
    const GridFrame frame = GridFrame::centred(width, height, 50.0);
    const Trial trial(GetParam(), frame);
    for (const int size : {16, 5})
      EXPECT_EQ(first_difference(trial, trial.reach(), frame, size), -1) << width << " x " << height;
  }
}

/// A test that cannot fail is no test: what looks at a neighbourhood differs without it.
TEST_P(ReachTest, ANeighbourhoodIsNeeded) {
  const GridFrame frame = wide_frame();
  const Trial trial(GetParam(), frame);
  if (trial.reach().of != Reach::Of::neighbourhood || trial.reach().cells < 2) return;
  EXPECT_NE(first_difference(trial, Reach::neighbourhood(0, trial.reach().step), frame, 128), -1);
}

std::string case_name(const ::testing::TestParamInfo<Case>& info) {
  std::string name = info.param.op;
  std::replace(name.begin(), name.end(), '.', '_');
  return name + "_" + std::to_string(info.index);
}

INSTANTIATE_TEST_SUITE_P(Operators, ReachTest, ::testing::ValuesIn(kCases), case_name);

TEST(Reaches, EveryClaimHasACase) {
  std::set<std::string> tried;
  for (const Case& one : kCases) {
    if (one.local) tried.insert(one.op);
  }
  for (const auto& op : recipe::standard_registry().operators())
    EXPECT_EQ(op->reach != nullptr, tried.contains(op->name)) << op->name;
}

TEST(Reaches, WhatHasAWayOfItsOwnInTilesSaysSo) {
  for (const auto& op : recipe::standard_registry().operators()) {
    recipe::Step step;
    step.op = op.get();
    EXPECT_EQ(find_tiled_way(step) != nullptr, !op->in_tiles.empty()) << op->name;
  }
}

TEST(WithReach, BeginsAtASteppedCellAndStaysWithin) {
  const GridFrame frame = GridFrame::centred(1000, 400, 10.0);
  EXPECT_EQ(with_reach({300, 100, 50, 60}, Reach::place(), frame), (Rect{300, 100, 50, 60}));
  EXPECT_EQ(with_reach({300, 100, 50, 60}, Reach::neighbourhood(10, 16), frame), (Rect{288, 80, 72, 90}));
  EXPECT_EQ(with_reach({5, 100, 990, 300}, Reach::neighbourhood(10), frame), (Rect{0, 90, 1000, 310}));
}

TEST(Window, HasThePositionsOfTheWholeToTheBit) {
  const GridFrame whole{5000, 4000, 0.1, -1234.567, 89.1011, "EPSG:32627"};
  const GridFrame part = whole.window(1234, 999, 100, 50), inner = part.window(10, 7, 20, 9);
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(inner.x(i), whole.x(1244 + i));
    EXPECT_EQ(inner.y(i), whole.y(1006 + i));
    EXPECT_EQ(inner.column(whole.x(1244 + i)), whole.column(whole.x(1244 + i)) - 1244);
  }
  EXPECT_EQ(inner.first_column(), 1244);
  EXPECT_EQ(inner.in_whole().x(0), whole.x(0));
  GridFrame moved = part;  // who moves or coarsens a window has a raster of its own
  moved.west_m += 7;
  EXPECT_FALSE(moved.is_window());
  EXPECT_EQ(moved.x(0), moved.west_m + 0.05);
}

}  // namespace
}  // namespace seamount::tiles
