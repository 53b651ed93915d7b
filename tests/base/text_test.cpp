#include "brindle/base/text.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace brindle {
namespace {

TEST(Printable, LeavesNothingThatATerminalObeys) {
  EXPECT_EQ(printable("a b~"), "a b~");
  EXPECT_EQ(printable(std::string_view("\x1b[2J\0\n\xff", 7)), "\\x1b[2J\\x00\\x0a\\xff");
}

TEST(Printable, NamesOfFilesKeepTheirLettersAndLoseWhatATerminalObeys) {
  EXPECT_EQ(shown("Geh\u00e4use 2 \u6a21\u578b.ply"), "Geh\u00e4use 2 \u6a21\u578b.ply");
  EXPECT_EQ(shown("caf\xe9.ply"), "caf\\xe9.ply") << "Latin-1";
  EXPECT_EQ(shown("a\x1b[2J\n.ply"), "a\\x1b[2J\\x0a.ply");
  EXPECT_EQ(shown("a\u202egpj.exe"), "a\\xe2\\x80\\xaegpj.exe") << "would be read backwards";
  EXPECT_EQ(shown("\xc0\x80\xed\xa0\x80\xf5"), "\\xc0\\x80\\xed\\xa0\\x80\\xf5");
  EXPECT_EQ(shown("\xe2\x82"), "\\xe2\\x82") << "cut off";
  EXPECT_EQ(shown(shown("\xe9\n")), shown("\xe9\n"));
  EXPECT_EQ(shown_lines("a\tb\nc\x1b"), "a\tb\nc\\x1b");
  EXPECT_EQ(utf8_text("\xe9\n\u00e9"), "\\xe9\n\u00e9");
}

TEST(Printable, IsShort) {
  EXPECT_EQ(printable("12345", 5), "12345");
  EXPECT_EQ(printable("123456", 5), "12345...");
  EXPECT_LT(in_quotes(std::string(1000000, '\x01')).size(), 200u);
  EXPECT_EQ(in_quotes("word"), "'word'");
}

const std::vector<std::string> kNames = {"torus", "sphere", "mobius", "trefoil", "x"};

TEST(Suggestion, FindsTheNameThatWasMistyped) {
  EXPECT_EQ(nearest("torsu", kNames), "torus");
  EXPECT_EQ(nearest("tors", kNames), "torus");
  EXPECT_EQ(nearest("Torus", kNames), "torus");
  EXPECT_EQ(nearest("shpere", kNames), "sphere");
  EXPECT_EQ(nearest("trefoill", kNames), "trefoil");
  EXPECT_EQ(nearest("torus", kNames), "torus");
}

TEST(Suggestion, SaysNothingWhereNothingIsNear) {
  EXPECT_EQ(nearest("teapot", kNames), "");
  EXPECT_EQ(nearest("", kNames), "");
  EXPECT_EQ(nearest("y", kNames), "");
  EXPECT_EQ(nearest(std::string(100000, 't'), kNames), "");
  EXPECT_EQ(nearest("torus", {}), "");
}

TEST(Suggestion, TakesTheNearestAndOfEquallyNearTheFirst) {
  const std::vector<std::string> names = {"stripes", "stripes-v", "strips"};
  EXPECT_EQ(nearest("stripes-w", names), "stripes-v");
  EXPECT_EQ(nearest("stripe", names), "stripes");
}

}  // namespace
}  // namespace brindle
