#include "seamount/geom/solve/transport_check.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/model/same_size.h"

namespace seamount::geom::transport {
namespace {

bool all_finite(const ScalarField& field) {
  return std::all_of(field.cells().begin(), field.cells().end(), [](float v) { return std::isfinite(v); });
}

void check_rate(const char* name, double value, const char* unit) {
  if (!(value >= 0.0) || !std::isfinite(value))
    throw InvalidArgument(name, format_number(value) + " is not a number of 0 or more (" + unit + ")");
}

/// Cells that a walk from marked cells reaches against (or with) what flows.
void spread_marks(const Level& level, bool upstream, std::vector<char>& marked) {
  std::vector<size_t> open;
  for (size_t i = 0; i < marked.size(); ++i)
    if (marked[i] != 0) open.push_back(i);
  const auto stride = static_cast<size_t>(level.stride);
  while (!open.empty()) {
    const size_t i = open.back();
    open.pop_back();
    const auto visit = [&](size_t j, float comes, float goes) {
      if (marked[j] != 0 || !((upstream ? comes : goes) > 0.0F)) return;
      marked[j] = 1;
      open.push_back(j);
    };
    const Cell& cell = level.cells[i];
    visit(i - 1, cell.west, level.cells[i - 1].east);
    visit(i + 1, cell.east, level.cells[i + 1].west);
    visit(i - stride, cell.north, level.cells[i - stride].south);
    visit(i + stride, cell.south, level.cells[i + stride].north);
  }
}

}  // namespace

void check_transport(const Transport& transport) {
  if (transport.source == nullptr) throw InvalidArgument("source", "is missing");
  check_rate("diffusivity_m2_s", transport.diffusivity_m2_s, "m^2/s");
  check_rate("decay_per_s", transport.decay_per_s, "1/s");
  const GridFrame& frame = transport.source->frame();
  if (!all_finite(*transport.source)) throw InvalidArgument("source", "has cells that are no numbers");
  if (transport.flow != nullptr) {
    check_same_size("flow", transport.flow->frame(), frame, "source");
    check_same_size("flow", transport.flow->y.frame(), frame, "source");
    if (!all_finite(transport.flow->x) || !all_finite(transport.flow->y))
      throw InvalidArgument("flow", "has cells that are no numbers");
  }
  if (transport.around != nullptr) {
    check_same_size("around", transport.around->frame(), frame, "source");
    for (const float v : transport.around->cells())
      if (!(v >= 0.0F) || !std::isfinite(v)) throw InvalidArgument("around", "has cells that are no numbers >= 0");
  }
}

void check_outflow(const Level& level, const Transport& transport) {
  if (transport.decay_per_s > 0.0 || transport.diffusivity_m2_s > 0.0) return;
  std::vector<char> drained(level.cells.size(), 0), reached(drained);
  for (size_t i = 0; i < drained.size(); ++i) {
    const Cell& cell = level.cells[i];
    drained[i] = cell.loss > 0.0F || cell.right < 0.0F ? 1 : 0;
    reached[i] = cell.right > 0.0F ? 1 : 0;
  }
  const ScalarField& source = *transport.source;
  for (int y = 0; y < level.height; ++y)  // cells that nothing leaves have no right-hand side
    for (int x = 0; x < level.width; ++x) {
      if (source(x, y) > 0.0F) reached[level.at(x, y)] = 1;
      if (source(x, y) < 0.0F) drained[level.at(x, y)] = 1;
    }
  spread_marks(level, true, drained);
  spread_marks(level, false, reached);
  size_t stuck = 0;
  for (size_t i = 0; i < reached.size(); ++i) stuck += reached[i] != 0 && drained[i] == 0 ? 1 : 0;
  if (stuck > 0)
    throw InvalidArgument("decay_per_s", "0 without diffusion leaves material in " + std::to_string(stuck) +
                                             " cells from which nothing flows over the border: no steady state");
}

}  // namespace seamount::geom::transport
