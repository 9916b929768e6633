#include "seamount/ops/reef/grow.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>

#include "seamount/base/parallel.h"
#include "seamount/geom/contour/contour.h"
#include "seamount/geom/grid/pyramid.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/grid/voids.h"
#include "seamount/geom/solve/fill_voids.h"
#include "seamount/geom/water/flat_sea.h"
#include "seamount/geom/water/inland.h"
#include "seamount/model/same_size.h"
#include "seamount/ops/reef/cays.h"
#include "seamount/ops/reef/habitat.h"
#include "seamount/ops/reef/lagoons.h"
#include "seamount/ops/reef/passes.h"
#include "seamount/ops/reef/shape.h"
#include "seamount/ops/reef/surface.h"

namespace seamount::reef {
namespace {

constexpr double kRadiusInCells = 40.0 * 150.0 / 4096.0;  // P4 sec. 4.1: 40 px, 4096 px over 150 cells
constexpr int64_t kCellsPerParticle = 8;                  // about P4's 3000 particles on 150^2 cells
constexpr float kBeachTop_m = 4.0F;
constexpr float kDry_m = 0.3F;
constexpr double kBackReefDepth_m = 1.2;  // behind the rim and this far below the flat is lagoon
constexpr double kLeastHole = 12.0;       // squares of the kernels' radius: smaller holes and lagoons are closed
constexpr float kOnFlat_m = -200.0F;      // further from a lagoon a flat knows nothing of it
constexpr int kOutlineCells = 2048;

/// Cells at the rim of a mask.
int64_t rim_cells(const Grid<uint8_t>& mask) {
  int64_t count = 0;
  for (int y = 0; y < mask.height(); ++y) {
    for (int x = 0; x < mask.width(); ++x) {
      if (mask(x, y) == 0) continue;
      const bool inner = mask.clamped(x - 1, y) != 0 && mask.clamped(x + 1, y) != 0 && mask.clamped(x, y - 1) != 0 &&
                         mask.clamped(x, y + 1) != 0;
      count += inner ? 0 : 1;
    }
  }
  return count;
}

/// How many particles to shoot; throws where there is no room for those that are wanted. A habitat as narrow as an
/// island's shelf is grown over by half, a wide one by P4's share.
int particles_for(int wanted, double lattice_m, const Habitat& habitat) {
  const int64_t room =
      reachable_habitat(habitat.suitable, habitat.kernels) - static_cast<int64_t>(habitat.kernels.size());
  if (wanted > room)
    throw InvalidArgument("particles", std::to_string(wanted) + " do not fit the " + std::to_string(room) +
                                           " free lattice cells that growth can reach; take fewer, or a lattice_m "
                                           "below " +
                                           format_number(lattice_m));
  if (wanted > 0) return wanted;
  const int64_t inner = std::max<int64_t>(0, room - rim_cells(habitat.suitable));
  return static_cast<int>(std::min(room, inner / kCellsPerParticle + (room - inner) / 2));
}

void say_if_small(const Habitat& habitat, const RunContext& run) {
  constexpr int64_t kFew = 50;
  const auto cells =
      static_cast<int64_t>(std::count(habitat.suitable.cells().begin(), habitat.suitable.cells().end(), 1));
  if (cells < kFew && habitat.suitable.size() > 10 * kFew)
    run.say("hardly any habitat: " + std::to_string(cells) + " of " + std::to_string(habitat.suitable.size()) +
            " lattice cells have a sea floor in light");
}

WalkRules walk_rules(const WalkParams& p, int particles) {
  const double bearing = p.current_to_deg * std::numbers::pi / 180.0;
  WalkRules rules;
  rules.particles = particles;
  rules.max_steps = p.max_steps;
  rules.stickiness = p.stickiness;
  rules.drift = {0.5 * p.current * std::sin(bearing), 0.5 * p.current * std::cos(bearing)};
  rules.launch = p.launch;
  return rules;
}

/// Where land is and where water is enclosed, on the form's lattice.
ScalarField open_sea(const Form& form, const HeightField& terrain, double gap_m, const RunContext& run) {
  const HeightField ground = geom::resample(terrain, form.distance.frame(), run);
  return distance_to_open_sea(form.distance, ground, gap_m, run);
}

void stretch(HeightField& field, const FinishParams& p, const RunContext& run) {
  if (p.low_m >= p.high_m)
    throw InvalidArgument("finish.low_m", format_number(p.low_m) + " is not below finish.high_m");
  float low = std::numeric_limits<float>::max(), high = std::numeric_limits<float>::lowest();
  for (const float z : field.cells())
    low = std::min(low, std::isnan(z) ? low : z), high = std::max(high, std::isnan(z) ? high : z);
  const double from = low, span = std::max(1e-6, static_cast<double>(high) - from);
  const auto scale = static_cast<float>((p.high_m - p.low_m) / span);
  const auto offset = static_cast<float>(p.low_m);
  parallel_blocks(run, static_cast<int64_t>(field.size()), 1 << 18, [&](int64_t begin, int64_t end) {
    for (int64_t i = begin; i < end; ++i) {
      float& z = field.cells()[static_cast<size_t>(i)];
      z = offset + (z - static_cast<float>(from)) * scale;
    }
  });
}

/// What labels are read from: heights of land and cays, of lagoons behind rims, and where cays begin to be green.
struct Borders {
  float lagoon_top_m, plants_m;
};

Region region_of(float z, float z0, float reef, float to_open_sea, const Borders& borders) {
  if (z > kDry_m) return z < (z0 <= 0.0F ? borders.plants_m : kBeachTop_m) ? Region::beach : Region::mountain;
  if (reef >= 0.999F && z < borders.lagoon_top_m) return Region::lagoon;  // behind the rim
  if (reef >= 0.5F) return Region::reef;
  return to_open_sea > 0.0F ? Region::lagoon : Region::abyss;
}

/// New regions; land and water that were labelled before and have no reef keep their labels, but for enclosed water.
LabelMap label_regions(const Grown& grown, const GrowInputs& in, const ScalarField& to_open_sea, const Borders& borders,
                       const RunContext& run) {
  const GridFrame& frame = grown.terrain.frame();
  LabelMap labels(frame);
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    geom::RowUpsampler rows(to_open_sea);
    std::vector<float> away(static_cast<size_t>(frame.width));
    const auto node = static_cast<float>(0.5 * to_open_sea.cell_m());
    for (int y = begin; y < end; ++y) {
      rows.read(frame.x(0), frame.cell_m, frame.y(y), away);
      for (int x = 0; x < frame.width; ++x) {
        const float z = grown.terrain(x, y), z0 = z > kDry_m ? in.terrain(x, y) : z;
        Region region = region_of(z, z0, grown.aggregate(x, y), away[static_cast<size_t>(x)] - node, borders);
        if (in.labels != nullptr) {
          const Region old = (*in.labels)(x, y);
          const bool both_land = region <= Region::beach && old <= Region::beach;
          if (both_land || (region == Region::abyss && old > Region::beach)) region = old;
        }
        labels(x, y) = region;
      }
    }
  });
  return labels;
}

