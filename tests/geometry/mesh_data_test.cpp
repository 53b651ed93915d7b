#include "brindle/mesh_data.h"

#include <cmath>
#include <limits>
#include <numeric>

#include <gtest/gtest.h>

#include "brindle/arrays.h"
#include "brindle/error.h"
#include "parametric_meshes.h"
#include "test_numbers.h"

namespace brindle {
namespace {

using testing_support::kInfinity;
using testing_support::kNaN;

double number(const DataArray& array, std::size_t row, std::size_t column = 0) {
  EXPECT_EQ(array.type, NumberType::float64);
  double value;
  std::memcpy(&value, array.view().address(row, column), sizeof value);
  return value;
}

/// Two triangles with the edge 1-2 in common, of areas 1 and 3, and a vertex in neither.
Mesh two_triangles(float size = 1) {
  Mesh mesh{{{-2, 0, 0}, {0, -0.5f, 0}, {0, 0.5f, 0}, {6, 0, 0}, {9, 9, 9}},
            {{0, 1, 2}, {1, 3, 2}}};
  for (Vec3& position : mesh.positions) position *= size;
  return mesh;
}

TEST(CellsToPoints, LeavesWhatIsTheSameEverywhereExactly) {
  const Mesh mesh = make_torus({.resolution = 20});
  for (const double value : {0.1, -1e300, 3.0, 1e-310}) {
    const std::vector<double> values(3 * mesh.triangle_count(), value);
    const DataArray points = cells_to_points(mesh, make_data_array("a", 3, values));
    EXPECT_EQ(points, make_data_array("a", 3, std::vector<double>(3 * mesh.vertex_count(), value)));
  }
  const std::vector<int> labels(mesh.triangle_count(), 7);
  EXPECT_EQ(number(cells_to_points(mesh, make_data_array("a", 1, labels)), 5), 7);
}

TEST(CellsToPoints, MeansOfAxesDoNotKnowSigns) {
  const Mesh mesh = make_torus({.resolution = 20});
  std::vector<float> alike, mixed;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const float sign = t * t % 7 < 3 ? -1.0f : 1.0f;
    for (const float number : {1.0f, 0.1f * static_cast<float>(t % 3), 0.2f}) {
      alike.push_back(number);
      mixed.push_back(sign * number);
    }
  }
  const DataArray expected = cells_to_points(mesh, make_data_array("fiber", 3, alike));
  const DataArray found = cells_to_points(mesh, make_data_array("fiber", 3, mixed));
  const std::vector<Vec3> axes = vectors_of(found.axes(), "axes");
  const std::vector<Vec3> expected_axes = vectors_of(expected.axes(), "axes");
  for (std::size_t v = 0; v < axes.size(); ++v) {
    const Vec3 turned = axes[v].x() < 0 ? Vec3(-axes[v]) : axes[v];
    EXPECT_EQ(turned, expected_axes[v]) << v;
    EXPECT_LT((turned - vectors_of(expected.view(), "numbers")[v]).norm(), 0.02f) << v;
  }
  EXPECT_NE(found.bytes, expected.bytes) << "numbers stay means of numbers";
}

TEST(CellsToPoints, WeighsRowsByAreas) {
  for (const float size : {1.0f, 1e-25f, 1e15f}) {
    const DataArray points = cells_to_points(
        two_triangles(size), make_data_array("a", 2, std::vector<float>{1, 10, 5, -10}));
    ASSERT_EQ(points.rows(), 5u);
    for (const std::size_t shared : {1u, 2u}) {
      EXPECT_NEAR(number(points, shared, 0), (1 * 1 + 3 * 5) / 4.0, 1e-6);
      EXPECT_NEAR(number(points, shared, 1), (1 * 10 - 3 * 10) / 4.0, 1e-6);
    }
    EXPECT_EQ(number(points, 0, 1), 10);
    EXPECT_EQ(number(points, 3, 0), 5);
    EXPECT_TRUE(std::isnan(number(points, 4, 0))) << "a vertex without a triangle";
  }
}

TEST(CellsToPoints, PassesOverRowsThatAreNotFinite) {
  for (const double bad : {kNaN, kInfinity}) {
    const DataArray points = cells_to_points(
        two_triangles(), make_data_array("a", 2, std::vector<double>{1, bad, 5, 6}));
    EXPECT_TRUE(std::isnan(number(points, 0, 0)));
    EXPECT_TRUE(std::isnan(number(points, 0, 1)));
    EXPECT_EQ(number(points, 1, 0), 5) << "also the number beside the bad one";
    EXPECT_EQ(number(points, 1, 1), 6);
  }
}

TEST(CellsToPoints, PassesOverTrianglesWithoutArea) {
  const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  const DataArray points =
      cells_to_points(mesh, make_data_array("a", 1, std::vector<double>{1, 5}));
  EXPECT_EQ(number(points, 0), 5);
  EXPECT_TRUE(std::isnan(number(points, 1)));
}

TEST(CellsToPoints, RefusesOtherNumbersOfRows) {
  const auto array = make_data_array("speed", 1, std::vector<double>{1, 5, 6});
  try {
    cells_to_points(two_triangles(), array);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("'speed' has 3 rows for 2 triangles"),
              std::string::npos)
        << error.what();
  }
}

