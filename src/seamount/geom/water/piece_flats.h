// Flats across the borders of pieces of a raster that is too large for memory (pieces.h), with the directions that
// flow_directions() gives on the whole. REQUIRES: filled ground, on which every flat drains.
//
// Where a cell of a flat flows to hangs on how many steps within the flat it is from where the flat drains, and how
// many from higher ground (flow_flats.h). A flat that lies in one piece is drained there. Of those that reach its rim a
// piece says what the steps are counted from; they are counted from there and from the rim, once it is known how many
// steps its cells are from what lies in other pieces.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/geom/water/flow.h"

namespace seamount::geom {

/// What the direction of a cell says besides. One of a flat that reaches the rim is kPit, or where it drains out of the
/// flat.
inline constexpr uint8_t kRimFlat = 16;
inline constexpr uint8_t kBesideHigher = 32;  ///< a rim flat's cell with a neighbour that is higher
inline constexpr uint8_t kDirection = 15;     ///< the direction alone

/// A piece of a window.
struct PieceIn {
  int x = 0, y = 0, width = 0, height = 0;
};

/// Directions in a piece, the flats that reach its rim marked. `filled`: heights of a window of two cells more on each
/// side, as far as the whole raster goes. Cost: as flow_directions().
FlowDirections piece_directions(const HeightField& filled, const PieceIn& piece, float sea_level_m,
                                const RunContext& run);

inline constexpr int32_t kNoFlat = -1;
inline constexpr int32_t kFarAway = INT32_MAX;

/// A cell of a piece, and how many steps it is from something.
struct FlatStart {
  int32_t cell = 0;
  int32_t steps = 0;
};

/// What steps are counted from in a piece itself.
std::vector<FlatStart> cells_that_drain(const FlowDirections& marked);
std::vector<FlatStart> cells_beside_higher(const FlowDirections& marked);

/// Steps of the cells of a piece's rim flats, and of those around the piece; 4 bytes a cell.
class FlatSteps {
 public:
  /// kFarAway on rim flats, kNoFlat elsewhere and around the piece.
  explicit FlatSteps(const FlowDirections& marked);

  int32_t at(int x, int y) const { return steps_[index(x, y)]; }
  int32_t of_cell(int32_t cell) const { return at(cell % width_, cell / width_); }
  /// Also one cell beside the piece, once all is counted in it.
  void set(int x, int y, int32_t steps) { steps_[index(x, y)] = steps; }

  /// Counts on from the starts, breadth first, where that gives fewer steps than were counted. `reached` is told which
  /// cells have how many. Linear. Throws Error for 2^31 steps and more.
  void spread(std::vector<FlatStart> starts, const RunContext& run,
              const std::function<void(std::span<const FlatStart>)>& reached = {});

 private:
  size_t index(int x, int y) const {
    return (static_cast<size_t>(y) + 1) * (static_cast<size_t>(width_) + 2) + static_cast<size_t>(x) + 1;
  }
  int width_;
  std::vector<int32_t> steps_;  ///< with a margin of one cell
};

/// Two rim cells of a piece, by rim number, and how many steps it is between them in it, within a flat.
struct FlatLink {
  int32_t a, b, steps;
};
struct RimLinks {
  std::vector<FlatLink> links;
  std::vector<uint8_t> linked;  ///< by rim number: is it linked with all others of its part?
};

/// Links the rim cells of such parts of flats as have few of them. At most 4 links for each rim cell; linear (16 looks
/// at each cell).
RimLinks link_rims(const FlowDirections& marked, const RunContext& run);

/// Gives the marked cells their directions, from the steps to where flats drain and from higher ground in the piece and
/// around it.
void aim_rim_flats(FlowDirections& marked, const FlatSteps& to_outlet, const FlatSteps& from_higher);

}  // namespace seamount::geom
