#include "stripe_surface.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <unordered_map>
#include <utility>

#include <brindle/pattern_arrays.h>
#include <brindle/texture_coordinates.h>
#include <brindle/texture_pattern.h>

#include "vtk_data.h"

namespace brindle::paraview {
namespace {

constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();
constexpr double kThird = 1.0 / 3;

bool is_mean(const std::array<Index, 3>& origins) { return origins[0] != origins[1]; }

/// Assigns output points to corners of the textured mesh. Input points at one position stay
/// separate, with their arrays, although they are one vertex.
class CornerPoints {
 public:
  CornerPoints(const InputSurface& input, const TexturedMesh& textured)
      : input_(input), textured_(textured) {
    for (Index p = 0; p < input.vertex_of_point.size(); ++p) {
      sources.push_back(whole_row(p));
      vertices.push_back(input.vertex_of_point[p]);
    }
  }

  /// The output point of a vertex of the textured mesh in a triangle of the surface.
  Index point(Index vertex, std::size_t triangle) {
    const bool is_own = vertex < input_.surface->mesh.vertex_count();
    if (is_own && !input_.joined) return vertex;
    const Triangle& corners = input_.points_of_triangle[triangle];
    const std::array<Index, 3>& origins = textured_.origins[vertex];
    if (is_mean(origins)) return added(vertex, {corners, {kThird, kThird, kThird}});
    const auto source = *std::find_if(corners.begin(), corners.end(), [&](Index p) {
      return input_.vertex_of_point[p] == origins[0];
    });
    return is_own ? source : added(vertex, whole_row(source));
  }

  std::vector<RowBlend> sources;  ///< per point of the output
  std::vector<Index> vertices;    ///< vertex in the textured mesh, per output point

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

/// Sets branches that include other ranks' triangles; unchanged without other ranks.
void set_branches(std::vector<DataArray>& arrays, const TexturedMesh& textured,
                  const std::vector<float>& branches) {
  std::vector<float> flags = carried_values(textured, branches, 1);
  for (float& flag : flags)
    flag = std::floor(flag);  // a barycentre has 1 only if all its corners do
  const auto found = std::ranges::find(arrays, "branch", &DataArray::name);
  if (found != arrays.end())
    *found = make_data_array("branch", 1, flags);  // absent if there are no points
}

}  // namespace

std::vector<float> branches_at_vertices(const InputSurface& input, const StripePattern& pattern) {
  std::vector<float> flags = brindle::branches_at_vertices(input.surface->mesh, pattern.corners);
  if (!input.piece) return flags;
  input.piece->greatest(std::span(flags));
  return flags;
}

StripeSurface plain_surface(const InputSurface& input, const StripePattern& pattern,
                            const VertexNotes& notes) {
  StripeSurface surface;
  for (Index p = 0; p < input.vertex_of_point.size(); ++p) surface.sources.push_back(whole_row(p));
  surface.triangles = input.points_of_triangle;
  surface.cells = input.cell_of_triangle;
  surface.branches = brindle::branches_in_triangles(pattern, "branch");
  std::vector<DataArray> arrays;
  brindle::add_waves(arrays, {pattern.waves, pattern.frequencies_wanted, pattern.solution.z, ""},
                     kMissing, notes.branches);
  brindle::add_support(arrays, notes.support);
  surface.point_arrays = rows_of(arrays, input.vertex_of_point);
  return surface;
}

StripeSurface textured_surface(const InputSurface& input, const StripePattern& pattern,
                               const VertexNotes& notes) {
  // The fields of filters have signs: neighbours agree where possible.
  const TexturedMesh textured =
      texture_coordinates(*input.surface, pattern, pattern.phase_shift, true);
  StripeSurface surface;
  CornerPoints points(input, textured);
  for (std::size_t t = 0; t < textured.mesh.triangle_count(); ++t) {
    const std::size_t base = textured.triangle_origins[t];
    std::array<Index, 3> corners = textured.mesh.triangles[t];
    for (Index& corner : corners) corner = points.point(corner, base);
    surface.triangles.push_back(corners);
    surface.cells.push_back(input.cell_of_triangle[base]);
  }
  surface.sources = std::move(points.sources);
  surface.branches =
      rows_of(brindle::branches_in_triangles(pattern, "branch"), textured.triangle_origins);
  for (const Index v : points.vertices) {
    surface.coordinates.push_back(textured.coordinates[v].x());
    surface.coordinates.push_back(textured.coordinates[v].y());
  }
  std::vector<DataArray> arrays;
  brindle::add_carried_waves(arrays, textured, input.surface->mesh, pattern, "", kMissing);
  set_branches(arrays, textured, notes.branches);
  brindle::add_support(arrays, brindle::carried_support(textured, notes.support));
  surface.point_arrays = rows_of(arrays, points.vertices);
  return surface;
}

}  // namespace brindle::paraview
