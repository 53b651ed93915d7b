/// Closed one-forms of least norm with prescribed periods.
#pragma once

#include <cstddef>
#include <vector>

#include "brindle/geometry/topology.h"
#include "brindle/pipeline/windings/twisted_forms.h"
#include "brindle/surface.h"

namespace brindle {

/// Periods to add round a loop, in the orientation of its first vertex's wave.
struct MissingPeriods {
  std::size_t loop;
  int periods;
};

/// Returns the harmonic one-form beta: d beta = 0, the given periods, least cotangent-weighted
/// norm. Its sign changes with the waves, since it lives on the field's orientation covering.
/// Result: its gradient at each vertex in that vertex's orientation, a tangent vector in radians
/// per unit length. `walks` has one entry per loop. A change round a boundary is balanced at the
/// nearest boundary that is not in `missing`. Throws Error if no path exists.
std::vector<Eigen::Vector3d> harmonic_change(const Surface& surface, const MeshEdges& edges,
                                             const std::vector<SurfaceLoop>& loops,
                                             const std::vector<LoopWalk>& walks,
                                             const std::vector<MissingPeriods>& missing,
                                             const std::vector<Vec3>& directions);

}  // namespace brindle
