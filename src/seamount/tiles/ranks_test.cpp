// Ranks as threads of one process, whose messages go through queues.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <deque>
#include <filesystem>
#include <fstream>
#include <future>
#include <numeric>
#include <sstream>

#include "seamount/io/test_files.h"
#include "seamount/tiles/folder_use.h"
#include "seamount/tiles/rank_messages.h"
#include "seamount/tiles/run.h"
#include "seamount/tiles/spread.h"
#include "seamount/tiles/test_world.h"

namespace seamount::tiles {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Messages to one rank, in the order in which they were sent.
struct Mailbox {
  std::mutex mutex;
  std::condition_variable changed;
  std::deque<std::pair<int, std::string>> messages;
  bool closed = false;
};

class QueueLink : public RankLink {
 public:
  QueueLink(int rank, std::vector<std::shared_ptr<Mailbox>> boxes) : rank_(rank), boxes_(std::move(boxes)) {}
  ~QueueLink() override { close(); }
  int rank() const override { return rank_; }
  int size() const override { return static_cast<int>(boxes_.size()); }
  std::string machine() const override { return rank_ == 2 ? "other" : "one"; }
  void start(Deliver deliver) override {
    thread_ = std::async(std::launch::async, [deliver, &box = *boxes_[static_cast<size_t>(rank_)]] {
      std::unique_lock lock(box.mutex);
      for (;;) {
        box.changed.wait(lock, [&] { return box.closed || !box.messages.empty(); });
        if (box.messages.empty()) return;
        const auto [from, message] = box.messages.front();
        box.messages.pop_front();
        lock.unlock();
        deliver(from, message);
        lock.lock();
      }
    });
  }
  void send(int to, std::string message) override {
    Mailbox& box = *boxes_[static_cast<size_t>(to)];
    const std::lock_guard lock(box.mutex);
    box.messages.emplace_back(rank_, std::move(message));
    box.changed.notify_all();
  }
  void close() override {
    {
      Mailbox& own = *boxes_[static_cast<size_t>(rank_)];
      const std::lock_guard lock(own.mutex);
      own.closed = true;
      own.changed.notify_all();
    }
    if (thread_.valid()) thread_.get();
  }
  void abandon() noexcept override { std::abort(); }

