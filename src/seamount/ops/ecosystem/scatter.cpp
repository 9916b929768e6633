#include "seamount/ops/ecosystem/scatter.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "seamount/base/error.h"
#include "seamount/geom/polygon/poisson_disc.h"
#include "seamount/model/same_size.h"
#include "seamount/model/sample_known.h"
#include "seamount/ops/ecosystem/place_things.h"

namespace seamount::ecosystem {
namespace {

constexpr double kMost = 1e6;

std::vector<Vec2> even_places(const ScatterInputs& in, double spacing, Seed seed, const RunContext& run) {
  const GridFrame& f = in.terrain.frame();
  const geom::Box box{{f.west_m, f.south_m()}, {f.east_m(), f.north_m}};
  std::vector<Polygon> areas;
  if (in.places != nullptr) {
    for (const NamedArea& area : in.places->areas) areas.insert(areas.end(), area.parts.begin(), area.parts.end());
  }
  if (areas.empty())
    areas = {
        {{{f.west_m, f.south_m()}, {f.east_m(), f.south_m()}, {f.east_m(), f.north_m}, {f.west_m, f.north_m}}, {}}};
  const double count = geom::kDiscDensity * f.width_m() * f.height_m() / (spacing * spacing);
  if (count > kMost || std::max(f.width_m(), f.height_m()) > geom::kMostDiscsAcross * spacing)
    throw InvalidArgument("spacing_m", format_number(spacing) + " would give more than a million places on " +
                                           format_number(f.width_m()) + " m x " + format_number(f.height_m()) + " m");
  const geom::DiscSampling discs = geom::poisson_discs(areas, 0.0, box, spacing, seed, run);
  std::vector<Vec2> all;
  for (const geom::LatticePoint& p : discs.points) {
    const Vec2 place = discs.lattice.place(p);
    if (place.x < f.west_m || place.x > f.east_m() || place.y < f.south_m() || place.y > f.north_m) continue;
    const bool inside =
        in.places == nullptr || in.places->areas.empty() ||
        std::any_of(areas.begin(), areas.end(), [&](const Polygon& a) { return geom::contains(a, place); });
    if (inside) all.push_back(place);
  }
  return all;
}

/// Over half a cell to each side; 0 where the ground is not known.
double slope_deg(const HeightField& terrain, double column, double row) {
  const double east = sample_known(terrain, column + 0.5, row) - sample_known(terrain, column - 0.5, row),
               south = sample_known(terrain, column, row + 0.5) - sample_known(terrain, column, row - 0.5);
  const double rise = std::hypot(east, south) / terrain.cell_m();
  return std::isnan(rise) ? 0.0 : std::atan(rise) * 180.0 / std::numbers::pi;
}

}  // namespace

Things scatter(const ScatterInputs& in, const ScatterParams& params, Seed seed, const RunContext& run) {
  check_params(params);
  if (in.terrain.empty()) throw InvalidArgument("terrain", "has no cells");
  if (in.density != nullptr) check_same_size("density", in.density->frame(), in.terrain.frame());
  if (params.min_height_m > params.max_height_m)
    throw InvalidArgument("min_height_m", format_number(params.min_height_m) + " is above max_height_m " +
                                              format_number(params.max_height_m));
  const bool drawn = in.places != nullptr && !in.places->points.empty();
  std::vector<Vec2> places;
  if (drawn)
    for (const ValuedPoint& point : in.places->points) places.push_back(point.place);
  else
    places = even_places(in, params.spacing_m, seed.derive("places"), run.part(0.0, 0.3));
  const GridFrame& frame = in.terrain.frame();
  std::vector<ThingPlace> wanted;
  for (size_t i = 0; i < places.size(); ++i) {
    const double column = frame.column(places[i].x), row = frame.row(places[i].y);
    const float z = sample_known(in.terrain, column, row);
    if (z < params.min_height_m || z > params.max_height_m) continue;
    if (params.max_slope_deg < 90.0 && slope_deg(in.terrain, column, row) > params.max_slope_deg) continue;
    const uint64_t key =
        mix_bits(std::bit_cast<uint64_t>(places[i].x) ^ mix_bits(std::bit_cast<uint64_t>(places[i].y)));
    if (in.density != nullptr) {
      const float share = sample_known(*in.density, column, row);
      if (!(Rng(seed.derive("density", key)).uniform() < static_cast<double>(share))) continue;
    }
    wanted.push_back({.place = places[i], .health = params.health, .key = key});
  }
  if (wanted.empty()) run.say("nothing stands anywhere: no place fits the density and the heights");
  const std::vector<ThingSpec> specs = {
      {std::string(Choices<ThingForm>::names[static_cast<size_t>(params.thing.shape)]), params.thing, in.mesh}};
  PlaceThingsOptions options;
  options.max_triangles = static_cast<uint64_t>(params.max_triangles);
  options.keep_ground = params.keep_ground;
  Things made = place_things(in.terrain, specs, wanted, options, seed, run.part(0.3, 1.0));
  return in.others != nullptr ? joined(*in.others, made) : made;
}

Things joined(Things first, const Things& second) {
  const auto shift = static_cast<uint32_t>(first.shapes.size());
  first.shapes.insert(first.shapes.end(), second.shapes.begin(), second.shapes.end());
  for (Thing thing : second.things) {
    thing.shape += shift;
    first.things.push_back(thing);
  }
  if (first.crs.empty()) first.crs = second.crs;
  if (first.ground.empty()) first.ground = second.ground;
  return first;
}

}  // namespace seamount::ecosystem
