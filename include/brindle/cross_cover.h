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

/// The covering of a surface by two sheets on which a cross field is an ordinary line field
/// (Kälberer et al. 2007). Wave r of the cross at vertex i, r = 0 or 1, is node 2 i + r; each edge
/// of the surface joins (i, r) to the wave of j that it turns least to, and the other two to
/// each other. On the cover everything is as on a mesh with one wave per vertex: its phase graph is
/// `build_phase_graph(neighborhood, waves)`.
struct CrossCover {
  WaveSet waves;                                  ///< one wave per node
  std::shared_ptr<const Adjacency> neighborhood;  ///< of the nodes

  /// For every triangle of `base`, in its order, the nodes of one of its two waves, U; behind them,
  /// for every triangle again, those of the other, V. Which is which may change from one triangle
  /// to the next: a cross tells them apart no better.
  std::vector<Triangle> triangles;
  std::vector<Index> base;  ///< triangles of the surface around which crosses match

  /// The other triangles, in ascending order: going round, U becomes V. They are the singularities
  /// of the cross field; each has index 1/4 or -1/4, and larger ones take several triangles.
  std::vector<Index> singular;

  std::span<const Triangle> u() const { return std::span(triangles).first(base.size()); }
  std::span<const Triangle> v() const { return std::span(triangles).last(base.size()); }
};

/// The other wave of a node's cross.
inline Index other_wave(Index node) { return node ^ 1u; }

/// Both waves of every vertex: the given one and its direction turned a quarter about the normal.
/// Directions are unit tangent vectors or zero, one per vertex as everything here. A vertex whose
/// normal is zero has no waves.
WaveSet cross_waves(const WaveSet& waves, std::span<const Vec3> normals);

/// The m in {0, 1} for which wave (i, 0) belongs to (j, m) and (i, 1) to (j, 1 - m): the pairing
/// that turns the cross by less than an eighth, once it has been moved in parallel from i to j. The
/// same from i to j as from j to i.
Index matching_wave(const WaveSet& crosses, Index i, Index j);

/// Whether `crosses`, other waves of the same vertices, belong together as those of the cover do:
/// then it is their cover, too, but for the waves.
bool are_matched_alike(const Adjacency& neighborhood, const WaveSet& crosses,
                       const CrossCover& cover);

/// `crosses` has two waves for every vertex of `neighborhood`, as `cross_waves` gives them. Throws
/// Error if it has not, or for more vertices than half an Index can count; Cancelled if `progress`
/// asks for it.
CrossCover cross_cover(const Adjacency& neighborhood, std::span<const Triangle> triangles,
                       WaveSet crosses, const Progress& progress = {});

}  // namespace brindle
