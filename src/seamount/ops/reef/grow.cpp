#include "seamount/ops/reef/grow.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "seamount/base/parallel.h"
#include "seamount/geom/contour/contour.h"
#include "seamount/geom/grid/pyramid.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/water/flat_sea.h"
#include "seamount/model/same_size.h"
#include "seamount/ops/reef/habitat.h"
#include "seamount/ops/reef/shape.h"
#include "seamount/ops/reef/surface.h"

namespace seamount::reef {
namespace {

constexpr double kRadiusInCells = 40.0 * 150.0 / 4096.0;  // P4 sec. 4.1: 40 px, 4096 px over 150 cells
constexpr int64_t kCellsPerParticle = 8;                  // about P4's 3000 particles on 150^2 cells
constexpr float kBeachTop_m = 4.0F;
constexpr float kDry_m = 0.3F;
constexpr double kBackReefDepth_m = 1.2;  // behind the rim and this far below the flat is lagoon
constexpr int kOutlineCells = 2048;

/// How many particles to shoot; throws where there is no room for those that are wanted.
int particles_for(int wanted, double lattice_m, const Habitat& habitat) {
  const int64_t room =
      reachable_habitat(habitat.suitable, habitat.kernels) - static_cast<int64_t>(habitat.kernels.size());
  if (wanted > room)
    throw InvalidArgument("particles", std::to_string(wanted) + " do not fit the " + std::to_string(room) +
                                           " free lattice cells that growth can reach; take fewer, or a lattice_m "
                                           "below " +
                                           format_number(lattice_m));
  return wanted > 0 ? wanted : static_cast<int>(room / kCellsPerParticle);
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

/// Islets: bumps on colonies in the thick of the reef, apart from each other.
ScalarField make_cays(int count, const std::vector<Colony>& colonies, const ScalarField& distance,
                      double swell_from_deg, double radius_m, Seed seed) {
  std::vector<std::pair<uint64_t, size_t>> order;
  for (size_t i = 0; i < colonies.size(); ++i) {
    const GridFrame& f = distance.frame();
    const double depth = static_cast<double>(
        geom::sample_bilinear(distance, f.column(colonies[i].centre.x), f.row(colonies[i].centre.y)));
    if (depth > 0.5 * radius_m) order.emplace_back(seed.derive("reef.cay", i).value, i);
  }
  std::sort(order.begin(), order.end());
  ScalarField cays(distance.frame(), 0.0F);
  std::vector<Vec2> placed;
  for (const auto& [hash, i] : order) {
    if (static_cast<int>(placed.size()) >= count) break;
    const Vec2 c = colonies[i].centre;
    if (std::any_of(placed.begin(), placed.end(), [&](Vec2 o) { return dot(o - c, o - c) < 36 * radius_m * radius_m; }))
      continue;
    placed.push_back(c);
    Rng rng(seed.derive("reef.cay_shape", i));
    const double along = radius_m * rng.uniform(0.45, 0.8), across = along * rng.uniform(0.4, 0.7);
    // Waves bend around the reef and pile the sand up across their way.
    const double angle = (swell_from_deg + rng.uniform(-35, 35)) * std::numbers::pi / 180.0;
    const Vec2 to_swell{std::sin(angle), std::cos(angle)};
    const GridFrame& f = cays.frame();
    const int reach = static_cast<int>(std::ceil(along / f.cell_m));
    const int cx = static_cast<int>(std::lround(f.column(c.x))), cy = static_cast<int>(std::lround(f.row(c.y)));
    for (int y = std::max(0, cy - reach); y <= std::min(f.height - 1, cy + reach); ++y) {
      for (int x = std::max(0, cx - reach); x <= std::min(f.width - 1, cx + reach); ++x) {
        const Vec2 d{f.x(x) - c.x, f.y(y) - c.y};
        const double u = dot(d, to_swell) / across, v = cross(d, to_swell) / along;
        const double bump = std::max(0.0, 1.0 - u * u - v * v);
        cays(x, y) = std::max(cays(x, y), static_cast<float>(bump * (2.0 - bump)));
      }
    }
  }
  return placed.empty() ? ScalarField() : cays;
}

/// Where land is and where water is enclosed, on the form's lattice.
ScalarField open_sea(const Form& form, const HeightField& terrain, double gap_m, const RunContext& run) {
  const HeightField ground = geom::resample(terrain, form.distance.frame(), run);
  return distance_to_open_sea(form.distance, ground, gap_m, run);
}

void stretch(HeightField& field, const FinishParams& p, const RunContext& run) {
  if (p.low_m >= p.high_m)
    throw InvalidArgument("finish.low_m", format_number(p.low_m) + " is not below finish.high_m");
  const auto [low, high] = std::minmax_element(field.cells().begin(), field.cells().end());
  const double from = *low, span = std::max(1e-6, static_cast<double>(*high) - from);
  const auto scale = static_cast<float>((p.high_m - p.low_m) / span);
  const auto offset = static_cast<float>(p.low_m);
  parallel_blocks(run, static_cast<int64_t>(field.size()), 1 << 18, [&](int64_t begin, int64_t end) {
    for (int64_t i = begin; i < end; ++i) {
      float& z = field.cells()[static_cast<size_t>(i)];
      z = offset + (z - static_cast<float>(from)) * scale;
    }
  });
}

Region region_of(float z, float reef, float to_open_sea, float lagoon_top) {
  if (z > kDry_m) return z < kBeachTop_m ? Region::beach : Region::mountain;
  if (reef >= 0.999F && z < lagoon_top) return Region::lagoon;  // behind the rim
  if (reef >= 0.5F) return Region::reef;
  return to_open_sea > 0.0F ? Region::lagoon : Region::abyss;
}

/// New regions; land and water that were labelled before and have no reef keep their labels, but for enclosed water.
LabelMap label_regions(const Grown& grown, const LabelMap* before, const ScalarField& to_open_sea, float lagoon_top,
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
        Region region =
            region_of(grown.terrain(x, y), grown.aggregate(x, y), away[static_cast<size_t>(x)] - node, lagoon_top);
        if (before != nullptr) {
          const Region old = (*before)(x, y);
          const bool both_land = region <= Region::beach && old <= Region::beach;
          if (both_land || (region == Region::abyss && old > Region::beach)) region = old;
        }
        labels(x, y) = region;
      }
    }
  });
  return labels;
}

