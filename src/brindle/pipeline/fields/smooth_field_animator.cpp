#include <algorithm>
#include <vector>

#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/direction_field.h"
#include "brindle/error.h"
#include "brindle/phases/hierarchy.h"
#include "brindle/phases/multilevel.h"
#include "brindle/phases/several_starts.h"
#include "brindle/pipeline/fields/field_anchors.h"
#include "brindle/smooth_field.h"
#include "brindle/waves/direction_graph.h"
#include "brindle/waves/wave_check.h"

namespace brindle {

struct SmoothFieldAnimator::State {
  SmoothFieldAnimatorOptions options;
  std::shared_ptr<const Adjacency> neighborhood;
  std::vector<Vec3> normals;
  Starts starts = Starts::one;  ///< of the first frame
  Hierarchy hierarchy;
  std::vector<Complex> last_u;  ///< by slot; empty before the first frame
  std::vector<Complex> u_by_vertex;
  std::vector<FieldAnchor> last_anchors;
  DirectionField field;

  Level& finest() { return hierarchy.levels[0]; }
};

namespace {

bool same(const FieldAnchor& a, const FieldAnchor& b) {
  return a.vertex == b.vertex && a.direction == b.direction && a.weight == b.weight;
}

float degree(const Adjacency& neighborhood, Index vertex) {
  return static_cast<float>(neighborhood.of(vertex).size());
}

}  // namespace

SmoothFieldAnimator::SmoothFieldAnimator(const Surface& surface,
                                         const SmoothFieldAnimatorOptions& options,
                                         const Progress& progress)
    : state_(std::make_unique<State>()) {
  if (options.symmetry < 1) throw Error("smooth field: the symmetry N must be 1 or above");
  if (!is_weight(options.lambda)) throw Error("smooth field: lambda must be from 0 to 1e6");
  if (options.sweeps < 0) throw Error("smooth field: sweeps must be 0 or above");
  State& s = *state_;
  s.options = options;
  s.neighborhood = surface.neighborhood;
  s.normals = surface.normals;
  const PhaseGraph graph = direction_graph_of(surface, options.symmetry);
  s.starts = starts_of_field(graph, !surface.mesh.triangles.empty());
  s.hierarchy = build_hierarchy(graph, progress);
}

SmoothFieldAnimator::~SmoothFieldAnimator() = default;
SmoothFieldAnimator::SmoothFieldAnimator(SmoothFieldAnimator&&) noexcept = default;
SmoothFieldAnimator& SmoothFieldAnimator::operator=(SmoothFieldAnimator&&) noexcept = default;

std::span<const Vec3> SmoothFieldAnimator::frame(std::span<const FieldAnchor> anchors,
                                                 const Progress& progress) {
  State& s = *state_;
  const bool first = s.last_u.empty();
  if (!first && ranges::equal(anchors, s.last_anchors, same)) return s.field;
  set_anchors(anchors);
  // Resets the hierarchy: a frame must not depend on what the last solve left in it.
  progress.report("field", 0);
  renew(s.hierarchy);
  if (first && s.starts == Starts::several) {
    descend_from_several(s.hierarchy, s.options.sweeps, progress.step("field").part(0, 0.5));
  } else {
    descend(s.hierarchy, s.options.sweeps);
  }
  progress.report("field", 0.5);

  // Everything that may throw happens before the last frame is overwritten.
  const SlicedLayout& layout = s.finest().layout();
  const std::span<const Complex> u = std::span(s.finest().z).first(layout.slot_count());
  to_nodes(layout, u, s.u_by_vertex);
  DirectionField field = directions_of(s.u_by_vertex, s.normals, s.options.symmetry);
  s.last_u.reserve(u.size());
  if (first) {
    orient_alike(*s.neighborhood, field);
  } else if (s.options.symmetry == 2) {
    orient_like(s.field, field);
  }
  std::vector<FieldAnchor> solved(anchors.begin(), anchors.end());
  s.last_u.assign(u.begin(), u.end());
  s.field = std::move(field);
  s.last_anchors = std::move(solved);
  return s.field;
}

void SmoothFieldAnimator::set_anchors(std::span<const FieldAnchor> anchors) {
  State& s = *state_;
  for (const FieldAnchor& anchor : anchors) check_field_anchor(anchor, s.normals.size());
  const SlicedLayout& layout = s.finest().layout();
  std::vector<Complex>& target = s.finest().couplings.anchor;
  target.assign(layout.slot_count(), Complex(0));
  if (!s.last_u.empty()) {
    for (Index vertex = 0; vertex < layout.slot_of.size(); ++vertex) {
      const Index slot = layout.slot_of[vertex];
      target[slot] = s.options.lambda * degree(*s.neighborhood, vertex) * s.last_u[slot];
    }
  }
  for (const FieldAnchor& anchor : anchors) {
    target[layout.slot_of[anchor.vertex]] +=
        pull_of(anchor, *s.neighborhood, s.normals[anchor.vertex], s.options.symmetry);
  }
}

}  // namespace brindle
