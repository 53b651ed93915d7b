/// How far stripes miss each other along sharp edges.
#pragma once

#include <optional>
#include <span>

#include "brindle/export.h"
#include "brindle/phase_graph.h"
#include "brindle/surface.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// Phases that differ by more, a sixth of a period, do not meet across a crease.
inline constexpr float kSlipDegrees = 60;

/// Where the faces of a crease ask for different frequencies along it, phases cannot meet: each
/// face keeps its spacing, and stripes end there.
struct CreaseSlip {
  double mean_deg = 0;  ///< mean difference of the phases on both sides, 0 to 180, by length
  double share = 0;     ///< of the length where it is above `kSlipDegrees`, 0 to 1
  double length = 0;    ///< of all creases between waves, in units of length
};

/// Nothing for a surface without creases. `z` has a phase for every vertex.
std::optional<CreaseSlip> crease_slip(const Surface& surface, const WaveSet& waves,
                                      std::span<const Complex> z);

}  // namespace brindle
