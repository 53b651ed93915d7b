/// Points and triangles with texture coordinates of a pattern.
#pragma once

#include <array>
#include <vector>

#include <brindle/data_arrays.h>
#include <brindle/stripe_pattern.h>
#include <brindle/types.h>
#include <brindle/waves_of.h>

#include "surface_cache.h"

namespace brindle::paraview {

/// A surface with a pattern, split so that each point has one pair of texture coordinates.
struct StripeSurface {
  std::vector<RowBlend> sources;  ///< per point: rows of input points; the input points come first
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Index> cells;             ///< per triangle: cell of the input
  std::vector<DataArray> point_arrays;  ///< the wave arrays of `brindle stripe`
  DataArray branches;                   ///< per triangle: whether a stripe begins or ends there
  std::vector<float> coordinates;       ///< U and V per point (texture_coordinates.h), or empty
};

/// Collective. 1 at the corners of triangles, of any rank, in which a stripe begins or ends.
std::vector<float> branches_at_vertices(const InputSurface& input, const StripePattern& pattern);

/// Values of vertices besides the pattern.
struct VertexNotes {
  std::vector<float> branches;  ///< as above
  FieldSupport support;         ///< of smoothed waves
};

/// The input's points and triangles, without degenerate triangles.
StripeSurface plain_surface(const InputSurface& input, const StripePattern& pattern,
                            const VertexNotes& notes);

/// The same with points copied along seams, and triangles with branches split at their barycentres,
/// so that U, across the stripes, is linear in every triangle.
StripeSurface textured_surface(const InputSurface& input, const StripePattern& pattern,
                               const VertexNotes& notes);

}  // namespace brindle::paraview
