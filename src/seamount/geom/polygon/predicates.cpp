// A sum that is exact: an expansion of doubles that do not overlap, each smaller than the last bit of the next, whose
// last one that is not 0 has the sign of the whole (Shewchuk 1997, sec. 2).
#include "seamount/geom/polygon/predicates.h"

#include <array>
#include <cstddef>

namespace seamount::geom {
namespace {

/// value + error, exactly the sum or product that it stands for.
struct Pair {
  double value, error;
};

Pair two_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  const double a_part = sum - b_part;
  return {sum, (a - a_part) + (b - b_part)};
}

/// A double as two of at most 26 bits (Dekker 1971), whose products are exact.
Pair split(double a) {
  constexpr double kSplitter = 134217729.0;  // 2^27 + 1
  const double scaled = kSplitter * a;
  const double high = scaled - (scaled - a);
  return {high, a - high};
}

Pair two_product(double a, double b) {
  const double product = a * b;
  const auto [a_high, a_low] = split(a);
  const auto [b_high, b_low] = split(b);
  const double rest = ((product - a_high * b_high) - a_low * b_high) - a_high * b_low;
  return {product, a_low * b_low - rest};
}

class ExactSum {
 public:
  void add(double term) {
    for (size_t i = 0; i < count_; ++i) {
      const auto [sum, error] = two_sum(term, parts_[i]);
      parts_[i] = error;
      term = sum;
    }
    parts_[count_++] = term;
  }

  void add_product(double a, double b) {
    const auto [product, error] = two_product(a, b);
    add(error);
    add(product);
  }

  int sign() const {
    for (size_t i = count_; i-- > 0;) {
      if (parts_[i] != 0.0) return parts_[i] > 0.0 ? 1 : -1;
    }
    return 0;
  }

 private:
  std::array<double, 12> parts_{};
  size_t count_ = 0;
};

bool boxes_meet(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  return std::max(a.x, b.x) >= std::min(c.x, d.x) && std::max(c.x, d.x) >= std::min(a.x, b.x) &&
         std::max(a.y, b.y) >= std::min(c.y, d.y) && std::max(c.y, d.y) >= std::min(a.y, b.y);
}

}  // namespace

int exact_orientation_sign(Vec2 a, Vec2 b, Vec2 c) {
  ExactSum sum;
  sum.add_product(a.x, b.y);
  sum.add_product(-a.y, b.x);
  sum.add_product(b.x, c.y);
  sum.add_product(-b.y, c.x);
  sum.add_product(c.x, a.y);
  sum.add_product(-c.y, a.x);
  return sum.sign();
}

bool segments_meet(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  if (!boxes_meet(a, b, c, d)) return false;
  if (orientation_sign(a, b, c) * orientation_sign(a, b, d) > 0) return false;
  // Neither line leaves the other segment on one side. Where all four lie on one line, their boxes meet as they do.
  return orientation_sign(c, d, a) * orientation_sign(c, d, b) <= 0;
}

Vec2 meeting_place(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  if (orientation_sign(c, d, a) == 0 && boxes_meet(a, a, c, d)) return a;
  if (orientation_sign(c, d, b) == 0 && boxes_meet(b, b, c, d)) return b;
  if (orientation_sign(a, b, c) == 0 && boxes_meet(c, c, a, b)) return c;
  if (orientation_sign(a, b, d) == 0 && boxes_meet(d, d, a, b)) return d;
  const double before = cross(d - c, a - c);
  const double after = cross(d - c, b - c);
  const double share = before / (before - after);
  return share >= 0.0 && share <= 1.0 ? a + share * (b - a) : a;  // rounding may leave nothing of either
}

bool turns_back(Vec2 a, Vec2 b, Vec2 c) {
  if (orientation_sign(a, b, c) != 0) return false;
  return a.x != b.x ? (a.x < b.x) == (c.x < b.x) : (a.y < b.y) == (c.y < b.y);
}

}  // namespace seamount::geom
