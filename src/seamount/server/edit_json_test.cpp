#include "seamount/server/edit_json.h"

#include <gtest/gtest.h>

#include "seamount/recipe/document.h"

namespace seamount::server {
namespace {

TEST(EditJson, ReadsWhatItWrites) {
  const std::vector<recipe::Edit> edits = {recipe::SetValue{"/steps/a/params/x", 1.5},
                                           recipe::SetValue{"/steps/a/params/x", {}},
                                           recipe::SetValue{"/steps/a/params/x", nullptr},
                                           recipe::InsertItem{"/steps", 2, {{"id", "b"}}},
                                           recipe::InsertItem{"/steps", {}, OrderedJson(3)},
                                           recipe::RemoveItem{"/outputs/1"},
                                           recipe::MoveItem{"/steps/a", 3},
                                           recipe::RenameStep{"a", "b"},
                                           recipe::RemoveStep{"a"}};
  for (const recipe::Edit& edit : edits) {
    const OrderedJson json = write_edit(edit);
    EXPECT_EQ(write_edit(read_edit(json, "edits[0]")), json) << json;
    EXPECT_EQ(read_edit(json, "edits[0]").index(), edit.index());
  }
  EXPECT_TRUE(std::get<recipe::SetValue>(read_edit(write_edit(edits[2]), "")).value.has_value());
  EXPECT_FALSE(std::get<recipe::SetValue>(read_edit(write_edit(edits[1]), "")).value.has_value());
}

TEST(EditJson, RefusesWhatIsNoEdit) {
  for (const char* text :
       {"[]", "{}", "null", R"({"do": "set"})", R"({"do": "set", "pointer": 3})", R"({"do": "jump"})",
        R"({"do": "insert", "list": "/steps"})", R"({"do": "move", "item": "/steps/0"})",
        R"({"do": "move", "item": "/steps/0", "index": -1})",
        R"({"do": "insert", "list": "/steps", "index": 1.5, "value": 1})",
        R"({"do": "insert", "list": "/steps", "index": 99999999999, "value": 1})"}) {
    EXPECT_THROW(read_edit(OrderedJson::parse(text), "edits[7]"), InvalidArgument) << text;
  }
  EXPECT_THROW(read_edits(OrderedJson::object()), InvalidArgument);
  try {
    read_edit(OrderedJson::parse(R"({"do": "set"})"), "edits[7]");
  } catch (const InvalidArgument& error) {
    EXPECT_STREQ(error.what(), "edits[7]: needs a text 'pointer'");
  }
}

TEST(EditJson, DifferencesLeadFromOneTextToAnother) {
  const std::vector<std::string> texts = {
      R"({"seamount": 1, "steps": []})",
      R"({"seamount": 1, "seed": 3, "domain": {"width_m": 640, "height_m": 640, "cell_m": 10},
          "steps": [{"id": "a", "op": "terrain.noise"}]})",
      R"({"seamount": 1, "seed": 4, "domain": {"width_m": 640, "height_m": 320, "cell_m": 10},
          "steps": [{"id": "a", "op": "terrain.noise", "params": {"octaves": 3}}, {"id": "b", "op": "terrain.smooth"}]})",
      R"({"seamount": 1, "about": "a~b/c", "steps": [{"id": "a", "op": "terrain.noise", "params": {"octaves": 4}},
          {"id": "b", "op": "terrain.smooth"}], "outputs": [{"path": "x.tif"}]})"};
  for (const std::string& from : texts) {
    for (const std::string& to : texts) {
      recipe::Document document(from, "a", "");
      const recipe::Document wanted(to, "b", "");
      document.apply(differences(document.json(), wanted.json()));
      EXPECT_EQ(document.json().dump().size(), wanted.json().dump().size()) << from << to;
      EXPECT_EQ(recipe::Json(document.json()), recipe::Json(wanted.json())) << from << to;
      document.undo();
      EXPECT_EQ(document.json(), recipe::Document(from, "a", "").json());
    }
  }
  const OrderedJson small = OrderedJson::parse(texts[1]);
  OrderedJson changed = small;
  changed["domain"]["cell_m"] = 20;
  const auto edits = differences(small, changed);
  ASSERT_EQ(edits.size(), 1U);
  EXPECT_EQ(std::get<recipe::SetValue>(edits[0]).pointer, "/domain/cell_m");
  EXPECT_TRUE(differences(small, small).empty());
}

TEST(EditJson, InverseTakesChangesBack) {
  recipe::Document document(R"({"seamount": 1, "steps": [{"id": "a", "op": "terrain.noise"}]})", "a", "");
  OrderedJson root = document.json();
  const auto changes =
      document.apply({recipe::set_parameter("a", "octaves", 3),
                      recipe::add_step({{"id", "b"}, {"op", "terrain.smooth"}}), recipe::RenameStep{"a", "c"}});
  recipe::make_again(root, changes);
  EXPECT_EQ(root, document.json());
  recipe::make_again(root, inverse(changes));
  document.undo();
  EXPECT_EQ(root, document.json());
}

}  // namespace
}  // namespace seamount::server
