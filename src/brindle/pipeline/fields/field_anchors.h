/// Anchors of a smooth field: at vertices, from curvature, sharp edges and boundaries.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "brindle/direction_field.h"
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

// Continues a smooth field from known directions, such as those of the last frame.

/// The last field at the nodes of a direction graph.
struct LastValues {
  std::vector<Complex> u;         ///< exp(i N theta); 0 if unknown
  std::vector<float> confidence;  ///< 0 or above
  float weight = 0;               ///< of the pull, relative to that of all neighbours
  std::vector<float> noisy = {};  ///< by node: strength of new anchors, such as curvature; empty: 0
};

/// Anchor strength by node.
std::vector<float> anchor_strengths(const PhaseGraph& graph);

/// Returns the start values of the new field. Adds the pull towards them to `graph.anchor`, which
/// holds all other anchors. The last field is smoothed with those anchors over a large part of the
/// surface. Zeros of a smoothed field move with the shape; those of a unit field stay trapped
/// between vertices. `fill` solves from scratch, and is only called if values are missing.
std::vector<Complex> warm_start(PhaseGraph& graph, const LastValues& last,
                                const std::function<std::vector<Complex>()>& fill);

/// Throws Error for a weight out of range, for numbers that are not finite, and for a number of
/// directions other than 0 or one per vertex. `what` starts the message.
void check_known(const KnownDirections& known, std::size_t vertices, const char* what);

/// Known directions as values of a field of symmetry N on these normals.
LastValues last_values(const KnownDirections& known, std::span<const Vec3> normals, int symmetry);

/// The direction nearest to the tangent vector `last`, among the N that `u` represents.
Vec3 direction_near(const Vec3& last, Complex u, const Vec3& normal, int symmetry);

/// Matches axes and signs with the last field where it has a direction, elsewhere with the
/// neighbours. `u` are the values of `field`.
void align_with_previous(const Adjacency& neighborhood, std::span<const Complex> u,
                         std::span<const Vec3> normals, std::span<const Vec3> last, int symmetry,
                         DirectionField& field);

}  // namespace brindle