 private:
  int rank_;
  std::vector<std::shared_ptr<Mailbox>> boxes_;
  std::future<void> thread_;
};

/// Does work(ranks, cancelled) as `count` ranks side by side; failures are told as the program does. What they were.
std::vector<std::optional<RankFailure>> as_ranks(
    int count, const std::function<void(Ranks& ranks, const std::atomic<bool>& cancelled)>& work) {
  std::vector<std::shared_ptr<Mailbox>> boxes;
  for (int rank = 0; rank < count; ++rank) boxes.push_back(std::make_shared<Mailbox>());
  std::vector<std::future<std::optional<RankFailure>>> running;
  for (int rank = 0; rank < count; ++rank) {
    running.push_back(std::async(std::launch::async, [&, rank] {
      std::atomic<bool> stopped{false};
      MessageRanks ranks(
          std::make_unique<QueueLink>(rank, boxes), [&] { stopped = true; }, &stopped);
      try {
        work(ranks, stopped);
      } catch (const std::exception& error) {
        ranks.fail(1, error.what());
      }
      ranks.close();
      return ranks.failure();
    }));
  }
  std::vector<std::optional<RankFailure>> failures;
  for (auto& one : running) failures.push_back(one.get());
  return failures;
}

TEST(Ranks, TakeNumbersOnceGatherAndShare) {
  std::mutex mutex;
  std::vector<int> taken;
  const auto failures = as_ranks(3, [&](Ranks& ranks, const std::atomic<bool>&) {
    EXPECT_EQ(ranks.on_this_machine(), ranks.rank() == 2 ? 1 : 2);
    for (int round = 0; round < 3; ++round) {
      spread(ranks, {.threads = 2}, 100, 2, [&](int i, const RunContext&) {
        const std::lock_guard lock(mutex);
        taken.push_back(100 * round + i);
        return true;
      });
    }
    const auto gathered = ranks.gather("of " + std::to_string(ranks.rank()));
    if (ranks.first())
      EXPECT_THAT(gathered, ElementsAre("of 0", "of 1", "of 2"));
    else
      EXPECT_THAT(gathered, IsEmpty());
    EXPECT_EQ(ranks.share(ranks.first() ? "for all" : "for nobody"), "for all");
    EXPECT_EQ(lowest(ranks, 5 - ranks.rank()), 3);
    EXPECT_TRUE(agreed(ranks, ranks.first()));
  });
  for (const auto& failure : failures) EXPECT_FALSE(failure);
  std::sort(taken.begin(), taken.end());
  std::vector<int> all(300);
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(taken, all) << "each piece of work once, whoever does it";
}

TEST(Ranks, NoMoreIsBegunAfterABodySaysSo) {
  std::atomic<int> begun{0};
  as_ranks(2, [&](Ranks& ranks, const std::atomic<bool>&) {
    spread(ranks, {.threads = 1}, 100000, 1, [&](int, const RunContext&) { return ++begun < 10; });
  });
  EXPECT_LT(begun.load(), 1000);
}

TEST(Ranks, OneThatFailsStopsAll) {
  const auto failures = as_ranks(3, [](Ranks& ranks, const std::atomic<bool>&) {
    if (ranks.rank() == 1) throw Error("the disk is full");
    if (ranks.rank() == 2) ranks.share("");  // waits for what never comes
    ranks.gather("");
  });
  for (const auto& failure : failures) {
    ASSERT_TRUE(failure);
    EXPECT_EQ(failure->rank, 1);
    EXPECT_EQ(failure->text, "the disk is full");
    EXPECT_EQ(failure->machine, "one");
  }
}

/// Chains, a step that is run as a whole, one that is small, water over the borders of tiles, with its lakes and
/// catchments, a plain through many of them, a mask by depth, colours that hang on the relief, a part cut out.
const char* const kWorld = R"({"seamount": 1, "seed": 9,
  "domain": {"width_m": 12000, "height_m": 9500, "cell_m": 31.3},
  "steps": [
    {"id": "hills", "op": "terrain.noise", "params": {"wavelength_m": 5000, "base_m": -120}},
    {"id": "steep", "op": "terrain.mask", "in": "hills", "params": {"criteria": [{"tool": "slope", "low_deg": 14, "scale_m": 150}]}},
    {"id": "filled", "op": "hydrology.fill", "in": {"terrain": "hills"}, "params": {"min_lake_m2": 4000}},
    {"id": "soft", "op": "terrain.smooth", "in": {"terrain": "filled.terrain", "mask": "steep"}, "params": {"radius_m": 90}},
    {"id": "flow", "op": "hydrology.flow", "in": {"terrain": "soft"}},
    {"id": "traced", "op": "hydrology.flow", "in": {"terrain": "filled.terrain"}, "params": {"min_catchment_m2": 90000}},
    {"id": "level", "op": "terrain.noise", "params": {"height_m": 0, "base_m": 60}},
    {"id": "plain", "op": "terrain.blend", "in": {"terrain": "hills", "with": "level"}, "params": {"mode": "max"}},
    {"id": "across", "op": "hydrology.flow", "in": {"terrain": "plain"}},
    {"id": "shore", "op": "terrain.noise", "params": {"kind": "smooth", "wavelength_m": 300, "base_m": 80}},
    {"id": "wet", "op": "terrain.mask", "in": {"terrain": "shore"}, "params": {"criteria": [{"tool": "depth", "low_m": 2, "falloff_m": 20}]}},
    {"id": "layered", "op": "terrain.layers", "in": {"terrain": "soft"}},
    {"id": "peak", "op": "terrain.crop", "in": {"terrain": "soft"}, "params": {"around": "highest", "width_m": 7000, "height_m": 6000}},
    {"id": "coarse", "op": "terrain.resample", "in": {"terrain": "soft"}, "params": {"cell_m": 200}},
    {"id": "isle", "op": "classify.terrain", "in": {"terrain": "coarse"}}],
  "outputs": [
    {"from": "soft.terrain", "path": "height.tif"}, {"from": "flow.area", "path": "water.tif"},
    {"from": "filled.change", "path": "change.tif"}, {"from": "isle.labels", "path": "labels.tif"},
    {"from": "filled.lakes", "path": "lakes.geojson"}, {"from": "flow.basins", "path": "basins.tif"},
    {"from": "flow.catchments", "path": "catchments.geojson"}, {"from": "traced.catchments", "path": "traced.geojson"},
    {"from": "across.direction", "path": "across.tif"}, {"from": "across.cells", "path": "cells.tif"},
    {"from": "wet", "path": "wet.tif"}, {"from": "layered.high", "path": "layered.tif"}, {"from": "peak", "path": "peak.tif"},
    {"from": "soft.terrain", "path": "u.r16", "as": "tiles", "engine": "unreal", "tile_size": 127},
    {"from": "soft.terrain", "path": "m.glb", "as": "mesh_tiles", "tile_size": 200, "texture_px": 0},
    {"from": "soft.terrain", "path": "map.png", "as": "map", "width_px": 200}]})";

class TiledRanks : public ::testing::Test {
 protected:
  std::string at(const std::string& name) const { return folder_(name); }

 private:
  io::TestFolder folder_;
};

