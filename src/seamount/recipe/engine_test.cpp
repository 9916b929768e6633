// The engine: only what follows from a change is computed, the newest revision wins, and results are those of
// execute().
#include "seamount/recipe/engine.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <sstream>
#include <utility>

#include "seamount/recipe/kinds.h"
#include "seamount/recipe/ports.h"

namespace seamount::recipe {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string kSmall = R"({"seamount": 1, "domain": {"width_m": 6400, "height_m": 6400, "cell_m": 100}, "seed": 3,
  "steps": [
    {"id": "isle", "op": "island.build"},
    {"id": "worn", "op": "island.wind", "in": {"terrain": "isle.terrain", "labels": "isle.labels"}},
    {"id": "reef", "op": "island.coral", "in": {"terrain": "worn.terrain", "labels": "worn.labels"}},
    {"id": "hills", "op": "terrain.noise"}],
  "outputs": [{"from": "reef.terrain", "path": "reef.asc"}, {"from": "hills.terrain", "path": "hills.asc"}]})";

/// toy.slow hands its terrain on after so many milliseconds, unless it is stopped.
struct SlowParams {
  int milliseconds = 0;
  static constexpr auto fields() {
    return std::tuple(field(&SlowParams::milliseconds, "milliseconds", "", between(0, 1000000), "how long it takes"));
  }
};

std::atomic<int>& slow_runs() {
  static std::atomic<int> count{0};
  return count;
}

const Registry& with_toys() {
  static const Registry registry = [] {
    Registry toys = standard_registry();
    toys.add(make_operator<SlowParams>({.name = "toy.slow", .summary = "Waits"},
                                       inputs(in<kinds::Terrain>("terrain", "heights")),
                                       outputs(out<kinds::Terrain>("terrain", "the same heights")),
                                       [](const SlowParams& params, const Call& call, const HeightField& heights) {
                                         ++slow_runs();
                                         for (int i = 0; i < params.milliseconds; ++i) {
                                           call.run.check_cancelled();
                                           call.run.report(static_cast<double>(i) / params.milliseconds);
                                           usleep(1000);
                                         }
                                         return heights;
                                       }));
    return toys;
  }();
  return registry;
}

/// Minutes of work that can be stopped.
const std::string kSlow =
    R"({"seamount": 1, "domain": {"width_m": 6400, "height_m": 6400, "cell_m": 100}, "steps": [
    {"id": "hills", "op": "terrain.noise"},
    {"id": "worn", "op": "toy.slow", "in": {"terrain": "hills.terrain"}, "params": {"milliseconds": 200000}},
    {"id": "map", "op": "toy.slow", "in": {"terrain": "worn.terrain"}}]})";
const Source kMap{"map", "terrain", ""};

const Source kReef{"reef", "terrain", ""};
const Source kHills{"hills", "terrain", ""};

Document document(const std::string& text) { return {text, "small.json", "", with_toys()}; }

EngineOptions quick(const std::string& cache = "") {
  EngineOptions options;
  options.cache_folder = cache;
  return options;
}

Recipe recipe_of(const Engine& engine) { return parse_recipe(engine.document().text(), "r.json", "", {}, with_toys()); }

/// The value that execute() has for a source.
HeightField judge(const Engine& engine, const Source& source) {
  return evaluate(recipe_of(engine), {source}, {"", ""}, {})[0].get<kinds::Terrain>();
}

StepState step(const Engine& engine, const std::string& id) {
  for (const StepState& state : engine.state().steps) {
    if (state.id == id) return state;
  }
  return {};
}

/// Steps and what stands in their state, in the document's order.
std::vector<std::string> standings(const Engine& engine) {
  static const char* const kNames[] = {"fresh",  "stale",   "queued",     "running",
                                       "failed", "blocked", "incomplete", "bypassed"};
  std::vector<std::string> all;
  for (const StepState& state : engine.state().steps)
    all.push_back(state.id + " " + kNames[static_cast<size_t>(state.standing)]);
  return all;
}

