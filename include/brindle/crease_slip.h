/// Mismatch of stripes across sharp edges.
#pragma once

#include <optional>
#include <span>

#include "brindle/export.h"
#include "brindle/phase_graph.h"
#include "brindle/surface.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// Phases that differ by more than this, a sixth of a period, do not meet across a crease.
inline constexpr float kSlipDegrees = 60;

/// Phase differences across creases. Phases cannot meet where the faces need different frequencies
/// along a crease: each face keeps its spacing, and stripes end there.
struct CreaseSlip {
  double mean_deg = 0;  ///< mean phase difference, 0 to 180, weighted by length
  double share = 0;     ///< share of the length with a difference above `kSlipDegrees`, 0 to 1
  double length = 0;    ///< of all creases between waves, in units of length
};

/// Empty for a surface without creases. `z` has one phase per vertex.
std::optional<CreaseSlip> crease_slip(const Surface& surface, const WaveSet& waves,
                                      std::span<const Complex> z);

}  // namespace brindle
