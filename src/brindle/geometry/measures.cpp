#include "brindle/geometry/measures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include <Eigen/Geometry>

#include "brindle/base/elementary.h"
#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/normals.h"

namespace brindle {
namespace {

constexpr float kLargestCotangent = 10;

/// Cotangent of the angle at `apex` between the directions to a and b; zero without an area.
float cotangent(const Vec3& apex, const Vec3& a, const Vec3& b) {
  const Vec3 u = a - apex, v = b - apex;
  const float sine = u.cross(v).norm();
  return sine > 0 ? u.dot(v) / sine : 0;
}

/// Half the cotangents of all angles, three per triangle.
std::vector<float> half_cotangents(const Mesh& mesh, const Progress& progress) {
  std::vector<float> halves(3 * mesh.triangle_count());
  parallel_for(mesh.triangle_count(), progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const Triangle& corners = mesh.triangles[t];
      for (int m = 0; m < 3; ++m) {
        halves[3 * t + m] =
            0.5f * cotangent(mesh.positions[corners[m]], mesh.positions[corners[(m + 1) % 3]],
                             mesh.positions[corners[(m + 2) % 3]]);
      }
    }
  });
  return halves;
}

/// One triangle of an edge.
struct Side {
  Vec3 normal = Vec3::Zero();
  bool forward = false;  ///< runs from the edge's lower vertex to its higher one
};

}  // namespace

float triangle_area(const Mesh& mesh, const Triangle& triangle) {
  const Vec3& a = mesh.positions[triangle[0]];
  return 0.5f * (mesh.positions[triangle[1]] - a).cross(mesh.positions[triangle[2]] - a).norm();
}

std::vector<float> vertex_areas(const Mesh& mesh) {
  std::vector<float> areas(mesh.vertex_count());
  for (const Triangle& triangle : mesh.triangles) {
    const float third = triangle_area(mesh, triangle) / 3;
    for (const Index vertex : triangle) areas[vertex] += third;
  }
  return areas;
}

EdgeLengths edge_lengths(std::span<const Vec3> positions, const Adjacency& neighborhood) {
  const auto body = [&](std::size_t begin, std::size_t end) {
    EdgeLengths lengths;
    for (auto v = static_cast<Index>(begin); v < end; ++v) {
      const Eigen::Vector3d from = positions[v].cast<double>();
      for (const Index neighbor : neighborhood.of(v)) {
        lengths.sum += (positions[neighbor].cast<double>() - from).norm();
        ++lengths.count;
      }
    }
    return lengths;
  };
  return parallel_sum<EdgeLengths>(neighborhood.node_count(), body);
}

void check_edge_lengths(const EdgeLengths& lengths) {
  if (!(lengths.sum > 0)) return;
  const double mean = lengths.sum / static_cast<double>(lengths.count);
  if (mean >= kShortestEdges && mean <= kLongestEdges) return;
  throw Error(formatted(
      "surface: neighbours are %.2g units apart on average, too %s for numbers of single "
      "precision, "
      "which need %.2g to %.2g; give coordinates in other units, such as multiplied by 1e%d",
      mean, mean < 1 ? "near" : "far", kShortestEdges, kLongestEdges,
      -static_cast<int>(std::floor(std::log10(mean)))));
}

std::vector<float> edge_cotangents(const Mesh& mesh, const Adjacency& neighborhood,
                                   const Progress& progress) {
  const std::vector<float> halves = half_cotangents(mesh, progress.part(0, 0.4));
  const VertexTriangles around = vertex_triangles(mesh, progress.part(0.4, 0.6));
  std::vector<float> sums(neighborhood.directed_edge_count());
  const auto add_to_row = [&](Index vertex, std::size_t triangle) {
    const Triangle& corners = mesh.triangles[triangle];
    const auto row = neighborhood.of(vertex);
    for (int m = 0; m < 3; ++m) {
      if (corners[m] == vertex) continue;
      // The angle opposite the edge is at the third corner.
      const int opposite = corners[(m + 1) % 3] == vertex ? (m + 2) % 3 : (m + 1) % 3;
      const auto place = ranges::lower_bound(row, corners[m]);
      if (place == row.end() || *place != corners[m]) continue;
      sums[neighborhood.offsets[vertex] + static_cast<std::size_t>(place - row.begin())] +=
          halves[3 * triangle + opposite];
    }
  };
  parallel_for(
      neighborhood.node_count(), progress.part(0.6, 1), [&](std::size_t begin, std::size_t end) {
        for (Index v = static_cast<Index>(begin); v < end; ++v) {
          for (const Index t : around.of(v)) add_to_row(v, t);
          const auto first = sums.begin() + neighborhood.offsets[v];
          const auto last = sums.begin() + neighborhood.offsets[v + 1];
          std::transform(first, last, first,
                         [](float sum) { return std::clamp(sum, 0.0f, kLargestCotangent); });
        }
      });
  return sums;
}

std::vector<float> cotangent_weights(const Mesh& mesh, const Adjacency& neighborhood,
                                     const Progress& progress) {
  std::vector<float> weights = edge_cotangents(mesh, neighborhood, progress);
  for (float& weight : weights) weight += 0.5f;
  return weights;
}

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
      if (edges.triangle_count(edge) != 2) {
        sharp[edge] = 1;
      } else if (edges.half_edges.of(edge)[0] == 3 * t + m) {
        first[edge] = {normal, forward};
      } else {
        // With equal winding, two triangles traverse their edge in opposite directions.
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
