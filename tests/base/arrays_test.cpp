#include "brindle/arrays.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <string>

#include <gtest/gtest.h>

#include "brindle/error.h"

namespace brindle {
namespace {

template <class Number>
struct Arrays : testing::Test {};
using Numbers = testing::Types<float, double, std::int8_t, std::uint8_t, std::int16_t,
                               std::uint16_t, int, unsigned, long, unsigned long, long long>;
TYPED_TEST_SUITE(Arrays, Numbers);

TYPED_TEST(Arrays, AreReadWhateverTheirType) {
  const std::vector<TypeParam> numbers = {1, 2, 3, 4, 5, 6};
  const std::vector<Vec3> expected = {{1, 2, 3}, {4, 5, 6}};
  EXPECT_EQ(vectors_of({numbers, 3}, "points"), expected);
  EXPECT_EQ(numbers_of({numbers, 1}, "values"), (std::vector<float>{1, 2, 3, 4, 5, 6}));
}

TYPED_TEST(Arrays, MayHaveAnyStrides) {
  const std::array<TypeParam, 6> columns = {1, 4, 2, 5, 3, 6};  // column after column
  constexpr auto kSize = static_cast<std::ptrdiff_t>(sizeof(TypeParam));
  const std::vector<Vec3> expected = {{1, 2, 3}, {4, 5, 6}};
  EXPECT_EQ(vectors_of(ArrayView(columns.data(), 2, 3, kSize, 2 * kSize), "points"), expected);
  const std::vector<Vec3> backwards = {{4, 5, 6}, {1, 2, 3}};
  EXPECT_EQ(vectors_of(ArrayView(columns.data() + 1, 2, 3, -kSize, 2 * kSize), "points"),
            backwards);
}

TEST(ArrayView, ReadsNumbersAtAnyAddress) {
  std::array<unsigned char, 13> bytes{};
  const std::array<float, 3> numbers = {0.5f, -2, 7};
  std::memcpy(bytes.data() + 1, numbers.data(), sizeof numbers);
  const ArrayView view(bytes.data() + 1, NumberType::float32, 1, 3, 12, 4);
  EXPECT_EQ(vectors_of(view, "points"), (std::vector<Vec3>{{0.5f, -2, 7}}));
}

TEST(ArrayView, OfNothingHasNoRows) {
  EXPECT_TRUE(vectors_of({}, "points").empty());
  EXPECT_TRUE(vectors_of({std::vector<int>(), 3}, "points").empty());
}

TEST(ArrayView, RefusesWhatDoesNotFillItsRows) {
  EXPECT_THROW(ArrayView(std::vector<int>(7), 3), Error);
  EXPECT_THROW(ArrayView(std::vector<int>(7), 0), Error);
}

TEST(ArrayView, NamesTheArrayWithTheWrongNumberOfColumns) {
  const std::vector<double> numbers(8);
  try {
    vectors_of({numbers, 2}, "directions");
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("directions: an array of 4 x 2"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace brindle
