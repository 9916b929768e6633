// What every operator promises, tested on every row of the registry. A new operator gets these tests for free.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "seamount/geom/scalar/expression_code.h"
#include "seamount/ops/ecosystem/words.h"
#include "seamount/recipe/catalogue_reference.h"
#include "seamount/recipe/reference.h"
#include "seamount/recipe/test_calls.h"
#include "seamount/recipe/value_bytes.h"

namespace seamount::recipe {
namespace {

using ::testing::HasSubstr;

/// `small` for what is tried often, `many_blocks` for what blocks of cells could change. Under the sanitizers the large
/// one is smaller, and still more than one block.
constexpr Extent kSmall = {96, 80, 900};
constexpr Extent kSomeBlocks = {260, 200, 2000};  ///< for what takes long
#if defined(__has_feature)                        // clang alone; g++ is not used with sanitizers
#if __has_feature(address_sanitizer)
#define SEAMOUNT_SANITIZED
#endif
#endif
#ifdef SEAMOUNT_SANITIZED
constexpr Extent kManyBlocks = {260, 200, 2000};
#else
constexpr Extent kManyBlocks = {700, 500, 10000};
#endif

std::string bytes_of(const Values& values) {
  std::ostringstream out;
  write_values(out, values);
  return out.str();
}

class Contract : public ::testing::TestWithParam<std::string> {
 protected:
  const Operator& op() const { return *standard_registry().find_operator(GetParam()); }
};

TEST_P(Contract, IsDescribed) {
  EXPECT_FALSE(op().summary.empty());
  EXPECT_FALSE(op().out.empty());
  EXPECT_THAT(op().name, HasSubstr("."));
  EXPECT_EQ(op().looks.empty(), op().reach == nullptr) << "says how far it looks, to people and to the program, or not";
  for (const ParamInfo& info : op().params) {
    EXPECT_FALSE(info.help.empty()) << info.name;
    EXPECT_THAT(describe_operator(op()), HasSubstr(info.name));
    const bool metres = info.name.size() > 2 && info.name.substr(info.name.size() - 2) == "_m";
    EXPECT_TRUE(!metres || info.unit == "m") << info.name;
  }
}

TEST_P(Contract, DefaultsAreValidAndSurviveJson) {
  Diagnostics diagnostics;
  const Json defaults = op().complete(Json::object(), {"", diagnostics});
  EXPECT_TRUE(diagnostics.empty());
  const Json again = op().complete(Json::parse(defaults.dump()), {"", diagnostics});
  EXPECT_TRUE(diagnostics.empty());
  EXPECT_EQ(again, defaults);
}

/// The numbers among parameters, each with a way to give it a value: those of groups and of tools too.
void collect_numbers(const std::vector<ParamInfo>& infos, const std::function<Json(Json)>& give,
                     std::vector<std::pair<ParamInfo, std::function<Json(Json)>>>& numbers) {
  for (const ParamInfo& info : infos) {
    const auto give_this = [give, name = info.name](Json value) { return give({{name, std::move(value)}}); };
    if (info.kind == "number" || info.kind == "integer") numbers.emplace_back(info, give_this);
    for (const ToolInfo& tool : info.tools) {
      collect_numbers(
          tool.params,
          [give_this, name = tool.name, list = info.kind == "groups"](Json members) {
            if (list) return give_this(Json::array({members}));
            if (name.empty()) return give_this(members);
            members["tool"] = name;
            return give_this(Json::array({members}));
          },
          numbers);
    }
  }
}

TEST_P(Contract, EachParameterIsRefusedOutsideItsRangeByName) {
  std::vector<std::pair<ParamInfo, std::function<Json(Json)>>> numbers;
  collect_numbers(
      op().params, [](Json members) { return members; }, numbers);
  for (const auto& [info, give] : numbers) {
    for (const auto& [bound, step] : {std::pair{info.range.min, -1.0}, {info.range.max, 1.0}}) {
      if (std::isinf(bound)) continue;
      Diagnostics diagnostics;
      op().complete(give(bound + step * std::max(1.0, std::abs(bound))), {"", diagnostics});
      ASSERT_EQ(diagnostics.items().size(), 1U) << info.name;
      EXPECT_THAT(diagnostics.items()[0].message, HasSubstr(info.name + ": "));
      EXPECT_THAT(diagnostics.items()[0].message, HasSubstr("is outside"));
    }
  }
}

TEST_P(Contract, SameSeedSameBytesOnAnyNumberOfThreads) {
  const bool slow = op().name == "contour.refine" || op().name == "erosion.run";
  const ExampleCall call(op(), slow ? kSomeBlocks : kManyBlocks);
  const auto bytes = [&](const RunContext& run) { return bytes_of(call.run(op(), Seed{5}, run)); };
  const std::string one = bytes({.threads = 1});
  EXPECT_TRUE(bytes({.threads = 1}) == one) << "again";
  EXPECT_TRUE(bytes({.threads = 2}) == one) << "two threads";
  const tbb::global_control four(tbb::global_control::max_allowed_parallelism, 4);
  tbb::task_arena(4).execute([&] { EXPECT_TRUE(bytes({}) == one) << "four threads"; });
}

TEST_P(Contract, AnotherSeedDiffersWhereTheOperatorIsStochastic) {
  ExampleCall call(op(), kSmall);
  if (op().name == "contour.edit") {
    Diagnostics diagnostics;
    call.params() = op().complete({{"edits", {{{"tool", "fractalize"}}}}}, {"", diagnostics});
  }
  if (op().name == "terrain.sculpt")
    call.params()["strokes"] = Json::parse(R"([{"tool": "roughen", "points": [[0, 0]]}])");
  if (op().name == "terrain.mask") call.params()["criteria"] = Json::parse(R"([{"tool": "noise"}])");
  const bool differs = bytes_of(call.run(op(), Seed{5}, {})) != bytes_of(call.run(op(), Seed{6}, {}));
  EXPECT_EQ(differs, op().stochastic);
}

TEST_P(Contract, MakesFiniteValuesOfTheKindsItDeclares) {
  const Values out = ExampleCall(op(), kSmall).run(op(), Seed{5}, {});
  EXPECT_EQ(out.size(), op().out.size());
  for (const Port& port : op().out) {
    ASSERT_TRUE(out.contains(port.name)) << port.name;
    const Value& value = out.at(port.name);
    EXPECT_EQ(&value.kind(), port.kind) << port.name;
    const ScalarField* cells = value.is<kinds::Terrain>() ? &value.get<kinds::Terrain>()
                               : value.is<kinds::Field>() ? &value.get<kinds::Field>()
                                                          : nullptr;
    if (cells == nullptr) continue;
    for (const float z : cells->cells()) ASSERT_TRUE(std::isfinite(z)) << port.name;
  }
}

/// The flag is set before the start and at reports of progress: nothing more is reported, and nothing comes out. What
/// takes only a moment reports nothing. How long stopping takes is measured by seamount_bench
/// --benchmark_filter=cancel.
TEST_P(Contract, StopsWhereverItIsWhenCancelled) {
  const ExampleCall call(op(), kSomeBlocks);
  int reports = 0;
  call.run(op(), Seed{5}, {.threads = 1, .progress = [&](double) { ++reports; }});
  for (const int stop : {0, 1, reports / 4, reports / 2, 3 * reports / 4}) {
    if (stop > 0 && stop >= reports) continue;
    std::atomic<bool> cancelled{stop == 0};
    int seen = 0;
    const auto count = [&](double) { cancelled = ++seen >= stop; };
    EXPECT_THROW(call.run(op(), Seed{5}, {.threads = 1, .progress = count, .cancelled = &cancelled}), Cancelled);
    EXPECT_EQ(seen, stop) << "of " << reports << ": it went on";
  }
}

std::string test_name(const ::testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Operators, Contract, ::testing::ValuesIn(standard_registry().operator_names()), test_name);

std::string page(const std::string& name) {
  std::ifstream file(std::string(SEAMOUNT_SOURCE_DIR) + "/docs/" + name);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(Reference, OperatorsPageIsFresh) {
  EXPECT_TRUE(page("operators.md") == reference_markdown())
      << "docs/operators.md is stale: ./run describe --markdown > docs/operators.md";
}

TEST(Reference, CataloguesPageIsFresh) {
  EXPECT_TRUE(page("catalogues.md") == catalogue_markdown())
      << "docs/catalogues.md is stale: ./run describe catalogue --markdown > docs/catalogues.md";
}

TEST(Reference, CataloguesPageKnowsEveryWord) {
  const std::string text = catalogue_markdown();
  for (const std::string_view word : ecosystem::kPlaceWords)
    EXPECT_NE(text.find("| `" + std::string(word) + "` |"), std::string::npos) << word;
  for (const std::string_view word : ecosystem::kClassWords)
    EXPECT_NE(text.find("| `" + std::string(word) + "(CLASS)` |"), std::string::npos) << word;
  const std::string functions = text.substr(text.find("## Functions"));
  for (const auto& function : geom::expression::kFunctions)
    EXPECT_NE(functions.find(std::string(function.name)), std::string::npos) << function.name;
}

}  // namespace
}  // namespace seamount::recipe
