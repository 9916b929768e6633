// The operations that expressions are made of: names, operands, meaning. For expression.cpp and its parser.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string_view>

namespace seamount::geom::expression {

enum class Code : uint8_t {
  constant,
  term,
  negate,
  invert,
  add,
  subtract,
  multiply,
  divide,
  power,
  less,
  at_most,
  more,
  at_least,
  equal,
  different,
  both,
  either,
  choose,
  minimum,
  maximum,
  absolute,
  root,
  exponential,
  logarithm,
  logarithm10,
  sine,
  cosine,
  tangent,
  arctangent2,
  floor,
  round,
  sign,
  clamp,
  ramp,
  step,
  bell,
};

/// A function by name; one that `joins` takes any more operands, from the left.
struct Function {
  std::string_view name;
  Code code;
  size_t operands;
  bool joins = false;
};

inline constexpr std::array kFunctions = {
    Function{"min", Code::minimum, 2, true}, Function{"max", Code::maximum, 2, true},
    Function{"abs", Code::absolute, 1},      Function{"sqrt", Code::root, 1},
    Function{"exp", Code::exponential, 1},   Function{"log", Code::logarithm, 1},
    Function{"log10", Code::logarithm10, 1}, Function{"sin", Code::sine, 1},
    Function{"cos", Code::cosine, 1},        Function{"tan", Code::tangent, 1},
    Function{"atan2", Code::arctangent2, 2}, Function{"pow", Code::power, 2},
    Function{"floor", Code::floor, 1},       Function{"round", Code::round, 1},
    Function{"sign", Code::sign, 1},         Function{"clamp", Code::clamp, 3},
    Function{"ramp", Code::ramp, 3},         Function{"step", Code::step, 3},
    Function{"bell", Code::bell, 3},
};

constexpr size_t operands(Code code) {
  switch (code) {
    case Code::constant:
    case Code::term:
      return 0;
    case Code::negate:
    case Code::invert:
    case Code::absolute:
    case Code::root:
    case Code::exponential:
    case Code::logarithm:
    case Code::logarithm10:
    case Code::sine:
    case Code::cosine:
    case Code::tangent:
    case Code::floor:
    case Code::round:
    case Code::sign:
      return 1;
    case Code::choose:
    case Code::clamp:
    case Code::ramp:
    case Code::step:
    case Code::bell:
      return 3;
    default:
      return 2;
  }
}

/// 0 before `from`, 1 beyond `to`, linear between; a jump where they are the same. `to` may lie before `from`.
inline double ramp(double x, double from, double to) {
  if (from == to) return x < from ? 0.0 : 1.0;
  return std::clamp((x - from) / (to - from), 0.0, 1.0);
}

/// Powers of small whole numbers by multiplication: they are what people write most.
inline double power(double base, double exponent) {
  if (exponent == 2.0) return base * base;
  return std::pow(base, exponent);
}

inline double bell(double x, double centre, double width) {
  const double t = (x - centre) / width;
  return std::exp(-0.5 * t * t);
}

}  // namespace seamount::geom::expression