/// Counts how often each step starts, by what the state says between waits.
std::vector<std::string> stale_after(Engine& engine, const Edit& edit) {
  engine.want({}, Quality::full);
  engine.edit(edit);
  engine.wait();
  std::vector<std::string> stale;
  for (const StepState& state : engine.state().steps) {
    if (state.standing == Standing::stale) stale.push_back(state.id);
  }
  engine.want({kReef, kHills}, Quality::full);
  engine.wait();
  return stale;
}

TEST(Engine, ComputesWhatIsWantedAndHasTheValuesOfExecute) {
  Engine engine(document(kSmall), quick());
  EXPECT_FALSE(engine.value(kReef));
  engine.want({kReef}, Quality::full);
  engine.wait();
  ASSERT_TRUE(engine.value(kReef));
  EXPECT_EQ(engine.value(kReef)->value.get<kinds::Terrain>(), judge(engine, kReef));
  EXPECT_FALSE(engine.value(kReef)->coarse);
  EXPECT_THAT(standings(engine), ElementsAre("isle fresh", "worn fresh", "reef fresh", "hills stale"));
  EXPECT_FALSE(engine.value(kHills));
  EXPECT_TRUE(engine.state().settled);
  EXPECT_EQ(engine.state().fraction, 1.0);
}

TEST(Engine, OneSliderMakesOnlyWhatFollowsStale) {
  Engine engine(document(kSmall), quick());
  engine.want({kReef, kHills}, Quality::full);
  engine.wait();
  EXPECT_THAT(stale_after(engine, set_parameter("reef", "subsidence", 0.4)), ElementsAre("reef"));
  EXPECT_EQ(engine.value(kReef)->value.get<kinds::Terrain>(), judge(engine, kReef));
  EXPECT_THAT(stale_after(engine, set_parameter("worn", "radial_count", 5)), ElementsAre("worn", "reef"));
  EXPECT_THAT(stale_after(engine, set_parameter("hills", "height_m", 50)), ElementsAre("hills"));
  EXPECT_THAT(stale_after(engine, set_seed(9)), ElementsAre("isle", "worn", "reef", "hills"));
  EXPECT_THAT(stale_after(engine, set_domain("cell_m", 80)), ElementsAre("isle", "worn", "reef", "hills"));
  EXPECT_EQ(engine.value(kReef)->value.get<kinds::Terrain>(), judge(engine, kReef));
  EXPECT_THAT(stale_after(engine, SetValue{"/about", "a remark"}), ElementsAre());
  EXPECT_THAT(stale_after(engine, RenameStep{"isle", "kauai"}), ElementsAre());
}

TEST(Engine, UndoneValuesAreThereAtOnce) {
  Engine engine(document(kSmall), quick());
  engine.want({kReef}, Quality::full);
  engine.wait();
  const HeightField first = engine.value(kReef)->value.get<kinds::Terrain>();
  engine.edit(set_parameter("isle", "peak_m", 500));
  engine.wait();
  EXPECT_NE(engine.value(kReef)->value.get<kinds::Terrain>(), first);
  EXPECT_TRUE(engine.undo());
  engine.wait();
  EXPECT_EQ(engine.value(kReef)->value.get<kinds::Terrain>(), first);
  EXPECT_EQ(engine.value(kReef)->revision, engine.revision());
  EXPECT_TRUE(engine.redo());
  EXPECT_FALSE(engine.redo());
}

TEST(Engine, TenChangesInARowEndWithTheLast) {
  for (const char* gesture : {"", "drag"}) {
    for (const Quality quality : {Quality::full, Quality::coarse_then_full}) {
      EngineOptions options = quick();
      options.coarse_cells = 16;
      Engine engine(document(kSmall), options);
      engine.want({kReef, kHills}, quality);
      for (int i = 1; i <= 10; ++i) engine.edit(set_parameter("isle", "peak_m", 500 + 10 * i), gesture);
      engine.wait();
      EXPECT_EQ(engine.value(kReef)->revision, 10U);
      EXPECT_EQ(engine.value(kReef)->value.get<kinds::Terrain>(), judge(engine, kReef));
      EXPECT_EQ(engine.document().done(), *gesture == '\0' ? 10U : 1U);
    }
  }
}

