/// Measures of triangles and edges: areas, lengths, weights and features.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "brindle/geometry/topology.h"
#include "brindle/mesh.h"
#include "brindle/progress.h"
#include "brindle/types.h"

namespace brindle {

/// The area of a triangle, in squared units of length.
float triangle_area(const Mesh& mesh, const Triangle& triangle);

/// A third of the area of all triangles around each vertex; zero for a vertex without a triangle.
std::vector<float> vertex_areas(const Mesh& mesh);

/// Range of mean edge lengths; beyond it, squared areas leave the range of float.
inline constexpr double kShortestEdges = 1e-10;
inline constexpr double kLongestEdges = 1e9;

/// The total length of edges, each counted from both ends.
struct EdgeLengths {
  double sum = 0;
  std::size_t count = 0;

  EdgeLengths operator+(const EdgeLengths& other) const {
    return {sum + other.sum, count + other.count};
  }
};

/// Sums the edges to the neighbours of every vertex with a row in `neighborhood`.
EdgeLengths edge_lengths(std::span<const Vec3> positions, const Adjacency& neighborhood);

/// Throws Error, with the remedy, unless the mean edge length is between kShortestEdges and
/// kLongestEdges, all lengths are zero, or there are no edges.
void check_edge_lengths(const EdgeLengths& lengths);

/// Cotangent weights c of the directed edges of `neighborhood`: half the sum of the cotangents of
/// the opposite angles (Pinkall and Polthier 1993), over all triangles of the edge. Clamped to [0,
/// 10]: obtuse angles give 0, and slivers must not dominate. `neighborhood` is that of `mesh`, or
/// has some of its rows.
std::vector<float> edge_cotangents(const Mesh& mesh, const Adjacency& neighborhood,
                                   const Progress& progress = {});

/// 1/2 + c: the constant keeps edges opposite obtuse angles coupled.
std::vector<float> cotangent_weights(const Mesh& mesh, const Adjacency& neighborhood,
                                     const Progress& progress = {});

/// Ends of the edges that lie on a boundary, have more than two triangles, or bend by more than
/// `angle_deg` degrees (0: flat), for any winding. `edges` are those of the mesh.
std::vector<std::array<Index, 2>> feature_edges(const Mesh& mesh, const MeshEdges& edges,
                                                float angle_deg, const Progress& progress = {});

}  // namespace brindle
