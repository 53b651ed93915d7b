/// Which way round each triangle shows its texture, and where that has to change.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "brindle/geometry/topology.h"
#include "brindle/pattern/corner_signs.h"
#include "brindle/progress.h"
#include "brindle/texture_waves.h"

namespace brindle {

/// How the waves on both sides of each shared edge agree: the triangles' corners at one vertex have
/// the same waves up to their signs.
using EdgeAgreement = std::uint8_t;
inline constexpr EdgeAgreement kUAlike = 1;
inline constexpr EdgeAgreement kVAlike = 2;
inline constexpr EdgeAgreement kNoAgreement = 4;  ///< a triangle without orientation

/// Agreements along all edges that triangles share, from how their corners are turned.
void agreements(std::span<const CornerSigns> signs, std::span<const SharedEdge> edges,
                std::vector<EdgeAgreement>& result);

/// The same from the waves themselves.
std::vector<EdgeAgreement> agreements(const TextureWaves& waves, std::span<const SharedEdge> edges);

/// Changes agreements to those after the triangles with a 1 have been turned round.
void turn_agreements(std::span<const std::uint8_t> turned, std::span<const SharedEdge> edges,
                     std::span<EdgeAgreement> agreement);

/// Which whole triangles to turn (1; U and V together) so that the seam runs along few edges: none
/// where the field has an orientation. Triangles are the nodes of a phase graph whose phases are +1
/// (as it stands) and -1 (turned), coupled along edges, whose energy counts the edges of the seam;
/// what the multilevel solver leaves is replaced by shortest paths (`shortening_turns`). Each piece
/// of the surface has most of its triangles as they stood. `edges` are those that `triangles`
/// share; triangles with a 0 in `oriented` have no orientation.
std::vector<std::uint8_t> orienting_turns(std::span<const Triangle> triangles,
                                          std::span<const std::uint8_t> oriented,
                                          std::span<const SharedEdge> edges,
                                          std::span<const EdgeAgreement> agreement,
                                          const Progress& progress = {});

/// The second half of it alone: turns that make a seam shorter.
std::vector<std::uint8_t> shortening_turns(std::span<const Triangle> triangles,
                                           std::span<const std::uint8_t> oriented,
                                           std::span<const SharedEdge> edges,
                                           std::span<const EdgeAgreement> agreement,
                                           const Progress& progress = {});

/// 1 for triangles with an orientation.
std::vector<std::uint8_t> oriented_triangles(std::span<const CornerSigns> signs);

/// Counts the seams. Edges of triangles without orientation are not counted.
TextureSeams texture_seams(std::span<const std::uint8_t> oriented,
                           std::span<const EdgeAgreement> agreement);
TextureSeams texture_seams(const TextureWaves& waves, std::span<const SharedEdge> edges);

/// Turns whole triangles as `orienting_turns` says. Corners must have been oriented
/// (`orient_corners`).
void orient_triangles(TextureWaves& waves, std::span<const Triangle> triangles,
                      std::span<const SharedEdge> edges, const Progress& progress = {});

}  // namespace brindle
