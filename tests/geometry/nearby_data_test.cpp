#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/mesh_data.h"
#include "parametric_meshes.h"

namespace brindle {
namespace {

constexpr double kAnywhere = std::numeric_limits<double>::infinity();

std::vector<double> doubles(const DataArray& array) {
  EXPECT_EQ(array.type, NumberType::float64);
  std::vector<double> numbers(array.bytes.size() / sizeof(double));
  std::memcpy(numbers.data(), array.bytes.data(), array.bytes.size());
  return numbers;
}

template <class Function>
DataArray per_vertex(const Mesh& mesh, const Function& function) {
  std::vector<double> numbers;
  for (const Vec3& p : mesh.positions) numbers.push_back(function(p.cast<double>() + mesh.origin));
  return make_data_array("f", 1, numbers);
}

double linear(const Eigen::Vector3d& p) { return 2 * p.x() - 3 * p.y() + p.z() + 5; }

TEST(NearbyData, OnTheMeshItselfIsItself) {
  const Mesh mesh = make_torus({.resolution = 20});
  const NearbyRows rows = nearby_rows(mesh, mesh, 0);
  const DataArray array =
      per_vertex(mesh, [](const Eigen::Vector3d& p) { return std::sin(7 * p.x()) - p.z(); });
  EXPECT_EQ(carried_from_points(array, rows), array);
  std::vector<float> floats;
  for (const double number : doubles(array)) floats.push_back(static_cast<float>(number));
  EXPECT_EQ(doubles(carried_from_points(make_data_array("f", 1, floats), rows)),
            std::vector<double>(floats.begin(), floats.end()));
}

TEST(NearbyData, ReproducesLinearFunctionsOnAFinerMesh) {
  const Mesh mesh = make_sphere({.resolution = 10});
  const Mesh fine = subdivide(mesh, 2);
  const std::vector<double> carried =
      doubles(carried_from_points(per_vertex(mesh, linear), nearby_rows(mesh, fine, 1e-5)));
  const std::vector<double> expected = doubles(per_vertex(fine, linear));
  for (std::size_t v = 0; v < carried.size(); ++v) EXPECT_NEAR(carried[v], expected[v], 1e-5);
  // And on a coarser one, whose vertices are the finer one's.
  EXPECT_EQ(carried_from_points(per_vertex(fine, linear), nearby_rows(fine, mesh, 0)),
            per_vertex(mesh, linear));
}

TEST(NearbyData, TakesTheRowOfTheNearestTriangle) {
  const Mesh mesh = make_sphere({.resolution = 10});
  Mesh centers;
  std::vector<int> numbers;
  std::vector<double> expected;
  for (const Triangle& t : mesh.triangles) {
    centers.positions.push_back(
        (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3);
    numbers.push_back(static_cast<int>(1000 - numbers.size()));
    expected.push_back(numbers.back());
  }
  const NearbyRows rows = nearby_rows(mesh, centers, kAnywhere);
  EXPECT_EQ(doubles(carried_from_cells(make_data_array("n", 1, numbers), rows)), expected);
}

TEST(NearbyData, OfPointsIsThatOfTheNearest) {
  const Mesh points{{{0, 0, 0}, {10, 0, 0}}, {}};
  const Mesh to{{{1, 0, 0}, {8, 1, 0}, {-3, 0, 0}}, {}};
  const NearbyRows rows = nearby_rows(points, to, kAnywhere);
  EXPECT_EQ(
      doubles(carried_from_points(make_data_array("a", 2, std::vector<int>{1, 2, 3, 4}), rows)),
      (std::vector<double>{1, 2, 3, 4, 1, 2}));
  EXPECT_THROW(carried_from_cells(make_data_array("a", 1, std::vector<int>{1}), rows), Error);
}

TEST(NearbyData, LeavesOutWhatIsTooFar) {
  for (const Mesh& from :
       {Mesh{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}}, Mesh{{{1, 1, 0}, {9, 9, 9}}, {}}}) {
    const Mesh to{{{1, 1, 0.5f}, {1, 1, 2}, {1, 1, -1}}, {}};
    const NearbyRows rows = nearby_rows(from, to, 1);
    EXPECT_EQ(rows.found, (std::vector<char>{1, 0, 1})) << "as far as the limit is near enough";
    const auto carried = doubles(carried_from_points(
        make_data_array("a", 1, std::vector<int>(from.vertex_count(), 7)), rows));
    EXPECT_EQ(carried[0], 7);
    EXPECT_TRUE(std::isnan(carried[1]));
  }
}

TEST(NearbyData, MindsOrigins) {
  Mesh from = make_sphere({.resolution = 10}), to = from;
  from.origin = {1e7, 0, 0};
  to.origin = {1e7 + 0.5, 0, 0};
  for (Vec3& p : to.positions) p.x() -= 0.5f;
  const NearbyRows rows = nearby_rows(from, to, 1e-5);
  EXPECT_EQ(std::count(rows.found.begin(), rows.found.end(), 1), std::ssize(to.positions));
}

TEST(NearbyData, RefusesArraysOfOtherMeshes) {
  const Mesh mesh = make_sphere({.resolution = 10});
  const NearbyRows rows = nearby_rows(mesh, mesh, 0);
  const DataArray one = make_data_array("one", 1, std::vector<int>{1});
  EXPECT_THROW(carried_from_points(one, rows), Error);
  EXPECT_THROW(carried_from_cells(one, rows), Error);
  EXPECT_THROW(nearby_rows({}, mesh, 0), Error);
}

}  // namespace
}  // namespace brindle
