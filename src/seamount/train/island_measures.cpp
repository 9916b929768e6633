#include "seamount/train/island_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

/// Every other sample has not sunk; of islands with other seeds than those of the training.
IslandSample measured_sample(const IslandSetParams& params, int n, Seed seed) {
  const uint64_t index = static_cast<uint64_t>(n) * static_cast<uint64_t>(params.levels) +
                         static_cast<uint64_t>(n % 2 == 0 ? 0 : 1 + n / 2 % (params.levels - 1));
  IslandSample drawn = draw_island_sample(params, index, seed);
  if (n % 2 == 0) drawn.subsidence = 0;
  return drawn;
}

/// One island, its map and what networks are told of it.
class Measured {
 public:
  Measured(const IslandSetParams& params, int n, Seed seed, const RunContext& run)
      : seed_(seed), drawn_(measured_sample(params, n, seed.derive("measured"))), run_(run) {
    pair_ = make_island_pair(params, drawn_, seed.derive("measured"), run);
    const auto [low, high] = std::minmax_element(pair_.terrain.cells().begin(), pair_.terrain.cells().end());
    low_ = *low;
    high_ = *high;
  }

  HeightField made(const learned::Network& network, const Image& painting) const {
    geom::PaintedLabels read = geom::decode_labels(painting, pair_.terrain.frame(), run_);
    learned::IslandMap map;
    map.frame = pair_.terrain.frame();
    map.shares = learned::without_specks(read.shares, run_);
    map.subsidence = std::move(read.subsidence_per_cell);
    map.floor_m = low_;  // P0's heights are shares of their range, ours may be told it
    if (high_ > 0) map.peak_m = high_;
    return learned::island(map, network, seed_, run_);
  }

  Image painting(MapDefect defect, int n) const {
    Rng rng(seed_.derive("defect", static_cast<uint64_t>(n)));
    Image image = geom::encode_labels(pair_.labels, drawn_.subsidence);
    spoil(image, pair_.terrain.frame(), defect, drawn_.subsidence, rng, run_);
    return image;
  }

  bool sunk() const { return drawn_.subsidence > 0; }

  /// Mean |dz| of what is higher, as a share of the range from there up; negative: there is nothing.
  double off(const HeightField& made, float above_m) const {
    double sum = 0;
    int cells = 0;
    for (size_t i = 0; i < made.size(); ++i) {
      const float z = pair_.terrain.data()[i];
      if (z <= above_m) continue;
      sum += std::abs(made.data()[i] - z);
      ++cells;
    }
    return cells == 0 ? -1.0 : sum / cells / (high_ - std::max(above_m, low_));
  }

  /// Intersection over union of the land painted and the land made; negative: there is none.
  double coast_iou(const HeightField& made) const {
    int both = 0, either = 0;
    for (size_t i = 0; i < made.size(); ++i) {
      const Region region = pair_.labels.data()[i];
      const bool land = region == Region::mountain || region == Region::beach;
      both += land && made.data()[i] > 0;
      either += land || made.data()[i] > 0;
    }
    return either == 0 ? -1.0 : static_cast<double>(both) / either;
  }

 private:
  Seed seed_;
  IslandSample drawn_;
  const RunContext& run_;
  IslandPair pair_;
  float low_ = 0, high_ = 0;
};

/// Of those numbers that there are.
class Mean {
 public:
  void add(double value) {
    if (value < 0) return;
    sum_ += value;
    ++count_;
  }
  double value() const { return sum_ / std::max(1, count_); }

 private:
  double sum_ = 0;
  int count_ = 0;
};

}  // namespace

IslandMeasures measure_islands(const learned::Network& network, int count, Seed seed, const RunContext& run) {
  constexpr float kAll = -std::numeric_limits<float>::infinity();
  IslandSetParams params;
  params.size = learned::kIslandCells;
  params.width_m = learned::kIslandWidth_m;
  std::array<Mean, kMapDefects.size()> off, off_above;
  Mean coast;
  for (int n = 0; n < count; ++n) {
    run.check_cancelled();
    run.report(static_cast<double>(n) / count);
    const Measured island(params, n, seed, run);
    for (size_t defect = 0; defect < kMapDefects.size(); ++defect) {
      const Image painting = island.painting(static_cast<MapDefect>(defect), n);
      const HeightField made = island.made(network, painting);
      off[defect].add(island.off(made, kAll));
      off_above[defect].add(island.off(made, kShallow_m));
      if (defect == 0 && !island.sunk()) coast.add(island.coast_iou(made));
    }
  }
  IslandMeasures out;
  out.maps = count;
  for (size_t defect = 0; defect < kMapDefects.size(); ++defect) {
    out.off[defect] = off[defect].value();
    out.off_above[defect] = off_above[defect].value();
  }
  out.coast_iou = coast.value();
  return out;
}

}  // namespace seamount::train
