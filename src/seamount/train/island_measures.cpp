#include "seamount/train/island_measures.h"

#include <algorithm>
#include <cmath>

#include "seamount/geom/grid/painted_labels.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/ops/learned/island.h"
#include "seamount/train/island_samples.h"

namespace seamount::train {
namespace {

constexpr float kShallow_m = -60.0F;  ///< down to here a map of regions tells heights

void spoil(Image& image, const GridFrame& frame, MapDefect defect, double subsidence, Rng& rng, const RunContext& run) {
  if (defect == MapDefect::blur) {
    for (size_t channel = 0; channel < 3; ++channel) {
      ScalarField plane(frame);
      for (size_t i = 0; i < plane.size(); ++i) plane.data()[i] = image.rgb[3 * i + channel];
      geom::gaussian_blur(plane, 2.0 * frame.cell_m, run);
      for (size_t i = 0; i < plane.size(); ++i)
        image.rgb[3 * i + channel] = static_cast<uint8_t>(std::lround(plane.data()[i]));
    }
  } else if (defect == MapDefect::noise) {
    for (uint8_t& value : image.rgb) value = static_cast<uint8_t>(std::clamp(value + 20.0 * rng.normal(), 0.0, 255.0));
  } else if (defect == MapDefect::specks) {
    for (int i = 0; i < 400; ++i) {
      const Colour colour = painted_colour(kRegions[static_cast<size_t>(rng.integer(0, kRegionCount - 1))], subsidence);
      uint8_t* const p = image.pixel(rng.integer(0, image.width - 1), rng.integer(0, image.height - 1));
      p[0] = colour.r;
      p[1] = colour.g;
      p[2] = colour.b;
    }
  } else if (defect ==
             MapDefect::jpeg) {  // colour known for blocks of eight pixels only half as well, as JPEG keeps it
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) {
        const uint8_t* const block =
            image.pixel(std::min(x / 8 * 8 + 4, image.width - 1), std::min(y / 8 * 8 + 4, image.height - 1));
        uint8_t* const p = image.pixel(x, y);
        if (x % 8 == 4 && y % 8 == 4) continue;
        for (int c = 0; c < 3; ++c) p[c] = static_cast<uint8_t>((4 * p[c] + block[c]) / 5);
      }
    }
  }
}

}  // namespace

IslandMeasures measure_islands(const learned::Network& network, int count, Seed seed, const RunContext& run) {
  IslandMeasures out;
  IslandSetParams params;
  params.size = learned::kIslandCells;
  params.width_m = learned::kIslandWidth_m;
  std::array<int, kMapDefects.size()> shallow{};
  int unsunk = 0;
  for (int n = 0; n < count; ++n) {
    run.check_cancelled();
    run.report(static_cast<double>(n) / count);
    // Every other sample has not sunk; of islands with other seeds than those of the training.
    const uint64_t index = static_cast<uint64_t>(n) * static_cast<uint64_t>(params.levels) +
                           static_cast<uint64_t>(n % 2 == 0 ? 0 : 1 + n / 2 % (params.levels - 1));
    IslandSample drawn = draw_island_sample(params, index, seed.derive("measured"));
    if (n % 2 == 0) drawn.subsidence = 0;
    const IslandPair pair = make_island_pair(params, drawn, seed.derive("measured"), run);
    const auto [low, high] = std::minmax_element(pair.terrain.cells().begin(), pair.terrain.cells().end());
    const double range = *high - *low;
    for (size_t defect = 0; defect < kMapDefects.size(); ++defect) {
      Rng rng(seed.derive("defect", static_cast<uint64_t>(n)));
      Image image = geom::encode_labels(pair.labels, drawn.subsidence);
      spoil(image, pair.terrain.frame(), static_cast<MapDefect>(defect), drawn.subsidence, rng, run);
      geom::PaintedLabels read = geom::decode_labels(image, pair.terrain.frame(), run);
      learned::IslandMap map;
      map.frame = pair.terrain.frame();
      map.shares = learned::without_specks(read.shares, run);
      map.subsidence = std::move(read.subsidence_per_cell);
      map.floor_m = *low;  // P0's heights are shares of their range, ours may be told it
      if (*high > 0) map.peak_m = *high;
      const HeightField made = learned::island(map, network, seed, run);
      double sum = 0, above = 0;
      int cells = 0, both = 0, either = 0;
      for (size_t i = 0; i < made.size(); ++i) {
        const float z = pair.terrain.data()[i], off = std::abs(made.data()[i] - z);
        sum += off;
        if (z > kShallow_m) {
          above += off;
          ++cells;
        }
        const Region region = pair.labels.data()[i];
        const bool land = region == Region::mountain || region == Region::beach;
        both += land && made.data()[i] > 0;
        either += land || made.data()[i] > 0;
      }
      out.off[defect] += sum / static_cast<double>(made.size()) / range;
      if (cells > 0) {
        out.off_above[defect] += above / cells / (*high - kShallow_m);
        ++shallow[defect];
      }
      if (defect == 0 && drawn.subsidence == 0 && either > 0) {
        out.coast_iou += static_cast<double>(both) / either;
        ++unsunk;
      }
    }
    ++out.maps;
  }
  for (size_t defect = 0; defect < kMapDefects.size(); ++defect) {
    out.off[defect] /= out.maps;
    out.off_above[defect] /= std::max(1, shallow[defect]);
  }
  out.coast_iou /= std::max(1, unsunk);
  return out;
}

}  // namespace seamount::train
