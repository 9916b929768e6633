#include "seamount/base/printable.h"

#include <gtest/gtest.h>

namespace seamount {
namespace {

TEST(Printable, LeavesOrdinaryTextAsItIs) {
  for (const char* text :
       {"", "height.tif: no such file", "récif/île.json", "珊瑚礁 🏝 \\ \"'", "\xF4\x8F\xBF\xBF"})
    EXPECT_EQ(printable(text), text);
}

TEST(Printable, ShowsWhatATerminalWouldActUpon) {
  EXPECT_EQ(printable("a\x1b[31mred\x1b]0;title\x07"), "a\\x1b[31mred\\x1b]0;title\\x07");
  EXPECT_EQ(printable(std::string_view("a\0b", 3)), "a\\x00b");
  EXPECT_EQ(printable("a\r\nb\tc\x7f"), "a\\x0d\\nb\\x09c\\x7f");
  EXPECT_EQ(printable("\xC2\x9B"
                      "31m"),
            "\\x9b31m");  // the control sequence introducer as one character
  EXPECT_EQ(printable("gpj\xE2\x80\xAE.exe"), "gpj\\u202e.exe");
}

TEST(Printable, ShowsBytesThatAreNoUtf8) {
  EXPECT_EQ(printable("\xff.json"), "\\xff.json");
  EXPECT_EQ(printable("\xC3"), "\\xc3");           // cut short
  EXPECT_EQ(printable("\xC3("), "\\xc3(");         // not continued
  EXPECT_EQ(printable("\xC0\x9B"), "\\xc0\\x9b");  // a longer form of the escape character
  EXPECT_EQ(printable("\xE0\x80\x9B"), "\\xe0\\x80\\x9b");
  EXPECT_EQ(printable("\xED\xA0\x80"), "\\xed\\xa0\\x80");  // half of a surrogate pair
  EXPECT_EQ(printable("\xF4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");
}

}  // namespace
}  // namespace seamount
