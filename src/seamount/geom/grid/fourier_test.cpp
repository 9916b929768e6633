#include "seamount/geom/grid/fourier.h"

#include <cmath>
#include <complex>
#include <numbers>

#include <gtest/gtest.h>

#include "seamount/base/rng.h"

namespace seamount::geom {
namespace {

ComplexPlane noise(int n, int filled) {
  Rng rng(Seed{7}.derive("fourier"));
  ComplexPlane plane(n);
  for (int y = 0; y < filled; ++y)
    for (int x = 0; x < filled; ++x) {
      plane.re[plane.at(x, y)] = static_cast<float>(rng.uniform(-1.0, 1.0));
      plane.im[plane.at(x, y)] = static_cast<float>(rng.uniform(-1.0, 1.0));
    }
  return plane;
}

TEST(Fourier, IsTheSumThatItSays) {
  for (const int n : {1, 2, 4, 8, 16, 32}) {
    const ComplexPlane given = noise(n, n);
    ComplexPlane spectrum = given, scratch = given;
    transform(spectrum, scratch, {});
    for (int v = 0; v < n; ++v)
      for (int u = 0; u < n; ++u) {
        std::complex<double> sum;
        for (int y = 0; y < n; ++y)
          for (int x = 0; x < n; ++x)
            sum += std::complex<double>(given.re[given.at(x, y)], given.im[given.at(x, y)]) *
                   std::polar(1.0, -2.0 * std::numbers::pi * (u * x + v * y) / n);
        ASSERT_NEAR(static_cast<double>(spectrum.re[spectrum.at(u, v)]), sum.real(), 1e-4) << n << ' ' << u << ' ' << v;
        ASSERT_NEAR(static_cast<double>(spectrum.im[spectrum.at(u, v)]), sum.imag(), 1e-4) << n << ' ' << u << ' ' << v;
      }
  }
}

TEST(Fourier, BackIsWhatWasThere) {
  for (const int n : {8, 64, 128}) {
    const ComplexPlane given = noise(n, n / 2 - 1);
    ComplexPlane plane = given, scratch = given;
    transform(plane, scratch, {});
    transform_back(plane, scratch, n / 2, {});
    for (int y = 0; y < n / 2; ++y)
      for (int x = 0; x < n / 2; ++x) {
        ASSERT_NEAR(plane.re[plane.at(x, y)], given.re[given.at(x, y)], 1e-5F) << n;
        ASSERT_NEAR(plane.im[plane.at(x, y)], given.im[given.at(x, y)], 1e-5F) << n;
      }
  }
}

}  // namespace
}  // namespace seamount::geom
