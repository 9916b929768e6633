#include "seamount/server/studio.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "seamount/io/atomic_file.h"
#include "seamount/io/raster.h"
#include "seamount/recipe/recipe.h"

namespace seamount::server {
namespace {

namespace fs = std::filesystem;

constexpr const char* kRecipe = R"({"seamount": 1, "domain": {"width_m": 640, "height_m": 640, "cell_m": 10},
 "steps": [{"id": "land", "op": "terrain.noise"}, {"id": "soft", "op": "terrain.smooth"}],
 "outputs": [{"path": "land.tif", "from": "land.terrain"}]})";

class StudioTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::canonical(fs::temp_directory_path()) / ("seamount_studio_" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "work");
    io::write_text((folder_ / "work/r.json").string(), kRecipe);
    start();
  }
  void TearDown() override {
    studio_.reset();
    fs::remove_all(folder_);
  }
  void start(const std::string& recipe = "r.json") {
    studio_.reset();
    StudioOptions options{.registry = &recipe::standard_registry(), .folder = (folder_ / "work").string()};
    if (!recipe.empty()) options.recipe = (folder_ / "work" / recipe).string();
    options.state_folder = (folder_ / "state").string();
    options.examples = {{"toy", "Toy", "an example"}};
    options.example_text = [](const std::string& name, const std::string&) -> std::string {
      if (name != "toy") throw InvalidArgument("example", "there is no '" + name + "'");
      return kRecipe;
    };
    options.example_picture = [](const std::string&) { return ""; };
    studio_ = std::make_unique<Studio>(std::move(options));
  }

  Reply reply(const std::string& method, const std::string& path, const OrderedJson& body = {},
              std::map<std::string, std::string> query = {}) {
    return studio_->answer({method, path, std::move(query), body.is_null() ? "" : body.dump()});
  }
  OrderedJson json(const std::string& method, const std::string& path, const OrderedJson& body = {}, int status = 200) {
    const Reply answer = reply(method, path, body);
    EXPECT_EQ(answer.status, status) << path << ": " << answer.bytes;
    return OrderedJson::parse(answer.bytes);
  }
  OrderedJson document() { return json("GET", "/api/document"); }
  OrderedJson asking(const std::string& window = "w") { return {{"window", window}, {"base", document()["revision"]}}; }
  OrderedJson octaves(int value, const std::string& gesture = "", const std::string& window = "w") {
    OrderedJson body = asking(window);
    body["gesture"] = gesture;
    body["label"] = "octaves";
    body["edits"] = {{{"do", "set"}, {"pointer", "/steps/land/params/octaves"}, {"value", value}}};
    return body;
  }

  fs::path folder_;
  std::unique_ptr<Studio> studio_;
};

/// Reads a stream until an event that `wanted` takes; fails after ten seconds.
OrderedJson wait_for(EventHub::Stream& stream, const std::function<bool(const OrderedJson&)>& wanted) {
  for (int i = 0; i < 100; ++i) {
    const std::string text = stream.next(100);
    for (size_t begin = 0; begin < text.size(); begin = text.find('\n', begin) + 1) {
      OrderedJson event = OrderedJson::parse(text.substr(begin, text.find('\n', begin) - begin));
      if (wanted(event)) return event;
    }
  }
  ADD_FAILURE() << "no such event";
  return {};
}

TEST_F(StudioTest, EditsAreInTheDocumentAndInTheHistory) {
  EXPECT_TRUE(document()["saved"].get<bool>());
  EXPECT_EQ(document()["file"], "r.json");
  const OrderedJson event = json("POST", "/api/edits", octaves(3));
  EXPECT_EQ(event["changes"].size(), 1U);
  EXPECT_EQ(event["changes"][0]["pointer"], "/steps/0/params");
  const OrderedJson now = document();
  EXPECT_EQ(now["revision"], event["revision"]);
  EXPECT_EQ(now["recipe"]["steps"][0]["params"]["octaves"], 3);
  EXPECT_EQ(now["history"], OrderedJson::parse(R"([{"label": "octaves", "window": "w"}])"));
  EXPECT_FALSE(now["saved"].get<bool>());
  EXPECT_TRUE(json("POST", "/api/undo", asking())["saved"].get<bool>());
  EXPECT_EQ(json("POST", "/api/undo", asking(), 404)["error"], "there is nothing to undo");
  json("POST", "/api/redo", asking());
  EXPECT_EQ(document()["recipe"], now["recipe"]);
}

