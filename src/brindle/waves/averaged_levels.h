/// The paper's hierarchy: waves averaged level by level (3.4, after Jakob et al. 2015).
#pragma once

#include <span>

#include "brindle/phase_graph.h"
#include "brindle/progress.h"

namespace brindle {

/// What averaging needs besides the waves: one entry per node.
struct SurfaceElements {
  std::vector<Vec3> normals;  ///< unit
  std::vector<float> areas;   ///< above 0; of the node's share of the surface
};

/// Up to `levels` coarser graphs, each with about half the nodes of the one before; the first is
/// that of the graph itself. Neighbours with similar normals and areas are merged first; position,
/// direction (turned to run alike), frequency and normal of a merged node are area-weighted
/// averages. `waves` and `elements` are those of the nodes, `edge_weights` too: the
/// weight of a coarse edge is multiplied by the mean of the factors of the fine edges that it
/// stands for. The mean, not the sum: the paper's own weight of a coarse edge is that of one edge,
/// however many it stands for, and factors of 1 must change nothing. Throws Error unless there is
/// none or one factor per directed edge.
std::vector<AveragedLevel> averaged_levels(const Adjacency& adjacency, const WaveSet& waves,
                                           const SurfaceElements& elements, PhaseShiftKind kind,
                                           int levels = 10,
                                           std::span<const float> edge_weights = {},
                                           const Progress& progress = {});

}  // namespace brindle
