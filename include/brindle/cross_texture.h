/// Cross fields: two linked waves per vertex, a quarter turn apart, and textures along them (paper,
/// 3.6).
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "brindle/adjacency.h"
#include "brindle/export.h"
#include "brindle/mesh.h"
#include "brindle/phase_graph.h"
#include "brindle/stripe_pattern.h"
#include "brindle/texture_pattern.h"

namespace BRINDLE_EXPORT brindle {

/// The covering of a surface by two sheets on which a cross field is an ordinary line field
/// (Kälberer et al. 2007). Wave r of the cross at vertex i, r = 0 or 1, is node 2 i + r; each edge
/// of the surface joins (i, r) to the wave of j that is best aligned with it, and the other two to
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
/// whose two alignments |<d, d'>| have the larger sum. The same from i to j as from j to i.
Index matching_wave(const WaveSet& crosses, Index i, Index j);

/// `crosses` has two waves for every vertex of `neighborhood`, as `cross_waves` gives them. Throws
/// Error if it has not, or for more vertices than half an Index can count.
CrossCover cross_cover(const Adjacency& neighborhood, std::span<const Triangle> triangles,
                       WaveSet crosses);

struct CrossPattern {
  CrossCover cover;
  Surface surface;        ///< the cover as a surface: its nodes are vertices
  StripePattern pattern;  ///< on `surface`; its corners are those of `cover.triangles`

  /// Both waves together. `field_singularities` are triangles of the mesh around which the cross
  /// does not come back to itself unturned; `branches` counts such a triangle once for each wave.
  PatternQuality quality;
};

/// The cover as a surface, whose vertices are its nodes: on it a cross field is a line field, and
/// everything that works on surfaces works. `normals` are those of the covered surface's vertices.
Surface cover_surface(const CrossCover& cover, std::span<const Vec3> normals);

/// Matches the crosses that `waves` (one per vertex) and a quarter turn make along the edges of the
/// surface, and lays stripes along both their waves. Everything has 90-degree symmetry: turning any
/// vertex's direction by a quarter changes nothing but names. Throws what `stripe_pattern` throws.
CrossPattern cross_pattern(const Surface& surface, const WaveSet& waves,
                           const StripeOptions& options = {}, const Progress& progress = {});

/// What a texture is drawn on.
struct CrossTexture {
  /// The surface with every singular triangle split at its barycentre: triangles around which
  /// crosses match come first (`cover.base`), then three for each of `cover.singular`. New vertices
  /// stand behind those of the surface and have no wave of their own.
  Surface surface;

  /// `u` holds the waves (i, 0), `v` the waves (i, 1); their corners, one entry per triangle, are
  /// those of U and V there, whichever of the two waves that is at a vertex. Both have the energy
  /// and the quality of the whole cross pattern. There are no seams for a tile that looks the same
  /// turned by 90 degrees: `seams` is not filled.
  TexturePattern pattern;
};

/// Gives every triangle waves U and V. In a singular triangle each of the three parts matches the
/// crosses along its own edge, so that it fits its neighbour there; between the parts, inside the
/// triangle, the texture turns. V runs to the left of U everywhere, seen from outside.
CrossTexture cross_texture(const Surface& surface, const CrossPattern& cross,
                           PhaseShiftKind phase_shift = PhaseShiftKind::aligned);

}  // namespace brindle
