#include "brindle/pipeline/fields/curvature_anchors.h"

#include <algorithm>
#include <cmath>

#include "brindle/direction_field.h"
#include "brindle/waves/direction_graph.h"

namespace brindle {

std::vector<float> curvature_differences(std::span<const PrincipalCurvature> curvatures) {
  std::vector<float> difference(curvatures.size());
  for (std::size_t i = 0; i < difference.size(); ++i) {
    difference[i] = std::abs(curvatures[i].maximum - curvatures[i].minimum);
  }
  return difference;
}

void add_curvature_anchors(PhaseGraph& graph, std::span<const Vec3> normals,
                           std::span<const PrincipalCurvature> curvatures, float scale,
                           const SmoothFieldOptions& options) {
  const DirectionField directions =
      curvature_direction_field(curvatures, options.curvature_direction);
  const std::vector<float> difference = curvature_differences(curvatures);
  const float factor = scale > 0 ? 1 / scale : 0;
  for (Index i = 0; i < curvatures.size(); ++i) {
    const float trust = std::min(1.0f, difference[i] * factor);
    const auto degree = static_cast<float>(graph.adjacency->of(i).size());
    graph.anchor[i] += options.curvature_anchor * trust * degree *
                       representation(directions[i], normals[i], options.symmetry);
  }
}

}  // namespace brindle