struct SubdividedData : testing::TestWithParam<int> {};

TEST_P(SubdividedData, BelongsToTheSameMesh) {
  for (Mesh mesh : {make_torus({.resolution = 12}), make_sheets({.resolution = 4})}) {
    const Mesh expected = subdivide(mesh, GetParam());
    const std::size_t triangles = mesh.triangle_count();
    std::vector<std::uint32_t> numbers(triangles);
    std::iota(numbers.begin(), numbers.end(), 0u);
    const std::span<const float> coordinates(mesh.positions[0].data(), 3 * mesh.vertex_count());
    DataArrays arrays{{make_data_array("place", 3, coordinates)},
                      {make_data_array("number", 1, numbers)}};
    subdivide(mesh, arrays, GetParam());
    EXPECT_EQ(mesh.positions, expected.positions);
    EXPECT_EQ(mesh.triangles, expected.triangles);
    EXPECT_EQ(vectors_of(arrays.points[0].view(), "place"), mesh.positions);
    std::vector<std::uint32_t> parents(mesh.triangle_count());
    for (std::size_t t = 0; t < parents.size(); ++t) {
      parents[t] = static_cast<std::uint32_t>(t * triangles / mesh.triangle_count());
    }
    EXPECT_EQ(arrays.cells[0], make_data_array("number", 1, parents));
  }
}
INSTANTIATE_TEST_SUITE_P(Times, SubdividedData, testing::Values(0, 1, 2));

TEST(Subdivide, KeepsRowsOfOldVerticesBitForBit) {
  Mesh mesh = two_triangles();
  const std::vector<double> numbers = {-0.0, kNaN, 1e-310, 0.1, -kNaN};
  DataArrays arrays{{make_data_array("a", 1, numbers)}, {}};
  const DataArray before = arrays.points[0];
  subdivide(mesh, arrays);
  EXPECT_TRUE(std::equal(before.bytes.begin(), before.bytes.end(), arrays.points[0].bytes.begin()));
  EXPECT_EQ(arrays.points[0].rows(), mesh.vertex_count());
}

TEST(Subdivide, BlendsNumbersAndRepeatsLabels) {
  Mesh mesh{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, {{2, 0, 1}}};
  DataArrays arrays{{make_data_array("a", 1, std::vector<double>{1, 2, 4}),
                     make_data_array("label", 1, std::vector<int>{10, 20, 40})},
                    {}};
  subdivide(mesh, arrays);
  // The midpoints of the edges 0-1, 0-2 and 1-2.
  EXPECT_EQ(arrays.points[0], make_data_array("a", 1, std::vector<double>{1, 2, 4, 1.5, 2.5, 3}));
  EXPECT_EQ(arrays.points[1],
            make_data_array("label", 1, std::vector<int>{10, 20, 40, 10, 10, 20}));
}

TEST(Subdivide, RefusesArraysOfOtherMeshes) {
  Mesh mesh = two_triangles();
  const DataArray four = make_data_array("four", 1, std::vector<int>{1, 2, 3, 4});
  for (DataArrays arrays : {DataArrays{{four}, {}}, DataArrays{{}, {four}}}) {
    const DataArrays before = arrays;
    EXPECT_THROW(subdivide(mesh, arrays), Error);
    EXPECT_EQ(arrays, before);
    EXPECT_EQ(mesh.triangle_count(), 2u);
  }
  DataArrays none;
  EXPECT_THROW(subdivide(mesh, none, -1), Error);
  EXPECT_THROW(subdivide(mesh, none, 16), Error);
}

}  // namespace
}  // namespace brindle
