// What every sketch must keep to, whatever the terrain.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "seamount/geom/grid/resample.h"
#include "seamount/geom/polygon/distance.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/ops/sketch/extract.h"
#include "seamount/ops/sketch/levelset.h"

namespace seamount::sketch {
namespace {

HeightField hills(int width, int height, uint64_t seed, float base = 400.0F, float relief = 500.0F) {
  HeightField terrain =
      geom::fbm_grid(GridFrame::centred(width, height, 30), Seed{seed}, {.wavelength_m = 2500, .octaves = 6}, {});
  for (float& z : terrain.cells()) z = base + relief * z;
  return terrain;
}

/// Sharp crests, as of a range: 1 - |noise|.
HeightField range(int width, int height, uint64_t seed) {
  HeightField terrain = hills(width, height, seed, 0.0F, 1.0F);
  for (float& z : terrain.cells()) z = 300.0F + 900.0F * (1.0F - std::abs(z));
  return terrain;
}

/// Hills in a sea that slopes away, with islets and inlets.
HeightField islands(int width, int height, uint64_t seed) {
  HeightField terrain = hills(width, height, seed, 0.0F, 400.0F);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      terrain(x, y) += 200.0F - 700.0F * static_cast<float>(std::hypot(x - 0.5 * width, y - 0.5 * height)) /
                                    static_cast<float>(std::min(width, height));
  return terrain;
}

struct Made {
  std::string name;
  HeightField terrain;
};

std::vector<Made> made_terrains() {
  std::vector<Made> out;
  for (const uint64_t seed : {1, 2, 3}) {
    const std::string name = " " + std::to_string(seed);
    out.push_back({"hills" + name, hills(256, 200, seed)});
    out.push_back({"range" + name, range(200, 300, seed)});
    out.push_back({"islands" + name, islands(300, 260, seed)});
    out.push_back({"wide" + name, hills(400, 37, seed)});
    out.push_back({"low" + name, hills(211, 256, seed, 30.0F, 60.0F)});
  }
  return out;
}

/// The vector graph of one of the two networks: ends that agree are one node.
class Graph {
 public:
  Graph(const Drawing& drawing, double value) {
    for (const ValuedLine& line : drawing.lines) {
      if (line.value != value) continue;
      const int a = node(line.points.front()), b = node(line.points.back());
      ++edges_;
      leader_[static_cast<size_t>(find(a))] = find(b);
    }
  }
  int independent_cycles() const {
    int pieces = 0;
    for (int i = 0; i < static_cast<int>(leader_.size()); ++i) pieces += find(i) == i ? 1 : 0;
    return edges_ - static_cast<int>(leader_.size()) + pieces;
  }
  std::map<int, std::vector<Vec2>> pieces() const {
    std::map<int, std::vector<Vec2>> out;
    for (const auto& [place, number] : nodes_) out[find(number)].push_back({place.first, place.second});
    return out;
  }