TEST_F(StudioTest, AGestureIsOneEntry) {
  for (int i = 2; i < 8; ++i) json("POST", "/api/edits", octaves(i, "drag"));
  EXPECT_EQ(document()["done"], 1);
  json("POST", "/api/undo", asking());
  EXPECT_FALSE(document()["recipe"]["steps"][0].contains("params"));
}

TEST_F(StudioTest, TwoWindowsStayInStep) {
  const OrderedJson late = octaves(5, "", "b");
  const auto stream = reply("GET", "/api/events", {}, {{"window", "b"}}).stream;
  const OrderedJson hello = wait_for(*stream, [](const OrderedJson&) { return true; });
  EXPECT_EQ(hello["event"], "hello");
  EXPECT_EQ(hello["revision"], document()["revision"]);
  const OrderedJson first = json("POST", "/api/edits", octaves(3, "", "a"));
  const OrderedJson event = wait_for(*stream, [](const OrderedJson& e) { return e["event"] == "document"; });
  EXPECT_EQ(event, first);
  const OrderedJson refused = json("POST", "/api/edits", late, 409);
  ASSERT_EQ(refused["missed"].size(), 1U);
  EXPECT_EQ(refused["missed"][0], first);
  OrderedJson again = late;
  again["base"] = first["revision"];
  json("POST", "/api/edits", again);
  EXPECT_EQ(document()["recipe"]["steps"][0]["params"]["octaves"], 5);
  again["base"] = 7;  // of another session
  EXPECT_TRUE(json("POST", "/api/edits", again, 409)["missed"].empty());
}

TEST_F(StudioTest, RefusesWhatWouldBeNoRecipe) {
  const OrderedJson before = document();
  OrderedJson body = octaves(3);
  body["edits"].push_back({{"do", "set"}, {"pointer", "/steps/land/params/octaves"}, {"value", "many"}});
  const OrderedJson refused = json("POST", "/api/edits", body, 422);
  EXPECT_EQ(refused["diagnostics"][0]["pointer"], "/steps/0/params/octaves");
  for (const char* text :
       {"", "{", "[]", "null", "{}", R"({"window": "w"})", R"({"window": "w", "base": -1, "edits": []})",
        R"({"window": "", "base": 1, "edits": []})", R"({"window": "w", "base": 1, "edits": {}})",
        R"({"window": 3, "base": 1, "edits": []})", R"({"window": "w", "window": "v", "base": 1, "edits": []})"}) {
    const int status = studio_->answer({"POST", "/api/edits", {}, text}).status;
    EXPECT_GE(status, 400) << text;
    EXPECT_LT(status, 500) << text;
  }
  EXPECT_EQ(document(), before);
}

TEST_F(StudioTest, TextBecomesEdits) {
  OrderedJson body = asking();
  OrderedJson recipe = document()["recipe"];
  recipe["steps"][1]["params"] = {{"radius_m", 50}};
  body["text"] = recipe.dump();
  EXPECT_EQ(json("POST", "/api/text", body)["changes"].size(), 1U);
  EXPECT_EQ(document()["recipe"], recipe);
  body = asking();
  body["text"] = "{\n \"seamount\": 1,\n \"steps\": [{\"id\": \"a\", \"op\": \"terrain.nose\"}]}";
  const OrderedJson refused = json("POST", "/api/text", body, 422);
  EXPECT_EQ(refused["diagnostics"][0]["line"], 3);
  EXPECT_EQ(json("POST", "/api/check", body)["diagnostics"], refused["diagnostics"]);
  EXPECT_EQ(document()["recipe"], recipe);
}

