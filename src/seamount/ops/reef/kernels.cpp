#include "seamount/ops/reef/kernels.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "seamount/base/simd.h"

namespace seamount::reef {
namespace {

constexpr double kCutOff = 1e-6;
constexpr int kSamples = 4096;
const double kTan22 = std::sqrt(2.0) - 1.0;  // of 22.5 degrees
const double kTan67 = std::sqrt(2.0) + 1.0;

/// The lattice step of each direction, rows counted from the north.
constexpr std::array<LatticeCell, 8> kSteps = {{{0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}}};

SEAMOUNT_VECTORISED void add_normal(const geom::CurveTable& table, float x0, float dx, float dy2, float scale2,
                                    int count, float* out) {
  for (int i = 0; i < count; ++i) {
    const float x = x0 + static_cast<float>(i) * dx;
    out[i] += table((x * x + dy2) * scale2);
  }
}

SEAMOUNT_VECTORISED void add_edge(const geom::CurveTable& table, float x0, float dx, float dy2, float scale, float k1,
                                  int count, float* out) {
  for (int i = 0; i < count; ++i) {
    const float x = x0 + static_cast<float>(i) * dx;
    const float root = __builtin_sqrtf(x * x + dy2);
    out[i] += table(k1 - k1 * scale * root);
  }
}

/// Cells [first, last) of a row whose centres lie in the open interval (low, high) metres.
struct Span {
  int first, last;
  Span(double low, double high, double x0, double dx, int width) {
    first = static_cast<int>(std::clamp(std::ceil((low - x0) / dx), 0.0, static_cast<double>(width)));
    last = static_cast<int>(std::clamp(std::ceil((high - x0) / dx), 0.0, static_cast<double>(width)));
  }
};

}  // namespace

int direction_of(Vec2 v) {
  const double ax = std::abs(v.x), ay = std::abs(v.y);
  if (ax >= kTan67 * ay) return v.x >= 0 ? 2 : 6;
  if (ax < kTan22 * ay) return v.y > 0 ? 0 : 4;
  if (v.x > 0) return v.y > 0 ? 1 : 3;
  return v.y > 0 ? 7 : 5;
}

double normal_kernel(double t, double k) { return std::exp(-std::pow(t, k)); }

double edge_kernel(double t, double k1, double k2) {
  if (t >= 1.0) return 0.0;
  return std::exp(-std::pow(std::abs(std::log(k1 * (1.0 - t))), k2));
}

double normal_reach(double k) { return std::pow(-std::log(kCutOff), 1.0 / k); }

std::vector<Colony> place_colonies(const std::vector<LatticeCell>& cells, const GridFrame& lattice,
                                   const Scatter& scatter, Seed seed) {
  Grid<uint8_t> taken(lattice, 0);
  for (const LatticeCell s : cells) taken(s.x, s.y) = 1;
  std::vector<Colony> colonies;
  colonies.reserve(cells.size());
  for (const LatticeCell s : cells) {
    // Keyed by place: a colony looks the same whatever grew before it.
    Rng rng(seed.derive("reef.colony", (static_cast<uint64_t>(s.y) << 32) | static_cast<uint64_t>(s.x)));
    Colony colony;
    const double ex = rng.uniform(-1, 1), ey = rng.uniform(-1, 1);
    colony.centre = {lattice.x(s.x + scatter.centre * ex), lattice.y(s.y + scatter.centre * ey)};
    colony.radius_m = scatter.radius_m * (1.0 + scatter.radius * rng.uniform(-1, 1));
    colony.k1 = scatter.k1 * (1.0 + scatter.k1_jitter * rng.uniform(-1, 1));
    for (size_t i = 0; i < kSteps.size(); ++i) {
      const LatticeCell n{s.x + kSteps[i].x, s.y + kSteps[i].y};
      if (taken.contains(n.x, n.y) && taken(n.x, n.y) != 0)
        colony.neighbours = static_cast<uint8_t>(colony.neighbours | (1U << i));
    }
    colonies.push_back(colony);
  }
  return colonies;
}

KernelSums::KernelSums(std::vector<Colony> colonies, double k, double k2)
    : colonies_(std::move(colonies)),
      normal_(make_table([k](double square) { return normal_kernel(std::sqrt(square), k); }, 0.0,
                         normal_reach(k) * normal_reach(k), kSamples)),
      edge_(make_table([k2](double s) { return s > 0.0 ? edge_kernel(0.0, s, k2) : 0.0; }, 0.0,
                       std::exp(std::pow(-std::log(kCutOff), 1.0 / k2)), kSamples)),
      reach_(normal_reach(k)) {
  std::stable_sort(colonies_.begin(), colonies_.end(),
                   [](const Colony& a, const Colony& b) { return a.centre.y > b.centre.y; });
  for (const Colony& colony : colonies_) widest_m_ = std::max(widest_m_, reach_ * colony.radius_m);
}

void KernelSums::row(double x0, double dx, double y, std::span<float> normal, std::span<float> edge) const {
  std::fill(normal.begin(), normal.end(), 0.0F);
  std::fill(edge.begin(), edge.end(), 0.0F);
  const int width = static_cast<int>(normal.size());
  const auto first = std::partition_point(colonies_.begin(), colonies_.end(),
                                          [&](const Colony& c) { return c.centre.y > y + widest_m_; });
  for (auto c = first; c != colonies_.end() && c->centre.y > y - widest_m_; ++c) {
    const double dy = y - c->centre.y, square = dy * dy, cx = c->centre.x, r = c->radius_m;
    const auto east = [&](int column) { return static_cast<float>(x0 + column * dx - cx); };
    const double wide = reach_ * reach_ * r * r - square;
    if (wide <= 0) continue;
    const Span disc(cx - std::sqrt(wide), cx + std::sqrt(wide), x0, dx, width);
    add_normal(normal_, east(disc.first), static_cast<float>(dx), static_cast<float>(square),
               static_cast<float>(1.0 / (r * r)), disc.last - disc.first, normal.data() + disc.first);
    const double narrow = r * r - square;
    if (narrow <= 0) continue;
    // The row crosses up to five sectors; w_d is constant in each.
    const double half = std::sqrt(narrow), t1 = kTan22 * std::abs(dy), t2 = kTan67 * std::abs(dy);
    const std::array<double, 6> bounds = {-half, -t2, -t1, t1, t2, half};
    const std::array<int, 5> sectors = dy > 0 ? std::array<int, 5>{6, 7, 0, 1, 2} : std::array<int, 5>{6, 5, 4, 3, 2};
    for (size_t i = 0; i < sectors.size(); ++i) {
      if ((c->neighbours >> sectors[i] & 1) != 0) continue;
      const Span part(cx + std::clamp(bounds[i], -half, half), cx + std::clamp(bounds[i + 1], -half, half), x0, dx,
                      width);
      if (part.first >= part.last) continue;
      add_edge(edge_, east(part.first), static_cast<float>(dx), static_cast<float>(square), static_cast<float>(1.0 / r),
               static_cast<float>(c->k1), part.last - part.first, edge.data() + part.first);
    }
  }
}

}  // namespace seamount::reef
