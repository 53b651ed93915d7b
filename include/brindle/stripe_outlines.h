/// Outlines of stripes and of the figures of tiles as smooth filled paths, for print at any size.
#pragma once

#include <span>
#include <vector>

#include "brindle/camera.h"
#include "brindle/export.h"
#include "brindle/line_drawing.h"
#include "brindle/progress.h"
#include "brindle/styled_picture.h"

namespace BRINDLE_EXPORT brindle {

/// For each surface, the last one first, a pen that fills what is seen of it, "surface", unless it
/// is discarded between its strokes, and one that fills what is seen of its strokes, "stripes", in
/// the colour of the first ones. Instead of strokes, a texture has a pen for the figures of each of
/// its tiles, in the tile's colour: "tiles", then "tiles2" and so on. Those of surface i, from 1
/// on, end in "_i". Pens are smooth paths of cubic Béziers.
///
/// Outlines are where the phase of `fragment_phase` passes the stripes' borders, where the figures
/// of tiles end (`tile_distance`), whole ones where others are to be left out, and where one
/// triangle ends in front of another: found for every point and not on a grid of pixels. Paths
/// leave them by less than a twentieth of a pixel. What is narrower than half a pixel may be
/// missed. Areas and holes of less than `least_area` square pixels are left out. Colours and
/// opacities that follow values, and light, do not show.
///
/// `camera` is relative to the origin of the first surface, as `styled_camera` has it; `light` is
/// what widths follow. Needs no OpenGL. Throws Error if a side is not in 1 .. 8192, strokes do not
/// have one entry per vertex, a tile is a picture, or `least_area` is negative or no number;
/// Cancelled if `progress` asks for it.
std::vector<Pen> stripe_outlines(std::span<const StyledSurface> surfaces, const Camera& camera,
                                 const PictureLight& light, int width, int height,
                                 float least_area = 0.1f, const Progress& progress = {});

}  // namespace brindle
