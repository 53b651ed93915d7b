/// Which way round each triangle shows its texture, and where that has to change.
#pragma once

#include <cstddef>
#include <span>

#include "brindle/geometry/shared_edges.h"
#include "brindle/progress.h"
#include "brindle/texture_waves.h"

namespace brindle {

/// Counts the seams. Edges of triangles without orientation are not counted.
TextureSeams texture_seams(const TextureWaves& waves, std::span<const SharedEdge> edges);

/// Turns whole triangles (U and V together) so that the seam runs along few edges: none where the
/// field has an orientation. Triangles are the nodes of a phase graph whose phases are +1 (as it
/// stands) and -1 (turned), coupled along edges, whose energy counts the edges of the seam; what
/// the multilevel solver leaves is replaced by shortest paths (`shortening_turns`). Each piece of
/// the surface has most of its triangles as they stood. Corners must have been oriented
/// (`orient_corners`); `edges` are those that `triangles` share.
void orient_triangles(TextureWaves& waves, std::span<const Triangle> triangles,
                      std::span<const SharedEdge> edges, const Progress& progress = {});

}  // namespace brindle
