/// What is measured of curves that rank 0 has joined, on a surface that all ranks hold together.
#pragma once

#include <span>

#include "brindle/curve_measures.h"
#include "brindle/curves.h"
#include "brindle/distributed_pattern.h"
#include "brindle/pattern/curve_spacing.h"

namespace brindle {

/// Must be called by all ranks, of which the first has the curves. On rank 0 as
/// `measure_curve_spacing` of the whole surface; nothing elsewhere. `wanted` are the frequencies
/// asked for at the vertices of the piece; empty, on all ranks: those of the pattern. Where
/// frequencies are not the same everywhere, all ranks get the points of the measurement, and say
/// which of their vertices are nearest. Of several that are equally near the one counts that has
/// the lowest number.
CurveSpacing measure_joined_spacing(const PiecePattern& pattern, const StripeCurves& curves,
                                    std::span<const float> wanted = {});

/// Must be called by all ranks, of which the first has the lines. On rank 0 as `measure_coverage`
/// of the whole surface, but at other places on more ranks than one: areas are counted rank by
/// rank. Throws Error on all ranks for a width that is none.
CurveCoverage measure_joined_coverage(const DistributedSurface& surface, const Polylines& lines,
                                      double width);

}  // namespace brindle
