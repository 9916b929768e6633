// What every output format promises, on a terrain, its labels and contours: the files that it says it will write are
// those that it writes, and a picture is its operator's.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "seamount/io/atomic_file.h"
#include "seamount/io/image_file.h"
#include "seamount/io/mesh_info.h"
#include "seamount/recipe/executor.h"
#include "seamount/recipe/kinds.h"
#include "seamount/recipe/output_files.h"

namespace seamount::recipe {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pair;

/// An island with one port of each kind that can be written.
Json document(Json outputs) {
  Json made = {{"seamount", 1},
               {"domain", {{"width_m", 9600}, {"height_m", 8000}, {"cell_m", 100}}},
               {"steps",
                {{{"id", "isle"}, {"op", "island.build"}},
                 {{"id", "lines"}, {"op", "island.outlines"}, {"in", {{"labels", "isle.labels"}}}},
                 {{"id", "levels"}, {"op", "contour.extract"}, {"in", {{"terrain", "isle.terrain"}}}},
                 {{"id", "grown"}, {"op", "contour.grow"}, {"params", {{"particles", 400}}}},
                 {{"id", "grove"},
                  {"op", "ecosystem.scatter"},
                  {"in", {{"terrain", "isle.terrain"}}},
                  {"params", {{"spacing_m", 900}, {"min_height_m", 2}}}},
                 {{"id", "told"}, {"op", "hydrology.describe"}, {"in", {{"terrain", "isle.terrain"}}}},
                 {{"id", "seen"}, {"op", "render.relief"}, {"in", {{"terrain", "isle.terrain"}}}}}},
               {"outputs", std::move(outputs)}};
  const std::string catalogue = std::string(SEAMOUNT_SOURCE_DIR) + "/tests/golden/ecosystem/catalogue.json";
  const Json life = {{"id", "life"},
                     {"op", "ecosystem.grow"},
                     {"in", {{"terrain", "isle.terrain"}, {"catalogue", {{"file", catalogue}}}}},
                     {"params", {{"iterations", 1}}}};
  if (made["outputs"].dump().find("life.") != std::string::npos) made["steps"].push_back(life);
  return made;
}

std::string source_of(const Kind& kind) {
  const std::map<std::string, std::string> sources = {
      {"terrain", "isle.terrain"},     {"labels", "isle.labels"},     {"field", "isle.coordinate"},
      {"image", "seen.image"},         {"drawing", "lines.outlines"}, {"tin", "grown.tin"},
      {"contours", "levels.contours"}, {"report", "told.report"},     {"things", "grove.things"},
      {"objects", "life.objects"},     {"current", "life.current"}};
  return sources.at(kind.name);
}

/// Whether an operator makes values of a kind: others can be read and drawn, but no document has any to write.
bool is_made(const Kind& kind) {
  const auto operators = standard_registry().operators();
  return std::any_of(operators.begin(), operators.end(), [&](const auto& op) {
    return std::any_of(op->out.begin(), op->out.end(), [&](const Port& port) { return port.kind == &kind; });
  });
}

class Outputs : public ::testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  std::vector<std::string> written() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
      if (entry.is_regular_file()) names.push_back(fs::relative(entry.path(), folder_).string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }
  Recipe recipe(const Json& outputs) const { return parse_recipe(document(outputs).dump(), "isle.json", ""); }
  std::string refusal(const Json& outputs) const {
    try {
      recipe(outputs);
    } catch (const RecipeError& error) {
      return error.what();
    }
    return "";
  }
  const std::string folder_ = ::testing::TempDir() + "seamount_outputs";
  const std::string cache_ = ::testing::TempDir() + "seamount_outputs_cache";
};

