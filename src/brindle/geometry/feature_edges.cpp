#include "brindle/geometry/measures.h"

#include <cmath>
#include <cstdint>
#include <numbers>

#include "brindle/base/elementary.h"
#include "brindle/base/parallel.h"
#include "brindle/normals.h"

namespace brindle {
namespace {

/// One triangle of an edge.
struct Side {
  Vec3 normal = Vec3::Zero();
  bool forward = false;  ///< runs from the edge's lower vertex to its higher one
};

}  // namespace

std::vector<std::array<Index, 2>> feature_edges(const Mesh& mesh, const MeshEdges& edges,
                                                float angle_deg, const Progress& progress) {
  const float flattest = elementary::cos(angle_deg * std::numbers::pi_v<float> / 180);
  std::vector<Side> first(edges.count());
  std::vector<std::uint8_t> sharp(edges.count());
  reported_for(mesh.triangle_count(), progress.part(0, 0.9), [&](std::size_t t) {
    const Triangle& triangle = mesh.triangles[t];
    const Vec3 normal = triangle_normal(mesh, triangle);
    for (std::size_t m = 0; m < 3; ++m) {
      const Index edge = edges.of_triangle[t][m];
      const bool forward = triangle[m] < triangle[(m + 1) % 3];
      if (edges.triangle_counts[edge] != 2) {
        sharp[edge] = 1;
      } else if (edges.ranks[t][m] == 0) {
        first[edge] = {normal, forward};
      } else {
        // Wound alike, two triangles run along their edge in opposite ways.
        const float cosine = first[edge].normal.dot(normal);
        sharp[edge] = (forward == first[edge].forward ? -cosine : cosine) < flattest;
      }
    }
  });
  progress.report(0.9);
  std::vector<std::array<Index, 2>> features;
  for (std::size_t edge = 0; edge < edges.count(); ++edge) {
    if (sharp[edge]) features.push_back(edges.vertices[edge]);
  }
  return features;
}

}  // namespace brindle
