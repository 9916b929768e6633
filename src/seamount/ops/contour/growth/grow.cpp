#include "seamount/ops/contour/growth/grow.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "seamount/base/parallel.h"
#include "seamount/base/text.h"
#include "seamount/geom/polygon/distance.h"
#include "seamount/geom/polygon/poisson_disc.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/geom/tin/delaunay.h"
#include "seamount/geom/tin/tin_border.h"
#include "seamount/ops/contour/growth/fit_regions.h"
#include "seamount/ops/contour/growth/growth.h"
#include "seamount/ops/contour/growth/outline_detail.h"
#include "seamount/ops/contour/growth/probability.h"
#include "seamount/ops/contour/growth/rivers.h"
#include "seamount/ops/contour/growth/sea_nodes.h"

namespace seamount::contour {
namespace {

constexpr double kBytesPerNode = 200.0;
constexpr double kMostChosen = 500'000.0;  ///< nodes in regions that are chosen because smaller ones have none
constexpr double kTiny = 1.0 / 32.0;       ///< of the ground that a node has: no region is worth more nodes for it
constexpr double kBeyond = 2.0;            ///< spacings by which ground goes on beyond the domain's edge
constexpr double kDrawnByHand = 0.4;       ///< irregularity of outlines that are given as a few points

geom::Box box_of(const GridFrame& frame, double margin_m) {
  return {{frame.west_m - margin_m, frame.south_m() - margin_m}, {frame.east_m() + margin_m, frame.north_m + margin_m}};
}

geom::Box intersection(const geom::Box& a, const geom::Box& b) {
  return {{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y)},
          {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y)}};
}

struct Measures {
  double area = 0.0;       ///< of the regions in the domain, m^2
  double perimeter = 0.0;  ///< of the outermost outlines in the domain, m
  geom::Box box;
};

Measures measure(const RegionTree& tree, const GridFrame& domain) {
  Measures all;
  for (const GrowthRegion& region : tree.regions) {
    if (region.parent >= 0) continue;
    const Ring ring = geom::clip_to_box(region.outline, box_of(domain, 0.0));
    all.area += std::abs(geom::signed_area(ring));
    all.perimeter += geom::ring_length(ring);
    const geom::Box box = geom::bounding_box(ring);
    if (box.empty()) continue;
    if (all.box.empty()) all.box = box;
    all.box.low = {std::min(all.box.low.x, box.low.x), std::min(all.box.low.y, box.low.y)};
    all.box.high = {std::max(all.box.high.x, box.high.x), std::max(all.box.high.y, box.high.y)};
  }
  return all;
}

std::string short_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", value);
  return format_number(std::stod(text));
}

/// Rounds to two digits, up or down: a number for people to type in.
double two_digits(double value, bool up) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", (up ? std::ceil(value / unit) : std::floor(value / unit)) * unit);
  return std::stod(text);
}

void check_size(const Measures& all, double spacing_m) {
  const auto nodes = [&](double spacing) {
    const double rim = all.perimeter * kSeaRows * spacing;
    return geom::kDiscDensity * (all.area + rim) / (spacing * spacing);
  };
  double least = spacing_m;
  while (nodes(least) > static_cast<double>(kMostNodes)) least *= 1.1;
  const double extent = std::max(all.box.high.x - all.box.low.x, all.box.high.y - all.box.low.y);
  least = std::max(least, extent / (geom::kMostDiscsAcross - 100.0));
  if (least <= spacing_m) return;
  const double count = nodes(spacing_m), most = nodes(two_digits(least, true));
  throw InvalidArgument("spacing_m", format_number(spacing_m) + " would need " + short_number(count / 1e6) +
                                         " million nodes and about " + short_number(count * kBytesPerNode / 1e9) +
                                         " GB; " + format_number(two_digits(least, true)) + " m needs " +
                                         short_number(most * kBytesPerNode / 1e9) + " GB");
}

