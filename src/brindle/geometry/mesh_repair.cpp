#include <algorithm>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/geometry/topology.h"
#include "brindle/local_positions.h"
#include "brindle/mesh.h"

namespace brindle {
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
