#include "seamount/io/folder_lock.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>

#include "seamount/io/test_files.h"

namespace seamount::io {
namespace {

using std::chrono::milliseconds;
using ::testing::HasSubstr;

TEST(FolderLock, IsForOneAtATime) {
  const TestFolder folder;
  write_text(folder("x.png"), "whole");
  {
    const FolderLock lock(folder(""));
    EXPECT_THAT(error_of([&] { FolderLock(folder("")); }), HasSubstr("another run is writing to it"));
    EXPECT_THAT(error_of([&] { FolderLock(folder(""), milliseconds(30)); }), HasSubstr("another run"));
  }
  EXPECT_NO_THROW(FolderLock(folder("")));
  EXPECT_NO_THROW(FolderLock(folder("new/folder")));
  EXPECT_THROW(FolderLock(folder("x.png")), WriteError);
}

TEST(FolderLock, AWaitCanBeCancelled) {
  const TestFolder folder;
  const FolderLock lock(folder(""));
  const std::atomic<bool> cancelled{true};
  RunContext run;
  run.cancelled = &cancelled;
  EXPECT_THROW(FolderLock(folder(""), std::chrono::hours(1), run), Cancelled);
}

TEST(FolderLock, RemovesWhatKilledRunsLeft) {
  const TestFolder folder;
  write_text(folder(".seamount-0123456789abcdef0123456789abcdef/x.png"), "half");
  write_text(folder(".seamount-notes/x.txt"), "a person's");
  { const FolderLock lock(folder("")); }
  EXPECT_FALSE(std::filesystem::exists(folder(".seamount-0123456789abcdef0123456789abcdef")));
  EXPECT_TRUE(std::filesystem::exists(folder(".seamount-notes/x.txt")));
}

}  // namespace
}  // namespace seamount::io
