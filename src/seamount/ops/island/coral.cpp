#include "seamount/ops/island/coral.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"
#include "seamount/geom/grid/sample_rows.h"
#include "seamount/geom/polygon/distance.h"
#include "seamount/geom/scalar/blend.h"
#include "seamount/geom/scalar/curve.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/geom/water/flat_sea.h"
#include "seamount/model/same_size.h"
#include "seamount/ops/island/coordinate.h"
#include "seamount/ops/island/reef_passes.h"

namespace seamount::island {
namespace {

constexpr float kReef = static_cast<float>(Region::reef);
constexpr float kBackReefDepth_m = 4.0F;  // behind the crest and this far below it is lagoon
constexpr float kBeachTop_m = 4.0F;       // what has sunk to below this height is beach

void check_breakpoints(const ReefSection& p) {
  const std::array<std::pair<const char*, double>, 5> order = {{{"back_start", p.back_start},
                                                                {"back_end", p.back_end},
                                                                {"crest_start", p.crest_start},
                                                                {"crest_end", p.crest_end},
                                                                {"abyss_start", p.abyss_start}}};
  for (size_t i = 0; i + 1 < order.size(); ++i) {
    const bool transition_follows = i == 1 || i == 3;
    const bool fine =
        transition_follows ? order[i].second < order[i + 1].second : order[i].second <= order[i + 1].second;
    if (fine) continue;
    throw InvalidArgument(std::string("section.") + order[i + 1].first, format_number(order[i + 1].second) +
                                                                            " does not follow " + order[i].first +
                                                                            " = " + format_number(order[i].second));
  }
}

/// h_coral as a table over x in [0, 1].
geom::CurveTable coral_table(const ReefSection& section) {
  constexpr int kSamples = 2048;
  Curve curve;
  for (int i = 0; i <= kSamples; ++i) {
    const double x = static_cast<double>(i) / kSamples;
    curve.knots.push_back({x, coral_profile(section, x)});
  }
  return geom::CurveTable(geom::CurveFunction(curve, geom::CurveKind::linear), 0.0, 1.0, kSamples + 1);
}

/// Distance in metres beyond the outer border of the reef, 0 within; on a lattice of at most 2048 cells a side.
ScalarField distance_beyond_reef(const LabelMap& labels, const RunContext& run) {
  const int step = std::max(1, std::max(labels.width(), labels.height()) / 2048);
  GridFrame lattice = labels.frame();
  lattice.cell_m *= step;
  lattice.width = (labels.width() + step - 1) / step;
  lattice.height = (labels.height() + step - 1) / step;
  Grid<uint8_t> within(lattice);
  for (int y = 0; y < lattice.height; ++y) {
    for (int x = 0; x < lattice.width; ++x) {
      within(x, y) = labels.clamped(x * step + step / 2, y * step + step / 2) != Region::abyss ? 1 : 0;
    }
  }
  ScalarField distance = geom::distance_to(within, run);
  const auto half = static_cast<float>(0.5 * lattice.cell_m);
  for (float& d : distance.cells()) d = std::isinf(d) ? 1e7F : std::max(0.0F, d - half);
  return distance;
}

/// Rows of noise that make the reef uneven.
struct ReefNoise {
  geom::Fbm floor;   ///< patch reefs and hollows of the lagoon
  geom::Fbm islets;  ///< where islets stand, and where patch reefs crowd
  Seed seed;
  float islet_threshold = 0;
};

ReefNoise reef_noise(const CoralParams& params, double reef_width, double cell, Seed seed) {
  const double share = std::clamp(params.islets, 1e-4, 1.0 - 1e-4);
  const double probit =
      std::log((1.0 - share) / share) / 1.702;  // normal quantile; noise has a deviation of about 0.35
  return {{.wavelength_m = 650.0, .octaves = 6, .gain = 0.58, .cell_m = cell},
          {.wavelength_m = 5.0 * reef_width, .octaves = 4, .gain = 0.55, .cell_m = cell},
          seed,
          static_cast<float>(params.islets > 0 ? 0.35 * probit : 1e9)};
}

struct RowShape {
  float subsided_scale, subsided_offset, k, talus, lagoon_relief, islet_m, crest_m, back_m, islet_threshold,
      crest_start, crest_end;
};

/// Basins and shoals, low hummocks, and patch reefs where the noise is high: crowded on shoals, rare in basins.
SEAMOUNT_INLINE float floor_relief(float n, float shoal) {
  const float share = 0.45F + 1.6F * shoal;
  const float threshold = 0.66F - 0.5F * (share > 0.0F ? (share < 1.0F ? share : 1.0F) : 0.0F);
  return 1.4F * shoal + 0.4F * n + 6.0F * (n > threshold ? n - threshold : 0.0F);
}

/// The reef's own height at one place: profile, uneven floor, islets; z_s is the sunken island there.
SEAMOUNT_INLINE float reef_height(const RowShape& s, float profile, float x, float z_s, float beyond, float floor_noise,
                                  float islet_noise) {
  const float on_floor = geom::smoothstep((s.crest_m - profile) * 0.25F);  // 0 on the crest, 1 from 4 m below it
  const float inside = x < s.crest_end ? 1.0F : 0.0F;
  const float uneven = profile + inside * on_floor * s.lagoon_relief * floor_relief(floor_noise, islet_noise);
  const float lid = profile > s.crest_m - 1.0F ? profile : s.crest_m - 1.0F;  // patch reefs stay below the crest
  float coral = uneven < lid ? uneven : lid;
  coral -= s.talus * beyond;
  // Islets stand just behind the crest, where the reef stands free of the island.
  const float across = (x - (s.crest_start - 0.06F)) * 9.0F;
  const float bump = across > -1.0F && across < 1.0F ? (1.0F - across * across) * (1.0F - across * across) : 0.0F;
  const float along = geom::smoothstep((islet_noise - s.islet_threshold) * 9.0F);
  const float free = geom::smoothstep((s.crest_m - z_s - 4.0F) * 0.1F);
  return coral + bump * along * free * (s.islet_m - s.crest_m);
}

SEAMOUNT_VECTORISED void coral_row(const RowShape s, const float* height, const float* profile, const float* across,
                                   const float* beyond, const float* floor_noise, const float* islet_noise,
                                   const float* channel, float pass_m, float* out, int count) {
  for (int i = 0; i < count; ++i) {
    const float z_s = s.subsided_offset + s.subsided_scale * height[i];
    float coral = reef_height(s, profile[i], across[i], z_s, beyond[i], floor_noise[i], islet_noise[i]);
    const float cut = coral < pass_m ? coral : pass_m;
    coral += channel[i] * (cut - coral);
    out[i] = geom::smax(z_s, coral, s.k);
  }
}

/// What a place is after subsidence: drowned land and deep back reef are lagoon, islets and low land are beach.
Region relabelled(Region label, float z, bool behind_crest, float crest_m) {
  if (label == Region::mountain || label == Region::beach) {
    if (z < 0.0F) return Region::lagoon;
    return label == Region::mountain && z < kBeachTop_m ? Region::beach : label;
  }
  if (label != Region::reef) return label;
  if (z > 0.3F) return Region::beach;
  return behind_crest && z < crest_m - kBackReefDepth_m ? Region::lagoon : label;
}

}  // namespace

double transition(double a, double b, double x0, double x1, double x) {
  return a + (b - a) * geom::smoothstep((x - x0) / (x1 - x0));
}

double coral_profile(const ReefSection& p, double x) {
  if (x <= p.back_end) return p.back_m;
  if (x < p.crest_start) return transition(p.back_m, p.crest_m, p.back_end, p.crest_start, x);
  if (x <= p.crest_end) return p.crest_m;
  if (x < p.abyss_start) return transition(p.crest_m, p.abyss_m, p.crest_end, p.abyss_start, x);
  return p.abyss_m;
}

Reefed coral(const HeightField& terrain, const LabelMap& labels, const ScalarField* coordinate,
             const CoralParams& params, Seed seed, const RunContext& run) {
  check_params(params);
  check_breakpoints(params.section);
  const GridFrame& frame = terrain.frame();
  check_same_size("labels", labels.frame(), frame);
  if (coordinate != nullptr) check_same_size("coordinate", coordinate->frame(), frame);
  ScalarField derived;
  if (coordinate == nullptr) {
    derived = coordinate_from_labels(labels, run.part(0.0, 0.3));
    coordinate = &derived;
  }
  const double floor = params.floor_m.value_or(*std::min_element(terrain.cells().begin(), terrain.cells().end()));
  const bool falls_on = params.section.fore_reef_slope_deg > 0;
  const ScalarField beyond = falls_on ? distance_beyond_reef(labels, run) : ScalarField();
  const ReefPasses passes(*coordinate, params.passes, params.pass_width_m, seed, run);
  const ReefNoise noise = reef_noise(params, passes.reef_width_m(), frame.cell_m, seed);
  const geom::CurveTable profile = coral_table(params.section);
  const auto sunk = static_cast<float>(params.subsidence);
  const RowShape shape{1.0F - sunk,
                       static_cast<float>(subside(0.0, floor, params.subsidence)),
                       static_cast<float>(0.5 / params.blend_m),
                       static_cast<float>(std::tan(params.section.fore_reef_slope_deg * std::numbers::pi / 180.0)),
                       static_cast<float>(params.lagoon_relief_m),
                       static_cast<float>(params.islet_m),
                       static_cast<float>(params.section.crest_m),
                       static_cast<float>(params.section.back_m),
                       noise.islet_threshold,
                       static_cast<float>(params.section.crest_start),
                       static_cast<float>(params.section.crest_end)};
  const Grid<uint8_t> no_floor = geom::flat_sea_to_coast(terrain, run);
  if (!no_floor.empty())
    run.say(
        "the sea of this terrain is 0 m everywhere, as elevation models of land give it: where it has no floor there "
        "is no reef (terrain.sea_floor gives it one)");
  Reefed out{HeightField(frame), LabelMap(frame)};
  parallel_rows(run.part(0.4, 1.0), frame.width, frame.height, [&](int begin, int end) {
    const auto width = static_cast<size_t>(frame.width);
    std::vector<float> across(width), rise(width), away(width, 0.0F), floor_noise(width, 0.0F),
        islet_noise(width, 0.0F), channel(width);
    std::vector<float> columns(width), rows(width);
    for (size_t i = 0; falls_on && i < width; ++i)
      columns[i] = static_cast<float>(beyond.frame().column(frame.x(static_cast<double>(i))));
    for (int y = begin; y < end; ++y) {
      const auto x = coordinate->row(y);
      for (size_t i = 0; i < width; ++i) across[i] = std::clamp(x[i] - kReef, 0.0F, 1.0F);
      profile.evaluate(across, rise);
      if (falls_on) {
        std::fill(rows.begin(), rows.end(), static_cast<float>(beyond.frame().row(frame.y(y))));
        geom::sample_bilinear_rows(beyond, columns, rows, away);
        for (size_t i = 0; i < width; ++i) away[i] = x[i] < kReef + 1.0F ? 0.0F : away[i];
      }
      if (params.lagoon_relief_m > 0)
        geom::fbm_row(seed.derive("island.lagoon"), noise.floor, frame.x(0), frame.cell_m, frame.y(y), floor_noise);
      if (params.islets > 0 || params.lagoon_relief_m > 0)
        geom::fbm_row(seed.derive("island.islets"), noise.islets, frame.x(0), frame.cell_m, frame.y(y), islet_noise);
      passes.row(frame, y, channel);
      coral_row(shape, terrain.row(y).data(), rise.data(), across.data(), away.data(), floor_noise.data(),
                islet_noise.data(), channel.data(), static_cast<float>(-params.pass_depth_m), out.terrain.row(y).data(),
                frame.width);
      for (int i = 0; i < frame.width; ++i) {
        const bool behind_crest = across[static_cast<size_t>(i)] < shape.crest_start;
        if (!no_floor.empty() && no_floor(i, y) != 0) {
          out.terrain(i, y) = 0.0F;
          out.labels(i, y) = params.relabel ? Region::abyss : labels(i, y);
          continue;
        }
        out.labels(i, y) =
            params.relabel ? relabelled(labels(i, y), out.terrain(i, y), behind_crest, shape.crest_m) : labels(i, y);
      }
    }
  });
  return out;
}

}  // namespace seamount::island
