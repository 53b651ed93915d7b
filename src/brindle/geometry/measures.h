/// Measures of triangles and edges: areas, lengths, weights, and where the surface is sharp.
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

/// The mean lengths of edges that floats can work with: squares of areas of what is smaller or
/// larger leave the range of float.
inline constexpr double kShortestEdges = 1e-10;
inline constexpr double kLongestEdges = 1e9;

/// The lengths of edges together, each counted from both ends.
struct EdgeLengths {
  double sum = 0;
  std::size_t count = 0;

  EdgeLengths operator+(const EdgeLengths& other) const {
    return {sum + other.sum, count + other.count};
  }
};

/// Of the edges to the neighbours of every vertex that has a row in `neighborhood`.
EdgeLengths edge_lengths(std::span<const Vec3> positions, const Adjacency& neighborhood);

/// Throws Error, with the remedy, unless edges are between kShortestEdges and kLongestEdges long on
/// average, or all have no length, or there are none.
void check_edge_lengths(const EdgeLengths& lengths);

/// Weights of edges by the shape of the triangles: c for every directed edge of `neighborhood`:
/// half the sum of the cotangents of the angles opposite the edge (Pinkall and Polthier 1993),
/// taken over all its triangles; between 0, where angles are obtuse, and 10, where slivers would
/// drown the rest. `neighborhood` is that of `mesh`, or has some of its rows.
std::vector<float> edge_cotangents(const Mesh& mesh, const Adjacency& neighborhood,
                                   const Progress& progress = {});

/// 1/2 + c: the constant keeps edges across obtuse angles alive.
std::vector<float> cotangent_weights(const Mesh& mesh, const Adjacency& neighborhood,
                                     const Progress& progress = {});

/// The two ends of every edge that lies on a boundary, has more than two triangles, or between
/// whose triangles the surface bends by more than `angle_deg` degrees (0: flat; however they are
/// wound). `edges` are those of the mesh.
std::vector<std::array<Index, 2>> feature_edges(const Mesh& mesh, const MeshEdges& edges,
                                                float angle_deg, const Progress& progress = {});

}  // namespace brindle