TEST(Engine, GivesACoarseResultFirst) {
  std::mutex mutex;
  std::vector<std::pair<uint64_t, bool>> seen;
  Engine* engine_seen = nullptr;
  EngineOptions options = quick();
  options.coarse_cells = 16;
  options.changed = [&] {
    const std::lock_guard lock(mutex);
    const auto value = engine_seen == nullptr ? std::nullopt : engine_seen->value(kReef);
    if (value && (seen.empty() || seen.back() != std::pair(value->revision, value->coarse)))
      seen.emplace_back(value->revision, value->coarse);
  };
  Engine engine(document(kSmall), options);
  {
    const std::lock_guard lock(mutex);
    engine_seen = &engine;
  }
  engine.want({kReef}, Quality::coarse);
  engine.wait();
  EXPECT_EQ(engine.value(kReef)->value.get<kinds::Terrain>().frame().width, 16);
  const Recipe coarse = parse_recipe(engine.document().text(), "r.json", "", {.sets = {}, .seed = {}, .size = 16});
  EXPECT_EQ(engine.value(kReef)->value.get<kinds::Terrain>(),
            evaluate(coarse, {kReef}, {"", ""}, {})[0].get<kinds::Terrain>());
  engine.want({kReef}, Quality::coarse_then_full);
  engine.wait();
  engine.edit(set_parameter("reef", "subsidence", 0.3));
  engine.wait();
  EXPECT_EQ(engine.value(kReef)->value.get<kinds::Terrain>(), judge(engine, kReef));
  const std::lock_guard lock(mutex);
  EXPECT_EQ(seen.front(), std::pair(uint64_t{0}, true));
  EXPECT_EQ(seen.back(), std::pair(uint64_t{1}, false));
  for (size_t i = 1; i < seen.size(); ++i)
    EXPECT_LT(std::pair(seen[i - 1].first, !seen[i - 1].second), std::pair(seen[i].first, !seen[i].second));
  engine_seen = nullptr;
}

TEST(Engine, WithinAGestureACoarseResultIsFinishedHoweverFastEditsCome) {
  EngineOptions options = quick();
  options.coarse_cells = 16;
  Engine engine(document(kSlow), options);
  const Source worn{"worn", "terrain", ""};
  engine.want({worn}, Quality::coarse_then_full);
  std::vector<uint64_t> shown;  // revisions
  for (int i = 1; i <= 3000 && shown.size() < 3; ++i) {
    engine.edit(set_parameter("worn", "milliseconds", 30 + i % 500), "drag");  // slower than edits come
    engine.wait_for(3);
    const auto value = engine.value(worn);
    if (!value || (!shown.empty() && shown.back() == value->revision)) continue;
    shown.push_back(value->revision);
  }
  EXPECT_EQ(shown.size(), 3U);
  EXPECT_TRUE(std::is_sorted(shown.begin(), shown.end()));
}

/// Waits until a step is being computed.
void wait_until_running(Engine& engine, const std::string& id) {
  for (int i = 0; i < 2000 && step(engine, id).standing != Standing::running; ++i) engine.wait_for(5);
  ASSERT_EQ(step(engine, id).standing, Standing::running);
}

TEST(Engine, WhatComesInAMomentGetsNoCoarseResultOnceAGestureIsOver) {
  EngineOptions options = quick();
  options.coarse_cells = 16;
  Engine engine(document(kSlow), options);
  engine.edit(set_parameter("worn", "milliseconds", 1));
  int before = slow_runs();
  const auto runs = [&] {
    engine.wait();
    return slow_runs() - std::exchange(before, slow_runs());
  };
  const Source worn{"worn", "terrain", ""};
  engine.want({worn}, Quality::coarse_then_full);
  EXPECT_EQ(runs(), 2);  // how long it takes is not known yet
  engine.edit({set_parameter("worn", "milliseconds", 2)}, "drag");
  EXPECT_EQ(runs(), 2);
  engine.edit({set_parameter("worn", "milliseconds", 3)}, "drag", "", "", true);
  EXPECT_EQ(runs(), 1);
  EXPECT_EQ(engine.value(worn)->revision, 3U);
  EXPECT_FALSE(engine.value(worn)->coarse);
  engine.edit({set_parameter("worn", "milliseconds", 400)}, "", "", "", true);
  EXPECT_EQ(runs(), 1);  // as long as last time is expected
  engine.edit({set_parameter("worn", "milliseconds", 401)}, "", "", "", true);
  EXPECT_EQ(runs(), 2);
}

