/// Steps shared by static and animated cross patterns.
#pragma once

#include <span>

#include "brindle/corner_phases.h"
#include "brindle/cross_cover.h"
#include "brindle/cross_texture.h"
#include "brindle/phase_shift.h"
#include "brindle/quality.h"
#include "brindle/spacing_tolerance.h"
#include "brindle/texture_waves.h"

namespace brindle {

struct CrossParts {
  Mesh mesh;           ///< as CrossTexture::surface
  TextureWaves waves;  ///< U and V per corner, consistently oriented where possible; V is left of U
};

/// Builds the cross texture of a cover of `mesh` with one phase `z` per node. Reuses the memory of
/// `last`.
CrossParts cross_parts(const Mesh& mesh, const CrossCover& cover, std::span<const Complex> z,
                       PhaseShiftKind kind, CrossParts last = {}, const Progress& progress = {});

/// The slack of the cover: both nodes of a vertex get the vertex's slack.
Slack slack_on_cover(Slack slack);

/// Quality of both waves together, from the quality and the corner phases of the cover.
PatternQuality cross_quality(const CrossCover& cover, PatternQuality on_cover,
                             std::span<const CornerPhases> corners);

/// The same for a whole pattern. `triangles` are the surface's; `branch_penalty` is per vertex, as
/// in Slack.
PatternQuality cross_quality(std::span<const Triangle> triangles, const CrossPattern& cross,
                             std::span<const float> branch_penalty);

}  // namespace brindle
