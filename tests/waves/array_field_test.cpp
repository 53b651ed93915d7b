#include "brindle/array_field.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "parametric_meshes.h"
#include "test_numbers.h"

namespace brindle {
namespace {

using testing_support::kInfinity;
using testing_support::kNaN;

/// Two triangles in the plane of x and y, and a vertex in neither.
Surface square() {
  return make_surface(
      {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {9, 9, 9}}, {{0, 1, 2}, {0, 2, 3}}});
}

DataArray numbers(const std::vector<double>& values, int components = 1) {
  return make_data_array("speed", components, values);
}

template <class Call>
void expect_error(const std::string& message, const Call& call) {
  try {
    call();
    FAIL() << "no error: " << message;
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
  }
}

template <class Number>
DataArray constant(const Surface& surface, const std::vector<Number>& row) {
  std::vector<Number> all;
  for (std::size_t v = 0; v < surface.mesh.vertex_count(); ++v) {
    all.insert(all.end(), row.begin(), row.end());
  }
  return make_data_array("constant", static_cast<int>(row.size()), all);
}

TEST(DirectionFieldOf, AConstantVectorIsThatDirection) {
  const Surface surface = make_surface(make_torus({.resolution = 40}));
  const DirectionField expected = projected_direction_field({0.3f, -2.5f, 4}, surface.normals);
  EXPECT_EQ(direction_field_of(surface, constant<float>(surface, {0.3f, -2.5f, 4})), expected);
  EXPECT_EQ(direction_field_of(surface, constant<double>(surface, {0.3, -2.5, 4})), expected);
  EXPECT_EQ(direction_field_of(surface, constant<std::int8_t>(surface, {3, -2, 4})),
            projected_direction_field({3, -2, 4}, surface.normals));
  EXPECT_EQ(direction_field_of(surface, constant<float>(surface, {0.3f, -2.5f})),
            projected_direction_field({0.3f, -2.5f, 0}, surface.normals));
}

TEST(DirectionFieldOf, RowsWithoutADirectionHaveNoWave) {
  const Surface surface = square();
  for (const double bad : {kNaN, kInfinity, -kInfinity}) {
    const DirectionField field = direction_field_of(
        surface, numbers({1, bad, 0, 0, 0, 0, 0, 0, 5, 0, -3, 0, bad, bad, bad}, 3));
    EXPECT_EQ(field[0], Vec3::Zero()) << "not finite";
    EXPECT_EQ(field[1], Vec3::Zero()) << "zero";
    EXPECT_EQ(field[2], Vec3::Zero()) << "normal to the surface";
    EXPECT_EQ(field[3], Vec3(0, -1, 0));
  }
}

TEST(DirectionFieldOf, VectorsMayHaveAnyLength) {
  const double h = std::sqrt(0.5);
  for (const double length : {1e-310, 1e-200, 1e-30, 1.0, 1e40, 1e300}) {
    const double x = h * length;
    const DirectionField field =
        direction_field_of(square(), numbers({x, x, 0, x, x, 0, x, x, 0, x, x, 0, x, x, 0}, 3));
    EXPECT_LT((field[1] - Vec3(std::sqrt(0.5f), std::sqrt(0.5f), 0)).norm(), 1e-6f) << length;
  }
}

TEST(DirectionFieldOf, OppositeMeansHaveAWaveUnlessTheirSignsCount) {
  DataArray fibers = numbers({1, 1, 0, 1, 1, 0, 1, 1, 0, 1, 1, 0, 1, 1, 0}, 3);
  fibers.axis_bytes = fibers.bytes;
  fibers.bytes = numbers({0, 0, 0, 1, 1, 0, 1, 1, 0, 1, 1, 0, 1, 1, 0}, 3).bytes;
  EXPECT_FALSE(direction_field_of(square(), fibers)[0].isZero(0));
  EXPECT_TRUE(direction_field_of(square(), fibers, true)[0].isZero(0));
}

TEST(DirectionFieldOf, RefusesWhatIsNoVectorPerVertex) {
  expect_error("'speed' has 1 numbers in a row", [] {
    direction_field_of(square(), numbers({1, 2, 3, 4, 5}));
  });
  expect_error("'speed' has 2 rows for 5 vertices", [] {
    direction_field_of(square(), numbers({1, 2, 3, 4, 5, 6}, 3));
  });
}

TEST(NonfiniteRows, AreCountedOnce) {
  EXPECT_EQ(nonfinite_rows(numbers({1, 2, kNaN, kNaN, kInfinity, 1, 0, 0}, 2)), 2u);
  EXPECT_EQ(nonfinite_rows(numbers({1, 2, 3})), 0u);
  EXPECT_EQ(nonfinite_rows(make_data_array("a", 1, std::vector<std::int64_t>{-1, 5})), 0u);
}

TEST(FrequenciesBy, MapTheExtremesToTheEndsOfTheRange) {
  const Surface surface = square();
  const DataArray array = numbers({-3, 5, 1, 3, 100});
  const FrequencyField field = frequencies_by(surface, array, 10, {0.4f, 2.5f});
  EXPECT_EQ(field[0], 10 * 0.4f);
  EXPECT_EQ(field[1], 25);
  EXPECT_FLOAT_EQ(field[2], 10 * 1.45f);
  EXPECT_FLOAT_EQ(field[3], 10 * (0.4f + 0.75f * 2.1f));
  EXPECT_EQ(field[4], 25) << "a vertex without neighbours has no say, and stays in the range";
  const FrequencyField inverse = frequencies_by(surface, array, 10, {0.4f, 2.5f, true});
  EXPECT_EQ(inverse[0], 25);
  EXPECT_EQ(inverse[1], 10 * 0.4f);
  for (std::size_t v = 0; v < 4; ++v) EXPECT_FLOAT_EQ(field[v] + inverse[v], 29);
}

TEST(FrequenciesBy, NumbersMayBeExtremeOrWhole) {
  const FrequencyField field = frequencies_by(square(), numbers({-1e308, 1e308, 0, 0, 0}), 10);
  EXPECT_EQ(field[0], 4);
  EXPECT_EQ(field[1], 25);
  EXPECT_FLOAT_EQ(field[2], 14.5);
  const DataArray bytes = make_data_array("b", 1, std::vector<std::uint8_t>{0, 255, 51, 0, 9});
  EXPECT_FLOAT_EQ(frequencies_by(square(), bytes, 1)[2], 0.4f + 0.2f * 2.1f);
}

TEST(FrequenciesBy, TakesTheLengthsOfVectors) {
  const FrequencyField field =
      frequencies_by(square(), numbers({0, 0, 3, 4, 0, 2.5, 5, 0, 0, 0}, 2), 1);
  EXPECT_EQ(field[0], 0.4f);
  EXPECT_EQ(field[1], 2.5f);
  EXPECT_FLOAT_EQ(field[2], 1.45f);
  EXPECT_EQ(field[3], 2.5f);
}

TEST(FrequenciesBy, ReciprocalIsOneOverTheNumberBetweenItsEnds) {
  FrequencyRange range{0.1f, 0.5f};
  range.reciprocal = true;
  const FrequencyField field = frequencies_by(square(), numbers({4, 1, 100, -3, 0}), 10, range);
  EXPECT_FLOAT_EQ(field[0], 2.5f);
  EXPECT_FLOAT_EQ(field[1], 5);
  EXPECT_FLOAT_EQ(field[2], 1);
  EXPECT_FLOAT_EQ(field[3], 5);
  EXPECT_FLOAT_EQ(field[4], 5);
}

TEST(FrequenciesBy, WhatIsTheSameEverywhereIsInTheMiddle) {
  for (const bool inverse : {false, true}) {
    EXPECT_FLOAT_EQ(
        frequencies_by(square(), numbers({7, 7, 7, 7, 9}), 12, {0.4f, 2.5f, inverse})[1], 12);
    EXPECT_FLOAT_EQ(frequencies_by(square(), numbers({7, 7, 7, 7, 9}), 12, {1, 4, inverse})[1], 24);
  }
}

TEST(FrequenciesBy, LeavesOutWhatIsNotFinite) {
  const FrequencyField field = frequencies_by(square(), numbers({kNaN, 1, kInfinity, 3, 0}), 1);
  EXPECT_TRUE(std::isnan(field[0]));
  EXPECT_EQ(field[1], 0.4f);
  EXPECT_TRUE(std::isnan(field[2]));
  EXPECT_EQ(field[3], 2.5f);
  expect_error("'speed' has no finite number", [] {
    frequencies_by(square(), numbers({kNaN, kNaN, kNaN, kNaN, 3}), 1);
  });
}

TEST(FrequenciesBy, RefusesRangesThatAreNone) {
  for (const FrequencyRange& range :
       {FrequencyRange{0, 1}, {2, 1}, {1, 1}, {-1, 1}, {1, static_cast<float>(kInfinity)}}) {
    EXPECT_THROW(frequencies_by(square(), numbers({1, 2, 3, 4, 5}), 1, range), Error);
  }
  EXPECT_THROW(frequencies_by(square(), numbers({1, 2, 3, 4, 5}), 0), Error);
  EXPECT_THROW(frequencies_by(square(), numbers({1, 2, 3, 4}), 1), Error);
}

TEST(FrequenciesOf, AreTheNumbers) {
  const DirectionField directions = projected_direction_field({1, 0, 0}, square().normals);
  const FrequencyField field = frequencies_of(numbers({1, 2.5, kNaN, 4, -1}), directions);
  EXPECT_EQ(field[0], 1);
  EXPECT_EQ(field[1], 2.5f);
  EXPECT_TRUE(std::isnan(field[2]));
  EXPECT_TRUE(std::isnan(field[4])) << "no wave there, so no frequency is asked for";
  EXPECT_EQ(frequencies_of(numbers({3, 4, 0, 1, 1, 0, 1, 0, 1, 0}, 2), directions)[0], 5);
}

TEST(FrequenciesOf, RefusesWhatIsNoFrequencyWhereThereIsAWave) {
  const DirectionField directions = projected_direction_field({1, 0, 0}, square().normals);
  for (const double bad : std::initializer_list<double>{0, -1, 1e-60, 1e60, kInfinity}) {
    expect_error("'speed': the frequency of vertex 2", [&] {
      frequencies_of(numbers({1, 1, bad, 1, 1}), directions);
    });
  }
}

TEST(DropWavesWithoutFrequency, LeavesFiniteFrequencies) {
  DirectionField directions = {{1, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 1, 0}};
  const auto nan = static_cast<float>(kNaN);
  FrequencyField frequencies = {2, nan, nan, 4};
  EXPECT_EQ(drop_waves_without_frequency(directions, frequencies), 1u)
      << "one of both had no wave anyway";
  EXPECT_EQ(directions, (DirectionField{{1, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(frequencies, (FrequencyField{2, 3, 3, 4}));
  FrequencyField none = {nan, nan, nan, nan};
  EXPECT_EQ(drop_waves_without_frequency(directions, none), 2u);
  EXPECT_EQ(none, (FrequencyField{1, 1, 1, 1}));
}

}  // namespace
}  // namespace brindle
