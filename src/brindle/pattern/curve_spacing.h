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

/// Points along all curves at which neighbours are looked for.
struct CurveMarks {
  Polylines lines;
  std::vector<Vec3> along;                     ///< the curve's direction, one per point
  std::vector<std::array<Index, 2>> adjacent;  ///< points before and behind on the curve
};

/// The points of `measure_curve_spacing` where no frequency is above `highest`; nothing where they
/// would be more than `most_points`.
std::optional<CurveMarks> curve_marks(const StripeCurves& curves, float highest,
                                      std::size_t most_points = kMostSpacingPoints,
                                      const Progress& progress = {});

/// Frequencies at points: those chosen, and those asked for.
struct MarkFrequencies {
  std::vector<float> chosen, wanted;
};

/// The second half of `measure_curve_spacing`, for who knows frequencies at the marks but not the
/// whole pattern: those of the nearest vertices.
CurveSpacing measure_curve_spacing(const CurveMarks& marks, const MarkFrequencies& frequencies,
                                   const Progress& progress = {});

}  // namespace brindle
