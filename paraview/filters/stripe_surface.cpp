#include "stripe_surface.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include <brindle/texture_coordinates.h>
#include <brindle/texture_pattern.h>

#include "vtk_arrays.h"

namespace brindle::paraview {
namespace {

bool is_mean(const std::array<Index, 3>& origins) { return origins[0] != origins[1]; }

/// Gives points of the output to corners of the textured mesh. Points of the input at one place,
/// with arrays of their own, stay apart though they are one vertex.
class CornerPoints {
 public:
  CornerPoints(const InputSurface& input, const TexturedMesh& textured)
      : input_(input), textured_(textured) {
    for (Index p = 0; p < input.vertex_of_point.size(); ++p) {
      sources.push_back(whole_row(p));
      vertices.push_back(input.vertex_of_point[p]);
    }
  }

  /// The output's point for a vertex of the textured mesh, seen from a triangle of the surface.
  Index point(Index vertex, std::size_t triangle) {
    const std::array<Index, 3> corners = input_.points_of(triangle);
    const std::array<Index, 3>& origins = textured_.origins[vertex];
    if (is_mean(origins)) {
      constexpr double kThird = 1.0 / 3;
      return added(vertex, {corners, {kThird, kThird, kThird}});
    }
    const auto source = *std::find_if(corners.begin(), corners.end(), [&](Index p) {
      return input_.vertex_of_point[p] == origins[0];
    });
    if (vertex < input_.vertex_of_point.size()) return source;
    return added(vertex, whole_row(source));
  }

  std::vector<RowBlend> sources;  ///< per point of the output
  std::vector<Index> vertices;    ///< per point of the output: its vertex in the textured mesh

 private:
  Index added(Index vertex, const RowBlend& source) {
    const std::uint64_t key = std::uint64_t{vertex} << 32 | source.rows[0];
    const auto [place, is_new] = ids_.try_emplace(key, static_cast<Index>(sources.size()));
    if (is_new) {
      sources.push_back(source);
      vertices.push_back(vertex);
    }
    return place->second;
  }

  const InputSurface& input_;
  const TexturedMesh& textured_;
  std::unordered_map<std::uint64_t, Index> ids_;
};

/// Rows of values per vertex for points that are those vertices.
template <class Value>
std::vector<Value> picked(const std::vector<Value>& values, const std::vector<Index>& vertices) {
  std::vector<Value> result;
  result.reserve(vertices.size());
  for (const Index v : vertices) result.push_back(values[v]);
  return result;
}

void set_waves(const CarriedWaves& carried, const std::vector<float>& wanted,
               const std::vector<float>& branches, const std::vector<Index>& vertices,
               PointWaves& waves) {
  waves.directions = picked(carried.waves.directions, vertices);
  waves.frequencies = picked(carried.waves.frequencies, vertices);
  waves.z = picked(carried.z, vertices);
  waves.branches = picked(branches, vertices);
  if (!wanted.empty()) waves.frequencies_wanted = picked(wanted, vertices);
}

void add_triangle(const InputSurface& input, const StripePattern& pattern, std::size_t base,
                  const std::array<Index, 3>& corners, StripeSurface& surface) {
  surface.triangles.push_back(corners);
  surface.cells.push_back(input.cell_of_triangle[base]);
  surface.branches.push_back(is_branch(pattern.corners[base]) ? 1 : 0);
}

}  // namespace

StripeSurface plain_surface(const InputSurface& input, const StripePattern& pattern) {
  StripeSurface surface;
  for (Index p = 0; p < input.vertex_of_point.size(); ++p) surface.sources.push_back(whole_row(p));
  const Mesh& mesh = input.surface->mesh;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    add_triangle(input, pattern, t, input.points_of(t), surface);
  }
  set_waves({pattern.waves, pattern.solution.z}, pattern.frequencies_wanted,
            branches_at_vertices(mesh, pattern.corners), input.vertex_of_point, surface.waves);
  return surface;
}

StripeSurface textured_surface(const InputSurface& input, const StripePattern& pattern) {
  const Mesh& mesh = input.surface->mesh;
  const TexturedMesh textured = texture_coordinates(*input.surface, pattern, pattern.phase_shift);
  StripeSurface surface;
  CornerPoints points(input, textured);
  for (std::size_t t = 0; t < textured.mesh.triangle_count(); ++t) {
    const std::size_t base = textured.triangle_origins[t];
    std::array<Index, 3> corners = textured.mesh.triangles[t];
    for (Index& corner : corners) corner = points.point(corner, base);
    add_triangle(input, pattern, base, corners, surface);
  }
  surface.sources = std::move(points.sources);
  for (const Index v : points.vertices) {
    surface.coordinates.push_back(textured.coordinates[v].x());
    surface.coordinates.push_back(textured.coordinates[v].y());
  }
  std::vector<float> branches =
      carried_values(textured, branches_at_vertices(mesh, pattern.corners), 1);
  // A barycentre is at a branch if all corners are.
  for (float& flag : branches) flag = std::floor(flag);
  std::vector<float> wanted;
  if (!pattern.frequencies_wanted.empty()) {
    wanted = carried_values(textured, pattern.frequencies_wanted, 1);
  }
  set_waves(carried_waves(textured, pattern.waves, pattern.solution.z), wanted, branches,
            points.vertices, surface.waves);
  return surface;
}

}  // namespace brindle::paraview
