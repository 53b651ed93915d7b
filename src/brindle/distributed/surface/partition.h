/// Partitions surfaces for ranks.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "brindle/communicator.h"
#include "brindle/data_arrays.h"
#include "brindle/distributed_surface.h"
#include "brindle/mesh.h"

namespace brindle {

/// The position of a cell of the cube of 2^16 cells per edge on a Hilbert curve (Skilling 2004).
/// Neighbours on the curve are neighbours in space.
std::uint64_t hilbert_place(std::array<std::uint32_t, 3> cell);

/// The rank of every triangle: `parts` equal numbers of triangles along a Hilbert curve.
std::vector<int> partition_by_curve(const Mesh& mesh, int parts);

/// A rank's triangles and vertices, with the numbers and in the order of `mesh`. Rank 0 gets
/// vertices without triangles.
SurfacePiece piece_of(const Mesh& mesh, std::span<const int> rank_of_triangle, int rank);

// Subdivision of distributed surfaces.

/// The result of `subdivide` on the whole surface: every rank has the triangles of its own ones.
/// Midpoints get the whole's numbers if vertices are numbered from 0 without gaps; otherwise,
/// numbers after the largest. Throws Error on all ranks, as `subdivide` does.
SurfacePiece subdivided_piece(Communicator& ranks, SurfacePiece piece, int times);

/// The same with the partition's arrays, as `subdivide` of mesh_data.h.
SurfacePiece subdivided_piece(Communicator& ranks, SurfacePiece piece, DataArrays& arrays,
                              int times);

}  // namespace brindle
