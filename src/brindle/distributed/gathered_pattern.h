/// Curves and samples that rank 0 computes on the whole surface.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "brindle/curve_measures.h"
#include "brindle/distributed/surface/gathered_surface.h"
#include "brindle/distributed_pattern.h"
#include "brindle/stripe_pattern.h"

namespace brindle {

// All of these are collective.

/// Waves and phases of all vertices, on rank 0. Throws Error on all ranks for patterns that do not
/// match their partition.
StripePattern gathered_pattern(const GatheredSurface& whole, const PiecePattern& pattern);

/// As `whole_curves`, for a surface that is already on rank 0.
WholeCurves whole_curves(const GatheredSurface& whole, const PiecePattern& pattern,
                         const CurveOptions& options, const Progress& progress = {});

/// Rank 0's curves on the whole surface, cut at borders. Their points lie on edges.
PieceCurves cut_curves(const GatheredSurface& whole, const StripeCurves& curves);

/// The bits of `shift_stripes` on the whole surface, at the partition's vertices.
std::size_t shift_phases(const GatheredSurface& whole, float periods, WaveSet& waves,
                         std::span<Complex> z);

/// `StripeTracer::spacing` of rank 0's curves; empty on other ranks. `wanted` are the requested
/// frequencies at the partition's vertices; empty on all ranks: those of the pattern.
std::optional<CurveSpacing> measure_spacing(const GatheredSurface& whole,
                                            const PiecePattern& pattern, const StripeCurves& curves,
                                            std::span<const float> wanted = {});

}  // namespace brindle
