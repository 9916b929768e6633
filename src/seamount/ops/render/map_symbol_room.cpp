// Room for symbols: how much they shrink so that they do not cover each other.
#include <algorithm>
#include <array>

#include "seamount/geom/skeleton/skeleton_index.h"
#include "seamount/ops/render/map_objects.h"

namespace seamount::render {
namespace {

/// A point of a class, with the radius that its symbol would have.
struct Spot {
  Vec2 place;
  double radius_px = 0.0;
  size_t of_shown = 0;
  int tier = 0;  ///< by its radius: those of one tier and above are no less than half as large
};

std::vector<Spot> spots_of(const std::vector<ShownClass>& shown, double pixel_m, double pen) {
  std::vector<Spot> spots;
  for (size_t i = 0; i < shown.size(); ++i) {
    if (shown[i].of_class->skeleton != SkeletonKind::point) continue;
    for (const SceneObject* object : shown[i].objects) {
      const double radius = symbol_radius(*shown[i].of_class, *object, pixel_m, pen);
      spots.push_back({object->skeleton.points.front(), radius, i,
                       radius < 4.0 * pen   ? 0
                       : radius < 8.0 * pen ? 1
                                            : 2});
    }
  }
  return spots;
}

/// Distances in metres of the spots of a tier from the nearest other spot of that tier or above.
void find_distances(const std::vector<Spot>& spots, int tier, std::vector<double>& distances, const RunContext& run) {
  std::vector<Skeleton> skeletons;
  std::vector<int32_t> owners, asking;
  std::vector<Vec2> places;
  for (size_t i = 0; i < spots.size(); ++i) {
    if (spots[i].tier < tier) continue;
    skeletons.push_back({SkeletonKind::point, {spots[i].place}});
    owners.push_back(static_cast<int32_t>(i));
    if (spots[i].tier > tier) continue;
    places.push_back(spots[i].place);
    asking.push_back(static_cast<int32_t>(i));
  }
  if (places.empty()) return;
  std::vector<double> found(places.size());
  geom::SkeletonIndex(skeletons, owners).distances(places, asking, found, run);
  for (size_t i = 0; i < asking.size(); ++i) distances[static_cast<size_t>(asking[i])] = found[i];
}

/// The value that a share of all lies below. REQUIRES: values that are not empty.
double quantile(std::vector<double>& values, double share) {
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

}  // namespace

void fit_symbols(std::vector<ShownClass>& shown, double pixel_m, double pen, const RunContext& run) {
  const std::vector<Spot> spots = spots_of(shown, pixel_m, pen);
  std::vector<double> distances(spots.size());
  for (const int tier : {0, 1, 2}) find_distances(spots, tier, distances, run);
  std::vector<std::vector<double>> room(shown.size()), radii(shown.size());
  for (size_t i = 0; i < spots.size(); ++i) {
    room[spots[i].of_shown].push_back(distances[i] / (2.0 * spots[i].radius_px * pixel_m));
    radii[spots[i].of_shown].push_back(spots[i].radius_px);
  }
  for (size_t i = 0; i < shown.size(); ++i) {
    if (room[i].empty()) continue;
    shown[i].shrink = std::min(1.0, quantile(room[i], 0.25));
    const double usual = quantile(radii[i], 0.5) * shown[i].shrink;
    if (shown[i].shrink < 1.0 && usual < 3.0 * pen) shown[i].dot_px = std::clamp(usual, 1.2 * pen, 2.0 * pen);
  }
}

}  // namespace seamount::render
