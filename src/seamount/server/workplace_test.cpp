#include "seamount/server/workplace.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "seamount/base/error.h"
#include "seamount/io/atomic_file.h"

namespace seamount::server {
namespace {

namespace fs = std::filesystem;

class WorkplaceTest : public testing::Test {
 protected:
  void SetUp() override {
    outside_ = fs::canonical(fs::temp_directory_path()) / ("seamount_workplace_" + std::to_string(::getpid()));
    fs::remove_all(outside_);
    fs::create_directories(outside_ / "in/deep/deeper/deepest");
    io::write_text((outside_ / "secret.json").string(), "{}");
    io::write_text((outside_ / "in/a.json").string(), "{}");
  }
  void TearDown() override { fs::remove_all(outside_); }
  fs::path outside_;
};

TEST_F(WorkplaceTest, NoNameLeadsOut) {
  const Workplace workplace((outside_ / "in").string());
  EXPECT_EQ(workplace.resolve("a.json"), (outside_ / "in/a.json").string());
  EXPECT_EQ(workplace.resolve("new/b.json"), (outside_ / "in/new/b.json").string());
  EXPECT_EQ(workplace.resolve("./a.json"), (outside_ / "in/a.json").string());
  fs::create_symlink(outside_ / "secret.json", outside_ / "in/link.json");
  fs::create_directory_symlink(outside_, outside_ / "in/up");
  for (const std::string& name :
       {std::string(""), std::string("."), std::string("/etc/passwd"), std::string("../secret.json"),
        std::string("deep/../../secret.json"), std::string(".."), std::string("deep/.."), std::string("link.json"),
        std::string("up/secret.json"), std::string("up"), std::string("a\nb.json"), std::string("a\0b.json", 8),
        std::string(2000, 'a'), (outside_ / "in/a.json").string()}) {
    EXPECT_THROW(workplace.resolve(name), InvalidArgument) << name;
  }
}

TEST_F(WorkplaceTest, ListsItsFiles) {
  io::write_text((outside_ / "in/deep/b.json").string(), "{}");
  io::write_text((outside_ / "in/deep/deeper/deepest/c.json").string(), "{}");
  io::write_text((outside_ / "in/.hidden.json").string(), "{}");
  io::write_text((outside_ / "in/d.txt").string(), "{}");
  fs::create_symlink(outside_ / "secret.json", outside_ / "in/link.json");
  const Workplace workplace((outside_ / "in").string());
  std::vector<std::string> names;
  for (const FileEntry& file : workplace.list({".json"}, 10)) names.push_back(file.path);
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (std::vector<std::string>{"a.json", "deep/b.json"}));
  EXPECT_EQ(workplace.list({".json"}, 1).size(), 1U);
}

TEST_F(WorkplaceTest, KeepsWhatArrivedAsAWhole) {
  const Workplace workplace((outside_ / "in").string());
  const auto sends = [](const std::string& text, bool whole) {
    return [=](const std::function<bool(const char*, size_t)>& piece) {
      for (const char& c : text) piece(&c, 1);
      return whole;
    };
  };
  const std::string kept = workplace.keep("x.files", "../My DEM é.tif", sends("height", true));
  EXPECT_TRUE(kept.starts_with("x.files/") && kept.ends_with("My-DEM---.tif")) << kept;
  EXPECT_EQ(io::read_file((outside_ / "in" / kept).string()).size(), 6U);
  EXPECT_EQ(workplace.keep("x.files", "My DEM é.tif", sends("height", true)), kept);
  EXPECT_THROW(workplace.keep("x.files", "b.tif", sends("heig", false)), InvalidArgument);
  EXPECT_THROW(workplace.keep("x.files", "", sends("a", true)), InvalidArgument);
  EXPECT_THROW(workplace.keep("x.files", "..", sends("a", true)), InvalidArgument);
  EXPECT_THROW(workplace.keep("../out", "a.tif", sends("a", true)), InvalidArgument);
  EXPECT_EQ(std::distance(fs::directory_iterator(outside_ / "in/x.files"), fs::directory_iterator()), 1);
}

}  // namespace
}  // namespace seamount::server
