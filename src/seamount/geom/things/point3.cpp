#include "seamount/geom/things/point3.h"

namespace seamount::geom {
namespace {

double lattice_value(Seed seed, int64_t x, int64_t y, int64_t z) {
  const uint64_t key = static_cast<uint64_t>(x) * 0x9e3779b97f4a7c15ULL ^
                       static_cast<uint64_t>(y) * 0xc2b2ae3d27d4eb4fULL ^
                       static_cast<uint64_t>(z) * 0x165667b19e3779f9ULL;
  return static_cast<double>(mix_bits(seed.value ^ mix_bits(key)) >> 11) * 0x1p-52 - 1.0;
}

double eased(double t) { return t * t * t * (t * (t * 6.0 - 15.0) + 10.0); }

}  // namespace

double noise3(Seed seed, Point3 at) {
  const double fx = std::floor(at.x), fy = std::floor(at.y), fz = std::floor(at.z);
  const auto x = static_cast<int64_t>(fx), y = static_cast<int64_t>(fy), z = static_cast<int64_t>(fz);
  const double u = eased(at.x - fx), v = eased(at.y - fy), w = eased(at.z - fz);
  const auto along = [&](int64_t j, int64_t k) {
    const double a = lattice_value(seed, x, y + j, z + k), b = lattice_value(seed, x + 1, y + j, z + k);
    return a + u * (b - a);
  };
  const double low = along(0, 0) + v * (along(1, 0) - along(0, 0));
  const double high = along(0, 1) + v * (along(1, 1) - along(0, 1));
  return low + w * (high - low);
}

}  // namespace seamount::geom
