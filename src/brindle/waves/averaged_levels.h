/// The paper's hierarchy: waves averaged level by level (3.4, after Jakob et al. 2015).
#pragma once

#include <span>

#include "brindle/phase_graph.h"
#include "brindle/progress.h"

namespace brindle {

/// Normals and areas of nodes, one entry per node.
struct SurfaceElements {
  std::vector<Vec3> normals;  ///< unit
  std::vector<float> areas;   ///< of the nodes' shares of the surface, above 0
};

/// Up to `levels` coarser graphs, each with about half the nodes of the previous one. Neighbours
/// with similar normals and areas are merged first. Position, direction (reversed to run alike),
/// frequency and normal of a merged node are area-weighted averages. `edge_weights` has one factor
/// per directed edge or none. The weight of a coarse edge is multiplied by the mean factor of its
/// fine edges, so factors of 1 change nothing. Throws Error for another number of factors;
/// Cancelled if `progress` cancels.
std::vector<AveragedLevel> averaged_levels(const Adjacency& adjacency, const WaveSet& waves,
                                           const SurfaceElements& elements, PhaseShiftKind kind,
                                           int levels = 10,
                                           std::span<const float> edge_weights = {},
                                           const Progress& progress = {});

}  // namespace brindle
