#include <cmath>
#include <string>
#include <utility>

#include "brindle/base/parallel.h"
#include "brindle/base/text.h"
#include "brindle/creases.h"
#include "brindle/error.h"
#include "brindle/geometry/normals_around.h"
#include "brindle/geometry/topology.h"
#include "brindle/relief/refined_relief.h"
#include "brindle/relief/volume.h"

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

/// Returns whether the mesh is closed.
bool check_edges(const Mesh& mesh) {
  const std::vector<Index> twins = twins_of(mesh.triangles);
  bool closed = true;
  for (Index h = 0; h < twins.size(); ++h) {
    const Index a = vertex_at(mesh.triangles, h);
    if (twins[h] == kManyTwins) {
      throw Error("a relief needs edges of one or two triangles, and an edge of vertex " +
                  std::to_string(a) + " has more; separate the parts that touch there");
    }
    closed = closed && twins[h] != kNoTwin;
    if (twins[h] != kNoTwin && vertex_at(mesh.triangles, twins[h]) == a) {
      throw Error("a relief needs an inside and an outside, and the triangles at vertex " +
                  std::to_string(a) + " cannot be wound alike; cut the surface open there");
    }
  }
  return closed;
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
                       const std::vector<std::uint8_t>& only) {
  check_relief(surface, textured, only);
  ReliefBase base = WeldedBase(surface, textured).take(only);
  const std::vector<std::uint8_t> turned =
      triangles_to_turn(base.mesh, vertex_triangles(base.mesh));
  for (std::size_t t = 0; t < turned.size(); ++t) {
    if (turned[t] != 0) turn(base, t);
  }
  if (check_edges(base.mesh) && volume_of(base.mesh) < 0) {
    for (std::size_t t = 0; t < base.mesh.triangle_count(); ++t) {
      turn(base, t);
      for (Vec3& normal : base.normals[t]) normal = -normal;
    }
  }
  return base;
}

double volume_of(const Mesh& mesh) {
  if (mesh.triangles.empty()) return 0;
  const Vec3 origin = mesh.positions[mesh.triangles[0][0]];
  return parallel_sum<double>(mesh.triangle_count(), [&](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (std::size_t t = begin; t < end; ++t) {
      std::array<Eigen::Vector3d, 3> p;
      for (int m = 0; m < 3; ++m) {
        p[m] = (mesh.positions[mesh.triangles[t][m]] - origin).cast<double>();
      }
      sum += p[0].dot(p[1].cross(p[2])) / 6;
    }
    return sum;
  });
}

}  // namespace brindle
