/// Outlines of what a picture shows, for print.
#pragma once

#include <span>
#include <vector>

#include "brindle/export.h"
#include "brindle/image.h"
#include "brindle/line_drawing.h"

namespace BRINDLE_EXPORT brindle {

/// Closed lines around all that covers more than half of a pixel: `shares` has a number from 0 to 1
/// for every pixel, row by row from the top. Lines run between pixels' middles as shares have it
/// (marching squares; Lorensen and Cline 1987), the covered side on their left on the screen, holes
/// the other way round; the first point is not repeated. Corners that change a line by less than
/// `tolerance` pixels are left out. Throws Error if there is not a share for every pixel.
std::vector<Stroke> region_outlines(int width, int height, std::span<const float> shares,
                                    float tolerance = 0.05f);

/// How much of every pixel is light, 0 to 1: of a picture in black and white what is white.
std::vector<float> light_shares(const Image& image);

}  // namespace brindle
