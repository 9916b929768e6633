#include "seamount/base/installation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>

namespace seamount {
namespace {

using ::testing::EndsWith;

/// An environment variable, as it was before when this is gone.
class Variable {
 public:
  Variable(const char* name, const std::string& value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    setenv(name, value.c_str(), 1);
  }
  ~Variable() {
    if (before_) {
      setenv(name_, before_->c_str(), 1);
    } else {
      unsetenv(name_);
    }
  }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

TEST(Installation, EmptyAndRepeatedFoldersDoNotCount) {
  const size_t others = [] {
    const Variable models("SEAMOUNT_MODELS", "");
    return shared_folders(Shared::models).size();
  }();
  const Variable models("SEAMOUNT_MODELS", ":/x::/x:");
  EXPECT_EQ(shared_folders(Shared::models).size(), others + 1);
  EXPECT_EQ(shared_folders(Shared::models).front(), "/x");
}

TEST(Installation, EachKindHasItsFolderAndVariable) {
  EXPECT_THAT(shared_folders(Shared::recipes).back(), EndsWith("share/seamount/recipes"));
  EXPECT_THAT(shared_folders(Shared::data).back(), EndsWith("share/seamount/data"));
  EXPECT_THAT(shared_folders(Shared::studio).back(), EndsWith("share/seamount/studio"));
  const Variable page("SEAMOUNT_STUDIO", "/d");
  EXPECT_EQ(shared_folders(Shared::studio).front(), "/d");
  EXPECT_NE(shared_folders(Shared::models).front(), "/d");
}

TEST(Installation, ABuildFindsTheSources) {
  EXPECT_TRUE(program_file().is_absolute());
  EXPECT_EQ(program_file().filename(), "base_tests");
  const std::string folder = find_shared_folder(Shared::recipes);
  EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(folder) / "kauai.json")) << folder;
}

/// A program is no library: nothing is looked for in share/ beside it, nor below the working folder.
TEST(Installation, AProgramHasNoShareBesideIt) {
  for (const std::string& folder : shared_folders(Shared::models)) {
    EXPECT_TRUE(folder.starts_with('/')) << folder;
    EXPECT_NE(folder, (program_file().parent_path() / "share/models").string());
  }
}

}  // namespace
}  // namespace seamount
