#include "brindle/smooth_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/direction_field.h"
#include "brindle/error.h"
#include "brindle/normals.h"
#include "brindle/phases/hierarchy.h"
#include "brindle/phases/multilevel.h"
#include "brindle/phases/screened.h"
#include "brindle/phases/several_starts.h"
#include "brindle/pipeline/fields/field_anchors.h"
#include "brindle/pipeline/fields/surface_elements.h"
#include "brindle/progress.h"
#include "brindle/solver.h"
#include "brindle/surface.h"
#include "brindle/types.h"
#include "brindle/waves/circulation.h"
#include "brindle/waves/direction_graph.h"
#include "brindle/waves/wave_check.h"

namespace brindle {
namespace {

// Averaged normals of a surface, and transfer of fields between sets of normals.

/// A field that is tangent to some normals of a surface.
struct FieldOnNormals {
  std::vector<Vec3> normals;
  DirectionField directions;
};

class Averaging {
 public:
  Averaging(const Surface& surface, const Progress& progress) : normals_(surface.normals) {
    const std::vector<float> stiffness = edge_stiffness(surface, progress);
    areas_ = areas_of_vertices(surface, areas_of_triangles(surface.mesh));
    degrees_ = stiffness_sums(*surface.neighborhood, stiffness);
    graph_ = stiffness_graph(surface, stiffness);
    graph_.anchor.resize(normals_.size());
    for (std::size_t i = 0; i < normals_.size(); ++i) {
      if (normals_[i].isZero(0)) areas_[i] = 0;  // no anchor
      across_.emplace_back(normals_[i].x(), normals_[i].y());
      up_.emplace_back(normals_[i].z());
    }
    averaged_across_ = across_;
    averaged_up_ = up_;
  }

  /// Starts from the previous average, which is close.
  std::vector<Vec3> over(float radius, const Progress& progress) {
    average(radius, across_, averaged_across_, progress.part(0, 0.6));
    average(radius, up_, averaged_up_, progress.part(0.6, 1));
    std::vector<Vec3> averages(normals_.size());
    for (std::size_t i = 0; i < averages.size(); ++i) {
      const Complex& across = averaged_across_[i];
      const Vec3 sum(across.real(), across.imag(), averaged_up_[i].real());
      constexpr float kNoDirection = 1e-3f;
      const bool has_direction = sum.norm() > kNoDirection && !normals_[i].isZero(0);
      averages[i] = has_direction ? Vec3(sum.normalized()) : normals_[i];
    }
    return averages;
  }

 private:
  void average(float radius, std::span<const Complex> values, std::vector<Complex>& averages,
               const Progress& progress) {
    // With decay length l, a screened field has a root mean square distance of 2 l.
    std::vector<float> screening = areas_;
    for (float& s : screening) s *= 4 / (radius * radius);
    for (std::size_t i = 0; i < values.size(); ++i) graph_.anchor[i] = screening[i] * values[i];
    averages = smooth_screened(graph_, screening, std::move(averages),
                               {.of_anchors = true, .degrees = degrees_, .progress = progress});
  }

