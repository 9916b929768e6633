#include "seamount/geom/scalar/expression.h"

#include "seamount/geom/scalar/blend.h"
#include "seamount/geom/scalar/expression_code.h"

namespace seamount::geom {
namespace {

using expression::Code;

constexpr size_t kBlock = 256;

template <class F>
void each(double* a, size_t count, F f) {
  for (size_t i = 0; i < count; ++i) a[i] = f(a[i]);
}

template <class F>
void each_pair(double* a, size_t count, F f) {
  const double* b = a + kBlock;
  for (size_t i = 0; i < count; ++i) a[i] = f(a[i], b[i]);
}

template <class F>
void each_triple(double* a, size_t count, F f) {
  const double* b = a + kBlock;
  const double* c = b + kBlock;
  for (size_t i = 0; i < count; ++i) a[i] = f(a[i], b[i], c[i]);
}

void apply_to_one(Code code, double* a, size_t n) {
  switch (code) {
    case Code::negate:
      return each(a, n, [](double x) { return -x; });
    case Code::invert:
      return each(a, n, [](double x) { return x == 0.0 ? 1.0 : 0.0; });
    case Code::absolute:
      return each(a, n, [](double x) { return std::abs(x); });
    case Code::root:
      return each(a, n, [](double x) { return std::sqrt(x); });
    case Code::exponential:
      return each(a, n, [](double x) { return std::exp(x); });
    case Code::logarithm:
      return each(a, n, [](double x) { return std::log(x); });
    case Code::logarithm10:
      return each(a, n, [](double x) { return std::log10(x); });
    case Code::sine:
      return each(a, n, [](double x) { return std::sin(x); });
    case Code::cosine:
      return each(a, n, [](double x) { return std::cos(x); });
    case Code::tangent:
      return each(a, n, [](double x) { return std::tan(x); });
    case Code::floor:
      return each(a, n, [](double x) { return std::floor(x); });
    case Code::round:
      return each(a, n, [](double x) { return std::round(x); });
    default:
      return each(a, n, [](double x) { return x > 0.0 ? 1.0 : (x < 0.0 ? -1.0 : x); });
  }
}

void apply_to_two(Code code, double* a, size_t n) {
  switch (code) {
    case Code::add:
      return each_pair(a, n, [](double x, double y) { return x + y; });
    case Code::subtract:
      return each_pair(a, n, [](double x, double y) { return x - y; });
    case Code::multiply:
      return each_pair(a, n, [](double x, double y) { return x * y; });
    case Code::divide:
      return each_pair(a, n, [](double x, double y) { return x / y; });
    case Code::power:
      return each_pair(a, n, expression::power);
    case Code::less:
      return each_pair(a, n, [](double x, double y) { return x < y ? 1.0 : 0.0; });
    case Code::at_most:
      return each_pair(a, n, [](double x, double y) { return x <= y ? 1.0 : 0.0; });
    case Code::more:
      return each_pair(a, n, [](double x, double y) { return x > y ? 1.0 : 0.0; });
    case Code::at_least:
      return each_pair(a, n, [](double x, double y) { return x >= y ? 1.0 : 0.0; });
    case Code::equal:
      return each_pair(a, n, [](double x, double y) { return x == y ? 1.0 : 0.0; });
    case Code::different:
      return each_pair(a, n, [](double x, double y) { return x != y ? 1.0 : 0.0; });
    case Code::both:
      return each_pair(a, n, [](double x, double y) { return x != 0.0 && y != 0.0 ? 1.0 : 0.0; });
    case Code::either:
      return each_pair(a, n, [](double x, double y) { return x != 0.0 || y != 0.0 ? 1.0 : 0.0; });
    case Code::minimum:
      return each_pair(a, n, [](double x, double y) { return y < x ? y : x; });
    case Code::maximum:
      return each_pair(a, n, [](double x, double y) { return y > x ? y : x; });
    default:
      return each_pair(a, n, [](double x, double y) { return std::atan2(x, y); });
  }
}

void apply_to_three(Code code, double* a, size_t n) {
  switch (code) {
    case Code::choose:
      return each_triple(a, n, [](double x, double y, double z) { return x != 0.0 ? y : z; });
    case Code::clamp:
      return each_triple(a, n, [](double x, double low, double high) { return x < low ? low : (x > high ? high : x); });
    case Code::ramp:
      return each_triple(a, n, expression::ramp);
    case Code::step:
      return each_triple(a, n,
                         [](double x, double from, double to) { return smoothstep(expression::ramp(x, from, to)); });
    default:
      return each_triple(a, n, expression::bell);
  }
}

}  // namespace

void Expression::evaluate(std::span<const std::span<const double>> columns, std::span<double> out) const {
  if (code_.empty()) return std::fill(out.begin(), out.end(), 0.0);
  std::vector<double> stack(depth_ * kBlock);
  for (size_t begin = 0; begin < out.size(); begin += kBlock) {
    const size_t count = std::min(kBlock, out.size() - begin);
    double* top = stack.data();  // one past the last operand
    for (const Instruction& step : code_) {
      const auto code = static_cast<Code>(step.code);
      const size_t taken = expression::operands(code);
      double* at = top - taken * kBlock;
      if (code == Code::constant) std::fill_n(at, count, step.value);
      if (code == Code::term) std::copy_n(columns[step.index].data() + begin, count, at);
      if (taken == 1) apply_to_one(code, at, count);
      if (taken == 2) apply_to_two(code, at, count);
      if (taken == 3) apply_to_three(code, at, count);
      top = at + kBlock;
    }
    std::copy_n(stack.data(), count, out.data() + begin);
  }
}

}  // namespace seamount::geom
