#include "seamount/ops/render/subject.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace seamount::render {
namespace {

constexpr int kMostCells = 128;
constexpr float kShallow_m = -25.0F, kReef_m = -6.0F;
constexpr double kLeastLand = 0.002, kLeastReef = 0.004;  // of the terrain

/// A place of the raster, and the island or reef that it is part of.
struct Place {
  Vec3 at;
  float height = 0.0F;
  int part = -1;
};

struct Raster {
  int width = 0, height = 0;
  std::vector<Place> places;
  const Place& operator()(int x, int y) const { return places[static_cast<size_t>(y) * width + x]; }
};

Raster raster_of(const Ground& ground) {
  const HeightField& heights = ground.heights();
  Raster raster;
  raster.width = std::min(kMostCells, heights.width());
  raster.height = std::min(kMostCells, heights.height());
  const auto column = [&](int i, int count, int cells) {
    return count < 2 ? 0 : static_cast<int>(static_cast<int64_t>(i) * (cells - 1) / (count - 1));
  };
  for (int j = 0; j < raster.height; ++j) {
    for (int i = 0; i < raster.width; ++i) {
      const int x = column(i, raster.width, heights.width()), y = column(j, raster.height, heights.height());
      const float h = heights(x, y);
      raster.places.push_back(
          {{(static_cast<float>(x) - 0.5F * static_cast<float>(heights.width() - 1)) * ground.cell_m(),
            (0.5F * static_cast<float>(heights.height() - 1) - static_cast<float>(y)) * ground.cell_m(), h},
           h / ground.exaggeration()});
    }
  }
  return raster;
}

/// Numbers what hangs together above a height, by sides and corners. Returns how many parts there are.
int number_parts(Raster& raster, float above) {
  int parts = 0;
  std::vector<size_t> open;
  for (size_t start = 0; start < raster.places.size(); ++start) {
    if (raster.places[start].part >= 0 || raster.places[start].height <= above) continue;
    raster.places[start].part = parts;
    open.assign(1, start);
    while (!open.empty()) {
      const auto x = static_cast<int>(open.back() % static_cast<size_t>(raster.width)),
                 y = static_cast<int>(open.back() / static_cast<size_t>(raster.width));
      open.pop_back();
      for (int k = 0; k < 9; ++k) {
        const int nx = x + k % 3 - 1, ny = y + k / 3 - 1;
        if (nx < 0 || ny < 0 || nx >= raster.width || ny >= raster.height) continue;
        const size_t next = static_cast<size_t>(ny) * static_cast<size_t>(raster.width) + static_cast<size_t>(nx);
        if (raster.places[next].part >= 0 || raster.places[next].height <= above) continue;
        raster.places[next].part = parts;
        open.push_back(next);
      }
    }
    ++parts;
  }
  return parts;
}

/// A box around parts and how much they weigh: a share of the picture's interest.
struct Frame {
  float west = std::numeric_limits<float>::infinity(), south = west, east = -west, north = -west;
  double weight = 0.0;

  void add(const Frame& other) {
    west = std::min(west, other.west);
    south = std::min(south, other.south);
    east = std::max(east, other.east);
    north = std::max(north, other.north);
    weight += other.weight;
  }
  bool surrounds(const Frame& inner) const {
    return west <= inner.west && south <= inner.south && east >= inner.east && north >= inner.north;
  }
  /// Much in little room: a far islet is not worth the sea before it, an equal neighbour is.
  double worth(double least_side) const {
    return weight /
           std::pow(std::max<double>(east - west, least_side) * std::max<double>(north - south, least_side), 0.18);
  }
};

/// The frame of the heaviest part, of others as long as that makes it worth more, and of a reef around it.
Frame best_frame(std::vector<Frame> parts, double least_side) {
  std::sort(parts.begin(), parts.end(), [](const Frame& a, const Frame& b) { return a.weight > b.weight; });
  constexpr size_t kMostParts = 200;
  if (parts.size() > kMostParts) parts.resize(kMostParts);
  Frame best = parts.front();
  parts.erase(parts.begin());
  while (!parts.empty()) {
    size_t next = parts.size();
    Frame grown = best;
    for (size_t i = 0; i < parts.size(); ++i) {
      Frame with = best;
      with.add(parts[i]);
      if (!parts[i].surrounds(best) && with.worth(least_side) <= grown.worth(least_side)) continue;
      grown = with;
      next = i;
      if (parts[i].surrounds(best)) break;
    }
    if (next == parts.size()) break;
    best = grown;
    parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(next));
  }
  return best;
}

std::vector<Vec3> whole(const Raster& raster, bool sea, float base) {
  std::vector<Vec3> all;
  for (const Place& place : raster.places) {
    all.push_back({place.at.x, place.at.y, sea ? std::max(place.height, 0.0F) : place.height});
    if (!sea) all.push_back({place.at.x, place.at.y, base});
  }
  return all;
}

std::vector<Vec3> chosen_places(const Ground& ground, bool sea, float base, bool all) {
  Raster raster = raster_of(ground);
  if (!sea) return whole(raster, sea, base);
  const auto share_above = [&](float height) {
    const auto count = std::count_if(raster.places.begin(), raster.places.end(),
                                     [&](const Place& place) { return place.height > height; });
    return static_cast<double>(count) / static_cast<double>(raster.places.size());
  };
  const bool land = share_above(0.0F) > kLeastLand;
  const float above = land || share_above(kReef_m) < kLeastReef ? kShallow_m : kReef_m;
  if (share_above(above) < kLeastLand) return whole(raster, sea, base);

  std::vector<Frame> parts(static_cast<size_t>(number_parts(raster, above)));
  for (const Place& place : raster.places) {
    if (place.part < 0) continue;
    constexpr double kShoal = 0.15;  // beside land
    parts[static_cast<size_t>(place.part)].add(
        {place.at.x, place.at.y, place.at.x, place.at.y, land && place.height <= 0.0F ? kShoal : 1.0});
  }
  Frame frame;
  for (const Frame& part : parts) frame.add(part);
  if (!all) frame = best_frame(std::move(parts), 3.0 * ground.cell_m());
  std::vector<Vec3> places;
  for (const Place& place : raster.places) {
    if (place.part >= 0 && place.at.x >= frame.west && place.at.x <= frame.east && place.at.y >= frame.south &&
        place.at.y <= frame.north)
      places.push_back({place.at.x, place.at.y, std::max(place.height, 0.0F)});
  }
  return places;
}

}  // namespace

std::vector<Vec3> places_to_show(const Ground& ground, bool sea, float base) {
  return chosen_places(ground, sea, base, false);
}

std::vector<Vec3> all_places_to_show(const Ground& ground, bool sea, float base) {
  return chosen_places(ground, sea, base, true);
}

}  // namespace seamount::render
