#include "seamount/ops/erosion/levels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/pyramid.h"
#include "seamount/geom/grid/sample_rows.h"
#include "seamount/geom/scalar/noise.h"

namespace seamount::erosion {
namespace {

// How deep erosion goes, or how thick deposits are, until half of a cell's own detail is gone; in cells.
constexpr double kErodedDepth = 3.0, kBuriedDepth = 0.1;
// Bends: their size and the deviation of the displacement, in fine cells; and the change of height, in fine cells, at
// which half of it is there.
constexpr double kBendSize = 8.0, kBend = 0.75, kBentDepth = 0.5;
constexpr double kMostCorrection = 0.1;

ScalarField halved_map(const ScalarField& map, const RunContext& run) {
  return map.empty() ? ScalarField() : geom::halved(map, run);
}

/// Curl of a noise along a row: (x, y) in fine cells, of deviation kBend. It moves ground without gathering or
/// spreading it.
class Bends {
 public:
  Bends(const GridFrame& frame, Seed seed)
      : frame_(frame), seed_(seed), shape_{.wavelength_m = kBendSize * frame.cell_m, .octaves = 1} {
    for (auto& row : noise_) row.resize(static_cast<size_t>(frame.width) + 2);
  }

  void read(int y, std::vector<float>& dx, std::vector<float>& dy) {
    for (int k = 0; k < 3; ++k) {
      geom::fbm_row(seed_, shape_, frame_.x(-1), frame_.cell_m, frame_.y(y + k - 1), noise_[static_cast<size_t>(k)]);
    }
    constexpr auto scale = static_cast<float>(0.5 * kBend * kBendSize);
    for (size_t x = 0; x < dx.size(); ++x) {
      dx[x] = scale * (noise_[2][x + 1] - noise_[0][x + 1]);
      dy[x] = scale * (noise_[1][x] - noise_[1][x + 2]);
    }
  }

 private:
  const GridFrame& frame_;
  Seed seed_;
  geom::Fbm shape_;
  std::array<std::vector<float>, 3> noise_;
};

/// Places of a fine row on the coarse grid, and what is read there.
struct Places {
  std::vector<float> column, row;
  explicit Places(int width) : column(static_cast<size_t>(width)), row(column) {}
  void set(size_t x, float fine_x, float fine_y) {
    column[x] = 0.5F * fine_x - 0.25F;
    row[x] = 0.5F * fine_y - 0.25F;
  }
  void read(const ScalarField& coarse, std::vector<float>& out) const {
    geom::sample_bicubic_rows(coarse, column, row, out);
  }
};

/// Volume of a change of a coarse ground in fine cells; `on_map`: without what of the cells at an odd edge lies off it.
struct Volume {
  double all = 0, on_map = 0;
};

Volume volume_of_change(const ScalarField& now, const ScalarField& start, const GridFrame& fine) {
  Volume sum;
  for (int y = 0; y < now.height(); ++y) {
    const double rows = 2 * y + 1 < fine.height ? 2.0 : 1.0;
    for (int x = 0; x < now.width(); ++x) {
      const double change = now(x, y) - start(x, y);
      sum.all += 4.0 * change;
      sum.on_map += rows * (2 * x + 1 < fine.width ? 2.0 : 1.0) * change;
    }
  }
  return sum;
}

/// One row of the fine ground.
class RowRefiner {
 public:
  RowRefiner(const Layers& now, const Layers& start, Layers& fine, const Maps& site, const Grid<uint8_t>& pinned,
             Seed seed)
      : now_(now),
        start_(start),
        fine_(fine),
        site_(site),
        pinned_(pinned),
        width_(static_cast<size_t>(fine.frame().width)),
        bends_(fine.frame(), seed),
        own_(fine.frame().width),
        bent_(fine.frame().width) {
    for (auto* row : {&dx_, &dy_, &open_, &before_, &after_}) row->resize(width_);
  }

