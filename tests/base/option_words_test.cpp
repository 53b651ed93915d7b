#include <gtest/gtest.h>

#include "brindle/base/text.h"

namespace brindle {
namespace {

TEST(OptionWords, OptionsGetTheirOtherNamesWhereverTheyBeginAWord) {
  const auto shouted = [](const std::string& text) {
    return with_option_names(text, [](const std::string& name) { return "<" + name + ">"; });
  };
  EXPECT_EQ(shouted("lower --stripes; or --field-smoothing 1"),
            "lower <stripes>; or <field-smoothing> 1");
  EXPECT_EQ(shouted("--up: says"), "<up>: says");
  for (const char* text : {"a--b.obj", "-- and --", "--1", "'--quoted'", ""}) {
    EXPECT_EQ(shouted(text), text);
  }
}

}  // namespace
}  // namespace brindle
