/// Steps that still and moving patterns of cross fields have in common.
#pragma once

#include <span>

#include "brindle/corner_phases.h"
#include "brindle/cross_cover.h"
#include "brindle/cross_texture.h"
#include "brindle/phase_shift.h"
#include "brindle/quality.h"
#include "brindle/texture_waves.h"
#include "brindle/yielding_frequency.h"

namespace brindle {

struct CrossParts {
  Mesh mesh;           ///< as that of CrossTexture::surface
  TextureWaves waves;  ///< U and V at its corners, which run alike where they can, V left of U
};

/// `z` has a phase for every node of the cover, which is one of `mesh`. The memory of `last` is
/// used again.
CrossParts cross_parts(const Mesh& mesh, const CrossCover& cover, std::span<const Complex> z,
                       PhaseShiftKind kind, CrossParts last = {}, const Progress& progress = {});

/// Both waves of a vertex have the slack that the vertex has.
Slack slack_on_cover(Slack slack);

/// What is measured of both waves together, from what was measured on the cover and the corner
/// phases of its triangles.
PatternQuality cross_quality(const CrossCover& cover, PatternQuality on_cover,
                             std::span<const CornerPhases> corners);

/// The same of a whole pattern. `calm` is that of a Slack, by vertices of `triangles`, the
/// surface's.
PatternQuality cross_quality(std::span<const Triangle> triangles, const CrossPattern& cross,
                             std::span<const float> calm);

}  // namespace brindle
