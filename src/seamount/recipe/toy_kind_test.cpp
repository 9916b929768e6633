// A kind of value, its operators and its file format that Seamount does not have, registered from outside: they must
// work in recipes, the cache, files, the schema and the reference like any other. What it takes stands in this file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "seamount/io/atomic_file.h"
#include "seamount/recipe/executor.h"
#include "seamount/recipe/file_info.h"
#include "seamount/recipe/format.h"
#include "seamount/recipe/ports.h"
#include "seamount/recipe/reference.h"

namespace seamount::recipe {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Pair;

struct Tune {
  std::vector<int> notes;
};

// ---- the kind

struct TuneKind {
  using Type = Tune;
  static const Kind& kind();
  static void add_formats(Registry& registry);
};

Tune read_tune(const FileCall& call) {
  Tune tune;
  for (const uint8_t byte : io::read_file(call.path)) tune.notes.push_back(byte);
  return tune;
}

const Kind& TuneKind::kind() {
  static const Kind kind = make_kind<Tune>({
      .name = "tune",
      .about = "notes in their order",
      .files = {".tune"},
      .reads = {".tune"},
      .frame = {},
      .bytes = [](const Tune& tune) { return tune.notes.size() * sizeof(int); },
      .write = [](Writer& writer, const Tune& tune) { writer.list(tune.notes); },
      .read = [](Reader& reader) { return Tune{reader.list<int>()}; },
      .read_file = read_tune,
      .info = [](const std::string& path) -> std::optional<io::FileInfo> {
        if (io::extension_of(path) != ".tune") return std::nullopt;
        return io::FileInfo{{"format", "tune"}};
      },
  });
  return kind;
}

void TuneKind::add_formats(Registry& registry) {
  registry.add(make_format<NoParams>({"tune", "a byte for each note", {".tune"}, {".tune"}, {&kind()}},
                                     [](const NoParams&, const OutputCall& call) {
                                       const Tune& tune = call.value.get<TuneKind>();
                                       io::write_text(call.path, std::string(tune.notes.begin(), tune.notes.end()));
                                     }));
}

// ---- its operators

struct ScaleParams {
  int count = 5;
  static constexpr auto fields() {
    return std::tuple(field(&ScaleParams::count, "count", "", between(1, 99), "number of notes"));
  }
};

struct NothingParams {
  static constexpr auto fields() { return std::tuple(); }
};

int& runs() {
  static int count = 0;
  return count;
}

Registry with_tunes() {
  Registry registry = standard_registry();
  registry.add_kind<TuneKind>();
  registry.add(make_operator<ScaleParams>({.name = "tune.scale", .summary = "Notes that rise"}, inputs(),
                                          outputs(out<TuneKind>("tune", "the notes")),
                                          [](const ScaleParams& params, const Call&) {
                                            ++runs();
                                            Tune tune;
                                            for (int i = 0; i < params.count; ++i) tune.notes.push_back('A' + i);
                                            return tune;
                                          }));
  registry.add(make_operator<NothingParams>(
      {.name = "tune.turn", .summary = "Notes backwards"}, inputs(in<TuneKind>("tune", "the notes")),
      outputs(out<TuneKind>("tune", "the notes backwards"), out<kinds::Field>("bars", "a bar for each note")),
      [](const NothingParams&, const Call& call, const Tune& tune) {
        ScalarField bars(call.domain, static_cast<float>(tune.notes.size()));
        return std::tuple(Tune{{tune.notes.rbegin(), tune.notes.rend()}}, std::move(bars));
      }));
  return registry;
}

const char* const kRecipe = R"({"seamount": 1, "domain": {"width_m": 40, "height_m": 40, "cell_m": 10}, "steps": [
  {"id": "up", "op": "tune.scale", "params": {"count": 3}},
  {"id": "down", "op": "tune.turn", "in": {"tune": "up.tune"}}],
  "outputs": [{"from": "down.tune", "path": "down.tune"}, {"from": "down.bars", "path": "bars.tif"}]})";

class ToyKind : public ::testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string file(const std::string& name) const { return folder_ + "/" + name; }
  std::string text(const std::string& name) const {
    const std::vector<uint8_t> bytes = io::read_file(file(name));
    return {bytes.begin(), bytes.end()};
  }
  const std::string folder_ = ::testing::TempDir() + "seamount_toy_kind";
  const Registry registry_ = with_tunes();
};

TEST_F(ToyKind, RunsInARecipeAndIsWritten) {
  execute(parse_recipe(kRecipe, "tune.json", "", {}, registry_), {folder_, ""}, {});
  EXPECT_EQ(text("down.tune"), "CBA");
}

TEST_F(ToyKind, ComesBackFromTheCache) {
  const Recipe recipe = parse_recipe(kRecipe, "tune.json", "", {}, registry_);
  const int before = runs();
  execute(recipe, {folder_, file("cache")}, {});
  const ExecuteReport again = execute(recipe, {folder_, file("cache")}, {});
  EXPECT_EQ(runs(), before + 1);
  EXPECT_TRUE(again.steps[0].cached && again.steps[1].cached);
  EXPECT_EQ(text("down.tune"), "CBA");
}

TEST_F(ToyKind, IsReadFromAFile) {
  io::write_text(file("given.tune"), "xyz");
  const Recipe recipe = parse_recipe(R"({"seamount": 1, "domain": {"width_m": 40, "height_m": 40, "cell_m": 10},
    "steps": [{"id": "down", "op": "tune.turn", "in": {"tune": {"file": "given.tune"}}}],
    "outputs": [{"from": "down.tune", "path": "down.tune"}]})",
                                     "tune.json", folder_, {}, registry_);
  execute(recipe, {folder_, ""}, {});
  EXPECT_EQ(text("down.tune"), "zyx");
  EXPECT_THAT(describe_file(file("given.tune"), registry_), Contains(Pair("format", "tune")));
}

TEST_F(ToyKind, IsRefusedWhereAnotherKindIsNeeded) {
  try {
    parse_recipe(R"({"seamount": 1, "steps": [{"id": "up", "op": "tune.scale"},
      {"id": "w", "op": "terrain.layers", "in": {"terrain": "up.tune"}}]})",
                 "tune.json", "", {}, registry_);
    FAIL();
  } catch (const RecipeError& error) {
    EXPECT_THAT(error.what(), HasSubstr("'up.tune' is tune; terrain is needed here"));
  }
}

TEST_F(ToyKind, StandsInSchemaAndReference) {
  EXPECT_THAT(recipe_schema(registry_).dump(), HasSubstr("\"x-kind\":\"tune\""));
  EXPECT_THAT(reference_markdown(registry_), HasSubstr("## tune.turn"));
  EXPECT_THAT(describe_operator(*registry_.find_operator("tune.turn")), HasSubstr("tune (tune)"));
  EXPECT_THAT(describe_kind(TuneKind::kind(), registry_), HasSubstr("made by tune.scale, tune.turn"));
  EXPECT_EQ(standard_registry().find_kind("tune"), nullptr);
}

}  // namespace
}  // namespace seamount::recipe
