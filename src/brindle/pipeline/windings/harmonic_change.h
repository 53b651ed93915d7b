/// Closed changes of phase with given periods, of least norm.
#pragma once

#include <cstddef>
#include <vector>

#include "brindle/geometry/topology.h"
#include "brindle/pipeline/windings/twisted_forms.h"
#include "brindle/surface.h"

namespace brindle {

/// How much a loop is to gain, in periods, in the sense of its first vertex's wave.
struct MissingPeriods {
  std::size_t loop;
  int periods;
};

/// Finds the one-form beta with d beta = 0 and these periods whose norm, weighted by cotangents, is
/// least: the harmonic one. Wherever waves of neighbours run against each other it changes its sign
/// with them (it lives on the field's orientation covering). Returns its gradient in every vertex's
/// own sense, a tangent vector in radians per unit length. `walks` has an entry per loop. Round a
/// boundary, the change runs to the nearest boundary that is not among `missing`. Throws Error
/// where there is no way for it.
std::vector<Eigen::Vector3d> harmonic_change(const Surface& surface, const MeshEdges& edges,
                                             const std::vector<SurfaceLoop>& loops,
                                             const std::vector<LoopWalk>& walks,
                                             const std::vector<MissingPeriods>& missing,
                                             const std::vector<Vec3>& directions);

}  // namespace brindle
