/// How curvature draws a smooth field.
#pragma once

#include <span>
#include <vector>

#include "brindle/normals.h"
#include "brindle/phase_graph.h"
#include "brindle/smooth_field.h"

namespace brindle {

/// Throws Error for options out of range.
void check_smoothing(const SmoothFieldOptions& options);

/// How far the principal curvatures of each vertex differ.
std::vector<float> curvature_differences(std::span<const PrincipalCurvature> curvatures);

/// Adds to the anchors of the nodes that have an entry in `curvatures`. Differences from `scale` on
/// count alike, smaller ones in proportion: it is the difference that nine vertices in ten stay
/// below, so that noise and creases do not drown the rest.
void add_curvature_anchors(PhaseGraph& graph, std::span<const Vec3> normals,
                           std::span<const PrincipalCurvature> curvatures, float scale,
                           const SmoothFieldOptions& options);

}  // namespace brindle
