/// The input's arrays at positions on its surface.
#pragma once

#include <span>

#include <brindle/polylines.h>

#include "surface_cache.h"

class vtkPointData;

namespace brindle::paraview {

/// Adds the input's arrays with a row per position, interpolated point arrays and then cell arrays,
/// except for names already taken.
void carry_to_places(const InputSurface& input, std::span<const TrianglePoint> places,
                     vtkPointData& points);

}  // namespace brindle::paraview
