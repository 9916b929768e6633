#include "seamount/io/find_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>

#include "seamount/io/test_files.h"

namespace seamount::io {
namespace {

using ::testing::HasSubstr;

/// SEAMOUNT_MODELS, as it was before when this is gone.
class ModelsVariable {
 public:
  explicit ModelsVariable(const std::string& value) {
    if (const char* before = std::getenv("SEAMOUNT_MODELS")) before_ = before;
    setenv("SEAMOUNT_MODELS", value.c_str(), 1);
  }
  ~ModelsVariable() {
    if (before_) {
      setenv("SEAMOUNT_MODELS", before_->c_str(), 1);
    } else {
      unsetenv("SEAMOUNT_MODELS");
    }
  }
  ModelsVariable(const ModelsVariable&) = delete;
  ModelsVariable& operator=(const ModelsVariable&) = delete;

 private:
  std::optional<std::string> before_;
};

TEST(FindModel, TakesTheFirstFolderThatHasIt) {
  const TestFolder first, second;
  write_text(second("a.safetensors"), "2");
  write_text(second("b.safetensors"), "2");
  write_text(first("b.safetensors"), "1");
  const ModelsVariable models(first("") + ":" + second(""));
  EXPECT_EQ(find_model("a"), second("a.safetensors"));
  EXPECT_EQ(find_model("b"), first("b.safetensors"));
}

TEST(FindModel, TakesAPathAsItIs) {
  const TestFolder folder;
  write_text(folder("mine.bin"), "");
  EXPECT_EQ(find_model(folder("mine.bin")), folder("mine.bin"));
  EXPECT_EQ(error_of([&] { find_model(folder("none")); }), folder("none") + ": is no file");
  EXPECT_EQ(error_of([] { find_model("none.safetensors"); }), "none.safetensors: is no file");
}

TEST(FindModel, SaysWhereItLooked) {
  const TestFolder folder;
  const ModelsVariable models(folder("x"));
  const std::string message = error_of([] { find_model("no_such\x1b"); });
  EXPECT_THAT(message, HasSubstr("no_such\\x1b: is no model: there is no no_such\\x1b.safetensors in "));
  EXPECT_THAT(message, HasSubstr(folder("x")));
  EXPECT_NE(error_of([] { find_model(""); }), "");
}

}  // namespace
}  // namespace seamount::io
