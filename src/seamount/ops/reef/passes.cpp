#include "seamount/ops/reef/passes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "seamount/geom/polygon/distance.h"
#include "seamount/geom/scalar/blend.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/model/drawn.h"
#include "seamount/ops/reef/regions.h"

namespace seamount::reef {
namespace {

constexpr std::array<int, 8> kStepX = {1, -1, 0, 0, 1, 1, -1, -1}, kStepY = {0, 0, 1, -1, 1, -1, 1, -1};
constexpr int kStraight = 5, kDiagonal = 7;  // lengths of steps
constexpr int kDearest = 60;                 // of a cell
constexpr Seed kWalls{17};                   // of noise in a place: whatever the reef, it bends walls alike
constexpr float kDeeper_m = 6.5F;            // sills to be cut once all water reaches the sea somehow
constexpr float kBelow = 1.5F;               // passes are that many times deeper than the water that is sought
constexpr int32_t kUnreached = 1 << 30;

/// Cheapest ways of all cells to the open sea: Dijkstra with whole costs in buckets (Dial 1969).
class Ways {
 public:
  /// price: of a cell, 1 ... kDearest, 0 where no way leads; ends: the open sea.
  Ways(const Grid<uint8_t>& price, const std::vector<int64_t>& ends) : width_(price.width()) {
    cost_ = Grid<int32_t>(price.frame(), kUnreached);
    next_ = Grid<uint8_t>(price.frame(), kEnd);
    std::vector<std::vector<int64_t>> buckets(static_cast<size_t>(kDearest * kDiagonal) + 1);
    for (const int64_t i : ends) cost_.cells()[static_cast<size_t>(i)] = 0;
    buckets[0] = ends;
    auto waiting = static_cast<int64_t>(ends.size());
    for (int32_t cost = 0; waiting > 0; ++cost) {
      std::vector<int64_t>& bucket = buckets[static_cast<size_t>(cost) % buckets.size()];
      for (size_t k = 0; k < bucket.size(); ++k) {
        const int64_t i = bucket[k];
        --waiting;
        if (cost_.cells()[static_cast<size_t>(i)] != cost) continue;
        const auto x = static_cast<int>(i % width_), y = static_cast<int>(i / width_);
        for (size_t s = 0; s < kStepX.size(); ++s) {
          const int nx = x + kStepX[s], ny = y + kStepY[s];
          if (!price.contains(nx, ny) || price(nx, ny) == 0) continue;
          const int32_t there = cost + price(nx, ny) * (s < 4 ? kStraight : kDiagonal);
          if (there >= cost_(nx, ny)) continue;
          cost_(nx, ny) = there;
          next_(nx, ny) = static_cast<uint8_t>(s);
          buckets[static_cast<size_t>(there) % buckets.size()].push_back(static_cast<int64_t>(ny) * width_ + nx);
          ++waiting;
        }
      }
      bucket.clear();
    }
  }

  int32_t cost(int64_t cell) const { return cost_.cells()[static_cast<size_t>(cell)]; }

  /// Cells from one to the open sea.
  std::vector<int64_t> from(int64_t cell) const {
    std::vector<int64_t> way = {cell};
    for (uint8_t s = next_.cells()[static_cast<size_t>(cell)]; s != kEnd;
         s = next_.cells()[static_cast<size_t>(cell)]) {
      cell -= static_cast<int64_t>(kStepY[s]) * width_ + kStepX[s];
      way.push_back(cell);
    }
    return way;
  }

