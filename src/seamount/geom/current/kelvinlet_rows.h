// The innermost loops of kelvinlet_sum.h: one Kelvinlet on a row of places, up to where its far field begins.
#pragma once

namespace seamount::geom::kelvinlets {

/// What the loops need of one Kelvinlet. A flow is u + i v, a place z = x + i y. Scale and twist are one complex
/// strength m = scale + i twist, whose flow is m falloff(r) z; a grab is a force F.
struct Source {
  double x = 0.0, y = 0.0;  ///< metres east and south of the grid's first cell centre
  float eps = 1.0F;
  bool grab = false;
  float re = 0.0F, im = 0.0F;  ///< m, or F
  float pressed = 0.0F;        ///< b, where a = 1
};

/// The near field's share of the whole: 1 up to half its reach, smoothly 0 from the reach on. Of the squared distance
/// over the squared reach.
double near_share(double squared);

/// Adds `count` places of a row, the first one x0 east and y north of the source, `step` apart, times near_share for
/// the reach 1 / inverse_reach (0: all of it).
void add_round_row(const Source& source, float x0, float y, float step, float inverse_reach, int count, float* u,
                   float* v);
void add_grab_row(const Source& source, float x0, float y, float step, float inverse_reach, int count, float* u,
                  float* v);

/// The three kernels of a far field, 1 - near_share of the whole, at `count` places of a row, `first` places east of
/// the source and y north of it, as re + i im: falloff z; 1/r_eps + eps^2 / (2 r_eps^3) and r^2 / (2 r_eps^3) -
/// 1/r_eps; z^2 / (2 r_eps^3).
struct FarKernel {
  float step, inverse_reach, eps;
};
void far_round_row(const FarKernel& kernel, int first, float y, int count, float* re, float* im);
void far_straight_row(const FarKernel& kernel, int first, float y, int count, float* re, float* im);
void far_turned_row(const FarKernel& kernel, int first, float y, int count, float* re, float* im);

}  // namespace seamount::geom::kelvinlets