TEST_F(TiledRanks, MakeTheSameBytes) {
  const recipe::Recipe recipe = recipe::parse_recipe(kWorld, "world.json", "");
  execute(recipe, {at("one"), at("cache"), 5000, 0}, {});
  for (const int count : {1, 2, 3}) {
    constexpr uint64_t kTooLittle = 3000000;  // for 383 x 303 cells as a whole
    const std::string out = at(std::to_string(count)),
                      cache = count == 2 ? "" : at("cache" + out.substr(out.size() - 1));
    const auto failures = as_ranks(count, [&](Ranks& ranks, const std::atomic<bool>& cancelled) {
      execute(recipe, {out, cache, 90 + count, kTooLittle, &ranks}, {.threads = 1, .cancelled = &cancelled});
    });
    for (const auto& failure : failures) EXPECT_FALSE(failure) << failure->text;
    for (const char* name : {"height.tif", "water.tif", "change.tif", "labels.tif", "lakes.geojson", "basins.tif",
                             "catchments.geojson", "traced.geojson", "across.tif", "cells.tif", "wet.tif",
                             "layered.tif", "peak.tif", "u_x3_y2.r16", "u_tiles.json", "m_x1_y1_lod0.glb", "m.gltf"})
      EXPECT_TRUE(bytes_of(out + "/" + name) == bytes_of(at("one/") + name)) << name << ", " << count << " ranks";
    EXPECT_TRUE(fs::exists(out + "/map.png")) << "from larger cells";
    if (cache.empty()) continue;
    EXPECT_TRUE(fs::is_empty(cache + "/tiles")) << "what is done leaves no tiles";
  }
}

TEST_F(TiledRanks, SayWhichTileFailed) {
  const recipe::Recipe recipe = recipe::parse_recipe(
      R"({"seamount": 1, "domain": {"width_m": 8000, "height_m": 8000, "cell_m": 20},
    "steps": [{"id": "hills", "op": "terrain.noise", "params": {"kind": "smooth"}},
              {"id": "some", "op": "terrain.mask", "params": {"criteria": [{"tool": "region"}]}}],
    "outputs": [{"from": "some", "path": "a.tif"}]})",
      "world.json", "");
  const auto failures = as_ranks(2, [&](Ranks& ranks, const std::atomic<bool>& cancelled) {
    execute(recipe, {at("out"), at("cache"), 256, 0, &ranks}, {.threads = 1, .cancelled = &cancelled});
  });
  ASSERT_TRUE(failures[0] && failures[1]);
  EXPECT_EQ(failures[0]->text, failures[1]->text);
  EXPECT_EQ(failures[0]->rank, failures[1]->rank);
  EXPECT_THAT(failures[0]->text, HasSubstr("step 'some' (terrain.mask)"));
  EXPECT_THAT(failures[0]->text, HasSubstr("of row 1 (columns"));
  EXPECT_FALSE(fs::exists(at("out")));
}

/// What the raster itself shows, all of them find.
TEST_F(TiledRanks, FindTogetherThatOnlyTheWholeTells) {
  const recipe::Recipe recipe = recipe::parse_recipe(
      R"({"seamount": 1, "seed": 9, "domain": {"width_m": 12000, "height_m": 9500, "cell_m": 31.3},
    "steps": [{"id": "lakes", "op": "terrain.noise", "params": {"kind": "smooth", "wavelength_m": 3000, "base_m": 80}},
              {"id": "sea", "op": "terrain.mask", "in": {"terrain": "lakes"}, "params": {"criteria": [{"tool": "depth"}]}}],
    "outputs": [{"from": "sea", "path": "a.tif"}]})",
      "world.json", "");
  constexpr uint64_t kTooLittle = 3000000;
  const auto failures = as_ranks(2, [&](Ranks& ranks, const std::atomic<bool>& cancelled) {
    execute(recipe, {at("out"), at("cache"), 92, kTooLittle, &ranks}, {.threads = 1, .cancelled = &cancelled});
  });
  for (const auto& failure : failures) {
    ASSERT_TRUE(failure);
    EXPECT_THAT(failure->text, HasSubstr("(terrain.mask) looks at everything (an enclosed water below sea level"));
  }
  for (const auto& left : fs::directory_iterator(at("cache/tiles")))
    EXPECT_THAT(left.path().filename().string(), HasSubstr(".terrain.")) << "what was found is of no use any more";
}

/// Two runs that share a folder: the one that ends first leaves it to the other.
TEST_F(TiledRanks, TheLastOneThatUsesAFolderRemovesIt) {
  const std::string folder = at("tiles/of_a_step");
  FolderUse one(folder), other(folder);
  fs::create_directories(folder);
  EXPECT_FALSE(one.end_and_remove());
  EXPECT_TRUE(fs::exists(folder));
  EXPECT_TRUE(other.end_and_remove());
  EXPECT_FALSE(fs::exists(folder));
  EXPECT_TRUE(fs::is_empty(at("tiles"))) << "nor is the lock left";
  { const FolderUse never_made(folder); }
  EXPECT_TRUE(fs::is_empty(at("tiles")));
}

}  // namespace
}  // namespace seamount::tiles