TEST(Engine, AHandThatRestsBeforeItLetsGoEndsItsGestureToo) {
  EngineOptions options = quick();
  options.coarse_cells = 16;
  Engine engine(document(kSlow), options);
  const Source worn{"worn", "terrain", ""};
  engine.edit(set_parameter("worn", "milliseconds", 20));
  engine.want({worn}, Quality::full);
  engine.wait();  // now it is known to come soon
  engine.want({worn}, Quality::coarse_then_full);
  const auto is_there = [&] { return engine.value(worn)->revision == engine.revision(); };
  bool in_time = false;
  for (int i = 21; i < 60 && !in_time; ++i) {
    engine.edit({set_parameter("worn", "milliseconds", i)}, "drag");
    wait_until_running(engine, "worn");
    EXPECT_TRUE(engine.edit({set_parameter("worn", "milliseconds", i)}, "drag", "", "", true).empty());
    in_time = !is_there();  // on a machine that is busy the coarse result may have been faster
    while (in_time && !is_there()) engine.wait_for(5);
    if (in_time) {
      EXPECT_FALSE(engine.value(worn)->coarse);
    }
  }
  EXPECT_TRUE(in_time);
}

TEST(Engine, AChangeBelowDoesNotStopARunningStepAndAChangeAboveDoes) {
  Engine engine(document(kSlow), quick());
  engine.want({kMap}, Quality::full);
  wait_until_running(engine, "worn");
  while (step(engine, "worn").fraction < 0.01) engine.wait_for(5);
  const int runs = slow_runs();
  engine.edit(set_parameter("map", "milliseconds", 1));
  while (engine.state().revision < 1) engine.wait_for(1);
  EXPECT_EQ(step(engine, "worn").standing, Standing::running);
  EXPECT_GE(step(engine, "worn").fraction, 0.01);
  EXPECT_EQ(step(engine, "map").standing, Standing::queued);
  EXPECT_EQ(slow_runs(), runs);
  engine.edit(set_parameter("worn", "milliseconds", 2));
  engine.wait();
  EXPECT_THAT(standings(engine), ElementsAre("hills fresh", "worn fresh", "map fresh"));
  EXPECT_EQ(slow_runs(), runs + 2);
}

TEST(Engine, CancelsAndIsDestroyedInTheMiddleOfWork) {
  const auto start = std::chrono::steady_clock::now();
  {
    Engine engine(document(kSlow), quick());
    engine.want({kMap}, Quality::full);
    wait_until_running(engine, "worn");
    engine.cancel();
    engine.wait();
    EXPECT_TRUE(engine.state().settled);
    EXPECT_THAT(standings(engine), ElementsAre("hills fresh", "worn stale", "map stale"));
    engine.want({kMap}, Quality::full);
    wait_until_running(engine, "worn");
    EXPECT_FALSE(engine.wait_for(1));
  }
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(100));  // not the minutes of the work
  for (int i = 0; i < 20; ++i) {
    Engine engine(document(kSmall), quick());
    engine.want({kReef, kHills}, Quality::coarse_then_full);
    engine.wait_for(i);
    engine.edit(set_parameter("isle", "peak_m", 600 + i));
  }
}

TEST(Engine, AFailedStepDoesNotStopOthersAndIsMendedByAnEdit) {
  Engine engine(document(kSmall), quick());
  engine.want({kReef, kHills}, Quality::full);
  engine.wait();
  const HeightField before = engine.value(kReef)->value.get<kinds::Terrain>();
  engine.edit(
      {set_parameter("isle", "outlines", OrderedJson::parse("[[99999]]")), set_parameter("hills", "height_m", 9)});
  engine.wait();
  EXPECT_THAT(standings(engine), ElementsAre("isle failed", "worn blocked", "reef blocked", "hills fresh"));
  EXPECT_THAT(step(engine, "isle").message, HasSubstr("step 'isle' (island.build): coast: the coast reaches from"));
  EXPECT_EQ(step(engine, "reef").message, step(engine, "isle").message);
  EXPECT_EQ(engine.value(kHills)->revision, 1U);
  EXPECT_EQ(engine.value(kReef)->revision, 0U);  // the last that there was
  EXPECT_EQ(engine.value(kReef)->value.get<kinds::Terrain>(), before);
  engine.edit(set_parameter("isle", "outlines", std::nullopt));
  engine.wait();
  EXPECT_EQ(engine.value(kReef)->value.get<kinds::Terrain>(), before);
  EXPECT_EQ(engine.value(kReef)->revision, 2U);
}