TEST_F(StudioTest, AfterACrashTheSessionComesBack) {
  json("POST", "/api/edits", octaves(3));
  json("POST", "/api/edits", octaves(4));
  const OrderedJson before = document();
  start();
  OrderedJson after = document();
  EXPECT_EQ(after["recipe"], before["recipe"]);
  EXPECT_EQ(after["history"], before["history"]);
  EXPECT_FALSE(after["saved"].get<bool>());
  json("POST", "/api/save", asking());
  EXPECT_TRUE(document()["saved"].get<bool>());
  io::write_text((folder_ / "work/r.json").string(), kRecipe);  // another program
  start();
  after = document();
  EXPECT_FALSE(after["recipe"]["steps"][0].contains("params"));
  EXPECT_NE(after["notice"].get<std::string>().find("another program"), std::string::npos);
}

TEST_F(StudioTest, SavesAndOpens) {
  OrderedJson body = asking();
  body["path"] = "other/mine";
  EXPECT_TRUE(json("POST", "/api/save", body)["saved"].get<bool>());
  EXPECT_TRUE(fs::exists(folder_ / "work/other/mine.json"));
  EXPECT_EQ(document()["file"], "other/mine.json");
  for (const char* path : {"../x", "/tmp/x.json", ""}) {
    OrderedJson out = asking();
    out["path"] = path;
    json("POST", "/api/save", out, 400);
    json("POST", "/api/open", out, 400);
  }
  EXPECT_EQ(json("POST", "/api/open", {{"path", "r.json"}})["file"], "r.json");
  EXPECT_EQ(json("POST", "/api/open", {{"example", "toy"}})["file"], "");
  json("POST", "/api/open", {{"example", "none"}}, 400);
  EXPECT_EQ(json("POST", "/api/open", {{"blank", true}, {"cell_m", 5}})["recipe"]["domain"]["cell_m"], 5.0);
  json("POST", "/api/open", {{"path", "none.json"}}, 404);
  EXPECT_EQ(document()["recipe"]["domain"]["cell_m"], 5.0);
  json("POST", "/api/save", asking(), 400);  // it has no file yet
}

TEST_F(StudioTest, SavedIntoAnotherFolderItFindsItsFilesAndKeepsItsHistory) {
  for (const char* name : {"a.tif", "b.tif"})
    io::write_field(ScalarField({.width = 4, .height = 4, .cell_m = 10}, 1.0F), (folder_ / "work" / name).string());
  const auto edit = [&](const OrderedJson& edits, const std::string& label) {
    OrderedJson body = asking();
    body["edits"] = edits, body["gesture"] = "", body["label"] = label;
    json("POST", "/api/edits", body);
  };
  edit({{{"do", "insert"},
         {"list", "/steps"},
         {"value", {{"id", "ground"}, {"op", "terrain.import"}, {"params", {{"file", "a.tif"}}}}}}},
       "read");
  edit({{{"do", "set"}, {"pointer", "/steps/2/params/file"}, {"value", "b.tif"}}}, "another");
  edit({{{"do", "set"}, {"pointer", "/about"}, {"value", "a.tif"}}}, "remark");
  OrderedJson body = asking();
  body["path"] = "other/mine";
  EXPECT_TRUE(json("POST", "/api/save", body)["saved"].get<bool>());
  EXPECT_EQ(document()["file"], "other/mine.json");
  EXPECT_TRUE(document()["saved"].get<bool>());
  EXPECT_EQ(document()["recipe"]["steps"][2]["params"]["file"], "../b.tif");
  EXPECT_EQ(document()["recipe"]["about"], "a.tif");
  EXPECT_EQ(document()["history"].size(), 3U);
  json("POST", "/api/undo", asking());
  json("POST", "/api/undo", asking());
  EXPECT_EQ(document()["recipe"]["steps"][2]["params"]["file"], "../a.tif");
  start();  // as its file and its journal say
  json("POST", "/api/open", {{"path", "other/mine.json"}});
  EXPECT_EQ(document()["recipe"]["steps"][2]["params"]["file"], "../a.tif");
  EXPECT_EQ(recipe::read_recipe((folder_ / "work/other/mine.json").string()).steps.size(), 3U);
}

