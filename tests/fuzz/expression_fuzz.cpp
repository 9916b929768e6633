// Expressions of catalogues: read or refused with a column, and evaluated without a fault at some values.
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "seamount/geom/scalar/expression.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace seamount::geom;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  Vocabulary words;
  words.variables = {"depth", "sand"};
  words.of_class = {"distance", "inside"};
  words.classes = {"reef", "coral"};
  words.of_number = {"noise"};
  try {
    const Expression expression = Expression::parse(text, words);
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const std::array<double, 7> values = {
        0.0, 1.0, -3.5, 1e300, -kInfinity, kInfinity, std::numeric_limits<double>::quiet_NaN()};
    const std::vector<std::span<const double>> columns(expression.terms().size(), values);
    std::array<double, 7> out{}, again{};
    expression.evaluate(columns, out);
    expression.evaluate(columns, again);
    for (size_t i = 0; i < out.size(); ++i)
      if (out[i] != again[i] && out[i] == out[i]) std::abort();
  } catch (const ExpressionError& error) {
    if (error.column() < 1 || error.column() > size + 1) std::abort();
  }
  return 0;
}
