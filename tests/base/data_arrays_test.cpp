#include "brindle/data_arrays.h"

#include <cmath>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

#include "brindle/arrays.h"
#include "brindle/base/array_numbers.h"
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
  EXPECT_EQ(blended(velocities(), blends).bytes,
            make_data_array("velocity", 2, std::vector<double>{1.5, 2, 2.25, 3}).bytes);
  EXPECT_THROW(blended(velocities(), std::vector<RowBlend>{{{0, 0, 3}, {1, 0, 0}}}), Error);
}

TEST(DataArrays, BlendsOfAxesDoNotKnowSigns) {
  const std::vector<RowBlend> blends = {{{0, 1, 2}, {0.5, 0.5, 0}}, {{0, 1, 2}, {0.5, 0.3, 0.2}}};
  const auto axes_of = [&](double a, double b) {
    const DataArray fibers =
        make_data_array("fiber", 3,
                        std::vector<float>{1, 2, 2, float(a) * 1, float(a) * 2, float(a) * 2,
                                           float(b) * 2, 0, float(b) * 1});
    return vectors_of(blended(fibers, blends).axes(), "axes");
  };
  const std::vector<Vec3> alike = axes_of(1, 1);
  EXPECT_EQ(alike[0], Vec3(1, 2, 2)) << "of equal axes it is that axis";
  for (const auto& [a, b] : {std::pair(-1, 1), std::pair(1, -1), std::pair(-1, -1)}) {
    EXPECT_EQ(axes_of(a, b), alike);
  }
  EXPECT_LT((alike[1] - Vec3(1.2f, 1.6f, 1.8f)).norm(), 1e-6f) << "the mean on one side";
}

TEST(DataArrays, NumbersOfOppositeVectorsCancelAndTheirAxesDoNot) {
  const DataArray wind = make_data_array("wind", 2, std::vector<double>{3, 4, -3, -4});
  const DataArray middle = blended(wind, std::vector<RowBlend>{{{0, 1, 1}, {0.5, 0.5, 0}}});
  EXPECT_EQ(doubles_of(middle.view()), (std::vector<double>{0, 0}));
  EXPECT_EQ(doubles_of(middle.axes()), (std::vector<double>{3, 4}));
  // What is copied keeps both.
  EXPECT_EQ(rows_of(middle, std::vector<Index>{0, 0}).axis_bytes.size(), 4 * sizeof(double));
}

TEST(DataArrays, MetricsAreOfVectorLengthsAndCountNan) {
  const ArrayMetrics vectors = measure_array(velocities());
  EXPECT_EQ(vectors.minimum, 0);
  EXPECT_EQ(vectors.maximum, 5);
  EXPECT_EQ(vectors.rows_nan, 1u);
  const ArrayMetrics numbers = measure_array(make_data_array("p", 1, std::vector<float>{-3, 2}));
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
