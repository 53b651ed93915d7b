/// Phases carried over from the last pattern of a time series, which keep its stripes in place
/// (docs/method.md, "Frames that follow changing input").
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "brindle/direction_field.h"
#include "brindle/export.h"
#include "brindle/mesh.h"
#include "brindle/phase_graph.h"
#include "brindle/progress.h"
#include "brindle/surface.h"
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

// Direction fields carried over from the last surface of a time series, as a start for smooth
// fields (docs/method.md, "Fields of surfaces that move").

/// The last field of a series.
struct LastField {
  const Mesh& mesh;
  std::span<const Vec3> normals;     ///< one unit normal per vertex, or zero
  std::span<const Vec3> directions;  ///< one unit tangent vector per vertex, or zero for none
};

/// For every vertex of `surface`, the direction at its counterpart in the last field: the vertex
/// with the same number or, if given, with the number in `counterparts` (`kNoCounterpart`: none).
/// Each direction turns with the surface, by the angle that best fits its neighbours' turn about
/// the vertex. A rigid motion thus carries the field exactly. Zero where no last direction is
/// known. Throws Error if sizes do not match or a counterpart does not exist.
DirectionField matched_directions(const LastField& last, const Surface& surface,
                                  std::span<const Index> counterparts = {});

/// For every vertex of `surface`, the direction of the last field at the nearest point of its
/// triangles, or at its nearest vertex if it has none, projected into the tangent plane. Inside a
/// triangle, directions are blended as a field of this symmetry (1 vector, 2 line, 4 cross). Zero
/// where the last surface is farther than `max_distance`, has no direction, or one along the
/// normal. Throws Error if sizes do not match, for a symmetry below 1, and for a distance that is
/// not above 0.
DirectionField carried_directions(const LastField& last, const Surface& surface, int symmetry = 2,
                                  double max_distance = std::numeric_limits<double>::infinity());

/// 1 over the mean frequency of waves, a `max_distance` for `carried_directions`. Infinite without
/// waves.
double mean_period(const WaveSet& waves);

/// The change of directions since the last field.
struct FieldStep {
  /// Mean angle in degrees, where both are known; at most 180 / N in a field of symmetry N.
  double mean_deg = 0;
  std::size_t unmatched = 0;  ///< directions without a last direction
};

/// `last` is a result of one of the functions above. Throws Error if sizes do not match, and for a
/// symmetry below 1.
FieldStep field_step(std::span<const Vec3> directions, std::span<const Vec3> last,
                     int symmetry = 2);

}  // namespace brindle
