#include "seamount/io/staged_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <atomic>

#include "seamount/io/folder_lock.h"
#include "seamount/io/test_files.h"

namespace seamount::io {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::string text_of(const std::string& path) {
  const std::vector<uint8_t> bytes = read_file(path);
  return {bytes.begin(), bytes.end()};
}

/// A stage in `out` with files of these names, each of which holds its name.
void commit_files(const std::string& out, const std::vector<std::string>& names) {
  StagedFolder stage(out);
  for (const std::string& name : names) write_text(stage.path(name), name);
  stage.commit();
}

TEST(StagedFolder, ShowsNothingBeforeTheCommitAndAllOfItAfter) {
  const TestFolder folder;
  const std::string out = folder("a/out");
  StagedFolder stage(out);
  write_text(stage.path("height.r16"), "height");
  write_text(stage.path("height.r16") + ".json", "side-car");
  write_text(stage.path("maps/deep/map.png"), "map");
  EXPECT_FALSE(fs::exists(out + "/height.r16"));
  stage.commit();
  EXPECT_EQ(text_of(out + "/height.r16"), "height");
  EXPECT_EQ(text_of(out + "/height.r16.json"), "side-car");
  EXPECT_EQ(text_of(out + "/maps/deep/map.png"), "map");
}

TEST(StagedFolder, LeavesNothingElseBehind) {
  const TestFolder folder;
  commit_files(folder("out"), {"x", "y"});
  commit_files(folder("out"), {"x"});
  EXPECT_EQ(std::distance(fs::directory_iterator(folder("out")), fs::directory_iterator()), 2);
}

TEST(StagedFolder, WithoutACommitNothingChanges) {
  const TestFolder folder;
  commit_files(folder("there"), {"x"});
  for (const char* out : {"there", "new/deep/out"}) {
    const StagedFolder stage(folder(out));
    write_text(stage.path("x"), "new");
    write_text(stage.path("sub/y"), "new");
  }
  EXPECT_EQ(text_of(folder("there/x")), "x");
  EXPECT_FALSE(fs::exists(folder("there/sub")));
  EXPECT_FALSE(fs::exists(folder("new")));
  EXPECT_EQ(folder.files(), 1U);
}

TEST(StagedFolder, TheStageIsPrivate) {
  const TestFolder folder;
  const StagedFolder stage(folder("out"));
  const fs::path place = fs::path(stage.path("x")).parent_path();
  EXPECT_EQ(fs::status(place).permissions(), fs::perms(0700));
}

TEST(StagedFolder, MessagesShowTheFinalNames) {
  const TestFolder folder;
  const StagedFolder stage(folder("out"));
  EXPECT_EQ(stage.shown("'" + stage.path("a/b.png") + "' and " + stage.path("c") + ": no"),
            "'" + folder("out/a/b.png") + "' and " + folder("out/c") + ": no");
  EXPECT_EQ(stage.final_path("a/b.png"), folder("out/a/b.png"));
}

TEST(StagedFolder, RefusesNamesThatLeaveIt) {
  const TestFolder folder;
  const StagedFolder stage(folder("out"));
  for (const char* name : {"", ".", "..", "../x", "a/../../x", "/x", "a/"})
    EXPECT_THROW((void)stage.path(name), WriteError) << name;
  EXPECT_EQ(stage.path("a/../x"), stage.path("x"));
}

TEST(StagedFolder, KeepsModesAndLeavesReadOnlyFilesAlone) {
  const TestFolder folder;
  const std::string out = folder("out");
  commit_files(out, {"a", "b"});
  fs::permissions(out + "/a", fs::perms(0600));
  commit_files(out, {"a", "b"});
  EXPECT_EQ(fs::status(out + "/a").permissions(), fs::perms(0600));
  fs::permissions(out + "/b", fs::perms(0444));
  StagedFolder stage(out);
  write_text(stage.path("a"), "new");
  write_text(stage.path("b"), "new");
  EXPECT_EQ(error_of([&] { stage.commit(); }), out + "/b: is read-only; make it writable, or choose another name");
  EXPECT_EQ(text_of(out + "/a"), "a");
}

TEST(StagedFolder, NoLinkLeadsOut) {
  const TestFolder folder;
  const std::string out = folder("out");
  write_text(folder("elsewhere/x"), "kept");
  commit_files(out, {"inside/x"});
  fs::create_symlink(folder("elsewhere"), out + "/way");
  fs::create_symlink(folder("elsewhere/x"), out + "/x");
  fs::create_symlink("inside", out + "/alias");
  fs::create_symlink("loop", out + "/loop");
  const auto refusal = [&](const std::string& name) { return error_of([&] { commit_files(out, {name}); }); };
  EXPECT_EQ(refusal("way/x"), out + "/way/x: a link leads out of the output folder");
  EXPECT_EQ(refusal("way/new/x"), out + "/way/new/x: a link leads out of the output folder");
  EXPECT_THAT(refusal("x"), HasSubstr("/x: is a link"));
  EXPECT_THAT(refusal("loop/x"), HasSubstr("/loop/x: cannot be written"));
  EXPECT_EQ(refusal("alias/y"), "");
  EXPECT_EQ(text_of(out + "/inside/y"), "alias/y");
  EXPECT_EQ(text_of(folder("elsewhere/x")), "kept");
}

TEST(StagedFolder, AFolderOrADeviceInTheWayIsFoundBeforeAnythingMoves) {
  const TestFolder folder;
  const std::string out = folder("out");
  commit_files(out, {"a", "b/c"});
  EXPECT_EQ(error_of([&] { commit_files(out, {"a2", "b"}); }), out + "/b: is a folder, not a file name");
  EXPECT_EQ(error_of([&] {
              commit_files(out, {"a/d", "a2"});
            }),
            out + "/a/d: its folder cannot be made: Not a directory");
  ::mkfifo((out + "/pipe").c_str(), 0600);
  EXPECT_EQ(error_of([&] { commit_files(out, {"a2", "pipe"}); }), out + "/pipe: is not a regular file");
  EXPECT_FALSE(fs::exists(out + "/a2"));
  EXPECT_EQ(error_of([&] { StagedFolder(out + "/a"); }), out + "/a: cannot be made: Not a directory");
  EXPECT_EQ(error_of([&] { StagedFolder("/proc/x"); }), "/proc/x: cannot be made: No such file or directory");
}

TEST(StagedFolder, CancellingBeforeTheFirstRenameLeavesAllAsItWas) {
  const TestFolder folder;
  commit_files(folder("out"), {"x"});
  const std::atomic<bool> cancelled{true};
  RunContext run;
  run.cancelled = &cancelled;
  {
    StagedFolder stage(folder("out"));
    write_text(stage.path("x"), "new");
    EXPECT_THROW(stage.commit(run), Cancelled);
  }
  EXPECT_EQ(text_of(folder("out/x")), "x");
}

TEST(StagedFolder, WaitsForAnotherCommit) {
  const TestFolder folder;
  StagedFolder stage(folder("out"));
  write_text(stage.path("x"), "x");
  const FolderLock other(folder("out"));
  std::atomic<bool> cancelled{true};
  RunContext run;
  run.cancelled = &cancelled;
  EXPECT_THROW(stage.commit(run), Cancelled);  // out of the wait
}

TEST(StagedFolder, TheNextRunRemovesWhatAKilledOneLeftAndNothingOfALivingOne) {
  const TestFolder folder;
  const std::string out = folder("out");
  const StagedFolder living(out);
  write_text(living.path("x"), "x");
  const pid_t child = ::fork();
  if (child == 0) {
    const StagedFolder killed(out);
    write_text(killed.path("x"), "half");
    ::raise(SIGKILL);
  }
  ::waitpid(child, nullptr, 0);
  const auto entries = [&] { return std::distance(fs::directory_iterator(out), fs::directory_iterator()); };
  EXPECT_EQ(entries(), 2);
  const StagedFolder next(out);
  EXPECT_EQ(entries(), 2);
  EXPECT_EQ(text_of(living.path("x")), "x");
}

}  // namespace
}  // namespace seamount::io
