#include "brindle/base/text.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace brindle {
namespace {

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
