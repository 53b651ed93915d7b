/// A surface that many processes hold together, each a piece of it (docs/distributed.md). Needs a
/// build with BRINDLE_MPI.
///
/// A process is a rank of an MPI communicator. What is said to be collective must be called by all
/// ranks of it, in the same order. An Error that one rank has is thrown by all, so that none waits
/// for it; MPI is called from the thread that calls.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

// C alone, without the C++ that MPI once had.
#ifndef OMPI_SKIP_MPICXX
#define OMPI_SKIP_MPICXX 1
#endif
#ifndef MPICH_SKIP_MPICXX
#define MPICH_SKIP_MPICXX 1
#endif
#include <mpi.h>

#include "brindle/direction_field.h"
#include "brindle/export.h"
#include "brindle/measured_field.h"
#include "brindle/mesh.h"
#include "brindle/progress.h"
#include "brindle/smooth_field.h"

namespace BRINDLE_EXPORT brindle {

struct RankSurface;

/// One rank's piece. It may be empty, of any topology, and in parts.
struct SurfacePiece {
  Mesh mesh;  ///< `origin` must be the same on all ranks
  /// One per vertex: vertices of several ranks are the same exactly if their numbers are. Any
  /// numbers will do, each once in a piece.
  std::vector<std::uint64_t> vertex_ids;
  /// One per triangle: 1 if it is another rank's and only here to be seen, as visualisation
  /// programs have layers of ghosts; empty: none. Every triangle is one rank's alone.
  std::vector<std::uint8_t> ghost_triangles;
  /// One per triangle: its number in the whole, on all ranks or on none. Normals then have the bits
  /// that `make_surface` gives the whole, also at borders, as sums around vertices are made in the
  /// order of these numbers; empty: triangles count as numbered rank by rank.
  std::vector<std::uint64_t> triangle_ids = {};
};

/// Collective. For every triangle of the piece 1 if it stands elsewhere already: with the same
/// three vertices, in whatever order, on a lower rank, or before it in the piece; otherwise 0. So
/// of the triangles that ranks have together one of each is left, as `repair_mesh` leaves of one
/// process's. Ghosts do not count. Throws Error on all ranks for a piece that a DistributedSurface
/// would refuse by itself.
std::vector<std::uint8_t> repeated_triangles(const SurfacePiece& piece, MPI_Comm communicator);

/// What a rank has sent to others, and how long it has waited for them.
struct Traffic {
  std::uint64_t bytes = 0;  ///< messages to single ranks; few more are for sums over all
  std::uint64_t messages = 0;
  double waiting_milliseconds = 0;

  Traffic since(const Traffic& before) const {
    return {bytes - before.bytes, messages - before.messages,
            waiting_milliseconds - before.waiting_milliseconds};
  }
};

/// Who owns which vertex, and what ranks need of each other, once per connectivity. A vertex is
/// owned by the lowest rank that has it in a triangle of its own. Copies share all this.
class DistributedSurface {
 public:
  /// Collective. Finds what lies around the piece's vertices on other ranks: ghosts that were given
  /// are not needed, and not used. Throws Error for pieces that do not fit together: numbers that
  /// are missing or double, triangles and positions as `make_surface` refuses them.
  DistributedSurface(SurfacePiece piece, MPI_Comm communicator);

  /// Unit normals of the piece's vertices, or zero, as `make_surface` has them of the whole.
  std::span<const Vec3> normals() const;

  /// Which of the piece's vertices this rank owns.
  std::span<const std::uint8_t> is_own() const;

  /// Of the whole surface, on every rank.
  std::size_t vertex_count() const;
  std::size_t triangle_count() const;
  std::size_t edge_count() const;
  double diagonal() const;  ///< of the box around all vertices that triangles use

  /// What this rank has sent in all that was done with this surface.
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

// Fields of a surface in pieces are found by rank 0, which gets the whole surface and needs room
// for it. They have the bits of one process where triangles have numbers.

/// Collective. What `smooth_direction_field` finds for the whole, at the vertices of the piece.
/// Anchors and the last field are those of vertices of the piece; what counts is what a vertex's
/// owner has. Throws Error on all ranks, as that does.
DirectionField smooth_direction_field(const DistributedSurface& surface,
                                      const SmoothFieldOptions& options = {});

/// Collective. The anchors that `stroke_anchors` of strokes.h makes for the whole surface, at the
/// vertices of the piece; all ranks have the same strokes. Throws Error on all ranks, as that does.
std::vector<FieldAnchor> stroke_anchors(const DistributedSurface& surface,
                                        std::span<const FieldStroke> strokes);

/// Collective. The strokes that `feature_strokes` of strokes.h makes of the whole surface, on all
/// ranks.
std::vector<FieldStroke> feature_strokes(const DistributedSurface& surface, float angle_deg,
                                         double radius, double strength);

/// A field at the scale of its stripes.
struct DistributedDetail {
  DetailedField field;         ///< of the piece's vertices
  FieldDetailFigures figures;  ///< of the whole, on every rank
};

/// Collective. What a FieldDetail makes of the whole's field. `measured` has a datum per vertex of
/// the piece, where what counts is what the owner has, or per triangle, ghosts among them, which do
/// not count; `frequencies` and `last`, on all ranks or none, one per vertex. Throws on all ranks
/// what FieldDetail throws, and Error for other numbers of entries; Cancelled if the `progress` of
/// a rank asks for it.
DistributedDetail detailed_field(const DistributedSurface& surface, const MeasuredField& measured,
                                 std::span<const float> frequencies,
                                 const FieldDetailOptions& options = {},
                                 const MeasuredField& last = {}, const Progress& progress = {});

/// Collective. The same of frequencies: what `detailed_frequencies` of measured_field.h makes of
/// those of the whole.
DetailedFrequencies detailed_frequencies(const DistributedSurface& surface,
                                         std::span<const float> frequencies,
                                         const FrequencyDetailOptions& options = {},
                                         const Progress& progress = {});

/// Collective. The principal curvature directions of the piece's vertices.
DirectionField curvature_direction_field(const DistributedSurface& surface,
                                         CurvatureDirection direction);

/// Collective. The greater principal curvature at the piece's vertices, as `principal_curvatures`
/// has it of the whole; NaN where there is none.
std::vector<float> greatest_curvatures(const DistributedSurface& surface);

}  // namespace brindle
