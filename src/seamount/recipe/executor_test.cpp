#include "seamount/recipe/executor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "seamount/io/atomic_file.h"
#include "seamount/recipe/ports.h"
#include "seamount/recipe/value_bytes.h"

namespace seamount::recipe {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// A folder of its own for each test.
class Execute : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(::testing::TempDir()) /
              ("seamount_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  ExecuteOptions options() const { return {(folder_ / "out").string(), (folder_ / "cache").string()}; }

  /// Which steps were computed, not read from the cache.
  std::vector<std::string> computed(const Recipe& recipe, const RunContext& run = {}) const {
    std::vector<std::string> ids;
    for (const StepReport& step : execute(recipe, options(), run).steps) {
      if (!step.cached) ids.push_back(step.id);
    }
    return ids;
  }

  std::string content(const std::string& name) const {
    std::ifstream file(folder_ / "out" / name, std::ios::binary);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
  }

  fs::path folder_;
};

/// isle -> reef, and a noise that nothing else needs but an output.
Recipe small(const RecipeChanges& changes = {}) {
  return parse_recipe(
      R"({"seamount": 1, "domain": {"width_m": 6400, "height_m": 6400, "cell_m": 100}, "seed": 3, "steps": [
      {"id": "isle", "op": "island.build"},
      {"id": "reef", "op": "island.coral", "in": {"terrain": "isle.terrain", "labels": "isle.labels"}},
      {"id": "hills", "op": "terrain.noise"}],
    "outputs": [{"from": "reef.terrain", "path": "reef.asc"}, {"from": "hills.terrain", "path": "hills.asc"}]})",
      "small.json", "", changes);
}

TEST_F(Execute, ComputesOnlyWhatFollowsFromAChange) {
  using ::testing::UnorderedElementsAre;
  EXPECT_THAT(computed(small()), UnorderedElementsAre("isle", "reef", "hills"));
  const std::string first = content("reef.asc");
  EXPECT_FALSE(first.empty());
  EXPECT_THAT(computed(small()), UnorderedElementsAre());
  EXPECT_EQ(content("reef.asc"), first);
  EXPECT_THAT(computed(small({.sets = {"steps.reef.params.subsidence=0.4"}, .seed = {}, .size = {}})),
              UnorderedElementsAre("reef"));
  EXPECT_NE(content("reef.asc"), first);
  EXPECT_THAT(computed(small({.sets = {"steps.isle.params.relief=0.1"}, .seed = {}, .size = {}})),
              UnorderedElementsAre("isle", "reef"));
  EXPECT_THAT(computed(small({.sets = {}, .seed = 4, .size = {}})), UnorderedElementsAre("isle", "reef", "hills"));
  EXPECT_THAT(computed(small({.sets = {}, .seed = {}, .size = 32})), UnorderedElementsAre("isle", "reef", "hills"));
}

TEST_F(Execute, SameBytesOnAnyNumberOfThreadsWithAndWithoutCache) {
  ExecuteOptions bare = options();
  bare.cache_folder.clear();
  execute(small(), bare, {.threads = 1});
  const std::string one = content("reef.asc");
  execute(small(), bare, {.threads = 4});
  EXPECT_EQ(content("reef.asc"), one);
  execute(small(), options(), {});
  execute(small(), options(), {});  // from the cache
  EXPECT_EQ(content("reef.asc"), one);
}

