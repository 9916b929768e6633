// Paired dictionaries: what pieces of coarse ground look like, and the detail that real ground of that look has.
//
// Source: Guerin, Digne, Galin and Peytavie 2016, "Sparse representation of terrains for procedural modeling", which
// P1 sec. 6.2 builds on. Here an atom's fine half is the ground less the coarse half refined (geom/grid/halve_cells.h),
// so that it has no share in what is known already, and coarse halves are compared as they are described (shape.h)
// instead of cell by cell.
#pragma once

#include <span>
#include <vector>

#include "seamount/model/weights.h"
#include "seamount/ops/amplify/shape.h"

namespace seamount::amplify {

/// Metres of detail for each metre of relief, row by row of the turned shape's core.
using Detail = std::array<float, kDetail * kDetail>;

struct Dictionary {
  std::vector<Features> shapes;  ///< of length one
  std::vector<Detail> details;   ///< as many
};

inline constexpr int kMostAtoms = 32768;

/// From "shapes" (n x 16) and "details" (n x 8 x 8) of weights that say of themselves {"kind": "dictionary"}. Throws
/// Error that says what is wrong: another kind, a tensor that is missing, of another size or superfluous, more than
/// kMostAtoms, shapes that are not of length one, numbers that are not finite or details beyond 10.
Dictionary dictionary_of(const Weights& weights);

/// The inverse, with what is said about it.
Weights weights_of(const Dictionary& dictionary);

/// The atoms' shapes as the search reads them: sixteen atoms side by side.
class AtomTable {
 public:
  /// REQUIRES: at least one shape.
  explicit AtomTable(std::span<const Features> shapes);

  struct Match {
    int atom;      ///< the nearest: of the largest product with the shape, the first of equals
    float cosine;  ///< the product
  };
  /// For each shape its nearest atom. Serial; about 1 ns for each pair of a shape and two atoms.
  void find(std::span<const Features> shapes, std::span<Match> matches) const;

 private:
  std::vector<float> tiles_;  ///< [tile of 16 atoms][feature][atom]; beyond the last atom the first again
};

}  // namespace seamount::amplify