  /// Writes by how much the surface changes, and changes the layers.
  void run(int y, std::span<float> change) {
    const size_t first = static_cast<size_t>(y) * width_;
    for (size_t x = 0; x < width_; ++x) {
      open_[x] = pinned_.data()[first + x] != 0 ? 0.0F : value_or_one(site_.mask, first + x);
      own_.set(x, static_cast<float>(x), static_cast<float>(y));
    }
    own_.read(now_.surface, after_);
    own_.read(start_.surface, before_);
    bends_.read(y, dx_, dy_);
    const auto half = static_cast<float>(1.0 / (kBentDepth * fine_.frame().cell_m));
    for (size_t x = 0; x < width_; ++x) {
      const float moved = (after_[x] - before_[x]) * half, share = open_[x] * moved * moved / (1.0F + moved * moved);
      bent_.set(x, static_cast<float>(x) + share * dx_[x], static_cast<float>(y) + share * dy_[x]);
    }
    bent_.read(now_.surface, after_);
    const auto eroded = static_cast<float>(1.0 / (kErodedDepth * fine_.frame().cell_m));
    const auto buried = static_cast<float>(1.0 / (kBuriedDepth * fine_.frame().cell_m));
    for (size_t x = 0; x < width_; ++x) {
      const float by = after_[x] - before_[x], moved = by * (by > 0.0F ? buried : eroded);
      const float detail = fine_.surface.data()[first + x] - before_[x];
      change[x] = open_[x] * (by - detail * (moved * moved / (1.0F + moved * moved)));
    }
    refine_layer(now_.debris, start_.debris, fine_.debris.row(y));
    refine_layer(now_.sediment, start_.sediment, fine_.sediment.row(y));
  }

 private:
  void refine_layer(const ScalarField& now, const ScalarField& start, std::span<float> layer) {
    bent_.read(now, after_);
    own_.read(start, before_);
    for (size_t x = 0; x < width_; ++x) layer[x] = std::max(0.0F, layer[x] + open_[x] * (after_[x] - before_[x]));
  }

  const Layers& now_;
  const Layers& start_;
  Layers& fine_;
  const Maps& site_;
  const Grid<uint8_t>& pinned_;
  size_t width_;
  Bends bends_;
  Places own_, bent_;
  std::vector<float> dx_, dy_, open_, before_, after_;
};

}  // namespace

Layers halved(const Layers& ground, const RunContext& run) {
  return {geom::halved(ground.surface, run), geom::halved(ground.debris, run), geom::halved(ground.sediment, run)};
}

Maps halved(const Maps& site, const RunContext& run) {
  return {halved_map(site.hardness, run), halved_map(site.mask, run), halved_map(site.uplift, run),
          halved_map(site.rain, run)};
}

void refine(const Layers& now, const Layers& start, Layers& fine, const Maps& site, const Grid<uint8_t>& pinned,
            Seed seed, Ledger& ledger, const RunContext& run) {
  const GridFrame& frame = fine.frame();
  ScalarField change(frame);
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    RowRefiner rows(now, start, fine, site, pinned, seed);
    for (int y = begin; y < end; ++y) rows.run(y, change.row(y));
  });
  double sum = 0, absolute = 0;
  for (const float by : change.cells()) sum += by, absolute += std::abs(by);
  const Volume coarse = volume_of_change(now.surface, start.surface, frame);
  const double missing = coarse.on_map - sum;
  const double share = absolute > 0 ? std::clamp(missing / absolute, -kMostCorrection, kMostCorrection) : 0.0;
  double added = 0;
  for (size_t i = 0; i < change.size(); ++i) {
    const float before = fine.surface.data()[i], by = change.data()[i];
    fine.surface.data()[i] += by + static_cast<float>(share) * std::abs(by);
    added += fine.surface.data()[i] - before;
  }
  ledger.exported += (coarse.all - added) * frame.cell_m * frame.cell_m;
}

}  // namespace seamount::erosion
