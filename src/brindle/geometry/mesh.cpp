#include "brindle/mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numeric>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/base/array_numbers.h"
#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
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

namespace {

constexpr auto kLargestFloat = static_cast<float>(kLargestCoordinate);
/// Relative area of a degenerate triangle: twice the area over the square of the longest edge.
/// Rounding of float coordinates leaves far more.
constexpr double kSmallestArea = 1e-12;

bool usable(const Vec3& position) {
  return (position.array().abs() <= kLargestFloat).all();  // false for NaN
}

bool has_area(const Mesh& mesh, const Triangle& t) {
  const Eigen::Vector3d p = mesh.positions[t[0]].cast<double>();
  const Eigen::Vector3d a = mesh.positions[t[1]].cast<double>() - p;
  const Eigen::Vector3d b = mesh.positions[t[2]].cast<double>() - p;
  const double longest2 = std::max({a.squaredNorm(), b.squaredNorm(), (a - b).squaredNorm()});
  return longest2 > 0 && a.cross(b).norm() > kSmallestArea * longest2;
}

/// Keeps the triangles whose entry in `bad` is 0, with their entries in `kept`.
void drop_triangles(Mesh& mesh, const std::vector<char>& bad, std::vector<Index>& kept) {
  std::size_t left = 0;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    if (bad[t]) continue;
    mesh.triangles[left] = mesh.triangles[t];
    kept[left++] = kept[t];
  }
  mesh.triangles.resize(left);
  kept.resize(left);
}

void drop_bad_triangles(Mesh& mesh, const std::vector<char>& good, MeshRepair& repair,
                        std::vector<Index>& kept) {
  std::vector<char> bad(mesh.triangle_count(), 1);
  for (std::size_t number = 0; number < bad.size(); ++number) {
    const Triangle& t = mesh.triangles[number];
    if (std::max({t[0], t[1], t[2]}) >= mesh.vertex_count()) {
      ++repair.triangles_out_of_range;
    } else if (!good[t[0]] || !good[t[1]] || !good[t[2]]) {
      ++repair.triangles_not_finite;
    } else if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0] || !has_area(mesh, t)) {
      ++repair.triangles_degenerate;
    } else {
      bad[number] = 0;
    }
  }
  drop_triangles(mesh, bad, kept);
}

void drop_duplicates(Mesh& mesh, MeshRepair& repair, std::vector<Index>& kept) {
  const std::vector<Index> first = first_with_same_corners(mesh);
  std::vector<char> duplicate(mesh.triangle_count(), 0);
  for (std::size_t t = 0; t < first.size(); ++t) duplicate[t] = first[t] != t;
  repair.triangles_duplicate =
      static_cast<std::size_t>(std::count(duplicate.begin(), duplicate.end(), 1));
  drop_triangles(mesh, duplicate, kept);
}

std::vector<char> referenced_vertices(const Mesh& mesh) {
  std::vector<char> referenced(mesh.vertex_count(), 0);
  for (const Triangle& t : mesh.triangles) {
    for (const Index v : t) referenced[v] = 1;
  }
  return referenced;
}

std::uint64_t hash(const Vec3& position) {
  std::uint64_t bits = 0;
  for (const float coordinate : position) {
    // Adding 0 makes -0 and 0 the same.
    bits = (bits ^ bit_cast<std::uint32_t>(coordinate + 0.0f)) * 0x9e3779b97f4a7c15u;
    bits ^= bits >> 32;
  }
  return bits;
}

}  // namespace

std::vector<char> set_positions_finite(std::vector<Vec3>& positions) {
  std::vector<char> good(positions.size());
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  std::size_t left = 0;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    good[v] = usable(positions[v]);
    if (!good[v]) continue;
    sum += positions[v].cast<double>();
    ++left;
  }
  if (left == positions.size()) return good;
  const Vec3 centroid = (sum / static_cast<double>(std::max<std::size_t>(left, 1))).cast<float>();
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (!good[v]) positions[v] = centroid;
  }
  return good;
}

