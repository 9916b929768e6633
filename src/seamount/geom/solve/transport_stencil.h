// The finite volumes of transport.h: what flows between a cell and its four neighbours.
#pragma once

#include <algorithm>

#include "seamount/geom/solve/transport.h"

namespace seamount::geom::transport {

/// Rates of exchange of one cell, 1/s. `in` from a neighbour's concentration to this cell, `out` from this cell to it.
template <class Real>
struct Stencil {
  Real west_in, east_in, north_in, south_in;
  Real west_out, east_out, north_out, south_out;
};

/// Evaluates stencils of a problem, whose rates are multiplied by `scale`.
template <class Real>
class Stencils {
 public:
  Stencils(const Transport& transport, double scale)
      : flow_(transport.flow),
        width_(transport.source->width()),
        height_(transport.source->height()),
        spread_(static_cast<Real>(scale * transport.diffusivity_m2_s /
                                  (transport.source->cell_m() * transport.source->cell_m()))),
        half_(static_cast<Real>(0.5 * scale / transport.source->cell_m())) {}

  /// What diffusion alone exchanges with each neighbour.
  Real spread() const { return spread_; }

  Stencil<Real> at(int x, int y) const {
    if (flow_ == nullptr) return {spread_, spread_, spread_, spread_, spread_, spread_, spread_, spread_};
    const float* east = flow_->x.row(y).data();
    const float* north = flow_->y.row(y).data();
    const Real u = east[x], v = north[x];
    const Real west_face = half_ * (u + Real(east[std::max(x - 1, 0)]));
    const Real east_face = half_ * (u + Real(east[std::min(x + 1, width_ - 1)]));
    const Real north_face = half_ * (v + Real(flow_->y(x, std::max(y - 1, 0))));
    const Real south_face = half_ * (v + Real(flow_->y(x, std::min(y + 1, height_ - 1))));
    return {spread_ + positive(west_face),  spread_ + positive(-east_face), spread_ + positive(-north_face),
            spread_ + positive(south_face), spread_ + positive(-west_face), spread_ + positive(east_face),
            spread_ + positive(north_face), spread_ + positive(-south_face)};
  }

 private:
  static Real positive(Real v) { return v > Real(0) ? v : Real(0); }

  const VectorField* flow_;
  int width_, height_;
  Real spread_, half_;
};

}  // namespace seamount::geom::transport
