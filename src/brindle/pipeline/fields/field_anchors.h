/// Anchors of a smooth field: at vertices, from curvature, sharp edges and boundaries.
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

/// The anchor's contribution to its vertex's T_i, for a field of symmetry N.
Complex pull_of(const FieldAnchor& anchor, const Adjacency& neighborhood, const Vec3& normal,
                int symmetry);

/// Throws Error for options out of range.
void check_smoothing(const SmoothFieldOptions& options);

/// Absolute difference of the principal curvatures, by vertex.
std::vector<float> curvature_differences(std::span<const PrincipalCurvature> curvatures);

/// Adds curvature anchors to the nodes with an entry in `curvatures`. Weights grow with the
/// difference of curvatures up to `scale`, and are constant above. `scale` is the 90th percentile
/// of the differences, so that noise and creases do not dominate.
void add_curvature_anchors(PhaseGraph& graph, std::span<const Vec3> normals,
                           std::span<const PrincipalCurvature> curvatures, float scale,
                           const SmoothFieldOptions& options);

/// Adds feature anchors to the graph. Its nodes are the first vertices of the mesh, whose own
/// neighbourhood and normals these are. Nodes with an empty row in the graph may lack triangles;
/// they get no anchor.
void add_feature_anchors(PhaseGraph& graph, const Mesh& mesh, const Adjacency& neighborhood,
                         std::span<const Vec3> normals, const SmoothFieldOptions& options);

}  // namespace brindle
