#include "seamount/server/journal.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "seamount/io/atomic_file.h"

namespace seamount::server {
namespace {

namespace fs = std::filesystem;

class JournalTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = (fs::temp_directory_path() / ("seamount_journal_" + std::to_string(::getpid()))).string();
    TearDown();
  }
  void TearDown() override {
    fs::remove_all(folder_);
    fs::remove_all(folder_ + "2");
  }

  static recipe::Document example() {
    return {R"({"seamount": 1, "steps": [{"id": "a", "op": "terrain.noise"}]})", "x.json", ""};
  }
  /// As another studio would find it, once this one is gone.
  std::optional<Remembered> read() const {
    fs::remove_all(folder_ + "2");
    if (fs::exists(folder_)) fs::copy(folder_, folder_ + "2");
    return Journal(folder_ + "2", "/x.json").read("", recipe::standard_registry());
  }
  std::string folder_;
};

bool same(const recipe::Document& a, const recipe::Document& b) {
  if (a.json() != b.json() || a.done() != b.done() || a.history().size() != b.history().size()) return false;
  for (size_t i = 0; i < a.history().size(); ++i) {
    if (a.history()[i].label != b.history()[i].label || a.history()[i].author != b.history()[i].author) return false;
  }
  return true;
}

/// Edits, undo and redo, in the document and in the journal; the document after each line.
std::vector<recipe::Document> session(Journal& journal, recipe::Document document) {
  std::vector<recipe::Document> states = {document};
  const auto edit = [&](const recipe::Edit& what, const std::string& gesture, const std::string& label) {
    document.apply({what}, gesture, label, "w");
    journal.edit({what}, gesture, label, "w");
    states.push_back(document);
  };
  edit(recipe::set_parameter("a", "octaves", 3), "", "octaves");
  edit(recipe::set_parameter("a", "octaves", 4), "drag", "octaves 4");
  edit(recipe::set_parameter("a", "octaves", 5), "drag", "octaves 5");
  edit(recipe::add_step({{"id", "b"}, {"op", "terrain.smooth"}}), "", "step b");
  document.undo();
  journal.undo();
  states.push_back(document);
  document.redo();
  journal.redo();
  states.push_back(document);
  edit(recipe::RenameStep{"a", "base"}, "", "renamed \"a\"\n");
  return states;
}

TEST_F(JournalTest, GivesTheSessionBack) {
  Journal journal(folder_, "/x.json");
  EXPECT_FALSE(read());
  journal.begin(example(), "as saved");
  const auto states = session(journal, example());
  const auto remembered = read();
  ASSERT_TRUE(remembered);
  EXPECT_EQ(remembered->saved_text, "as saved");
  EXPECT_TRUE(same(remembered->document, states.back()));
  recipe::Document document = remembered->document;
  while (document.undo()) {
  }
  EXPECT_EQ(document.json(), example().json());
  journal.begin(remembered->document, "again");  // a snapshot has the history too
  EXPECT_EQ(journal.length(), 0);
  EXPECT_TRUE(same(read()->document, states.back()));
}

TEST_F(JournalTest, LosesNothingThatWasAcknowledgedWhereverItIsCutOff) {
  std::vector<recipe::Document> states;
  std::vector<uintmax_t> sizes;
  {
    Journal journal(folder_, "/x.json");
    journal.begin(example(), "");
    sizes.push_back(fs::file_size(journal.path()));
    states = session(journal, example());
  }
  const std::string path = Journal(folder_, "/x.json").path();
  const std::vector<uint8_t> whole = io::read_file(path);
  for (size_t cut = sizes[0]; cut <= whole.size(); ++cut) {
    std::ofstream(path, std::ios::binary | std::ios::trunc)
        .write(reinterpret_cast<const char*>(whole.data()), static_cast<std::streamsize>(cut));
    const auto lines =
        static_cast<size_t>(std::count(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(cut), '\n'));
    const auto remembered = read();
    ASSERT_TRUE(remembered) << cut;
    ASSERT_TRUE(same(remembered->document, states[lines - 1])) << cut;
  }
  std::ofstream(path, std::ios::binary | std::ios::trunc)
      .write(reinterpret_cast<const char*>(whole.data()), static_cast<std::streamsize>(sizes[0] / 2));
  EXPECT_FALSE(read());
}

TEST_F(JournalTest, StopsAtALineThatWasChanged) {
  Journal journal(folder_, "/x.json");
  journal.begin(example(), "");
  const auto states = session(journal, example());
  std::vector<uint8_t> bytes = io::read_file(journal.path());
  const auto last = std::find(bytes.rbegin() + 1, bytes.rend(), '\n') - bytes.rbegin();
  bytes[bytes.size() - static_cast<size_t>(last) / 2] ^= 1;
  io::write_bytes(journal.path(), bytes);
  EXPECT_TRUE(same(read()->document, states[states.size() - 2]));
}

TEST_F(JournalTest, IsPutAside) {
  Journal journal(folder_, "/x.json");
  EXPECT_EQ(journal.put_aside(), "");
  journal.begin(example(), "");
  const std::string aside = journal.put_aside();
  EXPECT_TRUE(fs::exists(aside));
  EXPECT_FALSE(read());
  journal.begin(example(), "");
  EXPECT_NE(journal.put_aside(), aside);
}

TEST_F(JournalTest, BelongsToOneStudio) {
  {
    const Journal journal(folder_, "/x.json");
    EXPECT_THROW(Journal(folder_, "/x.json"), IoError);
    const Journal other(folder_, "/y.json");
  }
  const Journal again(folder_, "/x.json");
}

TEST_F(JournalTest, UnsavedDocumentsHaveOneEach) {
  EXPECT_EQ(Journal::newest_unsaved(folder_), nullptr);
  std::string newest;
  for (int i = 0; i < 25; ++i) {
    const auto journal = Journal::of_unsaved(folder_);
    journal->begin(example(), "");
    newest = journal->path();
  }
  const auto first = Journal::newest_unsaved(folder_);
  EXPECT_EQ(first->path(), newest);
  EXPECT_TRUE(first->read("", recipe::standard_registry()));
  EXPECT_NE(Journal::newest_unsaved(folder_)->path(), newest);  // another studio has that
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 20 + 1);
}

}  // namespace
}  // namespace seamount::server