 private:
  int node(Vec2 place) {
    const auto [at, fresh] = nodes_.try_emplace({place.x, place.y}, static_cast<int>(leader_.size()));
    if (fresh) leader_.push_back(at->second);
    return at->second;
  }
  int find(int i) const {
    while (leader_[static_cast<size_t>(i)] != i) i = leader_[static_cast<size_t>(i)];
    return i;
  }
  std::map<std::pair<double, double>, int> nodes_;
  std::vector<int> leader_;
  int edges_ = 0;
};

/// Pieces (8-connected) less Euler's characteristic: the holes of a mask.
int holes(const Mask& mask) {
  const auto set = [&](int x, int y) { return mask.contains(x, y) && mask(x, y) > 0.0F ? 1 : 0; };
  int quads = 0;
  for (int y = -1; y < mask.height(); ++y) {
    for (int x = -1; x < mask.width(); ++x) {
      const int a = set(x, y), b = set(x + 1, y), c = set(x, y + 1), d = set(x + 1, y + 1), sum = a + b + c + d;
      quads += sum == 1 ? 1 : sum == 3 ? -1 : sum == 2 && a == d ? -2 : 0;
    }
  }
  int pieces = 0;
  Grid<uint8_t> seen(mask.frame(), 0);
  std::vector<std::pair<int, int>> stack;
  for (int y = 0; y < mask.height(); ++y) {
    for (int x = 0; x < mask.width(); ++x) {
      if (set(x, y) == 0 || seen(x, y) != 0) continue;
      ++pieces;
      seen(x, y) = 1;
      stack.assign(1, {x, y});
      while (!stack.empty()) {
        const auto [u, v] = stack.back();
        stack.pop_back();
        for (int dy = -1; dy <= 1; ++dy) {
          for (int dx = -1; dx <= 1; ++dx) {
            if (set(u + dx, v + dy) == 0 || seen(u + dx, v + dy) != 0) continue;
            seen(u + dx, v + dy) = 1;
            stack.emplace_back(u + dx, v + dy);
          }
        }
      }
    }
  }
  return pieces - quads / 4;
}

/// The edge, the sea, or a basin that is drawn, within a cell and its corner.
bool is_outlet(const HeightField& terrain, const Sketch& sketch, Vec2 place) {
  const int x = static_cast<int>(std::lround(terrain.frame().column(place.x))),
            y = static_cast<int>(std::lround(terrain.frame().row(place.y)));
  for (int v = y - 1; v <= y + 1; ++v)
    for (int u = x - 1; u <= x + 1; ++u)
      if (!terrain.contains(u, v) || !(terrain(u, v) > 0.0F)) return true;
  return std::any_of(sketch.lines.points.begin(), sketch.lines.points.end(), [&](const ValuedPoint& cue) {
    return cue.attributes.at(0).value > 0.5 &&
           std::hypot(cue.place.x - place.x, cue.place.y - place.y) < 2.0 * terrain.cell_m();
  });
}

TEST(SketchLaws, NothingGoesInCircles) {
  for (const Made& made : made_terrains()) {
    for (const std::optional<double> coarse_m : {std::optional<double>{}, std::optional<double>{30.0}}) {
      const Sketch sketch = extract(made.terrain, {.coarse_m = coarse_m}, Seed{7}, {});
      EXPECT_EQ(holes(sketch.river), 0) << made.name;
      EXPECT_EQ(holes(sketch.ridge), 0) << made.name;
      EXPECT_EQ(Graph(sketch.lines, 0.0).independent_cycles(), 0) << made.name;
      EXPECT_EQ(Graph(sketch.lines, 1.0).independent_cycles(), 0) << made.name;
    }
  }
}

TEST(SketchLaws, EveryRiverReachesAnOutlet) {
  int rivers = 0;
  for (const Made& made : made_terrains()) {
    const Sketch sketch = extract(made.terrain, {}, Seed{7}, {});
    for (const auto& [piece, ends] : Graph(sketch.lines, 0.0).pieces()) {
      ++rivers;
      EXPECT_TRUE(std::any_of(ends.begin(), ends.end(), [&](Vec2 end) { return is_outlet(made.terrain, sketch, end); }))
          << made.name << " at " << ends.front().x << ", " << ends.front().y;
    }
  }
  EXPECT_GT(rivers, 100);
}

TEST(SketchLaws, RiversOfAClosedBasinEndInItsCue) {
  // A crater without a way out: a bowl with gullies.
  HeightField terrain = hills(200, 200, 4, 0.0F, 150.0F);
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 200; ++x)
      terrain(x, y) += 500.0F + 6.0F * std::min(90.0F, static_cast<float>(std::hypot(x - 90, y - 105)));
  const Sketch sketch = extract(terrain, {.leave = 0.0}, Seed{1}, {});
  int in_cue = 0;
  for (const auto& [piece, ends] : Graph(sketch.lines, 0.0).pieces()) {
    EXPECT_TRUE(std::any_of(ends.begin(), ends.end(), [&](Vec2 end) { return is_outlet(terrain, sketch, end); }));
    for (const Vec2 end : ends)
      for (const ValuedPoint& cue : sketch.lines.points)
        in_cue += std::hypot(cue.place.x - end.x, cue.place.y - end.y) < 60.0 ? 1 : 0;
  }
  EXPECT_GE(in_cue, 1);
  EXPECT_EQ(sketch.lines.points.at(0).attributes.at(0).value, 1.0);
}

TEST(SketchLaws, NothingIsDrawnWhereThereIsNoRelief) {
  for (const float base : {3.0F, 100.0F}) {
    for (const uint64_t seed : {1, 2, 3}) {
      HeightField plain = hills(300, 240, seed, base, 1.5F);
      for (float& z : plain.cells()) z = std::max(1.0F, std::round(z));
      const Sketch sketch = extract(plain, {}, Seed{seed}, {});
      EXPECT_TRUE(sketch.lines.lines.empty()) << base << ' ' << seed;
      EXPECT_TRUE(sketch.lines.points.empty()) << base << ' ' << seed;
    }
  }
  HeightField level(GridFrame::centred(64, 50, 10), 12.0F);
  EXPECT_TRUE(extract(level, {}, Seed{1}, {}).lines.lines.empty());
  // A slope that is a plane.
  for (int y = 0; y < 50; ++y)
    for (int x = 0; x < 64; ++x) level(x, y) = 100.0F + 3.0F * static_cast<float>(x) + static_cast<float>(y);
  EXPECT_TRUE(extract(level, {.ridges = false}, Seed{1}, {}).lines.lines.empty());
}

TEST(SketchLaws, NothingBeginsOnALake) {
  for (const uint64_t seed : {5, 6, 7}) {
    HeightField terrain = hills(300, 300, seed);
    const auto from_shore = [](double x, double y) { return std::hypot(x - 140, y - 150) - 60.0; };
    for (int y = 0; y < 300; ++y) {
      for (int x = 0; x < 300; ++x) {
        const auto rim = static_cast<float>(std::clamp(from_shore(x, y) / 40.0, 0.0, 1.0));
        terrain(x, y) = 150.0F + std::max(0.0F, terrain(x, y)) * rim;
      }
    }
    const Sketch sketch = extract(terrain, {}, Seed{1}, {});
    std::map<std::pair<double, double>, int> arriving;
    for (const ValuedLine& line : sketch.lines.lines) ++arriving[{line.points.back().x, line.points.back().y}];
    int on_lake = 0;
    for (const ValuedLine& line : sketch.lines.lines) {
      const Vec2 head = line.points.front();
      const double shore = from_shore(terrain.frame().column(head.x), terrain.frame().row(head.y));
      on_lake += shore < -8.0 && arriving[{head.x, head.y}] == 0 ? 1 : 0;
    }
    EXPECT_EQ(on_lake, 0) << seed;
    int ridge = 0;
    for (int y = 0; y < 300; ++y)
      for (int x = 0; x < 300; ++x) ridge += from_shore(x, y) < -8.0 && sketch.ridge(x, y) > 0.0F ? 1 : 0;
    EXPECT_EQ(ridge, 0) << seed;
  }
}

TEST(SketchLaws, NothingIsDrawnOnTheUnknown) {
  for (const uint64_t seed : {1, 2, 3}) {
    for (const bool sea : {true, false}) {
      HeightField terrain = hills(220, 200, seed);
      for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 220; ++x)
          if (std::hypot(x - 120, y - 100) > 85 || std::hypot(x - 90, y - 90) < 12) terrain(x, y) = NAN;
      const Sketch sketch = extract(terrain, {.sea = sea}, Seed{seed}, {});
      int lines = 0;
      for (size_t i = 0; i < terrain.size(); ++i) {
        const bool drawn = sketch.river.data()[i] + sketch.ridge.data()[i] > 0.0F;
        ASSERT_FALSE(drawn && std::isnan(terrain.data()[i]));
        ASSERT_TRUE(std::isfinite(sketch.altitude_m.data()[i]));
        lines += drawn ? 1 : 0;
      }
      EXPECT_GT(lines, 200);
      for (const auto& [piece, ends] : Graph(sketch.lines, 0.0).pieces()) {
        EXPECT_TRUE(std::any_of(ends.begin(), ends.end(), [&](Vec2 end) { return is_outlet(terrain, sketch, end); }));
      }
      for (const ValuedPoint& cue : sketch.lines.points) EXPECT_TRUE(std::isfinite(cue.value));
      const Levelset high = levelset(terrain, {.sea = sea}, {});
      for (size_t i = 0; i < terrain.size(); ++i)
        ASSERT_FALSE(high.mask.data()[i] > 0.0F && std::isnan(terrain.data()[i]));
      EXPECT_TRUE(std::isfinite(high.level_m));
    }
  }
}

