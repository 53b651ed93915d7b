/// Cross fields: two linked waves per vertex, a quarter turn apart (paper, 3.6).
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "brindle/export.h"
#include "brindle/mesh.h"
#include "brindle/phase_graph.h"
#include "brindle/progress.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// The double cover of a surface, on which a cross field is a line field (Kälberer et al. 2007).
/// Wave r of the cross at vertex i, r = 0 or 1, is node 2 i + r. Each edge of the surface joins (i,
/// r) to the wave of j with the smallest turn, and the other two waves to each other. The phase
/// graph of the cover is `build_phase_graph(neighborhood, waves)`, as on a mesh with one wave per
/// vertex.
struct CrossCover {
  WaveSet waves;                                  ///< one wave per node
  std::shared_ptr<const Adjacency> neighborhood;  ///< of the nodes

  /// For every triangle of `base`, in its order, the nodes of one of its two waves, U; then, again
  /// for every triangle, those of the other, V. A cross does not distinguish U from V, so they may
  /// be swapped between triangles.
  std::vector<Triangle> triangles;
  std::vector<Index> base;  ///< triangles of the surface around which crosses match

  /// All other triangles, in ascending order: around them U becomes V. They are the singularities
  /// of the cross field, of index 1/4 or -1/4; larger ones consist of several triangles.
  std::vector<Index> singular;

  std::span<const Triangle> u() const { return std::span(triangles).first(base.size()); }
  std::span<const Triangle> v() const { return std::span(triangles).last(base.size()); }
};

/// The other wave of a node's cross.
inline Index other_wave(Index node) { return node ^ 1u; }

/// Both waves of every vertex: the given one, and the same turned by 90 degrees about the normal.
/// All lists have one entry per vertex; directions are unit tangent vectors or zero. A vertex with
/// a zero normal has no waves.
WaveSet cross_waves(const WaveSet& waves, std::span<const Vec3> normals);

/// The m in {0, 1} for which wave (i, 0) matches (j, m) and (i, 1) matches (j, 1 - m): the pairing
/// that turns the cross by less than 45 degrees after parallel transport from i to j. Symmetric in
/// i and j.
Index matching_wave(const WaveSet& crosses, Index i, Index j);

/// Whether `crosses`, other waves of the same vertices, match along all edges as in the cover, so
/// that the cover is theirs except for `waves`.
bool are_matched_alike(const Adjacency& neighborhood, const WaveSet& crosses,
                       const CrossCover& cover);

/// Builds the double cover. `crosses` has two waves for every vertex of `neighborhood`, as from
/// `cross_waves`. Throws Error if sizes do not match or exceed half the range of Index; Cancelled
/// if `progress` cancels.
CrossCover cross_cover(const Adjacency& neighborhood, std::span<const Triangle> triangles,
                       WaveSet crosses, const Progress& progress = {});

}  // namespace brindle