TEST_F(Outputs, WriteTheFilesThatTheySay) {
  const std::map<std::string, Json> small = {{"mesh", {{"texture_px", 32}}},
                                             {"gazebo", {{"texture_px", 32}}},
                                             {"bundle", {{"texture_px", 32}}},
                                             {"tiles", {{"tile_size", 33}}},
                                             {"perspective", {{"width_px", 96}, {"height_px", 64}}},
                                             {"map", {{"width_px", 128}}},
                                             {"texture", {{"size_px", 64}}},
                                             {"things", {{"texture_px", 32}}},
                                             {"thing_world", {{"texture_px", 32}}}};
  for (const auto& format : standard_registry().formats()) {
    for (const Kind* kind : format->accepts) {
      if (!is_made(*kind)) continue;
      for (const std::string& extension : format->extensions) {
        Json output = small.contains(format->name) ? small.at(format->name) : Json::object();
        output.update({{"from", source_of(*kind)}, {"path", "made/it" + extension}, {"as", format->name}});
        const Recipe made = recipe(Json::array({output}));
        const ExecuteReport report = execute(made, {folder_, cache_}, {});
        const std::vector<std::string> names = written();
        std::vector<std::string> told;
        for (const std::string& file : report.outputs[0].files) told.push_back(fs::relative(file, folder_).string());
        std::sort(told.begin(), told.end());
        EXPECT_EQ(told, names) << format->name << ": the report lists the files that are there";
        EXPECT_TRUE(fs::exists(report.outputs[0].path)) << report.outputs[0].path;
        for (const std::string& file : made.outputs[0].files) {
          const bool there = std::find(names.begin(), names.end(), file) != names.end();
          // Digits are known afterwards; without a coordinate system there is no .prj.
          EXPECT_TRUE(there || file.find('*') != std::string::npos || file.ends_with(".prj"))
              << format->name << " does not write " << file;
        }
        EXPECT_FALSE(names.empty());
        for (const std::string& name : names) {
          const auto& files = made.outputs[0].files;
          EXPECT_TRUE(std::any_of(files.begin(), files.end(),
                                  [&](const std::string& file) { return may_be_same_file(file, name); }))
              << format->name << " writes " << name << " unannounced";
        }
        fs::remove_all(folder_);
      }
    }
  }
  fs::remove_all(cache_);
}

TEST_F(Outputs, MeshesInTilesAreFilesOfEachTileAndLevel) {
  const Recipe made = recipe(
      Json::array({{{"from", "isle.terrain"}, {"path", "t/isle.obj"}, {"tiles", 2}, {"lods", 2}, {"texture_px", 64}}}));
  EXPECT_THAT(made.outputs[0].files,
              ElementsAre("t/isle_x*_y*_lod*.obj", "t/isle_x*_y*_lod*.mtl", "t/isle_x*_y*_lod*.png"));
  execute(made, {folder_, ""}, {});
  for (const std::string name : {"x0_y0_lod0", "x1_y0_lod0", "x0_y0_lod1", "x1_y0_lod1"}) {
    EXPECT_TRUE(fs::exists(folder_ + "/t/isle_" + name + ".obj")) << name;
    EXPECT_TRUE(fs::exists(folder_ + "/t/isle_" + name + ".png")) << name;
  }
  EXPECT_FALSE(fs::exists(folder_ + "/t/isle.obj"));
  EXPECT_THAT(refusal(Json::array({{{"from", "isle.terrain"}, {"path", "s.stl"}, {"tiles", 2}, {"base_m", 10}}})),
              HasSubstr("/outputs/0/base_m: tiles are open surfaces"));
}

TEST_F(Outputs, MeshesShowTheSeaOnce) {
  const auto water_of = [&](const Json& more) {
    Json output = {{"from", "isle.terrain"}, {"path", "a.glb"}};
    output.update(more);
    const Recipe made = recipe(Json::array({output}));
    return made.outputs[0].prepared.empty() ? Json() : made.steps.back().params["water"];
  };
  EXPECT_EQ(water_of(Json::object()), true) << "in the texture";
  EXPECT_EQ(water_of({{"water", false}}), false);
  EXPECT_EQ(water_of({{"texture_px", 0}}), Json()) << "as a surface";
  execute(recipe(Json::array({{{"from", "isle.terrain"}, {"path", "a.glb"}, {"texture_px", 16}},
                              {{"from", "isle.terrain"}, {"path", "b.glb"}, {"texture_px", 0}}})),
          {folder_, ""}, {});
  EXPECT_THAT(*io::describe_mesh(folder_ + "/a.glb"), Contains(Pair("parts", "1")));
  EXPECT_THAT(*io::describe_mesh(folder_ + "/b.glb"), Contains(Pair("parts", "2")));
}

TEST_F(Outputs, OfPicturesAreThoseOfTheirOperators) {
  const Recipe made = recipe(Json::array({{{"from", "isle.terrain"}, {"path", "relief.png"}, {"as", "relief"}},
                                          {{"from", "seen.image"}, {"path", "seen.png"}}}));
  EXPECT_EQ(made.steps.size(), 7U);  // the step `seen` makes the same picture: none is added
  execute(made, {folder_, ""}, {});
  EXPECT_EQ(io::read_file(folder_ + "/relief.png"), io::read_file(folder_ + "/seen.png"));
}

