/// The points and triangles that a pattern's texture coordinates need.
#pragma once

#include <array>
#include <vector>

#include <brindle/data_arrays.h>
#include <brindle/stripe_pattern.h>
#include <brindle/types.h>
#include <brindle/waves_of.h>

#include "surface_cache.h"

namespace brindle::paraview {

/// A surface with a pattern, cut where one pair of texture coordinates per point needs it.
struct StripeSurface {
  std::vector<RowBlend> sources;  ///< per point: rows of the input's points; first those themselves
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Index> cells;             ///< per triangle: the input's cell
  std::vector<DataArray> point_arrays;  ///< what `brindle stripe` writes of waves
  DataArray branches;                   ///< per triangle: whether a stripe begins or ends there
  std::vector<float> coordinates;       ///< U and V per point (texture_coordinates.h), or none
};

/// Collective over ranks: 1 at the corners of triangles, of any rank, in which a stripe begins or
/// ends.
std::vector<float> branches_at_vertices(const InputSurface& input, const StripePattern& pattern);

/// What vertices have beside a pattern.
struct VertexNotes {
  std::vector<float> branches;  ///< as above
  FieldSupport support;         ///< of smoothed waves
};

/// The input's points and triangles, those without area left out.
StripeSurface plain_surface(const InputSurface& input, const StripePattern& pattern,
                            const VertexNotes& notes);

/// The same with copies of points along seams, and with triangles in which stripes begin or end
/// split at their barycentres, so that U, across the stripes, is linear in every triangle.
StripeSurface textured_surface(const InputSurface& input, const StripePattern& pattern,
                               const VertexNotes& notes);

}  // namespace brindle::paraview