/// Where no reef can stand whatever the height: on a sea without a floor, which is said, and, if there is a sea at all
/// (rising reefs), in hollows of the land.
Grid<uint8_t> dry_ground(const HeightField& terrain, bool rising, const RunContext& run) {
  Grid<uint8_t> dry;
  if (rising) dry = geom::find_hollows(terrain, 0.0F, std::nullopt, run);
  const Grid<uint8_t> no_floor = geom::flat_sea_to_coast(terrain, run);
  if (no_floor.empty()) return dry;
  run.say(
      "the sea of this terrain is 0 m everywhere, as elevation models of land give it: where it has no floor there "
      "is no reef (terrain.sea_floor gives it one)");
  if (dry.empty()) return no_floor;
  for (size_t i = 0; i < dry.size(); ++i) dry.cells()[i] |= no_floor.cells()[i];
  return dry;
}

/// Dry and unknown ground stays as it was.
void keep_dry(const HeightField& terrain, const Grid<uint8_t>& dry, bool unknown, Grown& out) {
  for (size_t i = 0; i < dry.size(); ++i) {
    if (dry.cells()[i] == 0) continue;
    out.terrain.cells()[i] = terrain.cells()[i];
    out.aggregate.cells()[i] = 0.0F;
  }
  if (!unknown) return;
  for (size_t i = 0; i < terrain.size(); ++i) {
    if (!std::isnan(terrain.cells()[i])) continue;
    out.terrain.cells()[i] = terrain.cells()[i];
    out.aggregate.cells()[i] = 0.0F;
  }
}