/// Nothing stands on a sea without a floor.
void keep_floorless(const HeightField& terrain, Grown& out, const RunContext& run) {
  const Grid<uint8_t> no_floor = geom::flat_sea_to_coast(terrain, run);
  if (no_floor.empty()) return;
  run.say(
      "the sea of this terrain is 0 m everywhere, as elevation models of land give it: where it has no floor there "
      "is no reef (terrain.sea_floor gives it one)");
  for (size_t i = 0; i < no_floor.size(); ++i) {
    if (no_floor.cells()[i] == 0) continue;
    out.terrain.cells()[i] = 0.0F;
    out.aggregate.cells()[i] = 0.0F;
  }
}

void check_inputs(const GrowInputs& in, const GrowParams& params) {
  check_params(params);
  if (in.labels != nullptr) check_same_size("labels", in.labels->frame(), in.terrain.frame());
}

}  // namespace

Grown grow(const GrowInputs& in, const GrowParams& params, Seed seed, const RunContext& run) {
  check_inputs(in, params);
  const GridFrame& frame = in.terrain.frame();
  const double radius = params.kernel.radius_m.value_or(kRadiusInCells * params.lattice_m);
  const bool rising = params.heights.mode == Lift::saturating;
  const Habitat habitat =
      find_habitat(in.terrain, {in.habitat, in.start, in.drawing}, params.lattice_m,
                   params.bounds.margin_m.value_or(3.0 * radius), params.starts, params.bounds, seed, run);
  const WalkRules rules = walk_rules(params.walk, particles_for(params.particles, params.lattice_m, habitat));
  const Aggregate reef = aggregate(habitat.suitable, habitat.kernels, rules, seed, run.part(0.0, 0.2));

  const double irregular = params.irregularity;
  const KernelParams& kernel = params.kernel;
  const std::vector<Colony> colonies = place_colonies(
      reef.cells, habitat.lattice, {radius, 0.45 * irregular, 0.3 * irregular, kernel.k1, kernel.k1_jitter}, seed);
  const KernelTables tables(kernel);
  Form form;
  form.tables = &tables;
  const GridFrame shape = shape_frame(frame, radius / 8.0);
  const Bend bend{0.3 * radius * irregular, 5.0 * radius};
  form.distance = outline_distance(colonies, reef.cells, habitat.lattice, shape, bend, seed, run.part(0.2, 0.4));
  if (kernel.combine == Combine::sum) form.sums.emplace(colonies, kernel.k, kernel.k2);
  if (rising || kernel.combine == Combine::union_) {
    form.crowding = crowding(form.distance, 2.5 * radius, run);
    form.exposure = exposure(form.distance, params.swell_from_deg, 0.6 * radius, run);
  }
  if (rising && params.sand.cays > 0)
    form.cays = make_cays(params.sand.cays, colonies, form.distance, params.swell_from_deg, radius, seed);

  Grown out{HeightField(frame), ScalarField(frame), LabelMap()};
  const SurfaceParams surface{kernel, params.heights, params.sand, params.detail, irregular, radius};
  parallel_rows(run.part(0.5, 0.9), frame.width, frame.height, [&](int begin, int end) {
    SurfaceRows rows(form, surface, frame, seed);
    for (int y = begin; y < end; ++y) rows.row(y, in.terrain.row(y), out.terrain.row(y), out.aggregate.row(y));
  });
  if (params.finish.blur_m > 0) geom::gaussian_blur(out.terrain, params.finish.blur_m, run);
  keep_floorless(in.terrain, out, run);
  if (params.finish.normalise) stretch(out.terrain, params.finish, run);
  const auto lagoon_top = static_cast<float>(rising ? params.heights.flat_m - kBackReefDepth_m : -1e9);
  const ScalarField to_open_sea = open_sea(form, out.terrain, params.lagoon_gap_m.value_or(2.0 * radius), run);
  out.labels = label_regions(out, in.labels, to_open_sea, lagoon_top, run.part(0.9, 1.0));
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