TEST_F(Outputs, ShareWhatTheyNeed) {
  const Recipe made = recipe(Json::array({{{"from", "isle.terrain"}, {"path", "a.glb"}},
                                          {{"from", "isle.terrain"}, {"path", "b.obj"}},
                                          {{"from", "isle.terrain"}, {"path", "c.stl"}}}));
  EXPECT_EQ(made.steps.size(), 8U);
  EXPECT_EQ(made.steps[7].output, "a.glb");
  EXPECT_EQ(made.steps[7].op->name, "render.texture");
  EXPECT_EQ(made.steps[7].in.size(), 2U) << "the labels of the same step come along";
  EXPECT_EQ(made.outputs[0].prepared, made.outputs[1].prepared);
  EXPECT_THAT(made.outputs[2].prepared, IsEmpty());
}

TEST_F(Outputs, ThatMeetAreRefusedWithBothNames) {
  EXPECT_THAT(refusal(Json::array(
                  {{{"from", "isle.terrain"}, {"path", "h.r16"}}, {{"from", "told.report"}, {"path", "h.r16.json"}}})),
              HasSubstr("/outputs/1/path: 'h.r16.json' is also written by output 0 ('h.r16')"));
  EXPECT_THAT(refusal(Json::array(
                  {{{"from", "isle.terrain"}, {"path", "isle.obj"}}, {{"from", "seen.image"}, {"path", "isle.png"}}})),
              HasSubstr("'isle.png' is also written by output 0 ('isle.obj')"));
  EXPECT_THAT(refusal(Json::array({{{"from", "isle.terrain"}, {"path", "t.png"}, {"as", "tiles"}},
                                   {{"from", "seen.image"}, {"path", "t_x0_y12.png"}}})),
              HasSubstr("'t_x0_y12.png' is also written by output 0 ('t.png')"));
  EXPECT_THAT(refusal(Json::array({{{"from", "isle.terrain"}, {"path", "t.png"}, {"as", "tiles"}},
                                   {{"from", "seen.image"}, {"path", "t_x0_yy.png"}}})),
              IsEmpty());
}

TEST_F(Outputs, NeverReplaceWhatIsRead) {
  const std::string recipe_file = folder_ + "/isle.json";
  Json isle = document(Json::array({{{"from", "told.report"}, {"path", "isle.json"}}}));
  io::write_text(recipe_file, isle.dump());
  const auto refused = [&](const std::string& out) -> std::string {
    try {
      execute(read_recipe(recipe_file), {out, ""}, {});
    } catch (const InvalidArgument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(refused(folder_), HasSubstr("output 'isle.json': would be written over the recipe"));
  EXPECT_EQ(io::read_file(recipe_file).size(), isle.dump().size());
  fs::create_directory_symlink(folder_, folder_ + "_link");
  EXPECT_THAT(refused(folder_ + "_link"), HasSubstr("over the recipe"));
  fs::remove(folder_ + "_link");
  EXPECT_EQ(refused(folder_ + "/elsewhere"), "");

  isle["outputs"][0] = {{"from", "isle.terrain"}, {"path", "in.tif"}};
  isle["steps"].push_back({{"id", "again"}, {"op", "terrain.import"}, {"params", {{"file", "in.tif"}}}});
  io::write_text(recipe_file, isle.dump());
  EXPECT_THAT(refused(folder_), HasSubstr("over the input"));
}

TEST_F(Outputs, OfAFailedRunLeaveNothing) {
  Json outputs =
      Json::array({{{"from", "isle.terrain"}, {"path", "height.tif"}},
                   {{"from", "isle.terrain"}, {"path", "h.r16"}, {"as", "unreal"}, {"low_m", 0}, {"high_m", 1}}});
  EXPECT_THROW(execute(recipe(outputs), {folder_, ""}, {}), Error);
  EXPECT_THAT(written(), IsEmpty());
}

TEST(OutputFiles, PatternsOfDigitsMeet) {
  EXPECT_TRUE(may_be_same_file("a_*.png", "a_12.png"));
  EXPECT_TRUE(may_be_same_file("a_12.png", "a_*.png"));
  EXPECT_TRUE(may_be_same_file("a_x*_y*.png", "a_x0_y*.png"));
  EXPECT_FALSE(may_be_same_file("a*", "*1"));
  EXPECT_FALSE(may_be_same_file("*1", "a*"));
  EXPECT_TRUE(may_be_same_file("1*", "*2"));
  EXPECT_FALSE(may_be_same_file("a_*.png", "a_.png"));
  EXPECT_FALSE(may_be_same_file("a_*.png", "a_1b.png"));
  EXPECT_FALSE(may_be_same_file("a_*.png", "b_*.png"));
}

}  // namespace
}  // namespace seamount::recipe