TEST(SketchLaws, StrokesDoNotKnowTheGrid) {
  constexpr double kChord = 10.0, kNear = 5.0;  // cells, degrees
  for (const double value : {0.0, 1.0}) {
    int near = 0, on_axis = 0, all = 0;
    for (uint64_t seed = 1; seed <= 6; ++seed) {
      const HeightField terrain = seed % 2 == 0 ? range(700, 700, seed) : hills(700, 700, seed);
      const Sketch sketch = extract(terrain, {.coarse_m = 150}, Seed{seed}, {});
      for (const ValuedLine& line : sketch.lines.lines) {
        if (line.value != value) continue;
        Vec2 from = line.points.front();
        for (size_t i = 1; i < line.points.size(); ++i) {
          const Vec2 step = line.points[i] - from;
          if (std::sqrt(dot(step, step)) < kChord * terrain.cell_m()) continue;
          // The last point may lie far along the line: back to where the chord has its length.
          const Vec2 a = line.points[i - 1], along = line.points[i] - a;
          double low = 0.0, high = 1.0;
          for (int k = 0; k < 40; ++k) {
            const double t = 0.5 * (low + high);
            const Vec2 there = a + t * along - from;
            (std::sqrt(dot(there, there)) < kChord * terrain.cell_m() ? low : high) = t;
          }
          const Vec2 to = a + high * along, chord = to - from;
          const double deg = std::atan2(chord.y, chord.x) * 180.0 / std::numbers::pi + 360.0;
          const double off_any = std::abs(std::fmod(deg + 22.5, 45.0) - 22.5),
                       off_axis = std::abs(std::fmod(deg + 45.0, 90.0) - 45.0);
          near += off_any < kNear ? 1 : 0;
          on_axis += off_axis < kNear ? 1 : 0;
          ++all;
          from = to;
          --i;
        }
      }
    }
    EXPECT_GT(all, 800);
    EXPECT_LT(static_cast<double>(near) / all, 1.3 * 2.0 * kNear / 45.0) << value;
    EXPECT_LT(static_cast<double>(on_axis) / all, 1.3 * 2.0 * kNear / 90.0) << value;
  }
}

