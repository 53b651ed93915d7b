/// What attracts a smooth field: anchors at vertices, curvature, sharp edges and boundaries.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "brindle/mesh.h"
#include "brindle/normals.h"
#include "brindle/phase_graph.h"
#include "brindle/smooth_field.h"
#include "brindle/strokes.h"
#include "brindle/types.h"

namespace brindle {

/// Throws Error for a vertex out of range, and for a direction or weight that is not finite.
void check_field_anchor(const FieldAnchor& anchor, std::size_t vertices);

/// What the anchor adds to its vertex's T_i, for a field of symmetry N.
Complex pull_of(const FieldAnchor& anchor, const Adjacency& neighborhood, const Vec3& normal,
                int symmetry);

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

/// Adds the pull of features to the graph's anchors. Its nodes are the first vertices of the mesh,
/// whose own neighbourhood and normals these are; those whose row in the graph is empty may lack
/// triangles, and are not drawn.
void add_feature_anchors(PhaseGraph& graph, const Mesh& mesh, const Adjacency& neighborhood,
                         std::span<const Vec3> normals, const SmoothFieldOptions& options);

}  // namespace brindle
