/// Visible surfaces at any point of a picture, also between pixels.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "brindle/camera.h"
#include "brindle/progress.h"
#include "brindle/render/drawing/region_tracer.h"
#include "brindle/styled_picture.h"
#include "brindle/surface_tones.h"

namespace brindle {

/// Kinds of marks of a surface: one for strokes, or one per tile.
std::size_t mark_count(const StyledSurface& surface);

/// Codes of the surfaces, each followed by those of its marks; then the first free code. 0 is the
/// background.
std::vector<std::size_t> first_codes(std::span<const StyledSurface> surfaces);

/// The code of the nearest surface at a picture point: background (0), surface s
/// (`first_codes(surfaces)[s]`), its strokes (one more) or the motifs of its tile i (i + 1 more).
/// `camera` is relative to the origin of the first surface. Surfaces and their arrays must outlive
/// the result. Throws Cancelled.
CodeAt seen_codes(std::span<const StyledSurface> surfaces, const Camera& camera,
                  const PictureLight& light, int width, int height, const Progress& progress);

}  // namespace brindle
