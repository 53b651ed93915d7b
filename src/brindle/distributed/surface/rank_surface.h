/// A rank's part of a distributed surface.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "brindle/distributed/levels/rank_graph.h"
#include "brindle/distributed_surface.h"

namespace brindle {

/// Vertex order: the rank's own vertices, as in its partition; ghosts, their neighbours that other
/// ranks own; then the partition's other vertices, which other ranks own and which only results
/// need. Own vertices and ghosts are the nodes of `graph`. A single rank keeps the order of its
/// partition.
struct RankSurface {
  /// a pointer, so that const functions can communicate
  std::unique_ptr<Communicator> ranks;
  Mesh mesh;                   ///< own triangles
  std::vector<Triangle> ring;  ///< triangles of other ranks around own vertices
  std::vector<Vec3> normals;   ///< by vertex
  RankGraph graph;
  NodeHalo rest;                                ///< owners of the rest of the vertices
  std::vector<Index> vertex_of_piece;           ///< for every vertex of the partition
  std::vector<std::uint64_t> piece_ids;         ///< global numbers
  std::vector<Index> triangle_of_piece;         ///< number in the partition of every own triangle
  std::vector<std::uint64_t> triangle_numbers;  ///< global numbers of own triangles, or empty
  std::size_t piece_triangles = 0;              ///< of the partition, including ghosts
  std::vector<Vec3> piece_normals;              ///< by vertex of the partition
  std::vector<std::uint8_t> piece_is_own;
  std::size_t vertices = 0, triangles = 0, edges = 0;  ///< over all ranks
  Creases creases;                                     ///< as in SurfacePiece
  std::size_t crease_vertices = 0;                     ///< copies, over all ranks
  double diagonal = 0;

  std::size_t vertex_count() const { return mesh.vertex_count(); }

  /// Sets the values of all vertices of other ranks.
  template <class T>
  void exchange_all(std::span<T> by_vertex) const {
    exchange(*ranks, graph.halo, by_vertex);
    exchange(*ranks, rest, by_vertex);
  }

  /// Copies values in the order of the partition, if there are any, to own vertices.
  template <class T>
  void copy_to_own(std::span<const T> of_piece, std::span<T> own) const {
    for (std::size_t p = 0; p < of_piece.size(); ++p) {
      const Index v = vertex_of_piece[p];
      if (v < graph.own) own[v] = of_piece[p];
    }
  }

  /// Values in the order of the partition.
  template <class T>
  std::vector<T> to_piece(std::span<const T> by_vertex) const {
    std::vector<T> result;
    result.reserve(vertex_of_piece.size());
    for (const Index v : vertex_of_piece) result.push_back(by_vertex[v]);
    return result;
  }

  /// By vertex of the partition: 1 for own vertices that have neighbours.
  std::vector<std::uint8_t> used_own() const {
    std::vector<std::uint8_t> used;
    for (const Index v : vertex_of_piece) {
      used.push_back(v < graph.own && !graph.adjacency->of(v).empty() ? 1 : 0);
    }
    return used;
  }
};

/// The global numbers of vertices; 0 for those outside the partition.
std::vector<std::uint64_t> known_ids(const RankSurface& surface);

/// All triangles around own vertices: own triangles, then the ring's. A single rank has those of
/// its partition.
Mesh triangles_around_own(const RankSurface& surface);

}  // namespace brindle
