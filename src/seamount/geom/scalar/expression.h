// Arithmetic that users write, evaluated for many places at once: "bell(depth, 5, 2) * (1 - sand) - 3 *
// inside(lagoon)".
//
//   a ? b : c    ||  &&    < <= > >= == !=    + -    * /    - ! (before a value)    ^ (from the right, before -)
//   min max (two or more)  abs sqrt exp log log10 sin cos tan atan2 pow floor round sign
//   clamp(x, low, high)  ramp(x, from, to): 0 to 1, linear  step(x, from, to): 0 to 1, smooth
//   bell(x, centre, width): exp(-((x - centre) / width)^2 / 2)    pi
//
// All are doubles; true is 1 and whatever is not 0 is true; both sides of a choice are computed. What has no value (a
// division of 0 by 0) is NaN, a comparison with it false. Compiled once, immutable, shared by threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "seamount/base/error.h"

namespace seamount::geom {

/// What an expression may speak of.
struct Vocabulary {
  std::vector<std::string> variables;       ///< "depth", "sand"
  std::vector<std::string> of_class = {};   ///< words that ask about a class: "distance" in distance(reef)
  std::vector<std::string> classes = {};    ///< and the classes
  std::vector<std::string> of_number = {};  ///< words that take a number: "noise" in noise(250)
};

/// A place of the vocabulary that an expression asks for; equal ones are asked for once.
struct Term {
  std::string word;
  std::string of_class = {};  ///< empty: none
  double number = 0.0;        ///< of a word that takes one

  bool operator==(const Term&) const = default;
};

/// Text that is no expression: what() says why, column() where, from 1.
class ExpressionError : public Error {
 public:
  ExpressionError(size_t column, const std::string& why) : Error(why), column_(column) {}
  size_t column() const { return column_; }

 private:
  size_t column_;
};

class Expression {
 public:
  /// The most characters; longer text is refused before it is read.
  static constexpr size_t kLongest = 100000;

  /// The constant 0.
  Expression() = default;

  /// Throws ExpressionError: an unknown name (with the nearest known one, or all of them), a wrong number of arguments,
  /// an operator without its operand, more than 100 levels of nesting, text that is empty or too long. Linear time.
  static Expression parse(std::string_view text, const Vocabulary& vocabulary);

  /// What it asks for, in the order of first use.
  const std::vector<Term>& terms() const { return terms_; }

  /// out[i] from columns[t][i], one column per term. REQUIRES: columns as long as `out`. About 1 to 10 ns a place and
  /// operation, in blocks that stay in the cache; not parallel itself, safe from many threads.
  void evaluate(std::span<const std::span<const double>> columns, std::span<double> out) const;

 private:
  friend class ExpressionParser;

  struct Instruction {
    uint8_t code = 0;
    uint32_t index = 0;  ///< of a term
    double value = 0.0;  ///< of a constant
  };
  std::vector<Instruction> code_;
  std::vector<Term> terms_;
  size_t depth_ = 1;  ///< of the stack
};

}  // namespace seamount::geom