TEST(SketchLaws, MasksImageAndLinesAgree) {
  for (const Made& made : made_terrains()) {
    const Sketch sketch = extract(made.terrain, {.cues = false}, Seed{2}, {});
    for (const double value : {0.0, 1.0}) {
      const Mask& mask = value == 0.0 ? sketch.river : sketch.ridge;
      Grid<uint8_t> drawn(mask.frame());
      for (size_t i = 0; i < mask.size(); ++i) {
        drawn.data()[i] = mask.data()[i] > 0.0F ? 1 : 0;
        ASSERT_EQ(sketch.image.rgb[3 * i + (value == 0.0 ? 2 : 0)], mask.data()[i] > 0.0F ? 255 : 0);
      }
      std::vector<Polyline> lines;
      for (const ValuedLine& line : sketch.lines.lines)
        if (line.value == value) lines.push_back(line.points);
      const ScalarField from_line = geom::distance_to_lines(lines, mask.frame(), {});
      for (size_t i = 0; i < mask.size(); ++i) {
        ASSERT_TRUE(mask.data()[i] == 0.0F || static_cast<double>(from_line.data()[i]) < 1.5 * made.terrain.cell_m())
            << made.name;
      }
      for (const Polyline& line : lines) {
        ASSERT_GE(line.size(), 2U);
        for (const Vec2 place : line) {
          const int x = static_cast<int>(std::lround(mask.frame().column(place.x))),
                    y = static_cast<int>(std::lround(mask.frame().row(place.y)));
          ASSERT_TRUE(mask.contains(x, y) && mask(x, y) > 0.0F) << made.name;
        }
      }
    }
  }
}

TEST(SketchLaws, GreenTellsTheHeight) {
  for (const uint64_t seed : {1, 2, 3}) {
    const HeightField terrain = hills(256, 256, seed);
    const Sketch sketch = extract(terrain, {}, Seed{seed}, {});
    ASSERT_GT(sketch.lines.points.size(), 3U);
    double lowest = 1e9, highest = -1e9;
    for (const ValuedPoint& cue : sketch.lines.points) {
      lowest = std::min(lowest, cue.value);
      highest = std::max(highest, cue.value);
    }
    EXPECT_EQ(sketch.lowest_cue_m, lowest);
    EXPECT_EQ(sketch.highest_cue_m, highest);
    std::vector<int> greens;
    for (size_t i = 0; i < terrain.size(); ++i)
      if (const int green = sketch.image.rgb[3 * i + 1]; green != 0) greens.push_back(green);
    EXPECT_EQ(*std::min_element(greens.begin(), greens.end()), 32);
    EXPECT_EQ(*std::max_element(greens.begin(), greens.end()), 255);
    for (const ValuedPoint& cue : sketch.lines.points) {
      ASSERT_EQ(cue.attributes.at(1).name, "green");
      const double back = lowest + (cue.attributes.at(1).value - 32.0) / 223.0 * (highest - lowest);
      EXPECT_NEAR(back, cue.value, (highest - lowest) / 440.0);
    }
  }
}

}  // namespace
}  // namespace seamount::sketch