/// Regions of the nodes. Ground at the domain's edge goes on beyond it: a node there is in the region of the nearest
/// place inside. What is nearer to the edge than half a spacing counts as touching it.
std::vector<int32_t> regions_of_nodes(const RegionTree& tree, const GridFrame& domain, double spacing_m,
                                      const std::vector<Vec2>& nodes, const RunContext& run) {
  const double inset = std::min({0.5 * spacing_m, 0.25 * domain.width_m(), 0.25 * domain.height_m()});
  const geom::Box box = box_of(domain, -inset);
  std::vector<Vec2> places;
  places.reserve(nodes.size());
  run.check_cancelled();
  for (const Vec2 p : nodes) {
    places.push_back({std::clamp(p.x, box.low.x, box.high.x), std::clamp(p.y, box.low.y, box.high.y)});
  }
  return regions_at(tree, places, run);
}

/// Radius of a disc that fits into a region in the domain: a sampling of that spacing never misses the region. About
/// the largest, and at least area / border; 0 if the region is all outside.
double disc_in(const RegionTree& tree, size_t region, const GridFrame& domain, const RunContext& run) {
  constexpr int kCells = 100;
  Polygon polygon{geom::clip_to_box(tree.regions[region].outline, box_of(domain, 0.0)), {}};
  const geom::Box box = geom::bounding_box(polygon.outer);
  for (const GrowthRegion& child : tree.regions) {
    if (child.parent == static_cast<int>(region)) polygon.holes.push_back(child.outline);
  }
  const double width = box.high.x - box.low.x, height = box.high.y - box.low.y;
  if (box.empty() || !(std::min(width, height) > 0.0)) return 0.0;
  const double cell = std::min(width, height) / kCells;
  const double least = std::max(0.0, geom::area(polygon) / geom::perimeter(polygon));
  if (std::max(width, height) > 1e4 * cell) return least;
  const auto cells = [&](double side) { return static_cast<int>(std::ceil(side / cell)); };
  const GridFrame frame = {cells(width), cells(height), cell, box.low.x, box.high.y, {}};
  const ScalarField distance = geom::signed_distance({polygon}, frame, run);
  return std::max(least, -static_cast<double>(*std::min_element(distance.cells().begin(), distance.cells().end())));
}

std::vector<size_t> empty_regions(const Tin& tin) {
  std::vector<uint8_t> full(tin.regions.size(), 0);
  for (const int32_t r : tin.region) {
    if (r >= 0) full[static_cast<size_t>(r)] = 1;
  }
  std::vector<size_t> empty;
  for (size_t i = 0; i < full.size(); ++i) {
    if (full[i] == 0) empty.push_back(i);
  }
  return empty;
}

/// A spacing at which a node falls into the region; 0: none.
double needed_spacing(const RegionTree& tree, size_t region, const GridFrame& domain, double spacing_m,
                      const RunContext& run) {
  return std::min(disc_in(tree, region, domain, run), 0.7 * spacing_m);
}

void refuse_empty_region(const RegionTree& tree, const Tin& tin, const GridFrame& domain, double spacing_m,
                         const RunContext& run) {
  const std::vector<size_t> empty = empty_regions(tin);
  if (empty.empty()) return;
  const double needed = needed_spacing(tree, empty[0], domain, spacing_m, run);
  const std::string advice =
      needed > 0.0 ? "; a spacing_m of " + format_number(two_digits(needed, false)) + " would do" : "; take it out";
  throw InvalidArgument("spacing_m", "no node falls into the region '" + tree.regions[empty[0]].name +
                                         "' at a spacing of " + short_number(spacing_m) + " m" + advice);
}

std::string count_regions(const std::vector<std::string>& names) {
  const std::string first = "'" + names[0] + "'";
  return names.size() == 1 ? "the region " + first : fmt::format("{} regions ({}, ...)", names.size(), first);
}

}  // namespace

void check_spacing(const RegionTree& tree, const GridFrame& domain, double spacing_m) {
  check_size(measure(tree, domain), spacing_m);
}

