// Golden recipes: tests/golden/<name>/recipe.json against expected.json, which holds for every output of every step the
// digest of its bytes (equal for both compilers and any number of threads) and statistics for people to compare.
//
// Every operator stands in at least one of them.
//
// A change on purpose: SEAMOUNT_UPDATE_GOLDEN=1 recipe_tests --gtest_filter='Golden*' rewrites expected.json and
// preview.png; look at the pictures, raise the operator's revision, and say why in the commit.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <vector>

#include "seamount/io/atomic_file.h"
#include "seamount/io/image_file.h"
#include "seamount/ops/render/relief.h"
#include "seamount/recipe/executor.h"
#include "seamount/recipe/kinds.h"

namespace seamount::recipe {
namespace {

namespace fs = std::filesystem;

fs::path golden_folder() { return fs::path(SEAMOUNT_SOURCE_DIR) / "tests/golden"; }

std::vector<std::string> golden_names() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(golden_folder())) {
    if (entry.is_directory()) names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// In a layout of their own, so that digests outlive changes of the cache's.
std::string digest_of(const Value& value) {
  static const std::vector<std::string> kNumbers = {"terrain",  "labels", "field",  "image",   "drawing",   "tin",
                                                    "contours", "report", "things", "current", "catalogue", "objects"};
  std::ostringstream bytes;
  Writer writer(bytes);
  writer.plain(uint64_t{0x31304d5354414d53ULL});
  writer.plain(uint64_t{1});
  writer.text("value");
  writer.plain(static_cast<uint8_t>(std::find(kNumbers.begin(), kNumbers.end(), value.kind().name) - kNumbers.begin()));
  value.write(writer);
  writer.finish();
  const std::string text = bytes.str();
  return hash_bytes(std::as_bytes(std::span(text))).hex();
}

std::string number(double v) { return fmt::format("{:.6g}", v); }

Json statistics_of(const ScalarField& field) {
  std::vector<float> known;
  std::copy_if(field.cells().begin(), field.cells().end(), std::back_inserter(known),
               [](float z) { return !std::isnan(z); });
  double sum = 0;
  for (const float z : known) sum += static_cast<double>(z);
  const auto [low, high] = std::minmax_element(known.begin(), known.end());
  Json result = {{"min", number(static_cast<double>(*low))},
                 {"max", number(static_cast<double>(*high))},
                 {"mean", number(sum / static_cast<double>(known.size()))}};
  if (known.size() < field.size()) result["unknown"] = field.size() - known.size();
  return result;
}

Json statistics_of(const LabelMap& labels) {
  std::array<int, kRegionCount> counts{};
  for (const Region region : labels.cells()) ++counts[static_cast<size_t>(region)];
  Json cells;
  for (const Region region : kRegions) cells[std::string(region_name(region))] = counts[static_cast<size_t>(region)];
  return {{"cells", cells}};
}

/// Areas by name where they are few, else how many there are; the same of lines and points.
Json statistics_of(const Drawing& drawing) {
  constexpr size_t kFew = 8;
  Json result = Json::object();
  if (drawing.areas.size() > kFew) result["areas"] = drawing.areas.size();
  for (const NamedArea& area : drawing.areas) {
    if (drawing.areas.size() > kFew) break;
    size_t points = 0;
    for (const Polygon& part : area.parts) points += part.outer.size();
    result["areas"].push_back(fmt::format("{}: {} parts, {} points", area.name, area.parts.size(), points));
  }
  size_t points = 0;
  for (const ValuedLine& line : drawing.lines) points += line.points.size();
  if (!drawing.lines.empty()) result["lines"] = fmt::format("{} with {} points", drawing.lines.size(), points);
  if (!drawing.points.empty()) result["points"] = drawing.points.size();
  return result;
}

Json statistics_of(const Tin& tin) {
  Json result = {{"nodes", tin.nodes.size()}, {"triangles", tin.triangles.size()}, {"regions", tin.regions.size()}};
  if (tin.height_m.empty()) return result;
  const auto [low, high] = std::minmax_element(tin.height_m.begin(), tin.height_m.end());
  result["min"] = number(static_cast<double>(*low));
  result["max"] = number(static_cast<double>(*high));
  return result;
}

Json statistics_of(const ContourSet& set) {
  size_t points = 0;
  for (const Contour& contour : set.contours) points += contour.ring.size();
  return {{"contours", set.contours.size()}, {"points", points}};
}

Json statistics_of(const Report& report) {
  Json result = Json::object();
  for (const Descriptor& descriptor : report.descriptors) {
    std::string line;
    for (const Measure& measure : descriptor.measures) {
      line += (line.empty() ? "" : "; ") + measure.name;
      for (const double value : measure.values) line += " " + number(value);
    }
    if (descriptor.distance) line += "; distance " + number(*descriptor.distance);
    result[descriptor.name] = line;
  }
  return {{"descriptors", result}};
}

/// What a person compares: rounded, so that the text is short.
Json statistics(const Value& value) {
  Json result = {{"kind", value.kind().name}};
  if (const GridFrame* frame = value.frame()) result["size"] = fmt::format("{} x {}", frame->width, frame->height);
  if (value.is<kinds::Terrain>()) result.update(statistics_of(value.get<kinds::Terrain>()));
  if (value.is<kinds::Field>()) result.update(statistics_of(value.get<kinds::Field>()));
  if (value.is<kinds::Labels>()) result.update(statistics_of(value.get<kinds::Labels>()));
  if (value.is<kinds::Drawing>()) result.update(statistics_of(value.get<kinds::Drawing>()));
  if (value.is<kinds::Tin>()) result.update(statistics_of(value.get<kinds::Tin>()));
  if (value.is<kinds::Contours>()) result.update(statistics_of(value.get<kinds::Contours>()));
  if (value.is<kinds::Report>()) result.update(statistics_of(value.get<kinds::Report>()));
  if (value.is<kinds::Image>()) {
    const Image& image = value.get<kinds::Image>();
    result["size"] = fmt::format("{} x {}", image.width, image.height);
  }
  return result;
}

/// Every output of every step, and what is expected of it, by "step.port".
struct Golden {
  std::vector<Source> sources;
  std::vector<Value> values;
  Json expected = Json::object();
};

Golden compute(const std::string& name, int threads) {
  const Recipe recipe = read_recipe((golden_folder() / name / "recipe.json").string());
  Golden golden;
  for (const Step& step : recipe.steps) {
    for (const Port& port : step.op->out) golden.sources.push_back({step.id, port.name, ""});
  }
  RunContext run;
  run.threads = threads;
  golden.values = evaluate(recipe, golden.sources, {"", ""}, run);
  for (size_t i = 0; i < golden.values.size(); ++i) {
    Json entry = statistics(golden.values[i]);
    entry["digest"] = digest_of(golden.values[i]);
    golden.expected[golden.sources[i].step + "." + golden.sources[i].port] = entry;
  }
  return golden;
}

/// The last picture; of a recipe without any the last terrain from above.
void write_preview(const std::string& name, const Golden& golden) {
  const auto last_of = [&](const Kind& kind) {
    const auto found = std::find_if(golden.values.rbegin(), golden.values.rend(),
                                    [&](const Value& value) { return &value.kind() == &kind; });
    return found == golden.values.rend() ? nullptr : &*found;
  };
  const std::string path = (golden_folder() / name / "preview.png").string();
  if (const Value* picture = last_of(kinds::Image::kind())) return io::write_png(picture->get<kinds::Image>(), path);
  const Value* terrain = last_of(kinds::Terrain::kind());
  if (terrain == nullptr) return;
  render::ReliefParams params;
  params.width_px = 256;
  io::write_png(render::relief(terrain->get<kinds::Terrain>(), params, {}), path);
}

class GoldenRecipe : public testing::TestWithParam<std::string> {};

TEST_P(GoldenRecipe, GivesTheSameBytesAsEver) {
  const Golden golden = compute(GetParam(), 0);
  const fs::path file = golden_folder() / GetParam() / "expected.json";
  if (const char* update = std::getenv("SEAMOUNT_UPDATE_GOLDEN"); update != nullptr && *update == '1') {
    io::write_text(file.string(), golden.expected.dump(2) + "\n");
    write_preview(GetParam(), golden);
    GTEST_SKIP() << file << " rewritten";
  }
  std::ifstream stream(file);
  ASSERT_TRUE(stream) << file << " is missing; SEAMOUNT_UPDATE_GOLDEN=1 writes it";
  const Json expected = Json::parse(stream);
  for (const auto& [port, entry] : golden.expected.items())
    EXPECT_EQ(expected.value(port, Json()).dump(2), entry.dump(2)) << port;
  EXPECT_EQ(expected.size(), golden.expected.size());
}

TEST_P(GoldenRecipe, GivesTheSameBytesOnOneThread) {
  EXPECT_EQ(compute(GetParam(), 1).expected, compute(GetParam(), 0).expected);
}

/// Networks give the same bytes on one machine only: their sums are in whatever numbers the processor has (ADR 2).
bool is_same_everywhere(const std::string& name) { return name.rfind("learned.", 0) != 0; }

TEST(GoldenRecipes, HoldEveryOperator) {
  std::set<std::string> held;
  for (const std::string& name : golden_names()) {
    for (const Step& step : read_recipe((golden_folder() / name / "recipe.json").string()).steps)
      held.insert(step.op->name);
  }
  for (const std::string& name : standard_registry().operator_names())
    EXPECT_TRUE(held.contains(name) || !is_same_everywhere(name)) << name;
}

INSTANTIATE_TEST_SUITE_P(Recipes, GoldenRecipe, testing::ValuesIn(golden_names()),
                         [](const auto& name) { return name.param; });

}  // namespace
}  // namespace seamount::recipe
