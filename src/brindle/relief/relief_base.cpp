#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "brindle/base/parallel.h"
#include "brindle/base/text.h"
#include "brindle/creases.h"
#include "brindle/error.h"
#include "brindle/geometry/normals_around.h"
#include "brindle/geometry/topology.h"
#include "brindle/normals.h"
#include "brindle/relief/refined_relief.h"
#include "brindle/relief/relief_bodies.h"

namespace brindle {
namespace {

/// Welds the textured mesh, triangle by triangle.
class WeldedBase {
 public:
  WeldedBase(const Surface& surface, const TexturedMesh& textured)
      : surface_(surface), textured_(textured), own_(surface.own_vertex_count()) {
    const Mesh& mesh = surface.mesh;
    base_.mesh.origin = mesh.origin;
    base_.mesh.positions.assign(mesh.positions.begin(),
                                mesh.positions.begin() + static_cast<std::ptrdiff_t>(own_));
    middle_.assign(mesh.triangle_count(), kNoTriangle);
  }

  ReliefBase take(const std::vector<std::uint8_t>& only) {
    for (std::size_t t = 0; t < textured_.mesh.triangle_count(); ++t) add(t, only);
    return std::move(base_);
  }

 private:
  void add(std::size_t t, const std::vector<std::uint8_t>& only) {
    const Index original = textured_.triangle_origins[t];
    Triangle corners;
    std::array<Eigen::Vector2f, 3> uv;
    std::array<Vec3, 3> normals, places;
    for (int m = 0; m < 3; ++m) {
      const Index vertex = textured_.mesh.triangles[t][m];
      const std::array<Index, 3>& origins = textured_.origins[vertex];
      uv[m] = textured_.coordinates[vertex];
      const bool is_middle = origins[0] != origins[1];
      corners[m] = is_middle ? middle_of(original, textured_.mesh.positions[vertex])
                             : surface_.creases.original(origins[0], surface_.mesh.vertex_count());
      normals[m] = (surface_.normals[origins[0]] + surface_.normals[origins[1]] +
                    surface_.normals[origins[2]])
                       .normalized();
      places[m] = is_middle ? Vec3(Vec3::Constant(1.0f / 3)) : corner_of(original, origins[0]);
    }
    // Triangles without waves have no coordinates.
    const bool has_waves = !(uv[0].isZero(0) && uv[1].isZero(0) && uv[2].isZero(0));
    base_.mesh.triangles.push_back(corners);
    base_.uv.push_back(uv);
    base_.normals.push_back(normals);
    base_.original.push_back(original);
    base_.in_original.push_back(places);
    base_.textured.push_back(has_waves && (only.empty() || only[original] != 0) ? 1 : 0);
  }

  Index middle_of(Index triangle, const Vec3& position) {
    if (middle_[triangle] == kNoTriangle) {
      middle_[triangle] = static_cast<Index>(base_.mesh.positions.size());
      base_.mesh.positions.push_back(position);
    }
    return middle_[triangle];
  }

  Vec3 corner_of(Index triangle, Index vertex) const {
    const Triangle& corners = surface_.mesh.triangles[triangle];
    return vertex == corners[0]   ? Vec3::UnitX()
           : vertex == corners[1] ? Vec3::UnitY()
                                  : Vec3::UnitZ();
  }

