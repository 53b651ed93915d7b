#include "brindle/pipeline/fields/averaged_normals.h"

#include <utility>

#include "brindle/phases/screened.h"
#include "brindle/pipeline/fields/surface_elements.h"

namespace brindle {

std::vector<Vec3> averaged_normals(const Surface& surface, float radius, const Progress& progress) {
  const std::size_t count = surface.mesh.vertex_count();
  const std::vector<float> stiffness = edge_stiffness(surface, progress.part(0, 0.2));
  const std::vector<float> degrees = stiffness_sums(*surface.neighborhood, stiffness);
  PhaseGraph graph = stiffness_graph(surface, stiffness);
  graph.anchor.resize(count);
  // What decays as a screened field does over a length has twice that root mean square distance.
  const float inverse_square = 4 / (radius * radius);
  std::vector<float> screening = areas_of_vertices(surface, areas_of_triangles(surface.mesh));
  for (float& s : screening) s *= inverse_square;
  std::vector<Complex> across(count), up(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (surface.normals[i].isZero(0)) screening[i] = 0;  // which pulls at nothing
    across[i] = {surface.normals[i].x(), surface.normals[i].y()};
    up[i] = surface.normals[i].z();
  }
  const auto average = [&](std::vector<Complex>& values, const Progress& solving) {
    for (std::size_t i = 0; i < count; ++i) graph.anchor[i] = screening[i] * values[i];
    values = smooth_screened(graph, screening, std::move(values),
                             {.of_anchors = true, .degrees = degrees, .progress = solving});
  };
  average(across, progress.part(0.2, 0.7));
  average(up, progress.part(0.7, 1));
  std::vector<Vec3> normals(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 sum(across[i].real(), across[i].imag(), up[i].real());
    constexpr float kNoDirection = 1e-3f;
    const bool has_direction = sum.norm() > kNoDirection && !surface.normals[i].isZero(0);
    normals[i] = has_direction ? Vec3(sum.normalized()) : surface.normals[i];
  }
  return normals;
}

}  // namespace brindle
