#include "brindle/pipeline/field_animator.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "brindle/base/error.h"
#include "brindle/base/parallel.h"
#include "brindle/phases/multilevel.h"
#include "brindle/waves/direction_graph.h"

namespace brindle {
namespace {

void check(const FieldAnimatorOptions& options) {
  if (options.symmetry < 1) throw Error("field animator: the symmetry N must be 1 or above");
  if (!(options.lambda >= 0) || !std::isfinite(options.lambda)) {
    throw Error("field animator: lambda must be a finite number, zero or more");
  }
  if (options.sweeps < 0) throw Error("field animator: the number of sweeps must be 0 or above");
}

bool same(const FieldAnchor& a, const FieldAnchor& b) {
  return a.vertex == b.vertex && a.direction == b.direction && a.weight == b.weight;
}

/// Which of the N angles that u = exp(i N theta) stands for is nearest to `last`.
float nearest_angle(Complex u, int symmetry, float last) {
  constexpr float kTurn = 2 * std::numbers::pi_v<float>;
  const auto n = static_cast<float>(symmetry);
  const float step = std::remainder(std::arg(u) - n * last, kTurn) / n;
  return std::remainder(last + step, kTurn);
}

}  // namespace

FieldAnimator::FieldAnimator(std::shared_ptr<const Adjacency> neighborhood,
                             std::span<const Vec3> normals, const FieldAnimatorOptions& options)
    : options_(options),
      neighborhood_(std::move(neighborhood)),
      normals_(normals.begin(), normals.end()),
      angle_(normals.size()) {
  check(options);
  if (neighborhood_->node_count() != normals.size()) {
    throw Error("field animator: " + std::to_string(normals.size()) + " normals for " +
                std::to_string(neighborhood_->node_count()) + " vertices");
  }
}

const DirectionField& FieldAnimator::frame(std::span<const FieldAnchor> anchors) {
  const bool first = hierarchy_.levels.empty();
  if (!first && std::ranges::equal(anchors, anchors_, same)) return directions_;
  anchors_.assign(anchors.begin(), anchors.end());
  if (first) {
    PhaseGraph graph = build_direction_graph(neighborhood_, normals_, options_.symmetry);
    graph.anchor.resize(graph.node_count());
    hierarchy_ = build_hierarchy(graph);
    gauged_.resize(hierarchy_.levels[0].layout().entry_count() + 1);
    directions_.assign(graph.node_count(), Vec3::Zero());
  }
  renew_anchors(first ? 0 : options_.lambda);
  descend(hierarchy_, options_.sweeps);
  turn_to_solution();
  return directions_;
}

void FieldAnimator::renew_anchors(float lambda) {
  Level& finest = hierarchy_.levels[0];
  const auto degree = [&](Index vertex) {
    return static_cast<float>(neighborhood_->of(vertex).size());
  };
  for (Index v = 0; v < normals_.size(); ++v) {
    const Index slot = finest.layout().slot_of[v];
    finest.couplings.anchor[slot] = lambda * degree(v) * finest.z[slot];
  }
  for (const FieldAnchor& a : anchors_) {
    finest.couplings.anchor[finest.layout().slot_of[a.vertex]] +=
        a.weight * degree(a.vertex) *
        representation(a.direction, normals_[a.vertex], options_.symmetry);
  }
  renew(hierarchy_, gauged_);
}

void FieldAnimator::turn_to_solution() {
  const Level& finest = hierarchy_.levels[0];
  parallel_for(normals_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      if (normals_[v].isZero(0)) continue;
      const Complex u = finest.z[finest.layout().slot_of[v]];
      angle_[v] = nearest_angle(u, options_.symmetry, angle_[v]);
      const TangentBasis basis = tangent_basis(normals_[v]);
      directions_[v] = std::cos(angle_[v]) * basis.x + std::sin(angle_[v]) * basis.y;
    }
  });
}

}  // namespace brindle