MeshRepair repair_mesh(Mesh& mesh) {
  std::vector<Index> ignored;
  return repair_mesh(mesh, ignored);
}

MeshRepair repair_mesh(Mesh& mesh, std::vector<Index>& kept) {
  kept.resize(mesh.triangle_count());
  std::iota(kept.begin(), kept.end(), Index{0});
  MeshRepair repair;
  const std::vector<char> good = set_positions_finite(mesh.positions);
  repair.vertices_not_finite = static_cast<std::size_t>(std::count(good.begin(), good.end(), 0));
  drop_bad_triangles(mesh, good, repair, kept);
  drop_duplicates(mesh, repair, kept);
  const std::vector<char> referenced = referenced_vertices(mesh);
  repair.vertices_unreferenced =
      static_cast<std::size_t>(std::count(referenced.begin(), referenced.end(), 0));
  return repair;
}

std::vector<Index> first_at_each_place(std::span<const Vec3> positions, const Progress& progress) {
  constexpr Index kFree = ~Index{0};
  constexpr std::size_t kPlacesPerReport = 1 << 12;  // each is a random memory access
  // Open addressing: at most half of the places are taken.
  std::vector<Index> table(std::bit_ceil(2 * positions.size() + 1), kFree);
  std::vector<Index> first(positions.size());
  const auto find = [&](std::size_t number) {
    const auto v = static_cast<Index>(number);
    std::size_t place = hash(positions[v]) & (table.size() - 1);
    // NaN equals nothing: it keeps its own number and needs no table entry.
    if (!usable(positions[v])) {
      first[v] = v;
      return;
    }
    while (table[place] != kFree && positions[table[place]] != positions[v]) {
      place = (place + 1) & (table.size() - 1);
    }
    if (table[place] == kFree) table[place] = v;
    first[v] = table[place];
  };
  reported_for(positions.size(), progress, find, kPlacesPerReport);
  return first;
}

std::size_t join_vertices(Mesh& mesh) {
  return join_vertices(mesh, first_at_each_place(mesh.positions));
}

std::size_t join_vertices(Mesh& mesh, std::span<const Index> first) {
  std::size_t joined = 0;
  for (std::size_t v = 0; v < first.size(); ++v) joined += first[v] != v;
  if (joined == 0) return 0;
  for (Triangle& t : mesh.triangles) {
    for (Index& v : t) {
      if (v < first.size()) v = first[v];
    }
  }
  return joined;
}

std::vector<Index> drop_unreferenced_vertices(Mesh& mesh) {
  const std::vector<char> referenced = referenced_vertices(mesh);
  std::vector<Index> number(mesh.vertex_count());
  Index kept = 0;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    number[v] = kept;
    if (referenced[v]) mesh.positions[kept++] = mesh.positions[v];
  }
  mesh.positions.resize(kept);
  for (Triangle& t : mesh.triangles) {
    for (Index& v : t) v = number[v];
  }
  return number;
}

std::string describe(const MeshRepair& repair) {
  std::string text;
  const auto line = [&](std::size_t count, const char* what) {
    if (count > 0) text += std::to_string(count) + ' ' + what + '\n';
  };
  line(repair.vertices_not_finite,
       "vertices with coordinates that are not finite or beyond 1e18: set aside");
  line(repair.vertices_joined, "vertices at the place of another: joined");
  line(repair.vertices_unreferenced, "vertices in no triangle: kept, without a wave");
  line(repair.triangles_out_of_range, "triangles with corners that do not exist: dropped");
  line(repair.triangles_not_finite,
       "triangles with corners that are not finite or beyond 1e18: dropped");
  line(repair.triangles_degenerate, "triangles without area: dropped");
  line(repair.triangles_duplicate, "triangles that stand twice: dropped");
  return text;
}

}  // namespace brindle