TEST(Engine, IncompleteAndBypassedStepsLetTheOthersBe) {
  Engine engine(document(kSmall), quick());
  engine.want({kReef, kHills, {"no", "such", ""}}, Quality::full);
  engine.edit(connect("worn", "terrain", ""));
  engine.wait();
  EXPECT_THAT(standings(engine), ElementsAre("isle stale", "worn incomplete", "reef blocked", "hills fresh"));
  EXPECT_THAT(step(engine, "worn").message, HasSubstr("needs the input 'terrain'"));
  EXPECT_FALSE(engine.value(kReef));
  EXPECT_THROW(engine.write_outputs("out", {}), RecipeError);
  engine.undo();
  engine.edit(bypass("worn", true));
  engine.want({kReef, {"worn", "terrain", ""}}, Quality::full);
  engine.wait();
  EXPECT_THAT(standings(engine), ElementsAre("isle fresh", "worn bypassed", "reef fresh", "hills fresh"));
  EXPECT_EQ(engine.value({"worn", "terrain", ""})->value.get<kinds::Terrain>(), judge(engine, {"isle", "terrain", ""}));
  EXPECT_EQ(engine.value(kReef)->value.get<kinds::Terrain>(), judge(engine, kReef));
}

TEST(Engine, MemoryIsBoundedAndResultsAreComputedAgain) {
  EngineOptions options = quick();
  options.memory_bytes = 200 << 10;  // a terrain has 16 KiB, labels 4
  Engine engine(document(kSmall), options);
  engine.want({kReef}, Quality::full);
  for (int i = 0; i < 20; ++i) {
    engine.edit(set_parameter("isle", "peak_m", 500 + i));
    engine.wait();
    EXPECT_LE(engine.bytes_in_memory(), options.memory_bytes);
  }
  options.memory_bytes = 1;  // only what is in use
  Engine tiny(document(kSmall), options);
  tiny.want({kReef}, Quality::full);
  tiny.wait();
  tiny.edit(set_parameter("reef", "subsidence", 0.2));
  tiny.wait();
  EXPECT_EQ(tiny.value(kReef)->value.get<kinds::Terrain>(), judge(tiny, kReef));
  EXPECT_LT(tiny.bytes_in_memory(), uint64_t{64} << 10);
}

TEST(Engine, TwoInOneProcessDoNotKnowOfEachOther) {
  Engine one(document(kSmall), quick()), two(document(kSmall), quick());
  one.want({kReef}, Quality::full);
  two.want({kReef}, Quality::full);
  for (int i = 1; i <= 5; ++i) {
    one.edit(set_parameter("isle", "peak_m", 500 + i));
    two.edit(set_parameter("isle", "peak_m", 700 + i));
  }
  one.wait();
  two.wait();
  EXPECT_EQ(one.value(kReef)->value.get<kinds::Terrain>(), judge(one, kReef));
  EXPECT_EQ(two.value(kReef)->value.get<kinds::Terrain>(), judge(two, kReef));
}

/// A folder of its own for each test.
class EngineFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(::testing::TempDir()) /
              ("seamount_engine_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string at(const std::string& name) const { return (folder_ / name).string(); }
  std::string content(const std::string& name) const {
    std::ifstream file(folder_ / name, std::ios::binary);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
  }

  fs::path folder_;
};

TEST_F(EngineFiles, WritesTheFilesOfRun) {
  execute(parse_recipe(kSmall, "small.json", ""), {at("run"), ""}, {});
  Engine engine(document(kSmall), quick());
  const ExecuteReport report = engine.write_outputs(at("engine"), {});
  EXPECT_EQ(report.outputs.size(), 2U);
  EXPECT_EQ(report.steps.size(), 4U);
  for (const char* name : {"reef.asc", "hills.asc"}) {
    EXPECT_FALSE(content(std::string("run/") + name).empty());
    EXPECT_EQ(content(std::string("run/") + name), content(std::string("engine/") + name));
  }
}