TEST_F(Execute, DamagedCacheEntriesAreComputedAgain) {
  computed(small());
  const std::string first = content("reef.asc");
  for (const auto& entry : fs::directory_iterator(folder_ / "cache")) {
    std::fstream file(entry.path(), std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(200);
    file.put('x');
  }
  EXPECT_EQ(computed(small()).size(), 3U);
  EXPECT_EQ(content("reef.asc"), first);
}

TEST_F(Execute, ASwappedCacheEntryIsNotBelieved) {
  const auto keep = [&](uint64_t key, float height) {
    const HeightField grid(GridFrame::centred(4, 4, 1), height);
    Cache((folder_ / "cache").string()).store({key, key}, {{"terrain", Value::of<kinds::Terrain>(grid)}});
    return folder_ / "cache" / (Digest{key, key}.hex() + ".step");
  };
  const fs::path one = keep(1, 10), two = keep(2, 20);
  fs::copy_file(two, one, fs::copy_options::overwrite_existing);
  const Cache cache((folder_ / "cache").string());
  EXPECT_FALSE(cache.load({1, 1}, {{"terrain", &kinds::Terrain::kind(), ""}}).has_value());
  EXPECT_TRUE(cache.load({2, 2}, {{"terrain", &kinds::Terrain::kind(), ""}}).has_value());
}

TEST_F(Execute, FailureNamesTheStepAndLeavesEarlierResultsAlone) {
  computed(small());
  const std::string first = content("reef.asc");
  try {
    execute(small({.sets = {R"(steps.isle.params.outlines=[99999])"}, .seed = {}, .size = {}}), options(), {});
    FAIL();
  } catch (const InvalidArgument& error) {
    EXPECT_THAT(error.what(), HasSubstr("step 'isle' (island.build): coast: the coast reaches from"));
  }
  EXPECT_EQ(content("reef.asc"), first);
}

TEST_F(Execute, OutputsThatCannotBeWrittenAreFailuresWithTheirPath) {
  std::ofstream(folder_ / "out") << "a file where the folder should be";
  try {
    execute(small(), options(), {});
    FAIL();
  } catch (const IoError&) {
    FAIL() << "an output that cannot be written is not wrong input";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("out"));
  }
}

TEST_F(Execute, StopsWhenCancelledAndReportsProgress) {
  std::atomic<bool> cancelled{true};
  EXPECT_THROW(execute(small(), options(), {.cancelled = &cancelled}), Cancelled);
  EXPECT_FALSE(fs::exists(folder_ / "out"));
  std::vector<double> seen;
  execute(small(), options(), {.progress = [&](double f) { seen.push_back(f); }});
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  EXPECT_NEAR(seen.back(), 1.0, 1e-9);
}

TEST_F(Execute, InputsComeFromFilesToo) {
  execute(small(), options(), {});
  const std::string text =
      R"({"seamount": 1, "steps": [{"id": "w", "op": "island.wind", "in": {"terrain": {"file": "out/reef.asc"}}}],
                               "outputs": [{"from": "w.terrain", "path": "again.asc"}]})";
  execute(parse_recipe(text, "files.json", folder_.string()), options(), {});
  EXPECT_EQ(content("again.asc"), content("reef.asc"));
  const std::string missing =
      R"({"seamount": 1, "steps": [{"id": "w", "op": "island.wind", "in": {"terrain": {"file": "none.tif"}}}]})";
  EXPECT_THROW(execute(parse_recipe(missing, "files.json", folder_.string()), options(), {}), IoError);
}

TEST_F(Execute, CacheStaysBelowItsLimit) {
  const std::string cache_folder = (folder_ / "cache").string();
  Cache cache(cache_folder, 300000);
  const HeightField grid(GridFrame::centred(100, 100, 1), 1.0F);  // 40 kB
  for (uint64_t i = 0; i < 20; ++i) EXPECT_TRUE(cache.store({i, i}, {{"terrain", Value::of<kinds::Terrain>(grid)}}));
  uint64_t bytes = 0;
  for (const auto& entry : fs::directory_iterator(cache_folder)) bytes += entry.file_size();
  EXPECT_LE(bytes, 300000U);
  EXPECT_TRUE(cache.load({19, 19}, {{"terrain", &kinds::Terrain::kind(), ""}}).has_value());
  EXPECT_FALSE(cache.load({19, 19}, {{"labels", &kinds::Labels::kind(), ""}}).has_value());
  EXPECT_FALSE(Cache("").store({1, 1}, {}));
}

