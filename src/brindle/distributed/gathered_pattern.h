/// What rank 0 makes of a pattern of the whole surface.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "brindle/curve_measures.h"
#include "brindle/distributed/surface/gathered_surface.h"
#include "brindle/distributed_pattern.h"

namespace brindle {

/// Waves and phases of all vertices, on rank 0.
struct GatheredPattern {
  WaveSet waves;
  std::vector<Complex> z;
};

// All of these must be called by all ranks.

/// Throws Error on all ranks for a pattern whose parts do not match the piece.
GatheredPattern gathered_pattern(const GatheredSurface& whole, const PiecePattern& pattern);

/// As `whole_curves` of a surface that rank 0 has already.
WholeCurves whole_curves(const GatheredSurface& whole, const PiecePattern& pattern,
                         const CurveOptions& options, const Progress& progress = {});

/// What `shift_phases` does with the whole, at the vertices of the piece, to the bit.
std::size_t shift_phases(const GatheredSurface& whole, float periods, WaveSet& waves,
                         std::span<Complex> z);

/// Of rank 0's curves, as `measure_curve_spacing` has it; nothing elsewhere. `wanted` are the
/// frequencies asked for at the vertices of the piece; empty, on all ranks: those of the pattern.
CurveSpacing measure_spacing(const GatheredSurface& whole, const PiecePattern& pattern,
                             const StripeCurves& curves, std::span<const float> wanted = {});

}  // namespace brindle
