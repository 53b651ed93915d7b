#include "brindle/base/input_file.h"

#include <cmath>
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "brindle/shapes/random.h"

namespace brindle {
namespace {

TEST(ParseNumber, ReadsNumbersOfAnySize) {
  EXPECT_EQ(parse_number("+1.5"), 1.5);
  EXPECT_EQ(parse_number("1e39"), 1e39);
  EXPECT_EQ(parse_number("1e-60"), 1e-60);
  EXPECT_EQ(parse_number("-1e999"), -HUGE_VAL);
  EXPECT_EQ(parse_number("1e-999"), 0.0);
  EXPECT_TRUE(std::isnan(*parse_number("nan")));
  for (const char* word : {"", "+", "1.5x", "x", "1,5", "--1"}) {
    EXPECT_FALSE(parse_number(word)) << word;
  }
}

// Rounding twice would take the wrong neighbour for these.
TEST(ParseNumber, IsTheNearestFloatOnceRounded) {
  EXPECT_EQ(static_cast<float>(*parse_number("1.00000005960464477539062500001")), 1.0000001f);
  EXPECT_EQ(static_cast<float>(*parse_number("1.00000005960464477539062499999")), 1.0f);
  EXPECT_EQ(static_cast<float>(*parse_number("1.000000059604644775390625")), 1.0f);
  EXPECT_EQ(static_cast<float>(*parse_number("-1.00000005960464477539062500001")), -1.0000001f);
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const std::string word = std::to_string(1000 * random_number(1, i)) + std::to_string(i);
    EXPECT_EQ(static_cast<float>(*parse_number(word)), std::strtof(word.c_str(), nullptr)) << word;
  }
}

}  // namespace
}  // namespace brindle
