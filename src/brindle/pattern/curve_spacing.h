/// Distances between neighbouring curves.
#pragma once

#include <cstddef>
#include <span>

#include "brindle/curve_measures.h"
#include "brindle/pattern/stripe_curves.h"

namespace brindle {

/// The length of an arc that is perpendicular to both normals, over that of its chord `way`.
float arc_over_chord(const Vec3& way, const Vec3& normal, const Vec3& other);

/// The default limit of points per measurement.
inline constexpr std::size_t kMostSpacingPoints = 1'000'000;

/// Measures distances along the surface, as arcs perpendicular to the normals at both ends. A
/// neighbour is the nearest curve sideways, on the same side of the surface, within 1.6 / f; gaps
/// count up to 2.5 / f. Without such a curve (at a boundary) nothing is measured. The result is
/// empty if more than `most_points` points were needed; their number grows with the square of the
/// frequency. `wanted` are the requested frequencies, one per vertex; empty: those of the pattern.
/// Throws Error in a build without nanoflann; Cancelled if `progress` cancels.
CurveSpacing measure_curve_spacing(const WavePattern& pattern, const StripeCurves& curves,
                                   std::size_t most_points = kMostSpacingPoints,
                                   std::span<const float> wanted = {},
                                   const Progress& progress = {});

}  // namespace brindle