  std::span<const Vec3> normals_;
  std::vector<float> areas_;    ///< of vertices
  std::vector<float> degrees_;  ///< sums of stiffness
  PhaseGraph graph_;            ///< coupled by the stiffness of edges
  std::vector<Complex> across_, up_, averaged_across_, averaged_up_;
};

constexpr double kBeforeAverages = 0.2;

/// Multiples of the requested radius.
constexpr std::array<float, 3> kFarther = {1, 2, 4};

/// Unit normals averaged over the surface, one set for each of `radii`. Radii are root mean square
/// distances in units of length, above 0 and ascending. Zero where the surface's normals are; the
/// surface's own where the average vanishes. Independent of the mesh resolution. Throws Cancelled
/// if `progress` asks for it.
std::vector<std::vector<Vec3>> averaged_normals(const Surface& surface,
                                                std::span<const float> radii,
                                                const Progress& progress = {}) {
  Averaging averaging(surface, progress.part(0, kBeforeAverages));
  const Progress averages = progress.part(kBeforeAverages, 1);
  std::vector<std::vector<Vec3>> normals;
  for (const float radius : radii) {
    const double each = 1 / static_cast<double>(radii.size());
    const auto done = static_cast<double>(normals.size());
    normals.push_back(averaging.over(radius, averages.part(done * each, (done + 1) * each)));
  }
  return normals;
}

/// Averaging radii of a coarse-to-fine solve, ascending; it starts with the last. A field that
/// continues (`goes_on`) from a previous one only needs the first.
std::vector<float> averaging_radii(float normal_radius, bool goes_on) {
  std::vector<float> radii(goes_on ? 1 : kFarther.size());
  for (std::size_t i = 0; i < radii.size(); ++i) radii[i] = kFarther[i] * normal_radius;
  return radii;
}

/// Rotates directions tangent to `from` until they are tangent to `to`.
void turn_to_normals(std::span<const Vec3> from, std::span<const Vec3> to, DirectionField& field) {
  parallel_for(field.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (field[i].isZero(0) || from[i] == to[i]) continue;
      // On fine folds the new normal may be that of the opposite side: mirror the direction.
      const bool folded = from[i].dot(to[i]) < kOppositeSides;
      field[i] =
          tangent_direction(transported(field[i], from[i], folded ? Vec3(-to[i]) : to[i]), to[i]);
    }
  });
}

/// The field's values in the direction graph of `normals`; 0 without a direction.
std::vector<Complex> values_at(FieldOnNormals field, std::span<const Vec3> normals, int symmetry) {
  turn_to_normals(field.normals, normals, field.directions);
  std::vector<Complex> u(normals.size());
  parallel_for(u.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      u[i] = representation(field.directions[i], normals[i], symmetry);
    }
  });
  return u;
}

void add_curvature(PhaseGraph& graph, const Surface& surface, const SmoothFieldOptions& options,
                   const Progress& progress) {
  const auto curvatures = principal_curvatures(surface.mesh.positions, surface.normals,
                                               *surface.neighborhood, progress);
  std::vector<float> sorted;
  for (Index i = 0; const float difference : curvature_differences(curvatures)) {
    if (!surface.neighborhood->of(i++).empty()) sorted.push_back(difference);
  }
  if (sorted.empty()) return;
  const auto tenth = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() * 9 / 10);
  std::nth_element(sorted.begin(), tenth, sorted.end());
  add_curvature_anchors(graph, surface.normals, curvatures, *tenth, options);
}

void add_anchors(PhaseGraph& graph, const Surface& surface, std::span<const FieldAnchor> anchors,
                 int symmetry) {
  for (const FieldAnchor& anchor : anchors) check_field_anchor(anchor, graph.node_count());
  for (const FieldAnchor& anchor : anchors) {
    graph.anchor[anchor.vertex] +=
        pull_of(anchor, *graph.adjacency, surface.normals[anchor.vertex], symmetry);
  }
}

void add_feature_anchors(PhaseGraph& graph, const Surface& surface,
                         const SmoothFieldOptions& options, const Progress& progress) {
  if (options.feature_radius > 0) {
    const std::vector<FieldStroke> strokes =
        feature_strokes(surface, options.feature_angle_deg, options.feature_radius,
                        options.feature_anchor, progress.part(0, 0.5));
    return add_anchors(graph, surface, stroke_anchors(surface, strokes, progress.part(0.5, 1)),
                       options.symmetry);
  }
  add_feature_anchors(graph, surface.mesh, *surface.neighborhood, surface.normals, options);
}

