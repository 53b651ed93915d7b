/// Outlines of stripes and of tile motifs as smooth filled paths, for print at any size.
#pragma once

#include <span>
#include <vector>

#include "brindle/camera.h"
#include "brindle/export.h"
#include "brindle/line_drawing.h"
#include "brindle/progress.h"
#include "brindle/styled_picture.h"

namespace BRINDLE_EXPORT brindle {

/// Pens that fill the visible parts of surfaces, the last surface first. "surface" fills a surface,
/// unless it is discarded between its strokes; "stripes" fills its strokes, in the colour of the
/// first ones. A texture instead has one pen for the motifs of each tile, in the tile's colour:
/// "tiles", then "tiles2" and so on. Names for surface i, from 1 on, end in "_i". Pens are smooth
/// paths of cubic Béziers.
///
/// Outlines are where the phase of `fragment_phase` passes the stripes' borders, where motifs end
/// (`tile_distance`; only whole motifs if others are left out), and where one triangle ends in
/// front of another. They are found for points rather than on a pixel grid; paths deviate by less
/// than a twentieth of a pixel. Parts narrower than half a pixel may be missed. Areas and holes of
/// less than `least_area` square pixels are left out. Light, and colours and opacities by value,
/// are not shown.
///
/// `camera` is relative to the origin of the first surface, as in `styled_camera`; `light` is for
/// widths that follow it. Needs no OpenGL. Throws Error if a side is not in 1 .. 8192, strokes do
/// not have one entry per vertex, a tile is a picture, or `least_area` is negative or no number;
/// Cancelled if `progress` cancels.
std::vector<Pen> stripe_outlines(std::span<const StyledSurface> surfaces, const Camera& camera,
                                 const PictureLight& light, int width, int height,
                                 float least_area = 0.1f, const Progress& progress = {});

}  // namespace brindle
