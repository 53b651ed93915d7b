#include "brindle/data_arrays.h"

#include <cmath>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "test_numbers.h"

namespace brindle {
namespace {

using testing_support::kNaN;

DataArray labels() { return make_data_array("label", 1, std::vector<std::int64_t>{7, 8, 9}); }
DataArray velocities() {
  return make_data_array("velocity", 2, std::vector<double>{0, 0, 3, 4, 6, kNaN});
}

TEST(DataArrays, KeepTypeAndNumbers) {
  const std::vector<std::int64_t> large = {std::numeric_limits<std::int64_t>::max(), -1};
  const DataArray array = make_data_array("id", 1, large);
  EXPECT_EQ(array.type, NumberType::int64);
  ASSERT_EQ(array.rows(), 2u);
  EXPECT_EQ(std::memcmp(array.bytes.data(), large.data(), 16), 0);
  EXPECT_THROW(make_data_array("v", 3, std::vector<float>(4)), Error);
  EXPECT_EQ(make_data_array("none", 3, std::vector<float>()).rows(), 0u);
}

TEST(DataArrays, RowsOfRepeatAndRefuse) {
  const std::vector<Index> rows = {2, 0, 2};
  EXPECT_EQ(rows_of(labels(), rows),
            make_data_array("label", 1, std::vector<std::int64_t>{9, 7, 9}));
  EXPECT_THROW(rows_of(labels(), std::vector<Index>{3}), Error);
}

TEST(DataArrays, BlendsAreMeansOfNumbersAndTheHeaviestOfLabels) {
  const std::vector<RowBlend> blends = {{{0, 1, 2}, {0.5, 0.5, 0}}, {{0, 1, 2}, {0.25, 0.75, 0}}};
  EXPECT_EQ(blended(labels(), blends),
            make_data_array("label", 1, std::vector<std::int64_t>{7, 8}));
  // Row 2, which has a NaN, has no weight.
  EXPECT_EQ(blended(velocities(), blends),
            make_data_array("velocity", 2, std::vector<double>{1.5, 2, 2.25, 3}));
  EXPECT_THROW(blended(velocities(), std::vector<RowBlend>{{{0, 0, 3}, {1, 0, 0}}}), Error);
}

TEST(DataArrays, FiguresAreOfVectorLengthsAndCountNan) {
  const ArrayFigures vectors = measure_array(velocities());
  EXPECT_EQ(vectors.minimum, 0);
  EXPECT_EQ(vectors.maximum, 5);
  EXPECT_EQ(vectors.rows_nan, 1u);
  const ArrayFigures numbers = measure_array(make_data_array("p", 1, std::vector<float>{-3, 2}));
  EXPECT_EQ(numbers.minimum, -3);
  EXPECT_EQ(numbers.maximum, 2);
  EXPECT_EQ(measure_array(make_data_array("n", 1, std::vector<double>{kNaN})).maximum, 0);
}

TEST(DataArrays, AreFoundByName) {
  const std::vector<DataArray> arrays = {labels(), velocities()};
  EXPECT_EQ(find_array(arrays, "velocity"), &arrays[1]);
  EXPECT_EQ(find_array(arrays, "speed"), nullptr);
}

}  // namespace
}  // namespace brindle