std::vector<JobStage> stages_of(const SmoothFieldOptions& options) {
  std::vector<JobStage> stages = {{"transport", 4}};
  if (options.curvature_anchor > 0) stages.push_back({"curvature", 4});
  if (options.feature_anchor > 0) stages.push_back({"features", 4});
  stages.insert(stages.end(), {{"solve", 10}, {"directions", 1}, {"orient", 2}});
  return stages;
}

bool has_anchors(const SmoothFieldOptions& options) {
  return options.curvature_anchor > 0 || options.feature_anchor > 0 || !options.anchors.empty();
}

/// Returns the strength of the curvature anchors by node.
std::vector<float> add_all_anchors(PhaseGraph& graph, const Surface& surface,
                                   const SmoothFieldOptions& options, JobStages& stages) {
  if (has_anchors(options)) graph.anchor.resize(graph.node_count());
  if (options.curvature_anchor > 0)
    add_curvature(graph, surface, options, stages.begin("curvature"));
  std::vector<float> of_curvature = anchor_strengths(graph);
  if (options.feature_anchor > 0) {
    add_feature_anchors(graph, surface, options, stages.begin("features"));
  }
  add_anchors(graph, surface, options.anchors, options.symmetry);
  return of_curvature;
}

SolverOptions solver_options(const SmoothFieldOptions& options) {
  SolverOptions solver;
  solver.sweeps = options.sweeps;
  solver.cycles = options.cycles;
  return solver;
}

std::vector<Complex> values_from(const PhaseGraph& graph, std::vector<Complex> start,
                                 const SmoothFieldOptions& options, const Progress& progress) {
  // Zero at nodes without coupling or anchor.
  ranges::replace(start, Complex(0), kPeak);
  Hierarchy hierarchy = build_hierarchy(graph, progress.part(0, 0.3));
  Level& finest = hierarchy.levels[0];
  to_slots(finest.layout(), start, finest.z);
  run_cycles(hierarchy, options.sweeps, std::max(1, options.cycles), progress.part(0.3, 1));
  return to_nodes(finest.layout(), finest.z);
}

DirectionField following_field(const Surface& surface, PhaseGraph& graph,
                               std::vector<float> of_curvature, const SmoothFieldOptions& options,
                               const Progress& progress) {
  LastValues last = last_values(options.last, surface.normals, options.symmetry);
  last.noisy = std::move(of_curvature);
  const std::vector<Complex> start = warm_start(graph, last, [&] {
    return solve_phases(graph, solver_options(options), progress.part(0, 0.5)).z;
  });
  const std::vector<Complex> u = values_from(graph, start, options, progress.part(0.5, 1));
  DirectionField field = directions_of(u, surface.normals, options.symmetry);
  align_with_previous(*surface.neighborhood, u, surface.normals, options.last.directions,
                      options.symmetry, field);
  return field;
}

/// `from`: initial field, if any.
LowestPhases solved(const Surface& seen, const PhaseGraph& graph,
                    std::optional<FieldOnNormals> from, const SmoothFieldOptions& options,
                    const Progress& progress) {
  if (!from) {
    return solve_from(starts_of_field(graph, !seen.mesh.triangles.empty()), graph, options.sweeps,
                      options.cycles, progress);
  }
  std::vector<Complex> start = values_at(*std::move(from), seen.normals, options.symmetry);
  return {values_from(graph, std::move(start), options, progress)};
}

/// Returns the initial field for the first of `normals`, which `seen` then has. Solves with the
/// last and passes the field on through those between. Normals averaged over longer distances have
/// fewer singularities; a field solved from scratch gets trapped in unnecessary ones.
std::optional<FieldOnNormals> coarse_to_fine_field(Surface& seen,
                                                   std::vector<std::vector<Vec3>> normals,
                                                   const SmoothFieldOptions& options,
                                                   const Progress& progress) {
  std::optional<FieldOnNormals> field;
  const auto steps = static_cast<double>(normals.size() - 1);
  for (double done = 0; normals.size() > 1; ++done) {
    seen.normals = std::move(normals.back());
    normals.pop_back();
    JobStages stages(progress.part(done / steps, (done + 1) / steps), stages_of(options));
    PhaseGraph graph = direction_graph_of(seen, options.symmetry, stages.begin("transport"));
    add_all_anchors(graph, seen, options, stages);
    const LowestPhases u = solved(seen, graph, std::move(field), options, stages.begin("solve"));
    field = {seen.normals,
             directions_of(u.z, seen.normals, options.symmetry, stages.begin("directions"))};
  }
  seen.normals = std::move(normals.front());
  return field;
}

