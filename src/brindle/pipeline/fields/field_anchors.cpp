#include "brindle/pipeline/fields/field_anchors.h"

#include <cmath>
#include <string>

#include "brindle/error.h"
#include "brindle/waves/direction_graph.h"

namespace brindle {

void check_field_anchor(const FieldAnchor& anchor, std::size_t vertices) {
  const bool finite = anchor.direction.allFinite() && std::isfinite(anchor.weight);
  if (anchor.vertex < vertices && finite) return;
  throw Error("smooth field: anchor at vertex " + std::to_string(anchor.vertex) +
              (finite ? ", but the surface has " + std::to_string(vertices)
                      : " has a direction or weight that is not finite; correct or leave it out"));
}

Complex pull_of(const FieldAnchor& anchor, const Adjacency& neighborhood, const Vec3& normal,
                int symmetry) {
  const Vec3 tangent = anchor.direction - anchor.direction.dot(normal) * normal;
  const auto degree = static_cast<float>(neighborhood.of(anchor.vertex).size());
  return anchor.weight * degree * representation(tangent, normal, symmetry);
}

}  // namespace brindle
