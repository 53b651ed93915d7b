#include "brindle/mesh.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>

#include "brindle/base/array_numbers.h"
#include "brindle/geometry/local_positions.h"

namespace brindle {
namespace {

BoundingBox box_around(const std::vector<Vec3>& positions) {
  if (positions.empty()) return {};
  BoundingBox box{positions[0], positions[0]};
  for (const Vec3& position : positions) {
    box.lower = box.lower.cwiseMin(position);
    box.upper = box.upper.cwiseMax(position);
  }
  return box;
}

std::vector<Eigen::Vector3d> coordinates(const ArrayView& positions) {
  check_columns(positions, 3, "positions");
  if (positions.rows() >= std::numeric_limits<Index>::max()) {
    throw Error("positions: more vertices than brindle can number; split the mesh into parts");
  }
  std::vector<Eigen::Vector3d> result(positions.rows());
  for_each_number(positions, [&](std::size_t vertex, std::size_t axis, auto number) {
    const auto coordinate = static_cast<double>(number);
    if (!(std::abs(coordinate) <= kLargestCoordinate)) {
      throw Error("positions: a coordinate of vertex " + std::to_string(vertex) + " is " +
                  std::to_string(coordinate) + "; correct it or leave the vertex out");
    }
    result[vertex][static_cast<Eigen::Index>(axis)] = coordinate;
  });
  return result;
}

[[noreturn]] void refuse_corner(std::size_t triangle, const std::string& corner,
                                std::size_t vertices) {
  throw Error("triangles: triangle " + std::to_string(triangle) + " has the corner " + corner +
              ", but there are " + std::to_string(vertices) + " vertices, numbered from 0");
}

std::vector<Triangle> corners(const ArrayView& triangles, std::size_t vertices) {
  check_columns(triangles, 3, "triangles");
  std::vector<Triangle> result(triangles.rows());
  for_each_number(triangles, [&](std::size_t triangle, std::size_t corner, auto number) {
    if constexpr (std::is_integral_v<decltype(number)>) {
      // A negative number becomes a very large one.
      if (static_cast<std::uint64_t>(number) >= vertices) {
        refuse_corner(triangle, std::to_string(number), vertices);
      }
      result[triangle][corner] = static_cast<Index>(number);
    } else {
      throw Error("triangles: their corners must be whole numbers, not floating-point ones");
    }
  });
  return result;
}

}  // namespace

BoundingBox bounding_box(const Mesh& mesh) {
  if (mesh.triangles.empty()) return box_around(mesh.positions);
  BoundingBox box;
  box.lower = box.upper = mesh.positions[mesh.triangles[0][0]];
  for (const Triangle& triangle : mesh.triangles) {
    for (const Index vertex : triangle) {
      box.lower = box.lower.cwiseMin(mesh.positions[vertex]);
      box.upper = box.upper.cwiseMax(mesh.positions[vertex]);
    }
  }
  return box;
}

Mesh make_mesh(const ArrayView& positions, const ArrayView& triangles) {
  const std::vector<Eigen::Vector3d> places = coordinates(positions);
  Mesh mesh;
  mesh.triangles = corners(triangles, places.size());
  mesh.origin = origin_near(places);
  mesh.positions = positions_about(mesh.origin, places);
  return mesh;
}

}  // namespace brindle
