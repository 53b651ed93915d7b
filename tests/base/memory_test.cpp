#include "brindle/base/memory.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace brindle {
namespace {

TEST(Memory, IsThere) {
  EXPECT_GT(available_memory(), 0);
  EXPECT_GT(count_that_fits(1), count_that_fits(8));
}

TEST(Memory, RefusesWhatItDoesNotHoldAndSaysWhatWouldDo) {
  const AssumedMemory assumed(200e6);
  const auto remedy = [](double most) { return "take " + rounded_down(most); };
  EXPECT_NO_THROW(check_fits(1e6, 100, "this", "points", remedy));
  try {
    check_fits(2.5e6, 100, "this", "points", remedy);
    FAIL() << "was not refused";
  } catch (const TooLarge& error) {
    EXPECT_STREQ(error.what(),
                 "this would be 2.5e+06 points, and memory has room for 1e+06; take 6e+05");
    EXPECT_DOUBLE_EQ(error.share(), 0.24);
  }
}

TEST(Memory, IsNotAskedForAFewBytes) {
  const AssumedMemory none(0);
  EXPECT_NO_THROW(check_fits(1000, 100, "this", "points", [](double) { return ""; }));
  EXPECT_THROW(check_fits(1e6, 100, "this", "points", [](double) { return ""; }), TooLarge);
}

TEST(Memory, RoundsToTheSafeSide) {
  EXPECT_EQ(rounded_up(1), "1");
  EXPECT_EQ(rounded_down(1), "1");
  EXPECT_EQ(rounded_up(0.00123), "0.0013");
  EXPECT_EQ(rounded_down(0.00129), "0.0012");
  EXPECT_EQ(rounded_up(0), "0");
  for (double x = 1e-12; x < 1e12; x *= 1.37) {
    EXPECT_GE(std::stod(rounded_up(x)), x * (1 - 1e-8));
    EXPECT_LE(std::stod(rounded_up(x)), x * 1.1001);
    EXPECT_LE(std::stod(rounded_down(x)), x * (1 + 1e-8));
    EXPECT_GE(std::stod(rounded_down(x)), x * 0.8999);
  }
}

}  // namespace
}  // namespace brindle
