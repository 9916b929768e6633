#include "seamount/io/atomic_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "seamount/io/test_files.h"

namespace seamount::io {
namespace {

using ::testing::HasSubstr;

std::string text_of(const std::string& path) {
  const std::vector<uint8_t> bytes = read_file(path);
  return {bytes.begin(), bytes.end()};
}

TEST(AtomicFile, MakesFoldersAndReplaces) {
  const TestFolder folder;
  const std::string path = folder("a/b/c.txt");
  write_text(path, "one");
  write_text(path, "two");
  EXPECT_EQ(text_of(path), "two");
  EXPECT_EQ(folder.files(), 1U);
}

TEST(AtomicFile, KeepsTheEarlierFileWhenWritingFails) {
  const TestFolder folder;
  const std::string path = folder("kept.txt");
  write_text(path, "earlier");
  const auto failing = [&](const std::string& temporary) {
    FileWriter(temporary, path).close();
    throw IoError(path, "half way");
  };
  EXPECT_THROW(write_atomically(path, failing), IoError);
  EXPECT_EQ(text_of(path), "earlier");
  EXPECT_EQ(folder.files(), 1U);
}

TEST(AtomicFile, RemovesWhatALibraryLeftBesideTheTemporary) {
  const TestFolder folder;
  EXPECT_THROW(write_atomically(folder("x.gpkg"),
                                [](const std::string& temporary) {
                                  FileWriter(temporary, "x").close();
                                  FileWriter(temporary + "-journal", "x").close();
                                  throw IoError("x", "no");
                                }),
               IoError);
  EXPECT_EQ(folder.files(), 0U);
}

TEST(AtomicFile, RefusesFoldersDevicesAndFilesAsFolders) {
  const TestFolder folder;
  write_text(folder("file"), "x");
  EXPECT_THAT(error_of([&] { write_text(folder(""), "x"); }), HasSubstr("is a folder"));
  EXPECT_THAT(error_of([&] { write_text(folder("file/below.txt"), "x"); }), HasSubstr("folder cannot be made"));
  EXPECT_THAT(error_of([&] { write_text("/dev/full", "x"); }), HasSubstr("not a regular file"));
  EXPECT_THAT(error_of([&] { write_text("", "x"); }), HasSubstr("name is needed"));
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST(AtomicFile, DoesNotWriteThroughLinks) {
  const TestFolder folder;
  write_text(folder("real.txt"), "old");
  std::filesystem::create_symlink(folder("real.txt"), folder("link.txt"));
  std::filesystem::create_symlink(folder("loop.txt"), folder("loop.txt"));
  EXPECT_THAT(error_of([&] { write_text(folder("link.txt"), "new"); }), HasSubstr("link.txt: is a link"));
  EXPECT_THAT(error_of([&] { write_text(folder("loop.txt"), "new"); }), HasSubstr("is a link"));
  EXPECT_EQ(text_of(folder("real.txt")), "old");
}

TEST(AtomicFile, KeepsTheModeOfWhatItReplacesAndLeavesReadOnlyFilesAlone) {
  namespace fs = std::filesystem;
  const TestFolder folder;
  write_text(folder("mine.txt"), "old");
  fs::permissions(folder("mine.txt"), fs::perms(0600));
  write_text(folder("mine.txt"), "new");
  EXPECT_EQ(fs::status(folder("mine.txt")).permissions(), fs::perms(0600));
  fs::permissions(folder("mine.txt"), fs::perms(0444));
  EXPECT_THAT(error_of([&] { write_text(folder("mine.txt"), "newer"); }), HasSubstr("mine.txt: is read-only"));
  EXPECT_EQ(text_of(folder("mine.txt")), "new");
  EXPECT_EQ(folder.files(), 1U);
}

TEST(AtomicFile, AFailureToWriteIsNoFaultOfAnInput) {
  EXPECT_THROW(write_text("/dev/full", "x"), WriteError);
  EXPECT_THROW(write_text("/proc/x/y", "x"), WriteError);
}

TEST(AtomicFile, FullDiskIsOneClearErrorAndLeavesNothing) {
  const TestFolder folder;
  write_text(folder("data.bin"), "earlier");
  std::string message;
  {
    const FileSizeLimit limit(10000);
    message = error_of([&] { write_bytes(folder("data.bin"), std::vector<uint8_t>(100000, 7)); });
  }
  EXPECT_THAT(message, HasSubstr("data.bin: cannot be written: "));
  EXPECT_EQ(text_of(folder("data.bin")), "earlier");
  EXPECT_EQ(folder.files(), 1U);
}

TEST(ReadFile, SaysWhatIsWrong) {
  const TestFolder folder;
  write_text(folder("x"), "12345");
  EXPECT_THAT(error_of([&] { read_file(folder("missing")); }), HasSubstr("no such file"));
  EXPECT_THAT(error_of([&] { read_file(folder("")); }), HasSubstr("is a folder"));
  EXPECT_THAT(error_of([&] { read_file(folder("x"), 4); }), HasSubstr("at most 4"));
  EXPECT_EQ(read_file(folder("x"), 5).size(), 5U);
}

TEST(ExtensionOf, IsLowerCase) {
  EXPECT_EQ(extension_of("/a.b/C.TIF"), ".tif");
  EXPECT_EQ(extension_of("/a.b/c"), "");
}

}  // namespace
}  // namespace seamount::io