Values every_kind() {
  GridFrame frame = GridFrame::centred(5, 3, 2.5);
  frame.crs = "EPSG:32604";
  HeightField heights(frame, 1.5F);
  heights(2, 1) = -7;
  const Drawing drawing{{{"kauai", {{{{0, 0}, {1, 0}, {1, 1}}, {{{0.2, 0.1}, {0.4, 0.1}, {0.3, 0.2}}}}}}},
                        {{{{0, 0}, {5, 5}}, 100, true}},
                        "EPSG:4326"};
  return {{"terrain", Value::of<kinds::Terrain>(heights)},
          {"coordinate", Value::of<kinds::Field>(heights)},
          {"labels", Value::of<kinds::Labels>(LabelMap(frame, Region::lagoon))},
          {"image", Value::of<kinds::Image>(Image(3, 2, {1, 2, 3}))},
          {"outlines", Value::of<kinds::Drawing>(drawing)}};
}

TEST(ValueBytes, RoundTripIsExact) {
  std::stringstream bytes;
  write_values(bytes, every_kind());
  const auto read = read_values(bytes, standard_registry());
  ASSERT_TRUE(read.has_value());
  const Values given = every_kind();
  EXPECT_EQ(read->at("terrain").get<kinds::Terrain>(), given.at("terrain").get<kinds::Terrain>());
  EXPECT_EQ(read->at("coordinate").kind().name, "field");
  EXPECT_EQ(read->at("labels").get<kinds::Labels>(), given.at("labels").get<kinds::Labels>());
  EXPECT_EQ(read->at("image").get<kinds::Image>(), given.at("image").get<kinds::Image>());
  EXPECT_EQ(read->at("outlines").get<kinds::Drawing>(), given.at("outlines").get<kinds::Drawing>());
}

TEST(ValueBytes, TruncatedOrChangedBytesAreRefused) {
  std::stringstream stream;
  write_values(stream, every_kind());
  const std::string bytes = stream.str();
  for (size_t n = 0; n < bytes.size(); ++n) {
    std::stringstream cut(bytes.substr(0, n));
    EXPECT_FALSE(read_values(cut, standard_registry()).has_value()) << n;
    std::string changed = bytes;
    changed[n] = static_cast<char>(changed[n] ^ 0x5a);
    std::stringstream other(changed);
    EXPECT_FALSE(read_values(other, standard_registry()).has_value()) << n;
  }
}

struct ReaderParams {
  FilePath file;
  static constexpr auto fields() { return std::tuple(field(&ReaderParams::file, "file", "a file")); }
};

/// Makes a field of a file's length; while `meddle`, somebody writes to the file in the meantime.
Registry with_reader(const bool& meddle) {
  Registry registry = standard_registry();
  registry.add(make_operator<ReaderParams>(
      {.name = "test.length", .summary = "The length of a file"}, inputs(),
      outputs(out<kinds::Field>("length", "everywhere the same")), [&meddle](const ReaderParams& p, const Call& call) {
        const auto length = static_cast<float>(io::read_file(call.resolve(p.file)).size());
        if (meddle) io::write_text(call.resolve(p.file), "written meanwhile");
        return ScalarField(call.domain, length);
      }));
  return registry;
}

TEST_F(Execute, ResultOfAFileThatIsWrittenToMeanwhileIsNotKept) {
  const std::string folder = folder_.string();
  io::write_text(folder + "/a.txt", "four");
  bool meddle = true;
  const Registry registry = with_reader(meddle);
  const Recipe recipe = parse_recipe(R"({"seamount": 1, "domain": {"width_m": 40, "height_m": 40, "cell_m": 10},
    "steps": [{"id": "l", "op": "test.length", "params": {"file": "a.txt"}}]})",
                                     "r.json", folder, {}, registry);
  const auto length = [&] {
    return evaluate(recipe, {{"l", "length", ""}}, {"", folder + "/cache"}, {})[0].get<kinds::Field>()(0, 0);
  };
  try {
    length();
    FAIL();
  } catch (const IoError& error) {
    EXPECT_THAT(error.what(), HasSubstr("a.txt: was written to while it was read"));
  }
  meddle = false;
  EXPECT_EQ(length(), 17.0F);
  io::write_text(folder + "/a.txt", "four");
  EXPECT_EQ(length(), 4.0F);  // a key that the first run had; what it read is not believed
}

}  // namespace
}  // namespace seamount::recipe
