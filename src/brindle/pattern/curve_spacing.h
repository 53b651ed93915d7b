/// How far neighbouring curves are apart.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "brindle/curve_measures.h"
#include "brindle/pattern/stripe_curves.h"

namespace brindle {

/// How much longer than `way`, which is straight, an arc is that meets the normals at both its
/// ends.
float arc_over_chord(const Vec3& way, const Vec3& normal, const Vec3& other);

/// As many points as a measurement takes unless told otherwise.
inline constexpr std::size_t kMostSpacingPoints = 1'000'000;

/// Distances along the surface are taken for arcs that meet the normals at both ends. A neighbour
/// is the nearest curve sideways, on the same side of the surface, within 1.6 / f; where there is
/// none (a boundary) nothing is measured. Nor is anything where it would take more than
/// `most_points` points: their number grows with the square of the frequency, that of the curves'
/// own points only with the frequency. `wanted` are the frequencies asked for, one per vertex;
/// empty: those of the pattern. Throws Error in a build without nanoflann, and Cancelled if
/// `progress` asks for it.
CurveSpacing measure_curve_spacing(const WavePattern& pattern, const StripeCurves& curves,
                                   std::size_t most_points = kMostSpacingPoints,
                                   std::span<const float> wanted = {},
                                   const Progress& progress = {});

}  // namespace brindle
