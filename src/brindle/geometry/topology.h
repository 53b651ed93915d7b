/// Adjacency of vertices, edges and triangles, for meshes of any topology.
///
/// Edge m of triangle t runs from corner m to the next one. It is also called half-edge 3 t + m,
/// which starts at corner 3 t + m.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "brindle/base/compressed_rows.h"
#include "brindle/mesh.h"
#include "brindle/progress.h"
#include "brindle/types.h"

namespace brindle {

/// Marks a missing triangle.
inline constexpr Index kNoTriangle = std::numeric_limits<Index>::max();

/// The next half-edge, or corner, of the same triangle, and the one before.
inline Index next_in_triangle(Index half_edge) {
  return half_edge % 3 == 2 ? half_edge - 2 : half_edge + 1;
}
inline Index previous_in_triangle(Index half_edge) {
  return half_edge % 3 == 0 ? half_edge + 2 : half_edge - 1;
}

/// The vertex at corner 3 t + m.
inline Index vertex_at(std::span<const Triangle> triangles, Index corner) {
  return triangles[corner / 3][corner % 3];
}

/// A row per vertex: the triangles that use it, in ascending order.
using VertexTriangles = CompressedRows<Index>;

/// Throws Error if the mesh has more corners than an Index can count, and Cancelled if `progress`
/// asks for it.
VertexTriangles vertex_triangles(const Mesh& mesh, const Progress& progress = {});

/// The neighbourhood N(i) of every vertex: two vertices are neighbours if a triangle has them both.
/// An edge that any number of triangles share counts once; vertices without a triangle have no
/// neighbours.
Adjacency vertex_neighborhood(const Mesh& mesh, const Progress& progress = {});

/// The same, with the result of `vertex_triangles`.
Adjacency vertex_neighborhood(const Mesh& mesh, const VertexTriangles& around,
                              const Progress& progress = {});

/// The edges of a mesh, each once, sorted by higher vertex, then by lower one.
struct MeshEdges {
  std::vector<std::array<Index, 2>> vertices;     ///< the two ends, the lower number first
  std::vector<std::array<Index, 3>> of_triangle;  ///< edge numbers of every triangle
  CompressedRows<Index> half_edges;               ///< of every edge, in ascending order

  std::size_t count() const { return vertices.size(); }

  /// 1 at a boundary, 2 inside.
  Index triangle_count(Index edge) const {
    return half_edges.offsets[edge + 1] - half_edges.offsets[edge];
  }
  /// The first two triangles of an edge; `kNoTriangle` where there is only one.
  std::array<Index, 2> triangles(Index edge) const {
    const std::span<const Index> along = half_edges.of(edge);
    return {along.empty() ? kNoTriangle : along[0] / 3,
            along.size() < 2 ? kNoTriangle : along[1] / 3};
  }
  /// The triangle on the other side of edge `m`; `kNoTriangle` unless there is exactly one.
  Index beyond(Index triangle, int m) const {
    const Index edge = of_triangle[triangle][m];
    if (triangle_count(edge) != 2) return kNoTriangle;
    const std::span<const Index> along = half_edges.of(edge);
    return along[along[0] == 3 * triangle + static_cast<Index>(m) ? 1 : 0] / 3;
  }
  /// The edge between two neighbours, in any order.
  Index between(Index a, Index b) const;
};

/// `neighborhood` is the mesh's own (`vertex_neighborhood`).
MeshEdges mesh_edges(const Mesh& mesh, const Adjacency& neighborhood,
                     const Progress& progress = {});

/// An edge in two of its triangles. The corners `from[0]` and `from[1]` are at one vertex, `to[0]`
/// and `to[1]` at the other; [0] is of the triangle with the lower number.
struct SharedEdge {
  std::array<Index, 2> from;
  std::array<Index, 2> to;
};

/// All edges that two triangles or more share, in ascending order of their lower vertex, then of
/// their higher one. An edge of k triangles gives k - 1 entries, each with the next triangle, so
/// that all of them are linked. Throws Error if there are more corners than an Index can count.
std::vector<SharedEdge> shared_edges(std::span<const Triangle> triangles,
                                     const Progress& progress = {});

/// Marks a missing twin: there is none, or more than one.
inline constexpr Index kNoTwin = 0xffffffff;
inline constexpr Index kManyTwins = 0xfffffffe;

/// For every half-edge the one along the same edge in another triangle, whichever way it runs.
std::vector<Index> twins_of(std::span<const Triangle> triangles, const Progress& progress = {});

/// The twins of a closed, consistently wound manifold, else nullopt. Every edge has two triangles
/// that traverse it in opposite directions, every vertex one fan.
std::optional<std::vector<Index>> manifold_twins(const Mesh& mesh, const Progress& progress = {});

/// For every triangle the first one with the same corners in any order: itself unless repeated.
std::vector<Index> first_with_same_corners(const Mesh& mesh);

}  // namespace brindle
