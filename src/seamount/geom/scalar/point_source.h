// Closed forms of what spreads from one point and decays (P3 sec. 1.3.3, eq. 1.24).
#pragma once

namespace seamount::geom {

/// The modified Bessel function K0(x), x > 0: to 2e-7 of its value (Abramowitz and Stegun 1964, 9.8.5 and 9.8.6).
double bessel_k0(double x);

/// The steady concentration at `distance_m` > 0 from a point that releases `rate` a second into still water without
/// borders: rate / (2 pi D) K0(distance sqrt(decay / D)), in units of rate per square metre and second.
/// REQUIRES: diffusivity and decay > 0.
double steady_point_source(double rate, double distance_m, double diffusivity_m2_s, double decay_per_s);

/// The same for a release smeared as a normalised Gaussian of deviation sigma_m: finite at the source. The integral of
/// eq. 1.24 over all times, in which a Gaussian source is one that has spread for sigma^2 / (2 D) already. sigma_m > 0.
double steady_gaussian_source(double rate, double distance_m, double diffusivity_m2_s, double decay_per_s,
                              double sigma_m);

/// Green's function, eq. 1.24: of one unit released at the origin, what is at (x_m, y_m) after `seconds` > 0 in a
/// uniform current (u, v), per square metre.
double released_unit(double x_m, double y_m, double seconds, double u_m_s, double v_m_s, double diffusivity_m2_s,
                     double decay_per_s);

}  // namespace seamount::geom
