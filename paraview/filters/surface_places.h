/// The input's arrays at places of its surface.
#pragma once

#include <span>

#include <brindle/polylines.h>

#include "surface_cache.h"

class vtkPointData;

namespace brindle::paraview {

/// Adds the input's arrays, of points blended and then of cells, with a row per place, but those
/// whose names are taken.
void carry_to_places(const InputSurface& input, std::span<const TrianglePoint> places,
                     vtkPointData& points);

}  // namespace brindle::paraview
