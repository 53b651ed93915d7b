/// What a rank knows of a surface that all ranks hold together.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "brindle/distributed/levels/rank_graph.h"
#include "brindle/distributed_surface.h"

namespace brindle {

/// Vertices here are numbered: first the rank's own, as in its piece, then ghosts, the neighbours
/// of these that other ranks own, then the rest of the piece's vertices, which other ranks own and
/// this one needs only in the end. Own and ghosts are the nodes of `graph`. One rank's vertices are
/// those of its piece.
struct RankSurface {
  /// Messages change nothing that a user sees.
  std::unique_ptr<Communicator> ranks;
  Mesh mesh;                   ///< own triangles
  std::vector<Triangle> ring;  ///< those of other ranks around own vertices
  std::vector<Vec3> normals;   ///< by vertex
  RankGraph graph;
  NodeHalo rest;                                ///< owners of the rest of the vertices
  std::vector<Index> vertex_of_piece;           ///< for every vertex of the piece
  std::vector<std::uint64_t> piece_ids;         ///< their numbers in the whole
  std::vector<Index> triangle_of_piece;         ///< number in the piece of every own triangle
  std::vector<std::uint64_t> triangle_numbers;  ///< of own triangles in the whole, or none
  std::size_t piece_triangles = 0;              ///< of the piece, ghosts included
  std::vector<Vec3> piece_normals;              ///< by vertex of the piece
  std::vector<std::uint8_t> piece_is_own;
  std::size_t vertices = 0, triangles = 0, edges = 0;  ///< of all ranks
  double diagonal = 0;

  std::size_t vertex_count() const { return mesh.vertex_count(); }

  /// Sets the values of all vertices of other ranks.
  template <class T>
  void exchange_all(std::span<T> by_vertex) const {
    exchange(*ranks, graph.halo, by_vertex);
    exchange(*ranks, rest, by_vertex);
  }

  /// Values in the order of the piece.
  template <class T>
  std::vector<T> to_piece(std::span<const T> by_vertex) const {
    std::vector<T> result;
    result.reserve(vertex_of_piece.size());
    for (const Index v : vertex_of_piece) result.push_back(by_vertex[v]);
    return result;
  }
};

/// The numbers of vertices in the whole; 0 for those that are not of the piece.
std::vector<std::uint64_t> known_ids(const RankSurface& surface);

/// All triangles around own vertices, in the order of own triangles and then the ring's; one rank
/// has those of its piece.
Mesh triangles_around_own(const RankSurface& surface);

}  // namespace brindle
