#include "brindle/mesh.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>

#include "brindle/base/array_numbers.h"
#include "brindle/base/text.h"
#include "brindle/geometry/topology.h"
#include "brindle/local_positions.h"

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

/// With `checked`, throws for invalid coordinates; otherwise a later repair handles them.
std::vector<Eigen::Vector3d> coordinates(const ArrayView& positions, bool checked) {
  check_columns(positions, 3, "positions");
  if (positions.rows() >= std::numeric_limits<Index>::max()) {
    throw Error("positions: more vertices than brindle can number; split the mesh into parts");
  }
  std::vector<Eigen::Vector3d> result(positions.rows());
  for_each_number(positions, [&](std::size_t vertex, std::size_t axis, auto number) {
    const auto coordinate = static_cast<double>(number);
    if (checked && !(std::abs(coordinate) <= kLargestCoordinate)) {
      throw Error("positions: a coordinate of vertex " + std::to_string(vertex) + " is " +
                  formatted("%g", coordinate) + "; correct it or leave the vertex out" +
                  (std::isfinite(coordinate) ? ", or give all coordinates in larger units" : ""));
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

/// Without `checked`, an invalid corner becomes the largest Index, which no mesh has.
std::vector<Triangle> corners(const ArrayView& triangles, std::size_t vertices, bool checked) {
  check_columns(triangles, 3, "triangles");
  std::vector<Triangle> result(triangles.rows());
  for_each_number(triangles, [&](std::size_t triangle, std::size_t corner, auto number) {
    if constexpr (std::is_integral_v<decltype(number)>) {
      // A negative number becomes a very large one.
      const bool is_vertex = static_cast<std::uint64_t>(number) < vertices;
      if (checked && !is_vertex) refuse_corner(triangle, std::to_string(number), vertices);
      result[triangle][corner] =
          is_vertex ? static_cast<Index>(number) : std::numeric_limits<Index>::max();
    } else {
      throw Error("triangles: their corners must be whole numbers, not floating-point ones");
    }
  });
  return result;
}

[[noreturn]] void refuse_triangle(std::size_t triangle, const std::string& what) {
  throw Error("triangles: triangle " + std::to_string(triangle) + " has " + what +
              "; drop it, or repair the mesh (make_repaired_mesh; in Python repair=True)");
}

void refuse_bad_triangles(const Mesh& mesh) {
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.triangles[t];
    if (a != b && b != c && c != a) continue;
    refuse_triangle(t, "vertex " + std::to_string(a == b || a == c ? a : b) + " at two corners");
  }
  const std::vector<Index> first = first_with_same_corners(mesh);
  for (std::size_t t = 0; t < first.size(); ++t) {
    if (first[t] != t) refuse_triangle(t, "the corners of triangle " + std::to_string(first[t]));
  }
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

Mesh make_mesh(const ArrayView& positions, const ArrayView& triangles, BadTriangles bad,
               const Progress& progress) {
  JobStages stages(progress, {{"positions", 1}, {"triangles", 1}, {"origin", 1}});
  stages.begin("positions");
  const std::vector<Eigen::Vector3d> places = coordinates(positions, true);
  Mesh mesh;
  stages.begin("triangles");
  mesh.triangles = corners(triangles, places.size(), true);
  stages.begin("origin");
  mesh.origin = origin_near(places);
  mesh.positions = positions_about(mesh.origin, places);
  if (bad == BadTriangles::refused) refuse_bad_triangles(mesh);
  stages.finish();
  return mesh;
}

RepairedMesh make_repaired_mesh(const ArrayView& positions, const ArrayView& triangles) {
  RepairedMesh result;
  Mesh& mesh = result.mesh;
  const std::vector<Eigen::Vector3d> places = coordinates(positions, false);
  mesh.origin = origin_near(places);
  mesh.positions = positions_about(mesh.origin, places);
  mesh.triangles = corners(triangles, places.size(), false);
  const std::size_t count = mesh.triangle_count();
  std::vector<Index> first = first_at_each_place(mesh.positions);
  const std::size_t joined = join_vertices(mesh, first);
  if (joined > 0) result.vertex_of_row = std::move(first);
  std::vector<Index> kept;
  result.repair = repair_mesh(mesh, kept);
  result.repair.vertices_joined = joined;
  if (kept.size() < count) result.kept_triangles = std::move(kept);
  return result;
}

void append(const Mesh& other, Mesh& mesh) {
  const auto first = static_cast<Index>(mesh.positions.size());
  if (mesh.positions.empty()) mesh.origin = other.origin;
  mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
  if (other.origin != mesh.origin) {
    const Eigen::Vector3d way = other.origin - mesh.origin;
    for (std::size_t v = first; v < mesh.positions.size(); ++v) {
      mesh.positions[v] = placed(mesh.positions[v], way).cast<float>();
    }
  }
  mesh.triangles.reserve(mesh.triangles.size() + other.triangles.size());
  for (const Triangle& t : other.triangles) {
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
}

void translate(Mesh& mesh, const Vec3& way) {
  for (Vec3& position : mesh.positions) position += way;
}

}  // namespace brindle
