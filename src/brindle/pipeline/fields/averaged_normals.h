/// Normals of a surface as it is seen from farther away.
#pragma once

#include <span>
#include <vector>

#include "brindle/phase_graph.h"
#include "brindle/phases/screened.h"
#include "brindle/progress.h"
#include "brindle/surface.h"

namespace brindle {

/// Normals at the nodes of a graph, and what of a surface is to be known to average them: see
/// `surface_elements.h`.
struct NormalElements {
  std::span<const Vec3> normals;
  std::vector<float> areas;    ///< of nodes
  std::vector<float> degrees;  ///< sums of the nodes' stiffness
  PhaseGraph graph;            ///< coupled by the stiffness of edges
  /// `own`, `exchange` and `total` of a part that has nodes of other ranks; then averaging is
  /// collective.
  ScreenedOptions part = {};
};

/// For each of `radii`, which ascend, in units of length and above 0, the surface's normals
/// averaged over places whose root mean square distance it is; of unit length. Zero where the
/// surface's are, and the surface's own where their average has no direction. A finer mesh has the
/// same. Throws Cancelled if `progress` asks for it.
std::vector<std::vector<Vec3>> averaged_normals(const Surface& surface,
                                                std::span<const float> radii,
                                                const Progress& progress = {});

/// The same of a part of a surface, other ranks' nodes with what their owners have.
std::vector<std::vector<Vec3>> averaged_normals(NormalElements elements,
                                                std::span<const float> radii,
                                                const Progress& progress = {});

}  // namespace brindle