TEST_F(EngineFiles, FindsOnDiskWhatAnotherSessionComputed) {
  const HeightField first = [&] {
    Engine engine(document(kSmall), quick(at("cache")));
    engine.want({kReef}, Quality::full);
    engine.wait();
    return engine.value(kReef)->value.get<kinds::Terrain>();
  }();
  Engine engine(document(kSmall), quick(at("cache")));
  engine.want({kReef}, Quality::full);
  engine.wait();
  EXPECT_EQ(engine.value(kReef)->value.get<kinds::Terrain>(), first);
  EXPECT_TRUE(step(engine, "reef").cached);
  EXPECT_EQ(step(engine, "isle").standing, Standing::fresh);  // never read: what follows from it is there
  const ExecuteReport report = execute(parse_recipe(kSmall, "small.json", ""), {at("out"), at("cache")}, {});
  for (const StepReport& ran : report.steps) EXPECT_EQ(ran.cached, ran.id != "hills") << ran.id;
}

TEST_F(EngineFiles, SeesThatAFileHasChanged) {
  execute(parse_recipe(kSmall, "small.json", ""), {at("out"), ""}, {});
  Engine engine({R"({"seamount": 1, "steps": [{"id": "dem", "op": "terrain.import", "params": {"file": "dem.asc"}}]})",
                 "r.json", folder_.string()},
                quick());
  const Source dem{"dem", "terrain", ""};
  engine.want({dem}, Quality::full);
  engine.wait();
  EXPECT_EQ(step(engine, "dem").standing, Standing::failed);
  EXPECT_THAT(step(engine, "dem").message, HasSubstr("dem.asc"));
  for (const char* name : {"out/reef.asc", "out/hills.asc", "out/reef.asc"}) {
    fs::copy_file(at(name), at("dem.asc"), fs::copy_options::overwrite_existing);
    engine.refresh();
    engine.wait();
    EXPECT_EQ(engine.value(dem)->value.get<kinds::Terrain>(),
              evaluate(parse_recipe(engine.document().text(), "r.json", folder_.string()), {dem}, {"", ""}, {})[0]
                  .get<kinds::Terrain>());
  }
}

TEST_F(EngineFiles, NotesComeWithResultsFromMemoryAndDiskToo) {
  // A hairpin narrower than the tool folds space: the operator limits its strength and says so.
  const std::string text = R"({"seamount": 1, "domain": {"width_m": 9600, "height_m": 9600, "cell_m": 100}, "steps": [
    {"id": "isle", "op": "island.build"},
    {"id": "lines", "op": "contour.extract", "in": {"terrain": "isle.terrain"}, "params": {"interval_m": 100}},
    {"id": "edited", "op": "contour.edit", "in": {"contours": "lines.contours"}, "params": {"edits": [
      {"tool": "slope", "stroke": [[-3000, -700], [2500, -650], [2600, 650], [-3000, 700]], "radius_m": 2000,
       "strength": -1}]}}],
    "outputs": [{"from": "edited.contours", "path": "lines.geojson"}]})";
  const Recipe recipe = parse_recipe(text, "notes.json", "");
  std::vector<std::string> said;
  const RunContext run{.note = [&](const std::string& line) { said.push_back(line); }};
  const ExecuteReport first = execute(recipe, {at("out"), at("cache")}, run);
  ASSERT_FALSE(first.steps[2].notes.empty());
  EXPECT_THAT(said, ElementsAre("step 'edited': " + first.steps[2].notes[0]));
  const ExecuteReport second = execute(recipe, {at("out"), at("cache")}, run);
  EXPECT_TRUE(second.steps[2].cached);
  EXPECT_EQ(second.steps[2].notes, first.steps[2].notes);
  EXPECT_EQ(said.size(), 2U);
  Engine engine({text, "notes.json", ""}, quick(at("cache")));
  engine.want({{"edited", "contours", ""}}, Quality::full);
  engine.wait();
  EXPECT_EQ(step(engine, "edited").notes, first.steps[2].notes);
}

}  // namespace
}  // namespace seamount::recipe