/// The field of a surface, solved with the normals of `seen`. `from`: initial field, if any.
DirectionField field_of(const Surface& surface, const Surface& seen,
                        std::optional<FieldOnNormals> from, const SmoothFieldOptions& options,
                        JobStages& stages) {
  PhaseGraph graph = direction_graph_of(seen, options.symmetry, stages.begin("transport"));
  std::vector<float> of_curvature = add_all_anchors(graph, seen, options, stages);
  if (!options.last.directions.empty()) {
    DirectionField field =
        following_field(seen, graph, std::move(of_curvature), options, stages.begin("solve"));
    turn_to_normals(seen.normals, surface.normals, field);
    return field;
  }
  const LowestPhases u = solved(seen, graph, std::move(from), options, stages.begin("solve"));
  DirectionField field =
      directions_of(u.z, seen.normals, options.symmetry, stages.begin("directions"));
  turn_to_normals(seen.normals, surface.normals, field);
  if (!surface.mesh.triangles.empty() && turns_freely(graph, options.symmetry)) {
    const CurlSums sums = curl_sums(surface.mesh, field, surface.normals);
    turn_to_least_curl(sums, u.is_lower, surface.normals, field);
  }
  orient_alike(surface, field, stages.begin("orient"));
  return field;
}

}  // namespace

void check_smoothing(const SmoothFieldOptions& options) {
  const auto require = [](bool holds, const char* message) {
    if (!holds) throw Error(std::string("smooth field: ") + message);
  };
  const auto length = [](float radius) { return std::isfinite(radius) && radius >= 0; };
  require(options.symmetry >= 1, "the symmetry N must be 1 or above");
  require(is_weight(options.curvature_anchor) && is_weight(options.feature_anchor),
          "anchors must be numbers from 0 to 1e6");
  require(std::isfinite(options.feature_angle_deg), "the feature angle must be finite");
  require(length(options.feature_radius), "the feature radius must be finite and 0 or above");
  require(length(options.normal_radius), "the normal radius must be finite and 0 or above");
  require(options.feature_anchor == 0 || options.symmetry % 2 == 0,
          "edges have no sign; feature anchors need an even symmetry");
}

DirectionField smooth_direction_field(const Surface& surface, const SmoothFieldOptions& options,
                                      const Progress& progress) {
  check_smoothing(options);
  check_positions(surface.mesh.positions);
  if (surface.mesh.vertex_count() == 0) return {};
  check_known(options.last, surface.mesh.vertex_count(), "the last field");
  std::vector<JobStage> in_order = stages_of(options);
  if (options.normal_radius > 0) {
    in_order.insert(in_order.begin(), {{"normals", 25}, {"from afar", 35}});
  }
  JobStages stages(progress, std::move(in_order));
  DirectionField field;
  if (options.normal_radius > 0) {
    std::vector<std::vector<Vec3>> normals = averaged_normals(
        surface, averaging_radii(options.normal_radius, !options.last.directions.empty()),
        stages.begin("normals"));
    Surface seen = surface;
    std::optional<FieldOnNormals> from =
        coarse_to_fine_field(seen, std::move(normals), options, stages.begin("from afar"));
    field = field_of(surface, seen, std::move(from), options, stages);
  } else {
    field = field_of(surface, surface, std::nullopt, options, stages);
  }
  stages.finish();
  return field;
}

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