 private:
  static constexpr uint8_t kEnd = 255;
  int width_;
  Grid<int32_t> cost_;
  Grid<uint8_t> next_;  ///< the step that led here, against the way
};

/// How a lagoon of that size drains.
struct Channel {
  double half_width_m, depth_m;
};

Channel channel_of(double km2, const PassParams& p, double least_half_m) {
  const double size = std::sqrt(km2);
  const double width = p.width_m.value_or(std::clamp(90.0 + 55.0 * size, 100.0, 1000.0));
  return {std::max(0.5 * width, least_half_m), p.depth_m.value_or(std::clamp(8.0 + 9.0 * size, 10.0, 60.0))};
}

/// The middle of a way with its corners rounded off over `radius` cells.
std::vector<Vec2> smoothed(const std::vector<int64_t>& way, const GridFrame& f, int radius) {
  const auto place = [&](int64_t cell) {
    return Vec2{f.x(static_cast<int>(cell % f.width)), f.y(static_cast<int>(cell / f.width))};
  };
  const auto last = static_cast<int>(way.size()) - 1;
  std::vector<Vec2> line;
  for (int i = 0; i <= last; ++i) {
    const int reach = std::min({radius, i, last - i});
    Vec2 sum;
    for (int k = i - reach; k <= i + reach; ++k) sum = sum + place(way[static_cast<size_t>(k)]);
    line.push_back((1.0 / (2 * reach + 1)) * sum);
  }
  return line;
}

/// Digs around a place: depth_m in the middle, uneven walls at the sides.
void dig(ScalarField& passes, Vec2 at, double half_width_m, double depth_m) {
  const GridFrame& f = passes.frame();
  const double reach = 2.0 * half_width_m;
  const geom::Fbm walls{.wavelength_m = 1.5 * half_width_m, .octaves = 3, .cell_m = f.cell_m};
  const int west = std::max(0, static_cast<int>(f.column(at.x - reach)));
  const int east = std::min(f.width - 1, static_cast<int>(f.column(at.x + reach)) + 1);
  const int north = std::max(0, static_cast<int>(f.row(at.y + reach)));
  const int south = std::min(f.height - 1, static_cast<int>(f.row(at.y - reach)) + 1);
  for (int y = north; y <= south; ++y) {
    for (int x = west; x <= east; ++x) {
      const Vec2 d = Vec2{f.x(x), f.y(y)} - at;
      const double bent = 1.0 - 0.5 * geom::fbm(kWalls, walls, f.x(x), f.y(y));
      const double from_middle = bent * std::sqrt(dot(d, d)) / half_width_m;
      const double depth = depth_m * (1.0 - geom::smoothstep((from_middle - 0.55) / 0.95));
      passes(x, y) = std::max(passes(x, y), static_cast<float>(depth));
    }
  }
}

/// What the ways to the sea are sought on.
struct Waters {
  Grid<uint8_t> clear;       ///< deep and wide enough to pass
  Grid<uint8_t> shut;        ///< deep water from which no clear way leads to the sea
  ScalarField room;          ///< metres to the nearest shoal
  std::vector<int64_t> sea;  ///< clear water that reaches the edge or unknown ground
  double half_m = 0.0;       ///< of the narrowest way
};

/// Marks the water that `from` reaches in `within`, `steps` cells far at most.
void spread(std::vector<int64_t> from, const Grid<uint8_t>& within, int steps, Grid<uint8_t>& reached) {
  const int width = within.width(), height = within.height();
  std::vector<int64_t> next;
  for (; !from.empty() && steps > 0; --steps) {
    next.clear();
    for (const int64_t i : from) {
      const auto x = static_cast<int>(i % width), y = static_cast<int>(i / width);
      for (size_t s = 0; s < 4; ++s) {
        const int nx = x + kStepX[s], ny = y + kStepY[s];
        if (nx < 0 || ny < 0 || nx >= width || ny >= height || within(nx, ny) == 0 || reached(nx, ny) != 0) continue;
        reached(nx, ny) = 1;
        next.push_back(static_cast<int64_t>(ny) * width + nx);
      }
    }
    std::swap(from, next);
  }
}

Waters find_waters(const HeightField& reef, float depth_m, double cell_m, const RunContext& run) {
  const GridFrame& f = reef.frame();
  Waters out{Grid<uint8_t>(f, 0), Grid<uint8_t>(f, 0), {}, {}, std::max({1.5 * f.cell_m, 1.1 * cell_m, 25.0})};
  Grid<uint8_t> shoal(f, 0), wet(f, 0), open(f, 0);
  for (size_t i = 0; i < shoal.size(); ++i) {
    shoal.cells()[i] = reef.cells()[i] > -depth_m ? 1 : 0;  // unknown ground is none
    wet.cells()[i] = 1 - shoal.cells()[i];
  }
  out.room = geom::distance_to(shoal, run);
  std::vector<int64_t> sea;
  for (int y = 0; y < f.height; ++y) {
    for (int x = 0; x < f.width; ++x) {
      if (static_cast<double>(out.room(x, y)) <= out.half_m) continue;
      out.clear(x, y) = 1;
      const bool edge = x == 0 || y == 0 || x == f.width - 1 || y == f.height - 1;
      if (!edge && !std::isnan(reef(x, y))) continue;
      open(x, y) = 1;
      sea.push_back(static_cast<int64_t>(y) * f.width + x);
    }
  }
  spread(sea, out.clear, std::numeric_limits<int>::max(), open);
  // Shallow bights and the water along shoals belong to what they adjoin.
  for (size_t i = 0; i < open.size(); ++i)
    if (open.cells()[i] != 0) out.sea.push_back(static_cast<int64_t>(i));
  std::vector<int64_t> rim = out.sea;
  for (int x = 0; x < f.width; ++x) rim.push_back(x), rim.push_back(static_cast<int64_t>(f.height - 1) * f.width + x);
  for (int y = 0; y < f.height; ++y)
    rim.push_back(static_cast<int64_t>(y) * f.width), rim.push_back(static_cast<int64_t>(y) * f.width + f.width - 1);
  Grid<uint8_t> near = open;
  spread(std::move(rim), wet, static_cast<int>(std::ceil(1.5 * out.half_m / f.cell_m)) + 1, near);
  for (size_t i = 0; i < open.size(); ++i) out.shut.cells()[i] = wet.cells()[i] != 0 && near.cells()[i] == 0 ? 1 : 0;
  return out;
}

/// Price of passing a cell: thick reefs, their windward sides and high ground are dear; 0: no way.
Grid<uint8_t> price_of(const HeightField& ground, const ScalarField& exposure, const Waters& waters, float depth_m) {
  Grid<uint8_t> price(ground.frame(), 0);
  for (size_t i = 0; i < price.size(); ++i) {
    const float z = ground.cells()[i];
    if (!(z <= -depth_m)) continue;  // NaN is not
    const float shallow = std::clamp(1.0F + 30.0F / (-z), 1.0F, 4.0F);
    const float windward = 1.0F + 0.8F * geom::smoothstep(0.5F + 0.8F * exposure.cells()[i]);
    price.cells()[i] = static_cast<uint8_t>(
        waters.clear.cells()[i] != 0 ? 1 : std::clamp(std::lround(7.0F * shallow * windward), 2L, long{kDearest}));
  }
  return price;
}

/// Places of a lagoon where ways begin: the cheapest, then the cheapest that are `apart` from those before.
std::vector<int64_t> mouths_of(const RegionOfMask& lagoon, const Ways& ways, const GridFrame& f, size_t count,
                               double apart) {
  std::vector<int64_t> mouths;
  while (mouths.size() < count) {
    int64_t best = -1;
    for (const int64_t i : lagoon.cells) {
      if (ways.cost(i) >= kUnreached || (best >= 0 && ways.cost(i) >= ways.cost(best))) continue;
      const bool near = std::any_of(mouths.begin(), mouths.end(), [&](int64_t o) {
        const int64_t columns = i % f.width - o % f.width, rows = i / f.width - o / f.width;
        const auto dx = static_cast<double>(columns), dy = static_cast<double>(rows);
        return std::sqrt(dx * dx + dy * dy) * f.cell_m < apart;
      });
      if (!near) best = i;
    }
    if (best < 0) break;
    mouths.push_back(best);
  }
  return mouths;
}

/// Metres of shore of a region, about.
double shore_m(const RegionOfMask& region, const Grid<uint8_t>& mask) {
  int64_t count = 0;
  const int64_t width = mask.width();
  for (const int64_t i : region.cells) {
    const auto x = static_cast<int>(i % width), y = static_cast<int>(i / width);
    const bool inner = mask.clamped(x - 1, y) != 0 && mask.clamped(x + 1, y) != 0 && mask.clamped(x, y - 1) != 0 &&
                       mask.clamped(x, y + 1) != 0;
    count += inner ? 0 : 1;
  }
  return static_cast<double>(count) * mask.cell_m();
}

/// Digs along a way from a lagoon to the sea, from the depth of the one to that of the other, so that no pool is left.
void dig_way(const std::vector<int64_t>& way, const Channel& channel, const HeightField& reef, const Waters& waters,
             float depth_m, ScalarField& passes) {
  const auto depth_at = [&](int64_t cell) {
    const double depth = -static_cast<double>(reef.cells()[static_cast<size_t>(cell)]);
    return std::clamp(depth, std::min(static_cast<double>(kBelow * depth_m), channel.depth_m), channel.depth_m);
  };
  const GridFrame& f = passes.frame();
  const int rounding = std::max(2, static_cast<int>(0.8 * channel.half_width_m / f.cell_m));
  const std::vector<Vec2> line = smoothed(way, f, rounding);
  const double first = depth_at(way.front()), last = depth_at(way.back());
  for (size_t i = 0; i < line.size(); ++i) {
    if (static_cast<double>(waters.room.cells()[static_cast<size_t>(way[i])]) >= 1.6 * channel.half_width_m) continue;
    const double share = static_cast<double>(i) / static_cast<double>(std::max<size_t>(1, line.size() - 1));
    dig(passes, line[i], channel.half_width_m, first + share * (last - first));
  }
}

/// Digs from all that is shut; false where nothing is.
bool open_lagoons(const HeightField& ground, const HeightField& reef, const ScalarField& exposure,
                  const PassParams& passes, float depth_m, double cell_m, ScalarField& out, const RunContext& run) {
  const GridFrame& f = ground.frame();
  const Waters waters = find_waters(reef, depth_m, cell_m, run);
  std::vector<RegionOfMask> lagoons = regions_of(waters.shut);
  const auto km2 = [&](const RegionOfMask& r) {
    return static_cast<double>(r.cells.size()) * f.cell_m * f.cell_m * 1e-6;
  };
  // Water that adjoins the open sea through a gap that is too narrow does not count as shut, a strip of half_m.
  const double strip_km2 = 4e-6 * waters.half_m * waters.half_m;
  const double least_km2 = std::max(0.8 * passes.least_km2 - strip_km2, 0.15 * passes.least_km2);
  std::erase_if(lagoons, [&](const RegionOfMask& r) { return km2(r) < least_km2; });
  if (lagoons.empty()) return false;
  run.check_cancelled();
  if (out.empty()) out = ScalarField(f, 0.0F);
  const Ways ways(price_of(ground, exposure, waters, depth_m), waters.sea);
  bool any = false;
  for (const RegionOfMask& lagoon : lagoons) {
    const auto count = static_cast<size_t>(std::max(1.0, shore_m(lagoon, waters.shut) / passes.spacing_m));
    const Channel channel = channel_of(km2(lagoon), passes, 1.25 * waters.half_m);
    for (const int64_t mouth : mouths_of(lagoon, ways, f, count, 0.6 * passes.spacing_m)) {
      dig_way(ways.from(mouth), channel, reef, waters, depth_m, out);
      any = true;
    }
  }
  return any;
}

}  // namespace

ScalarField find_passes(const HeightField& ground, const HeightField& reef, const ScalarField& exposure,
                        const PassParams& passes, double cell_m, const RunContext& run) {
  constexpr int kRounds = 3;  // parts of a lagoon that narrows may be shut off still when its other parts are open
  ScalarField out;
  HeightField dug = reef;
  for (const float depth_m : {kPassable_m, kDeeper_m}) {
    for (int round = 0; round < kRounds; ++round) {
      if (!open_lagoons(ground, dug, exposure, passes, depth_m, cell_m, out, run)) break;
      for (size_t i = 0; i < dug.size(); ++i)
        dug.cells()[i] = std::min(reef.cells()[i], std::max(ground.cells()[i], -out.cells()[i]));
    }
  }
  return std::any_of(out.cells().begin(), out.cells().end(), [](float d) { return d > 0; }) ? out : ScalarField();
}

}  // namespace seamount::reef
