/// Sharp edges of a mesh, along which a vertex has a wave for each side.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "brindle/data_arrays.h"
#include "brindle/export.h"
#include "brindle/mesh.h"
#include "brindle/progress.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// The bend in degrees from which an edge may be a crease.
inline constexpr float kCreaseAngle = 40;

/// An edge on a crease, with the same two ends as seen from the triangles on both its sides: at
/// each end two copies of a vertex, or twice the same where a crease runs out and nothing was
/// split.
struct CreaseEdge {
  std::array<Index, 2> first;
  std::array<Index, 2> second;
};

/// What `split_at_creases` did to a mesh. Empty where nothing is sharp.
struct Creases {
  /// For each vertex that was added, in order, the one that it is a copy of.
  std::vector<Index> copied;
  std::vector<CreaseEdge> edges;

  bool empty() const { return copied.empty(); }
  /// The vertex before the split, of a mesh that has `vertex_count` now.
  Index original(Index vertex, std::size_t vertex_count) const {
    const std::size_t own = vertex_count - copied.size();
    return vertex < own ? vertex : copied[vertex - own];
  }
};

/// Gives every vertex whose triangles fall into several smooth sectors, parted by creases, a vertex
/// for each sector: the first keeps its number, the others are added behind all vertices. So a
/// corner of a box has three normals and three waves. Triangles keep their numbers.
///
/// A crease is an edge of two triangles that bend by more than `angle_deg` degrees (0 to 180; 180:
/// none), also when each side is averaged over the triangles near by, so that noise is none, and
/// that is part of a chain which closes or runs from boundary to boundary. Edges of three triangles
/// or more part those that bend by more. Throws Error for another angle and for a mesh that
/// `check_mesh` refuses, and Cancelled if `progress` asks for it.
Creases split_at_creases(Mesh& mesh, float angle_deg = kCreaseAngle, const Progress& progress = {});

/// The same mesh with triangles between the vertices from before the split; copies stay, in none.
Mesh joined_mesh(const Mesh& mesh, const Creases& creases);

/// A row for every vertex that was added: that of the vertex which it is a copy of. A list without
/// rows stays so.
template <class Row>
void add_rows_of_copies(const Creases& creases, std::vector<Row>& rows) {
  if (rows.empty()) return;
  rows.reserve(rows.size() + creases.copied.size());
  for (const Index vertex : creases.copied) rows.push_back(rows[vertex]);
}

/// The same for all arrays with a row per vertex.
void add_rows_of_copies(const Creases& creases, DataArrays& arrays);

}  // namespace brindle
