#include "brindle/frequency_field.h"

#include <limits>

#include <gtest/gtest.h>

#include "brindle/error.h"

namespace brindle {
namespace {

TEST(FrequencyField, StripesAreCountedAlongTheDiagonal) {
  EXPECT_FLOAT_EQ(frequency_of_stripes(40, 2.5f), 16);
  EXPECT_EQ(frequency_of_spacing(0.4f), 2.5f);
  EXPECT_EQ(constant_frequency_field(3, 2), (FrequencyField{3, 3}));
}

TEST(FrequencyField, RefusesWhatIsNotFiniteAndAboveZero) {
  for (const float bad : {0.0f, -1.0f, std::numeric_limits<float>::infinity(),
                          std::numeric_limits<float>::quiet_NaN()}) {
    EXPECT_THROW(constant_frequency_field(bad, 1), Error);
    EXPECT_THROW(frequency_of_stripes(bad, 1), Error);
    EXPECT_THROW(frequency_of_stripes(1, bad), Error);
    EXPECT_THROW(frequency_of_spacing(bad), Error);
  }
}

}  // namespace
}  // namespace brindle
