/// Phases carried over from the last pattern of a time series, which keep its stripes in place
/// (docs/method.md, "Frames that follow changing input").
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "brindle/export.h"
#include "brindle/mesh.h"
#include "brindle/phase_graph.h"
#include "brindle/progress.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// The last pattern of a series. A vertex has no wave if its direction is zero or its phase is 0 or
/// not finite.
struct LastPattern {
  const Mesh& mesh;
  const WaveSet& waves;        ///< one per vertex
  std::span<const Complex> z;  ///< one phase exp(i Phi) per vertex
};

/// Marks a vertex without a counterpart.
inline constexpr Index kNoCounterpart = std::numeric_limits<Index>::max();

/// For every wave, the phase at its counterpart in the last pattern: the vertex with the same
/// number or, if given, with the number in `counterparts`. A vertex that moves, turns or changes
/// its frequency keeps its phase. If its direction has reversed, the phase is that of the reversed
/// wave. 0 where either wave or the counterpart is missing. Throws Error if sizes do not match or a
/// counterpart does not exist.
std::vector<Complex> matched_phases(const LastPattern& last, const WaveSet& waves,
                                    std::span<const Index> counterparts = {});

/// For every wave on `mesh`, the phase of the last pattern at the nearest point of its triangles,
/// or at its nearest vertex if it has none, plus the phase shift from there to the vertex. Reversed
/// directions are treated as above. 0 where either wave is missing, or the last pattern is farther
/// away than `max_periods` of its wave: new parts have no last phase. Throws Error if sizes do not
/// match, and Cancelled if `progress` cancels.
std::vector<Complex> carried_phases(const LastPattern& last, const Mesh& mesh, const WaveSet& waves,
                                    double max_periods = 1, const Progress& progress = {});

/// The change of phases since the last pattern.
struct PhaseStep {
  double mean = 0;            ///< mean angle in radians, where both are known
  std::size_t unmatched = 0;  ///< waves without a last phase
};

/// `last_z` is a result of one of the functions above. Throws Error if sizes do not match.
PhaseStep phase_step(const WaveSet& waves, std::span<const Complex> z,
                     std::span<const Complex> last_z);

}  // namespace brindle
