#include "seamount/train/dictionary_pieces.h"

#include <cmath>
#include <limits>
#include <optional>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/halve_cells.h"
#include "seamount/geom/scalar/quantile.h"

namespace seamount::train {
namespace {

using amplify::kCore, amplify::kDetail, amplify::kShape;

constexpr int kMargin = (kShape - kCore) / 2;  ///< coarse cells of a shape around its core
constexpr float kLargestDetail = 3.0F;         ///< metres for each of relief; more is an error of the data
constexpr double kErrors = 0.04;               ///< share of pieces whose detail is strongest for their relief: left out
constexpr int kTries = 4;                      ///< places drawn for a piece

/// A ground at one scale: its coarse cells, and what they do not say.
struct Scale {
  Grid<float> coarse, detail;
};

/// Land with an even number of cells along both sides; the rest is unknown.
HeightField even_land(const HeightField& ground) {
  GridFrame frame = ground.frame();
  frame.width &= ~1;
  frame.height &= ~1;
  HeightField land(frame);
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      const float z = ground(x, y);
      land(x, y) = z > 0.0F ? z : std::numeric_limits<float>::quiet_NaN();
    }
  }
  return land;
}

Scale scale_of(const HeightField& land, const RunContext& run) {
  Scale scale{geom::means_of_four(land, run), Grid<float>(land.frame(), 0.0F)};
  geom::add_halved_cells(scale.coarse, nullptr, scale.detail, run);
  for (size_t i = 0; i < scale.detail.size(); ++i) scale.detail.data()[i] = land.data()[i] - scale.detail.data()[i];
  return scale;
}

/// The piece whose shape begins at coarse cell (x, y), if it is of use.
std::optional<Piece> piece_at(const Scale& scale, int x, int y, double least_detail_m) {
  const amplify::Shape shape = amplify::describe_shape(&scale.coarse(x, y), scale.coarse.width());
  if (!(shape.relief_m > 0.0F)) return std::nullopt;  // level, or with unknown cells
  Piece piece{shape.features, {}, 0.0F};
  for (int row = 0; row < kDetail; ++row) {
    for (int column = 0; column < kDetail; ++column) {
      const auto [east, south] = amplify::on_ground(shape.turn, column, row, kDetail);
      const float detail = scale.detail(2 * (x + kMargin) + east, 2 * (y + kMargin) + south) / shape.relief_m;
      if (!(std::abs(detail) <= kLargestDetail)) return std::nullopt;
      piece.detail[kDetail * row + column] = detail;
      piece.strength += detail * detail;
    }
  }
  piece.strength = std::sqrt(piece.strength / (kDetail * kDetail));
  if (!(piece.strength > 0.0F) || piece.strength * shape.relief_m < least_detail_m) return std::nullopt;
  return piece;
}

}  // namespace

std::vector<Piece> draw_pieces(std::span<const HeightField> grounds, int count, double least_detail_m, Seed seed,
                               const RunContext& run) {
  std::vector<Scale> fine, wide;
  for (const HeightField& ground : grounds) {
    run.check_cancelled();
    if (ground.width() < 4 * kShape || ground.height() < 4 * kShape) continue;
    const HeightField land = even_land(ground);
    fine.push_back(scale_of(land, run.part(0.0, 0.0)));
    wide.push_back(scale_of(even_land(geom::means_of_four(land, run.part(0.0, 0.0))), run.part(0.0, 0.0)));
  }
  if (fine.empty()) return {};
  std::vector<std::optional<Piece>> drawn(static_cast<size_t>(count));
  parallel_blocks(run, count, 1024, [&](int64_t begin, int64_t end) {
    for (int64_t i = begin; i < end; ++i) {
      Rng rng(seed.derive("piece", static_cast<uint64_t>(i)));
      for (int tried = 0; tried < kTries && !drawn[i]; ++tried) {
        const std::vector<Scale>& scales = rng.chance(1.0 / 3.0) ? wide : fine;
        const Scale& scale = scales[rng.integer(0, static_cast<int>(scales.size()) - 1)];
        const int x = rng.integer(0, scale.coarse.width() - kShape), y = rng.integer(0, scale.coarse.height() - kShape);
        drawn[i] = piece_at(scale, x, y, least_detail_m);
      }
    }
  });
  std::vector<Piece> pieces;
  std::vector<float> strengths;
  for (const std::optional<Piece>& piece : drawn) {
    if (!piece) continue;
    pieces.push_back(*piece);
    strengths.push_back(piece->strength);
  }
  if (pieces.empty()) return pieces;
  const float most = geom::quantile(strengths, 1.0 - kErrors);
  std::erase_if(pieces, [most](const Piece& piece) { return piece.strength > most; });
  return pieces;
}

}  // namespace seamount::train