TEST_F(StudioTest, ResultsAreAnnouncedAndFetched) {
  const auto stream = reply("GET", "/api/events", {}, {{"window", "w"}}).stream;
  json("POST", "/api/want", {{"window", "w"}, {"sources", {"soft.terrain", "none.terrain"}}, {"quality", "full"}});
  const auto is_value = [](const OrderedJson& e) { return e["event"] == "value"; };
  const OrderedJson value = wait_for(*stream, is_value);
  EXPECT_EQ(value["source"], "soft.terrain");
  EXPECT_EQ(value["frame"]["columns"], 64);
  const std::string at = "/api/values/" + value["key"].get<std::string>();
  const Reply whole = reply("GET", at + "/raster");
  EXPECT_EQ(whole.bytes.size(), 64U * 64U * 4U);
  EXPECT_EQ(reply("GET", at + "/raster", {}, {{"level", "3"}}).bytes.size(), 8U * 8U * 4U);
  const Reply part = reply("GET", at + "/raster", {}, {{"x", "62"}, {"y", "1"}, {"columns", "2"}, {"rows", "1"}});
  EXPECT_EQ(part.bytes, whole.bytes.substr(4 * (64 + 62), 8));
  EXPECT_EQ(part.headers.back().second, "2 1 f32");
  for (const auto& query : std::vector<std::map<std::string, std::string>>{{{"level", "17"}},
                                                                           {{"level", "-1"}},
                                                                           {{"x", "64"}},
                                                                           {{"x", "-1"}},
                                                                           {{"columns", "0"}},
                                                                           {{"columns", "65"}},
                                                                           {{"rows", "999999999"}},
                                                                           {{"level", "x"}},
                                                                           {{"y", "1e3"}},
                                                                           {{"y", "99999999999"}}})
    EXPECT_EQ(reply("GET", at + "/raster", {}, query).status, 400) << query.begin()->first;
  EXPECT_EQ(reply("GET", at + "/picture").status, 400);
  EXPECT_EQ(reply("GET", at + "/nothing").status, 404);
  EXPECT_EQ(reply("GET", "/api/values/00/raster").status, 404);
  json("POST", "/api/edits", octaves(2));
  const OrderedJson next = wait_for(*stream, is_value);
  EXPECT_NE(next["key"], value["key"]);
  EXPECT_EQ(next["revision"], document()["revision"]);
  EXPECT_EQ(reply("GET", at + "/raster").status, 200);  // the one before is kept for who is just fetching it
  json("POST", "/api/want", {{"window", "w"}, {"sources", OrderedJson::array()}});
  EXPECT_EQ(wait_for(*stream, [](const OrderedJson& e) { return e["event"] == "gone"; })["source"], "soft.terrain");
  EXPECT_EQ(reply("GET", at + "/raster").status, 404);
}

TEST_F(StudioTest, AStepThatComesLaterIsShownThen) {
  const auto stream = reply("GET", "/api/events", {}, {{"window", "w"}}).stream;
  json("POST", "/api/want", {{"window", "w"}, {"sources", {"late"}}, {"quality", "full"}});
  OrderedJson body = asking();
  body["edits"] = {{{"do", "insert"}, {"list", "/steps"}, {"value", {{"id", "late"}, {"op", "terrain.noise"}}}}};
  json("POST", "/api/edits", body);
  EXPECT_EQ(wait_for(*stream, [](const OrderedJson& e) { return e["event"] == "value"; })["source"], "late");
}

