#include "seamount/geom/scalar/expression.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace seamount::geom {
namespace {

using testing::HasSubstr;

const Vocabulary kWords = {{"depth", "sand", "x"}, {"distance", "inside"}, {"reef", "lagoon"}, {"noise"}};

/// The value at one place, every term being 2, 3, 5, 7 ... in order of first use.
double value(const std::string& text) {
  const Expression expression = Expression::parse(text, kWords);
  constexpr double kPrimes[] = {2, 3, 5, 7, 11};
  std::vector<std::vector<double>> columns;
  std::vector<std::span<const double>> views;
  for (size_t i = 0; i < expression.terms().size(); ++i) columns.push_back({kPrimes[i]});
  views.assign(columns.begin(), columns.end());
  double out = 0.0;
  expression.evaluate(views, {&out, 1});
  return out;
}

TEST(Expression, FollowsArithmetic) {
  EXPECT_EQ(value("1 + 2 * 3 - 4 / 2"), 5.0);
  EXPECT_EQ(value("(1 + 2) * 3"), 9.0);
  EXPECT_EQ(value("2 ^ 3 ^ 2"), 512.0);
  EXPECT_EQ(value("-2 ^ 2"), -4.0);
  EXPECT_EQ(value("2 ^ -1"), 0.5);
  EXPECT_EQ(value("10 - 3 - 2"), 5.0);
  EXPECT_EQ(value("- - 3"), 3.0);
  EXPECT_EQ(value("1.5e2 + .5"), 150.5);
  EXPECT_EQ(value("2 * pi"), 2.0 * std::numbers::pi);
}

TEST(Expression, ComparesAndChooses) {
  EXPECT_EQ(value("1 < 2 && 2 <= 2 && 3 > 2 && 3 >= 3 && 1 != 2 && 1 == 1"), 1.0);
  EXPECT_EQ(value("1 > 2 || 0"), 0.0);
  EXPECT_EQ(value("!(1 > 2)"), 1.0);
  EXPECT_EQ(value("1 ? 2 : 3"), 2.0);
  EXPECT_EQ(value("0 ? 2 : 0 ? 3 : 4"), 4.0);
  EXPECT_EQ(value("0 / 0 > 1 ? 2 : 3"), 3.0);
  EXPECT_TRUE(std::isnan(value("0 / 0")));
}

TEST(Expression, KnowsFunctions) {
  EXPECT_EQ(value("min(3, 1, 2) + max(3, 1, 7, 2) + min(4, 5)"), 12.0);
  EXPECT_EQ(value("clamp(5, 0, 2) + abs(-3) + sqrt(16) + floor(2.7) + round(2.7) + sign(-9)"), 2 + 3 + 4 + 2 + 3 - 1);
  EXPECT_EQ(value("ramp(15, 10, 20)"), 0.5);
  EXPECT_EQ(value("ramp(12, 20, 10)"), 0.8);
  EXPECT_EQ(value("step(12.5, 10, 20)"), 3 * 0.0625 - 2 * 0.015625);
  EXPECT_EQ(value("bell(7, 5, 2)"), std::exp(-0.5));
  EXPECT_EQ(value("pow(2, 10) + exp(0) + log(1) + log10(1000) + atan2(0, 1) + sin(0) + cos(0) + tan(0)"), 1029.0);
}

TEST(Expression, AsksOncePerTerm) {
  const Expression expression =
      Expression::parse("depth * depth + distance(reef) + noise(250) + noise(-2.5) + depth", kWords);
  EXPECT_THAT(expression.terms(), testing::ElementsAre(Term{"depth"}, Term{"distance", "reef"},
                                                       Term{"noise", {}, 250.0}, Term{"noise", {}, -2.5}));
  EXPECT_EQ(value("depth * depth + distance(reef)"), 7.0);
}

TEST(Expression, HoldsForEveryPlaceOfManyBlocks) {
  const Expression expression = Expression::parse("max(depth, 3) - sand * 2 > 0 ? depth : -sand", kWords);
  std::vector<double> depth(1000);
  std::vector<double> sand(1000);
  for (size_t i = 0; i < depth.size(); ++i) {
    depth[i] = static_cast<double>(i % 17);
    sand[i] = static_cast<double>(i % 13);
  }
  const std::vector<std::span<const double>> columns = {depth, sand};
  std::vector<double> out(1000);
  expression.evaluate(columns, out);
  for (size_t i = 0; i < out.size(); ++i)
    EXPECT_EQ(out[i], std::max(depth[i], 3.0) - sand[i] * 2 > 0 ? depth[i] : -sand[i]) << i;
}

TEST(Expression, SaysWhereItIsWrong) {
  const auto expect_error = [](const std::string& text, size_t column, const std::string& why) {
    try {
      Expression::parse(text, kWords);
      ADD_FAILURE() << text << " was read";
    } catch (const ExpressionError& error) {
      EXPECT_EQ(error.column(), column) << text;
      EXPECT_THAT(error.what(), HasSubstr(why)) << text;
    }
  };
  expect_error("", 1, "no expression");
  expect_error("depth + dept", 9, "unknown name 'dept'");
  expect_error("depth + dept", 9, "depth");
  expect_error("depth +", 8, "found the end");
  expect_error("sqrt(depth", 11, "expected ')'");
  expect_error("depth = 3", 7, "'==' compares");
  expect_error("1 < 2 < 3", 7, "expected an operator");
  expect_error("depth sand", 7, "expected an operator, found 's'");
  expect_error("clamp(1, 2)", 11, "clamp takes 3 values, found 2");
  expect_error("min(1)", 6, "min takes 2 or more values, found 1");
  expect_error("distance(ref)", 10, "unknown class 'ref'");
  expect_error("distance(3)", 10, "takes the name of a class");
  expect_error("noise(depth)", 7, "takes a number");
  expect_error("1e999", 1, "no number");
  expect_error("depth $ 2", 7, "expected an operator, found '$'");
  expect_error("1 ? 2", 6, "expected ':'");
  expect_error(std::string(100001, '1'), 100001, "more than 100000");
}

TEST(Expression, BearsLongAndDeepText) {
  std::string sum = "depth";
  while (sum.size() + 6 <= Expression::kLongest) sum += "+depth";
  EXPECT_EQ(value(sum), 2.0 * (1.0 + std::floor((sum.size() - 5) / 6.0)));
  const std::string deep = std::string(40000, '(') + "1" + std::string(40000, ')');
  EXPECT_THROW(Expression::parse(deep, kWords), ExpressionError);
  EXPECT_THROW(Expression::parse(std::string(90000, '-') + "1", kWords), ExpressionError);
  EXPECT_EQ(value(std::string(40, '(') + "1" + std::string(40, ')')), 1.0);
}

}  // namespace
}  // namespace seamount::geom