void blur(HeightField& terrain, double blur_m, bool unknown, const RunContext& run) {
  if (blur_m <= 0) return;
  if (unknown) geom::fill_voids(terrain, run);
  geom::gaussian_blur(terrain, blur_m, run);
}

void check_inputs(const GrowInputs& in, const GrowParams& params) {
  check_params(params);
  if (in.labels != nullptr) check_same_size("labels", in.labels->frame(), in.terrain.frame());
}

/// Everything about a reef but its heights, from where its particles settled.
Form make_form(const Aggregate& reef, const GridFrame& lattice, const GridFrame& frame, const GrowParams& params,
               double radius, const KernelTables& tables, Seed seed, const RunContext& run) {
  const bool rising = params.heights.mode == Lift::saturating;
  const double irregular = params.irregularity;
  const KernelParams& kernel = params.kernel;
  const std::vector<Colony> colonies = place_colonies(
      reef.cells, lattice, {radius, 0.45 * irregular, 0.3 * irregular, kernel.k1, kernel.k1_jitter}, seed);
  Form form;
  form.tables = &tables;
  const Bend bend{0.3 * radius * irregular, 5.0 * radius};
  const double least_hole_m2 = rising ? kLeastHole * radius * radius : 0.0;
  form.distance =
      outline_distance(colonies, reef.cells, lattice, shape_frame(frame, std::max(radius / 8.0, 0.5 * frame.cell_m)),
                       bend, least_hole_m2, seed, run);
  if (kernel.combine == Combine::sum) form.sums.emplace(colonies, kernel.k, kernel.k2);
  if (!rising && kernel.combine == Combine::sum) return form;
  form.crowding = crowding(form.distance, 2.5 * radius, run);
  form.exposure = exposure(form.distance, params.swell_from_deg, 0.6 * radius, run);
  if (!rising) return form;
  ScalarField lagoon =
      lagoon_depths(form.distance, form.exposure, params.heights.flat_width_m, kLeastHole * radius * radius, seed, run);
  form.knolls = {scatter_knolls(form.distance, lagoon, form.crowding, params.sand.knolls_per_km2, seed), 0.0F};
  form.cays = {make_cays({params.sand.cays, params.swell_from_deg, radius}, form.distance, lagoon, form.exposure,
                         form.crowding, seed),
               0.0F};
  form.lagoon = {std::move(lagoon), kOnFlat_m};
  return form;
}

/// Heights and aggregate from a base; true if any of it is unknown.
bool raise(const Form& form, const SurfaceParams& surface, const HeightField& base, Seed seed, HeightField& terrain,
           ScalarField& aggregate, const RunContext& run) {
  std::atomic<bool> unknown = false;
  parallel_rows(run, base.width(), base.height(), [&](int begin, int end) {
    SurfaceRows rows(form, surface, base.frame(), seed);
    for (int y = begin; y < end; ++y) {
      rows.row(y, base.row(y), terrain.row(y), aggregate.row(y));
      if (geom::any_void(base.row(y))) unknown = true;
    }
  });
  return unknown;
}