TEST_F(StudioTest, Exports) {
  const auto stream = reply("GET", "/api/events", {}, {{"window", "w"}}).stream;
  const OrderedJson outputs = OrderedJson::parse(R"([{"path": "a.tif", "from": "soft.terrain"}])");
  const OrderedJson job = json("POST", "/api/export", {{"window", "w"}, {"folder", "ex"}, {"outputs", outputs}});
  const OrderedJson done = wait_for(*stream, [&](const OrderedJson& e) {
    return e["event"] == "job" && e["job"] == job["job"] && e["state"] != "running";
  });
  EXPECT_EQ(done["state"], "done") << done["message"];
  ASSERT_FALSE(done["files"].empty());
  EXPECT_EQ(done["files"][0]["path"], "ex/a.tif");
  EXPECT_EQ(reply("GET", "/api/download", {}, {{"path", "ex/a.tif"}}).file, (folder_ / "work/ex/a.tif").string());
  EXPECT_EQ(reply("GET", "/api/download", {}, {{"path", "../state"}}).status, 400);
  EXPECT_EQ(document()["recipe"]["outputs"][0]["path"], "land.tif");
  json("POST", "/api/export", {{"window", "w"}, {"folder", "../ex"}, {"outputs", outputs}}, 400);
  json("POST", "/api/export", {{"window", "w"}, {"outputs", OrderedJson::array()}}, 400);
  json("POST", "/api/export", {{"window", "w"}, {"outputs", {{{"path", "../../a.tif"}, {"from", "soft"}}}}}, 422);
}

TEST_F(StudioTest, UploadsAreKeptAsAWhole) {
  const auto send = [](const std::string& text, bool whole) -> Receive {
    return [=](const auto& piece) { return piece(text.data(), text.size()) && whole; };
  };
  const Request request{"POST", "/api/upload", {{"name", "dem.asc"}}, ""};
  const std::string raster = "ncols 2\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 10\n1 2\n";
  const OrderedJson kept = OrderedJson::parse(studio_->upload(request, send(raster, true)).bytes);
  EXPECT_EQ(kept["kind"], "terrain") << kept;
  EXPECT_TRUE(fs::exists(folder_ / "work" / kept["file"].get<std::string>()));
  EXPECT_EQ(studio_->upload(request, send(raster, false)).status, 400);
  EXPECT_EQ(studio_->upload({"POST", "/api/upload", {}, ""}, send(raster, true)).status, 400);
  const OrderedJson odd =
      OrderedJson::parse(studio_->upload({"POST", "/api/upload", {{"name", "a.tif"}}, ""}, send("no", true)).bytes);
  EXPECT_TRUE(odd["info"].contains("problem"));
}

TEST_F(StudioTest, UnknownPlacesAreSaid) {
  EXPECT_EQ(reply("GET", "/api/nothing").status, 404);
  EXPECT_EQ(reply("POST", "/api/document").status, 404);
  EXPECT_EQ(reply("GET", "/api/events").status, 400);
  EXPECT_EQ(reply("GET", "/api/examples/toy/picture").status, 404);
  EXPECT_EQ(json("GET", "/api/examples")["examples"][0]["name"], "toy");
  EXPECT_EQ(json("GET", "/api/files")["files"].size(), 1U);
  EXPECT_GT(json("GET", "/api/schema")["operators"].size(), 40U);
  json("POST", "/api/cancel", {{"job", "job-9"}}, 404);
  json("POST", "/api/cancel", OrderedJson::object());
}

TEST(EventHub, KeepsTheNewestStatesAndAllDocuments) {
  EventHub hub;
  const auto early = hub.open("a");
  hub.publish("one");
  hub.publish_state("s", "old");
  hub.publish_state("s", "new");
  hub.publish("two");
  EXPECT_EQ(early->next(0), "one\ntwo\nnew\n");
  EXPECT_EQ(early->next(0), "");
  EXPECT_EQ(hub.open("b")->next(0), "new\n");
  hub.withdraw_state("s", "gone");
  EXPECT_EQ(early->next(0), "gone\n");
  EXPECT_EQ(hub.open("c")->next(0), "");
  const auto again = hub.open("a");
  EXPECT_TRUE(early->closed());
  for (size_t i = 0; i < EventHub::kMostStreams; ++i) hub.open("more " + std::to_string(i));
  EXPECT_TRUE(again->closed());
  hub.close();
  EXPECT_TRUE(hub.open("late")->closed());
}

}  // namespace
}  // namespace seamount::server