double node_spacing(const RegionTree& tree, const GridFrame& domain, const GrowParams& params) {
  if (params.spacing_m) return *params.spacing_m;
  return std::sqrt(geom::kDiscDensity * measure(tree, domain).area / params.particles);
}

Tin scatter_nodes(const RegionTree& tree, const GridFrame& domain, std::vector<RiverLine> rivers,
                  const GrowParams& params, Seed seed, const RunContext& run) {
  const Measures all = measure(tree, domain);
  if (!(all.area > 0.0)) throw InvalidArgument("outlines", "no region has an area inside the domain");
  const double spacing = node_spacing(tree, domain, params);
  check_size(all, spacing);

  std::vector<Polygon> areas;
  for (const GrowthRegion& region : tree.regions) {
    if (region.parent < 0) areas.push_back({region.outline, {}});
  }
  const Vec2 margin = {kDenseSea * spacing, kDenseSea * spacing};
  const geom::Box box = intersection({all.box.low - margin, all.box.high + margin}, box_of(domain, kBeyond * spacing));
  geom::DiscSampling discs =
      geom::poisson_discs(areas, kDenseSea * spacing, box, spacing, seed.derive("nodes"), run.part(0.0, 0.5));
  rivers.insert(rivers.end(), params.rivers.begin(), params.rivers.end());
  const std::vector<River> courses = prepare_rivers(rivers, tree, domain, kRiverStep * spacing, "rivers");
  Tin tin;
  tin.bed_m = lay_rivers(courses, tree, domain, spacing, discs);
  tin.frame = domain;
  tin.regions = tin_regions(tree);
  const std::vector<int32_t> wide = add_sea_nodes(tree, domain, spacing, seed, discs, run);
  if (!tin.bed_m.empty()) tin.bed_m.resize(discs.points.size(), Tin::kNoBed);
  tin.triangles = geom::delaunay(discs.points, run.part(0.5, 0.9));
  run.check_cancelled();
  tin.nodes.reserve(discs.points.size());
  for (const geom::LatticePoint p : discs.points) tin.nodes.push_back(discs.lattice.place(p));
  drop_slivers(tin, wide, spacing);
  geom::open_pinches(tin, run);
  tin.region = regions_of_nodes(tree, domain, spacing, tin.nodes, run.part(0.9, 1.0));
  return tin;
}

void close_waters(Tin& tin, const RunContext& run) {
  const int64_t closed = close_shut_waters(tin);
  if (closed == 0) return;
  run.say(fmt::format("{} node{} of sea that land shuts off, nearer than nodes are apart, {} land", closed,
                      closed == 1 ? "" : "s", closed == 1 ? "is" : "are"));
}

void grow_nodes(Tin& tin, const ScalarField* probability, const GrowParams& params, Seed seed, const RunContext& run) {
  std::vector<float> chance(tin.nodes.size(), 0.5F);
  if (probability != nullptr) {
    chance = field_probability(tin.nodes, *probability, params.exponent, run.part(0.0, 0.2));
  } else if (params.probability == ProbabilityKind::noise) {
    geom::Fbm shape;
    shape.wavelength_m = params.feature_m.value_or(std::sqrt(measure(regions_of(tin), tin.frame).area) / 3.0);
    shape.octaves = params.octaves;
    chance = noise_probability(tin.nodes, shape, params.exponent, seed.derive("probability"), run.part(0.0, 0.2));
  }
  const RiverNodes river_nodes = keep_river_nodes(tin);
  tin.rank = grow_ranks(tin.triangles, tin.region, tin.regions, chance, river_nodes, seed.derive("growth"),
                        run.part(0.2, 1.0));
}

