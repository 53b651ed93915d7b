/// Phases of one pattern as the next one finds them, on the same mesh or on another: what keeps the
/// stripes of a time series together (docs/method.md, "Frames that follow changing input").
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

/// A pattern that others go on from. A vertex whose direction is zero or whose phase is 0 or not
/// finite has no wave.
struct LastPattern {
  const Mesh& mesh;
  const WaveSet& waves;        ///< one per vertex
  std::span<const Complex> z;  ///< one phase exp(i Phi) per vertex
};

/// A vertex that has no counterpart.
inline constexpr Index kNoCounterpart = std::numeric_limits<Index>::max();

/// For every one of `waves` the phase of the last pattern's vertex with the same number or, if
/// `counterparts` are given, with the number that stands there. Vertices move, turn and change
/// their frequency, and keep their phase. Where the direction has turned round, the phase is that
/// of the wave that runs the other way. 0 where either wave or the counterpart is missing. Throws
/// Error if sizes do not match or a counterpart does not exist.
std::vector<Complex> matched_phases(const LastPattern& last, const WaveSet& waves,
                                    std::span<const Index> counterparts = {});

/// For every one of `waves`, which stand on `mesh`, the phase that the last pattern has there: that
/// of its wave at the nearest place of its triangles, or at its nearest vertex if it has none, led
/// from there to the vertex by the phase shift between both waves. Directions count as above. 0
/// where either wave is missing, and where the last pattern is farther away than `max_periods` of
/// its wave: what is new has no last phase. Throws Error if sizes do not match, and Cancelled if
/// `progress` asks for it.
std::vector<Complex> carried_phases(const LastPattern& last, const Mesh& mesh, const WaveSet& waves,
                                    double max_periods = 1, const Progress& progress = {});

/// How far phases moved since the last pattern.
struct PhaseStep {
  double mean = 0;            ///< of the angles between both, in radians, where both are known
  std::size_t unmatched = 0;  ///< waves without a last phase
};

/// `last_z` as one of the functions above gives it. Throws Error if sizes do not match.
PhaseStep phase_step(const WaveSet& waves, std::span<const Complex> z,
                     std::span<const Complex> last_z);

}  // namespace brindle