  const Surface& surface_;
  const TexturedMesh& textured_;
  std::size_t own_;
  ReliefBase base_;
  std::vector<Index> middle_;  // vertex at the barycentre of a split triangle
};

void turn(ReliefBase& base, std::size_t t) {
  std::swap(base.mesh.triangles[t][1], base.mesh.triangles[t][2]);
  std::swap(base.uv[t][1], base.uv[t][2]);
  std::swap(base.normals[t][1], base.normals[t][2]);
  std::swap(base.in_original[t][1], base.in_original[t][2]);
}

/// Throws Error unless all edges have one or two triangles, wound alike. Returns the twins.
std::vector<Index> checked_twins(const Mesh& mesh) {
  std::vector<Index> twins = twins_of(mesh.triangles);
  for (Index h = 0; h < twins.size(); ++h) {
    const Index a = vertex_at(mesh.triangles, h);
    if (twins[h] == kManyTwins) {
      throw Error("a relief needs edges of one or two triangles, and an edge of vertex " +
                  std::to_string(a) + " has more; separate the parts that touch there");
    }
    if (twins[h] != kNoTwin && vertex_at(mesh.triangles, twins[h]) == a) {
      throw Error("a relief needs an inside and an outside, and the triangles at vertex " +
                  std::to_string(a) + " cannot be wound alike; cut the surface open there");
    }
  }
  return twins;
}

/// The vertices of a hole, along the triangles that will fill it. Marks its half-edges.
std::vector<Index> hole_at(const Mesh& mesh, const std::vector<Index>& twins, Index first,
                           std::vector<std::uint8_t>& seen) {
  std::vector<Index> corners;
  for (Index h = first; seen[h] == 0;) {
    seen[h] = 1;
    corners.push_back(vertex_at(mesh.triangles, h));
    h = next_in_triangle(h);
    while (twins[h] != kNoTwin) h = next_in_triangle(twins[h]);
  }
  std::reverse(corners.begin(), corners.end());
  return corners;
}

/// The parts of a hole between passes of the same vertex.
std::vector<std::vector<Index>> simple_holes(const std::vector<Index>& hole) {
  std::vector<std::vector<Index>> holes(1);
  for (const Index v : hole) {
    std::vector<Index> way = std::move(holes.back());
    const auto again = ranges::find(way, v);
    if (again != way.end()) {
      holes.back().assign(again, way.end());
      way.erase(again, way.end());
      holes.emplace_back();
    }
    way.push_back(v);
    holes.back() = std::move(way);
  }
  return holes;
}

float perimeter_of(const Mesh& mesh, const std::vector<Index>& corners) {
  float length = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Index next = corners[(i + 1) % corners.size()];
    length += (mesh.positions[next] - mesh.positions[corners[i]]).norm();
  }
  return length;
}

/// Whether a triangle has an edge between corners of a hole that the mesh has already, beside those
/// around the hole.
bool doubles_edge(const Mesh& mesh, const VertexTriangles& around, const std::vector<Index>& hole,
                  const Triangle& triangle) {
  for (int m = 0; m < 3; ++m) {
    const Index a = triangle[m], b = triangle[(m + 1) % 3];
    const auto at = static_cast<std::size_t>(ranges::find(hole, a) - hole.begin());
    const std::size_t count = hole.size();
    if (hole[(at + 1) % count] == b || hole[(at + count - 1) % count] == b) continue;
    for (const Index t : around.of(a)) {
      if (ranges::find(mesh.triangles[t], b) != mesh.triangles[t].end()) return true;
    }
  }
  return false;
}

/// Triangles between the corners of a hole or, if those would meet other edges, around its middle.
void fill_hole(Mesh& mesh, const VertexTriangles& around, const std::vector<Index>& hole) {
  std::vector<Triangle> filling;
  triangulate_polygon(mesh.positions, hole, filling);
  const auto doubles = [&](const Triangle& t) { return doubles_edge(mesh, around, hole, t); };
  if (ranges::any_of(filling, doubles)) {
    filling.clear();
    Vec3 middle = Vec3::Zero();
    for (const Index v : hole) middle += mesh.positions[v] / static_cast<float>(hole.size());
    const auto centre = static_cast<Index>(mesh.vertex_count());
    mesh.positions.push_back(middle);
    for (std::size_t i = 0; i < hole.size(); ++i) {
      filling.push_back({hole[i], hole[(i + 1) % hole.size()], centre});
    }
  }
  mesh.triangles.insert(mesh.triangles.end(), filling.begin(), filling.end());
}

/// Fills holes up to a perimeter with triangles without texture.
void fill_holes(ReliefBase& base, const std::vector<Index>& twins, float largest) {
  Mesh& mesh = base.mesh;
  const VertexTriangles around = vertex_triangles(mesh);
  std::vector<std::uint8_t> seen(twins.size());
  for (Index h = 0; h < twins.size(); ++h) {
    if (twins[h] != kNoTwin || seen[h] != 0) continue;
    for (const auto& corners : simple_holes(hole_at(mesh, twins, h, seen))) {
      if (!(perimeter_of(mesh, corners) <= largest)) continue;
      fill_hole(mesh, around, corners);
      ++base.filled_holes;
    }
  }
  const std::size_t count = mesh.triangle_count();
  for (std::size_t t = base.original.size(); t < count; ++t) {
    const Vec3 normal = triangle_normal(mesh, mesh.triangles[t]);
    base.normals.push_back({normal, normal, normal});
  }
  const Eigen::Vector2f zero = Eigen::Vector2f::Zero();
  base.uv.resize(count, {zero, zero, zero});
  base.original.resize(count, 0);
  base.in_original.resize(count, {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()});
  base.textured.resize(count, 0);
}

void check_relief(const Surface& surface, const TexturedMesh& textured,
                  const std::vector<std::uint8_t>& only) {
  const std::size_t vertices = surface.mesh.vertex_count();
  const std::size_t triangles = surface.mesh.triangle_count();
  bool fits = textured.coordinates.size() == textured.mesh.vertex_count() &&
              textured.origins.size() == textured.mesh.vertex_count() &&
              textured.triangle_origins.size() == textured.mesh.triangle_count() &&
              (only.empty() || only.size() == triangles);
  for (const auto& origins : textured.origins) {
    for (const Index origin : origins) fits = fits && origin < vertices;
  }
  for (const Index origin : textured.triangle_origins) fits = fits && origin < triangles;
  if (!fits) throw Error("the relief's texture coordinates or triangles are of another surface");
}

}  // namespace

ReliefBase relief_base(const Surface& surface, const TexturedMesh& textured,
                       const std::vector<std::uint8_t>& only, float holes) {
  check_relief(surface, textured, only);
  ReliefBase base = WeldedBase(surface, textured).take(only);
  const std::vector<std::uint8_t> turned =
      triangles_to_turn(base.mesh, vertex_triangles(base.mesh));
  for (std::size_t t = 0; t < turned.size(); ++t) {
    if (turned[t] != 0) turn(base, t);
  }
  fill_holes(base, checked_twins(base.mesh), holes);
  const std::vector<Index> twins = checked_twins(base.mesh);
  const bool is_closed = ranges::find(twins, kNoTwin) == twins.end();
  if (is_closed && volume_of(base.mesh) < 0) {
    for (std::size_t t = 0; t < base.mesh.triangle_count(); ++t) {
      turn(base, t);
      for (Vec3& normal : base.normals[t]) normal = -normal;
    }
  }
  return base;
}

}  // namespace brindle
