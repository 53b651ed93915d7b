#include "brindle/base/printable.h"

#include <string>

#include <gtest/gtest.h>

namespace brindle {
namespace {

TEST(Printable, LeavesNothingThatATerminalObeys) {
  EXPECT_EQ(printable("a b~"), "a b~");
  EXPECT_EQ(printable(std::string_view("\x1b[2J\0\n\xff", 7)), "\\x1b[2J\\x00\\x0a\\xff");
}

TEST(Printable, IsShort) {
  EXPECT_EQ(printable("12345", 5), "12345");
  EXPECT_EQ(printable("123456", 5), "12345...");
  EXPECT_LT(in_quotes(std::string(1000000, '\x01')).size(), 200u);
  EXPECT_EQ(in_quotes("word"), "'word'");
}

}  // namespace
}  // namespace brindle
