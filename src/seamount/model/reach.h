// How far an operator looks: which cells of its inputs a cell of its outputs hangs on. What looks at its own place or
// at a neighbourhood can be run window by window (GridFrame::window), and every cell has the bytes of a run of the
// whole.
#pragma once

#include <algorithm>
#include <string>
#include <utility>

namespace seamount {

struct Reach {
  enum class Of { place, neighbourhood, everything };
  Of of = Of::everything;
  int cells = 0;       ///< of a neighbourhood: on every side
  int step = 1;        ///< windows begin at multiples of so many cells of the whole: what is halved begins so
  bool known = false;  ///< it holds where every cell of the inputs has a value; if not, it looks at everything
  std::string why;     ///< of everything: what in the parameters makes it so, and what would not

  static Reach place() { return {Of::place, 0, 1, false, {}}; }
  static Reach neighbourhood(int cells, int step = 1) { return {Of::neighbourhood, cells, step, false, {}}; }
  static Reach everything(std::string why) { return {Of::everything, 0, 1, false, std::move(why)}; }

  bool local() const { return of != Of::everything; }

  /// What looks as far as both. Their steps are powers of two.
  Reach with(const Reach& other) const {
    if (!local()) return *this;
    if (!other.local()) return other;
    return {std::max(of, other.of), std::max(cells, other.cells), std::max(step, other.step), known || other.known, {}};
  }

  bool operator==(const Reach&) const = default;
};

}  // namespace seamount
