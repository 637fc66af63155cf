#include "generator/base/printable.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "generator/base/error.h"

namespace pomona {
namespace {

TEST(Printable, SpellsOutWhatMovesACursor) {
  EXPECT_EQ(printable("a\x1b[2Jb\r\x7f"), "a\\x1b[2Jb\\x0d\\x7f");
  EXPECT_EQ(printable("\xc2\x9b"
                      "2J"),
            "\\x9b2J")
      << "the same sequence in one character of UTF-8";
  EXPECT_EQ(printable(std::string_view("\0", 1)), "\\x00");
}

TEST(Printable, SpellsOutWhatTurnsOrBreaksALine) {
  EXPECT_EQ(printable("a\xe2\x80\xae.toml\xe2\x81\xa9\xd8\x9c\xe2\x80\xa8"), "a\\u202e.toml\\u2069\\u061c\\u2028");
  EXPECT_EQ(printable("\x9b"
                      "2J\xe6\x9b\xbf"),
            "\\x9b2J\xe6\x9b\xbf")
      << "a byte that belongs to no character; as part of one it stays";
}

TEST(Printable, LeavesWordsLinesAndTabs) {
  const std::string text = "K\xc3\xbcrbis\t\xe6\x9f\xbf\n\xc2\xa0";
  EXPECT_EQ(printable(text), text);
  EXPECT_EQ(printable("\xc2"), "\xc2") << "half a character at the end";
}

TEST(Printable, KeepsALineALine) { EXPECT_EQ(printable_line("a\nb\tc\x1b\\n"), "a\\nb\\tc\\x1b\\n"); }

TEST(Printable, HoldsForAllThatIsTold) {
  const Diagnostic diagnostic{{"x\x1b[2J\n.toml", 1, 2, {}}, "unknown key \"\x07\n\"", "\x9b is\nleft alone"};
  const std::string told = to_string(diagnostic);
  for (const char c : told) EXPECT_TRUE(c == '\n' || static_cast<unsigned char>(c) >= 0x20);
  EXPECT_EQ(std::count(told.begin(), told.end(), '\n'), 1) << "the hint has a line of its own";
}

}  // namespace
}  // namespace pomona