/// The passes of a form, sought on its own lattice.
ScalarField passes_of(const Form& form, SurfaceParams surface, const PassParams& passes, const HeightField& terrain,
                      Seed seed, const RunContext& run) {
  const HeightField ground = geom::resample(terrain, form.distance.frame(), run);
  surface.detail.grooves_m = 0.0;  // as fine as the terrain's cells, which are others
  HeightField reef(ground.frame());
  ScalarField aggregate(ground.frame());
  raise(form, surface, ground, seed, reef, aggregate, run);
  return find_passes(ground, reef, form.exposure, passes, terrain.cell_m(), run);
}

}  // namespace

Grown grow(const GrowInputs& in, const GrowParams& params, Seed seed, const RunContext& run) {
  check_inputs(in, params);
  const GridFrame& frame = in.terrain.frame();
  const double lattice_m = params.lattice_m.value_or(default_lattice_m(frame));
  if (!params.lattice_m && lattice_m > default_lattice_m({}))
    run.say("lattice_m is " + format_number(std::round(lattice_m)) +
            " m, as fine as this terrain's cells and extent allow: reefs come out about three times as wide");
  const double radius = params.kernel.radius_m.value_or(kRadiusInCells * lattice_m);
  const bool rising = params.heights.mode == Lift::saturating;
  const Grid<uint8_t> dry = dry_ground(in.terrain, rising, run);
  const BoundParams bounds = rising ? bounds_in_light(params.bounds) : params.bounds;
  const Habitat habitat = find_habitat(in.terrain, {in.habitat, in.start, in.drawing, &dry}, lattice_m,
                                       bounds.margin_m.value_or(3.0 * radius), params.starts, bounds, seed, run);
  say_if_small(habitat, run);
  const WalkRules rules = walk_rules(params.walk, particles_for(params.particles, lattice_m, habitat));
  const Aggregate reef = aggregate(habitat.suitable, habitat.kernels, rules, seed, run.part(0.0, 0.2));

  const KernelTables tables(params.kernel);
  Form form = make_form(reef, habitat.lattice, frame, params, radius, tables, seed, run.part(0.2, 0.4));
  const SurfaceParams surface{params.kernel,
                              params.heights,
                              params.sand,
                              params.detail,
                              params.irregularity,
                              radius,
                              bounds.low_m.value_or(-1e9)};
  if (rising) form.passes = {passes_of(form, surface, params.passes, in.terrain, seed, run.part(0.4, 0.5)), 0.0F};

  Grown out{HeightField(frame), ScalarField(frame), LabelMap()};
  const bool unknown = raise(form, surface, in.terrain, seed, out.terrain, out.aggregate, run.part(0.5, 0.9));
  blur(out.terrain, params.finish.blur_m, unknown, run);
  keep_dry(in.terrain, dry, unknown, out);
  if (params.finish.normalise) stretch(out.terrain, params.finish, run);
  const Borders borders{static_cast<float>(rising ? params.heights.flat_m - kBackReefDepth_m : -1e9),
                        static_cast<float>(kPlants * params.sand.cay_m)};
  const ScalarField to_open_sea = open_sea(form, out.terrain, params.lagoon_gap_m.value_or(2.0 * radius), run);
  out.labels = label_regions(out, in, to_open_sea, borders, run.part(0.9, 1.0));
  return out;
}

Drawing reef_outlines(const ScalarField& aggregate, const RunContext& run) {
  ScalarField coarse;
  const ScalarField* field = &aggregate;
  while (std::max(field->width(), field->height()) > kOutlineCells) {
    coarse = geom::halved(*field, run);
    field = &coarse;
  }
  Drawing drawing;
  drawing.crs = aggregate.frame().crs;
  drawing.areas.push_back({"reef", geom::trace_areas(*field, 0.5, run)});
  return drawing;
}

}  // namespace seamount::reef
