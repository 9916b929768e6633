#include "seamount/ops/island/coral.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"
#include "seamount/geom/grid/sample_rows.h"
#include "seamount/geom/grid/upsample_rows.h"
#include "seamount/geom/polygon/distance.h"
#include "seamount/geom/scalar/blend.h"
#include "seamount/geom/scalar/curve.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/geom/water/flat_sea.h"
#include "seamount/model/same_size.h"
#include "seamount/ops/island/coordinate.h"
#include "seamount/ops/island/exposure.h"
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
  float islet_threshold = 0;
};

ReefNoise reef_noise(const CoralParams& params, double reef_width, double cell) {
  const double share = std::clamp(params.islets, 1e-4, 1.0 - 1e-4);
  const double probit =
      std::log((1.0 - share) / share) / 1.702;  // normal quantile; noise has a deviation of about 0.35
  return {{.wavelength_m = 650.0, .octaves = 6, .gain = 0.58, .cell_m = cell},
          {.wavelength_m = 5.0 * reef_width, .octaves = 4, .gain = 0.55, .cell_m = cell},
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

/// Windward reefs have a narrow flat and lie further in. A bijection of [0, 1] for |exposed| <= 1.
SEAMOUNT_VECTORISED void shift_by_exposure(const float* __restrict exposed, int count, float* __restrict across) {
  for (int i = 0; i < count; ++i) {
    const float x = across[i];
    across[i] = x + exposed[i] * x * (1.0F - x) * (0.3F + 1.3F * (x - 0.5F));
  }
}

/// The reef's own height at one place: profile, uneven floor, islets; z_s is the sunken island there.
SEAMOUNT_INLINE float reef_height(const RowShape& s, float flat_profile, float x, float z_s, float beyond,
                                  float floor_noise, float islet_noise, float exposed) {
  const float on_crest = geom::smoothstep((flat_profile - s.back_m) / (s.crest_m - s.back_m + 1e-3F));
  const float profile = flat_profile + 0.8F * exposed * on_crest;
  const float on_floor = geom::smoothstep((s.crest_m - profile) * 0.25F);  // 0 on the crest, 1 from 4 m below it
  const float inside = x < s.crest_end ? 1.0F : 0.0F;
  const float uneven = profile + inside * on_floor * s.lagoon_relief * floor_relief(floor_noise, islet_noise);
  const float lid = profile > s.crest_m - 1.0F ? profile : s.crest_m - 1.0F;  // patch reefs stay below the crest
  float coral = uneven < lid ? uneven : lid;
  coral -= s.talus * beyond;
  // Islets stand just behind the crest, where the reef stands free of the island.
  const float across = (x - (s.crest_start - 0.06F)) * 9.0F;
  const float bump = across > -1.0F && across < 1.0F ? (1.0F - across * across) * (1.0F - across * across) : 0.0F;
  const float along = geom::smoothstep((islet_noise + 0.5F * exposed - s.islet_threshold) * 9.0F);
  const float free = geom::smoothstep((s.crest_m - z_s - 4.0F) * 0.1F);
  return coral + bump * along * free * (s.islet_m - s.crest_m);
}

SEAMOUNT_VECTORISED void coral_row(const RowShape s, const float* height, const float* profile, const float* across,
                                   const float* beyond, const float* floor_noise, const float* islet_noise,
                                   const float* channel, const float* exposed, float pass_m, float* out, int count) {
  for (int i = 0; i < count; ++i) {
    const float z_s = s.subsided_offset + s.subsided_scale * height[i];
    float coral = reef_height(s, profile[i], across[i], z_s, beyond[i], floor_noise[i], islet_noise[i], exposed[i]);
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

namespace {

/// Everything that a row of the reef is made from.
struct Reef {
  const CoralParams& params;
  const ScalarField& coordinate;
  ScalarField beyond;   ///< metres beyond the reef; empty: the fore reef stays at abyss_m
  ScalarField exposed;  ///< -1 to 1 by the swell; empty: none
  ReefPasses passes;
  ReefNoise noise;
  geom::CurveTable profile;
  RowShape shape;
};

/// Mouths of the rivers on the island as it stands, sunk by `subsidence` over `floor`.
std::vector<RiverMouth> mouths_after(const HeightField& terrain, double floor, double subsidence,
                                     const RunContext& run) {
  if (subsidence >= 1.0) return {};
  return river_mouths(terrain, static_cast<float>(floor - floor / (1.0 - subsidence)), run);
}

RowShape row_shape(const CoralParams& params, double floor, float islet_threshold) {
  return {static_cast<float>(1.0 - params.subsidence),
          static_cast<float>(subside(0.0, floor, params.subsidence)),
          static_cast<float>(0.5 / params.blend_m),
          static_cast<float>(std::tan(params.section.fore_reef_slope_deg * std::numbers::pi / 180.0)),
          static_cast<float>(params.lagoon_relief_m),
          static_cast<float>(params.islet_m),
          static_cast<float>(params.section.crest_m),
          static_cast<float>(params.section.back_m),
          islet_threshold,
          static_cast<float>(params.section.crest_start),
          static_cast<float>(params.section.crest_end)};
}

/// Rows of the reef, with the scratch of one thread.
class RowMaker {
 public:
  RowMaker(const Reef& reef, const GridFrame& frame, Seed seed)
      : reef_(reef),
        frame_(frame),
        seed_(seed),
        across_(static_cast<size_t>(frame.width)),
        rise_(across_.size()),
        away_(across_.size(), 0.0F),
        floor_noise_(across_.size(), 0.0F),
        islet_noise_(across_.size(), 0.0F),
        channel_(across_.size()),
        exposed_(across_.size(), 0.0F),
        columns_(across_.size()),
        rows_(across_.size()) {
    for (size_t i = 0; !reef.beyond.empty() && i < columns_.size(); ++i)
      columns_[i] = static_cast<float>(reef.beyond.frame().column(frame.x(static_cast<double>(i))));
  }

  void make(int y, const HeightField& terrain, HeightField& out) {
    const auto x = reef_.coordinate.row(y);
    for (size_t i = 0; i < x.size(); ++i) across_[i] = std::clamp(x[i] - kReef, 0.0F, 1.0F);
    if (!reef_.exposed.empty()) {
      geom::RowUpsampler(reef_.exposed).read(frame_.x(0), frame_.cell_m, frame_.y(y), exposed_);
      for (float& e : exposed_) e *= static_cast<float>(reef_.params.exposure);
      shift_by_exposure(exposed_.data(), frame_.width, across_.data());
    }
    reef_.profile.evaluate(across_, rise_);
    fall_on(y, x);
    add_noise(y, x);
    reef_.passes.row(frame_, y, channel_);
    coral_row(reef_.shape, terrain.row(y).data(), rise_.data(), across_.data(), away_.data(), floor_noise_.data(),
              islet_noise_.data(), channel_.data(), exposed_.data(), static_cast<float>(-reef_.params.pass_depth_m),
              out.row(y).data(), frame_.width);
  }

  bool behind_crest(int x) const { return across_[static_cast<size_t>(x)] < reef_.shape.crest_start; }

 private:
  void fall_on(int y, std::span<const float> x) {
    if (reef_.beyond.empty()) return;
    std::fill(rows_.begin(), rows_.end(), static_cast<float>(reef_.beyond.frame().row(frame_.y(y))));
    geom::sample_bilinear_rows(reef_.beyond, columns_, rows_, away_);
    for (size_t i = 0; i < x.size(); ++i) away_[i] = x[i] < kReef + 1.0F ? 0.0F : away_[i];
  }

  /// Unevenness counts inside the outer border of the reef alone.
  void add_noise(int y, std::span<const float> x) {
    size_t first = 0, last = x.size();
    while (first < last && x[first] >= kReef + 1.0F) ++first;
    while (last > first && x[last - 1] >= kReef + 1.0F) --last;
    if (first == last) return;
    const double x0 = frame_.x(static_cast<double>(first));
    const auto part = [&](std::vector<float>& row) { return std::span<float>(&row[first], last - first); };
    if (reef_.params.lagoon_relief_m > 0)
      geom::fbm_row(seed_.derive("island.lagoon"), reef_.noise.floor, x0, frame_.cell_m, frame_.y(y),
                    part(floor_noise_));
    if (reef_.params.islets > 0 || reef_.params.lagoon_relief_m > 0)
      geom::fbm_row(seed_.derive("island.islets"), reef_.noise.islets, x0, frame_.cell_m, frame_.y(y),
                    part(islet_noise_));
  }

  const Reef& reef_;
  const GridFrame& frame_;
  Seed seed_;
  std::vector<float> across_, rise_, away_, floor_noise_, islet_noise_, channel_, exposed_, columns_, rows_;
};

}  // namespace

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
  const std::vector<RiverMouth> mouths =
      params.passes != 0 ? mouths_after(terrain, floor, params.subsidence, run) : std::vector<RiverMouth>();
  const ReefPasses passes(*coordinate, params.passes, params.pass_width_m, mouths, seed, run);
  const ReefNoise noise = reef_noise(params, passes.reef_width_m(), frame.cell_m);
  const double smooth_m = 2.0 * passes.reef_width_m();
  const Reef reef{params,
                  *coordinate,
                  params.section.fore_reef_slope_deg > 0 ? distance_beyond_reef(labels, run) : ScalarField(),
                  params.exposure > 0 ? exposure(*coordinate, params.swell_from_deg, smooth_m, run) : ScalarField(),
                  passes,
                  noise,
                  coral_table(params.section),
                  row_shape(params, floor, noise.islet_threshold)};
  const Grid<uint8_t> no_floor = geom::flat_sea_to_coast(terrain, run);
  if (!no_floor.empty())
    run.say(
        "the sea of this terrain is 0 m everywhere, as elevation models of land give it: where it has no floor there "
        "is no reef (terrain.sea_floor gives it one)");
  Reefed out{HeightField(frame), LabelMap(frame)};
  parallel_rows(run.part(0.4, 1.0), frame.width, frame.height, [&](int begin, int end) {
    RowMaker rows(reef, frame, seed);
    for (int y = begin; y < end; ++y) {
      rows.make(y, terrain, out.terrain);
      for (int i = 0; i < frame.width; ++i) {
        const bool floorless = !no_floor.empty() && no_floor(i, y) != 0;
        if (floorless) out.terrain(i, y) = 0.0F;
        out.labels(i, y) = !params.relabel ? labels(i, y)
                           : floorless
                               ? Region::abyss
                               : relabelled(labels(i, y), out.terrain(i, y), rows.behind_crest(i), reef.shape.crest_m);
      }
    }
  });
  return out;
}

}  // namespace seamount::island
