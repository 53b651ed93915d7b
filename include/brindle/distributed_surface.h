/// A surface partitioned over processes (docs/distributed.md). Needs a build with BRINDLE_MPI.
///
/// A process is a rank of an MPI communicator. All ranks must call collective functions in the same
/// order. An Error on one rank is thrown on all, so that none waits for it. MPI is called from the
/// calling thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

// Only the C interface, without MPI's former C++ bindings.
#ifndef OMPI_SKIP_MPICXX
#define OMPI_SKIP_MPICXX 1
#endif
#ifndef MPICH_SKIP_MPICXX
#define MPICH_SKIP_MPICXX 1
#endif
#include <mpi.h>

#include "brindle/creases.h"
#include "brindle/data_arrays.h"
#include "brindle/direction_field.h"
#include "brindle/export.h"
#include "brindle/mesh.h"
#include "brindle/progress.h"
#include "brindle/smooth_field.h"

namespace BRINDLE_EXPORT brindle {

class Communicator;
struct RankSurface;

/// One rank's partition. It may be empty, of any topology, and have several components.
struct SurfacePiece {
  Mesh mesh;  ///< `origin` must be the same on all ranks
  /// One per vertex: ranks share a vertex exactly if its numbers are equal. Any numbers may be
  /// used, each once per partition.
  std::vector<std::uint64_t> vertex_ids;
  /// One per triangle: 1 for a ghost, which belongs to another rank, as in visualisation programs;
  /// empty: none. Every triangle belongs to exactly one rank.
  std::vector<std::uint8_t> ghost_triangles;
  /// One per triangle: its number in the whole, on all ranks or on none. Sums around vertices
  /// follow these numbers. Normals are therefore bit-identical to those of `make_surface` on the
  /// whole, also at borders. Empty: triangles are numbered rank by rank.
  std::vector<std::uint64_t> triangle_ids = {};
  /// From `split_at_creases`: on rank 0 those of the whole, whose vertices are in the order of
  /// their numbers; empty on other ranks.
  Creases creases = {};
};

/// Collective. 1 for every triangle of the partition that repeats another one: with the same three
/// vertices, in any order, on a lower rank or earlier in the partition; otherwise 0. Dropping these
/// leaves one of each over all ranks, as `repair_mesh` does in one process. Ghosts do not count.
/// Throws Error on all ranks for a partition that a DistributedSurface would reject by itself.
std::vector<std::uint8_t> repeated_triangles(const SurfacePiece& piece, MPI_Comm communicator);

/// Collective. The result of `cells_to_points` on the whole surface, at the partition's vertices:
/// means over the triangles of all ranks but ghosts, with the bits of the whole if triangles are
/// numbered. All ranks have the same number of components. Throws Error on all ranks unless there
/// is a row per triangle.
DataArray cells_to_points(Communicator& ranks, const SurfacePiece& piece, const DataArray& cells);

/// Data sent by a rank, and its time waiting for others.
struct Traffic {
  std::uint64_t bytes = 0;  ///< of messages to single ranks; sums over all ranks add few
  std::uint64_t messages = 0;
  double waiting_milliseconds = 0;

  Traffic since(const Traffic& before) const {
    return {bytes - before.bytes, messages - before.messages,
            waiting_milliseconds - before.waiting_milliseconds};
  }
};

/// Owners of vertices, and the data that ranks need of each other, once per connectivity. The
/// lowest rank with a vertex in a triangle of its own owns it. Copies share these data.
class DistributedSurface {
 public:
  /// Collective. Finds the neighbourhood of the partition on other ranks; given ghosts are neither
  /// needed nor used. Throws Error for inconsistent partitions: missing or repeated numbers, and
  /// triangles and positions that `make_surface` rejects.
  DistributedSurface(SurfacePiece piece, MPI_Comm communicator);

  /// Unit normals of the partition's vertices, or zero, as in `make_surface` of the whole.
  std::span<const Vec3> normals() const;

  /// 1 for vertices of the partition that this rank owns.
  std::span<const std::uint8_t> is_own() const;

  /// Of the whole surface, on every rank. An edge on a crease counts once.
  std::size_t vertex_count() const;
  std::size_t own_vertex_count() const;  ///< before creases split any
  std::size_t triangle_count() const;
  std::size_t edge_count() const;
  double diagonal() const;  ///< of the bounding box of all vertices in triangles

  /// Traffic of this rank for all work with this surface.
  const Traffic& traffic() const;

  /// For the library itself.
  const RankSurface& rank_surface() const {
    if (surface_ == nullptr) refuse_moved_from();
    return *surface_;
  }
  std::shared_ptr<const RankSurface> shared() const {
    if (surface_ == nullptr) refuse_moved_from();
    return surface_;
  }

 private:
  std::shared_ptr<const RankSurface> surface_;
};

/// Collective. Splits the partition that `surface` was made from, as `split_at_creases` does with
/// the whole. Copies follow all vertices, with numbers above all others. If any edge is sharp, rank
/// 0 gathers the whole. Returns for each copy the vertex that it copies, or nullopt on all ranks if
/// there are no creases. Throws Error on all ranks for an angle out of range.
std::optional<std::vector<Index>> split_at_creases(const DistributedSurface& surface,
                                                   SurfacePiece& piece,
                                                   float angle_deg = kCreaseAngle);

// Rank 0 computes fields on the gathered surface, and needs memory for it. They have the bits of
// one process if triangles have numbers.

/// Collective. `smooth_direction_field` of the whole, at the vertices of the partition. Anchors and
/// the last field refer to the partition's vertices; the owner's values of a vertex count. Throws
/// Error on all ranks, as that does.
DirectionField smooth_direction_field(const DistributedSurface& surface,
                                      const SmoothFieldOptions& options = {});

/// Collective. `stroke_anchors` of strokes.h for the whole surface, at the vertices of the
/// partition; all ranks pass the same strokes. Throws Error on all ranks, as that does.
std::vector<FieldAnchor> stroke_anchors(const DistributedSurface& surface,
                                        std::span<const FieldStroke> strokes);

/// Collective. `feature_strokes` of strokes.h for the whole surface, on all ranks.
std::vector<FieldStroke> feature_strokes(const DistributedSurface& surface, float angle_deg,
                                         double radius, double strength);

/// Collective. The principal curvature directions of the piece's vertices.
DirectionField curvature_direction_field(const DistributedSurface& surface,
                                         CurvatureDirection direction);

/// Collective. The maximum principal curvature at the partition's vertices, as in
/// `principal_curvatures` of the whole; NaN where there is none.
std::vector<float> greatest_curvatures(const DistributedSurface& surface);

}  // namespace brindle