namespace {

/// As many nodes more as regions need that have none, up to a bound; what is too small for that, or tiny beside the
/// ground of a node that was asked for, is left out.
void scatter_enough(Tin& tin, const RegionTree& tree, const GridFrame& domain, const std::vector<RiverLine>& rivers,
                    GrowParams params, Seed seed, const RunContext& run) {
  const double asked = node_spacing(tree, domain, params);
  const double least = asked * std::sqrt(std::min(1.0, static_cast<double>(params.particles) / kMostChosen));
  double spacing = asked;
  const auto worth_nodes = [&] {
    std::vector<size_t> empty = empty_regions(tin);
    std::erase_if(empty, [&](size_t region) {
      return std::abs(geom::signed_area(tree.regions[region].outline)) < kTiny * asked * asked / geom::kDiscDensity;
    });
    return empty;
  };
  for (std::vector<size_t> empty = worth_nodes(); !empty.empty() && spacing > least; empty = worth_nodes()) {
    double needed = spacing;
    for (const size_t region : empty) {
      const double disc = needed_spacing(tree, region, domain, spacing, run);
      if (disc > 0.0) needed = std::min(needed, disc);
    }
    spacing = std::max(std::min(needed, 0.7 * spacing), least);
    params.spacing_m = spacing;
    tin = scatter_nodes(tree, domain, rivers, params, seed, run);
  }
  if (spacing < asked) {
    const auto nodes = tin.region.size() - static_cast<size_t>(std::count(tin.region.begin(), tin.region.end(), -1));
    run.say(fmt::format("particles: {} are too few for the smallest regions; there are {}, {} m apart at least",
                        params.particles, nodes, short_number(spacing)));
  }
  const std::vector<std::string> dropped = drop_empty_regions(tin);
  if (tin.regions.empty()) throw InvalidArgument("particles", "no node falls into any region; there are too few");
  if (dropped.empty()) return;
  run.say(fmt::format("{} {} smaller than nodes {} m apart and left out; a finer spacing_m shows more",
                      count_regions(dropped), dropped.size() == 1 ? "is" : "are", short_number(spacing)));
}

}  // namespace

Tin grow(RegionTree tree, const GridFrame& domain, const ScalarField* probability, std::vector<RiverLine> rivers,
         GrowParams params, Seed seed, const RunContext& run) {
  check_params(params);
  const double irregularity = params.irregularity.value_or(params.outlines.empty() ? 0.0 : kDrawnByHand);
  if (irregularity > 0.0) {
    check_size(measure(tree, domain), node_spacing(tree, domain, params));
    rivers.insert(rivers.end(), params.rivers.begin(), params.rivers.end());
    params.rivers.clear();
    add_outline_detail(tree, rivers, irregularity, domain, seed.derive("outlines"), run);
  }
  Tin tin = scatter_nodes(tree, domain, rivers, params, seed, run.part(0.0, 0.7));
  if (params.spacing_m) {
    refuse_empty_region(tree, tin, domain, *params.spacing_m, run);
  } else {
    scatter_enough(tin, tree, domain, rivers, params, seed, run.part(0.0, 0.7));
  }
  close_waters(tin, run);
  if (tin.regions.size() > 1) join_strays(tin, run);
  grow_nodes(tin, probability, params, seed, run.part(0.7, 1.0));
  return tin;
}

RegionTree random_region(const GridFrame& domain, Seed seed) {
  constexpr int kPoints = 360;
  const double size = std::min(domain.width_m(), domain.height_m());
  const Vec2 centre = {domain.west_m + 0.5 * domain.width_m(), domain.south_m() + 0.5 * domain.height_m()};
  Ring ring;
  for (int i = 0; i < kPoints; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kPoints;
    const double wave = geom::fbm_circle(seed.derive("outline"), angle, 4.0, 6);
    const double radius = size * std::clamp(0.33 + 0.16 * wave, 0.15, 0.47);
    ring.push_back(centre + radius * Vec2{std::cos(angle), std::sin(angle)});
  }
  GrowthRegion region;
  region.name = "land";
  region.outline = ring;
  return {{region}};
}

}  // namespace seamount::contour
