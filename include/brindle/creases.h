/// Sharp edges of a mesh, where a vertex has one wave for each side.
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

/// Default bend in degrees from which an edge may be a crease.
inline constexpr float kCreaseAngle = 40;

/// An edge on a crease, with its two ends as seen from the triangles on both sides. An end is two
/// copies of a vertex or, where a crease ends without a split, the same vertex twice.
struct CreaseEdge {
  std::array<Index, 2> first;
  std::array<Index, 2> second;
};

/// The result of `split_at_creases`. Empty if the mesh has no crease.
struct Creases {
  /// For each added vertex, in order, the vertex that it copies.
  std::vector<Index> copied;
  std::vector<CreaseEdge> edges;

  bool empty() const { return copied.empty(); }
  /// The vertex before the split, in a mesh that now has `vertex_count` vertices.
  Index original(Index vertex, std::size_t vertex_count) const {
    const std::size_t own = vertex_count - copied.size();
    return vertex < own ? vertex : copied[vertex - own];
  }
};

/// Splits every vertex whose triangles form several smooth sectors, separated by creases, into one
/// vertex per sector. The first keeps its number; the others are appended. A corner of a box thus
/// has three normals and three waves. Triangles keep their numbers.
///
/// A crease is an edge of two triangles that bend by more than `angle_deg` degrees (0 to 180; 180:
/// none). To exclude noise, the bend must remain when each side is averaged over nearby triangles.
/// The edge must belong to a chain of at least 20 edges, to one that runs from boundary to
/// boundary, or to a closed one between faces that are flat or as coarse as the chain. Edges of
/// three or more triangles separate those that bend by more. Throws Error for another angle and for
/// a mesh that `check_mesh` rejects, and Cancelled if `progress` cancels.
Creases split_at_creases(Mesh& mesh, float angle_deg = kCreaseAngle, const Progress& progress = {});

/// The same mesh with triangles between the original vertices; copies stay, unreferenced.
Mesh joined_mesh(const Mesh& mesh, const Creases& creases);

/// Appends a row for every added vertex: that of the vertex it copies. An empty list stays empty.
template <class Row>
void add_rows_of_copies(const Creases& creases, std::vector<Row>& rows) {
  if (rows.empty()) return;
  rows.reserve(rows.size() + creases.copied.size());
  for (const Index vertex : creases.copied) rows.push_back(rows[vertex]);
}

/// As above for all arrays with a row per vertex.
void add_rows_of_copies(const Creases& creases, DataArrays& arrays);

}  // namespace brindle
