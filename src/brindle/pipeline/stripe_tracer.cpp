#include "brindle/stripe_tracer.h"

#include <memory>
#include <string>

#include "brindle/direction_field.h"
#include "brindle/error.h"
#include "brindle/geometry/topology.h"
#include "brindle/pattern/curve_spacing.h"
#include "brindle/pattern/lifted_waves.h"
#include "brindle/pattern/sampling.h"
#include "brindle/pattern/stripe_curves.h"
#include "brindle/points.h"

namespace brindle {

struct StripeTracer::State {
  const Surface& surface;
  MeshEdges edges;

  WavePattern waves_of(const StripePattern& pattern) const {
    return {surface.mesh,         edges,
            surface.normals,      pattern.waves,
            pattern.solution.z,   pattern.phase_shift,
            surface.creases.edges};
  }
};

namespace {

/// Patterns of animation frames may have no corners.
void check_belongs(const Surface& surface, const StripePattern& pattern) {
  if (pattern.solution.z.size() == surface.mesh.vertex_count() &&
      (pattern.corners.empty() || pattern.corners.size() == surface.mesh.triangle_count())) {
    return;
  }
  throw Error("a pattern of " + std::to_string(pattern.solution.z.size()) + " vertices and " +
              std::to_string(pattern.corners.size()) + " triangles was not made for a surface of " +
              std::to_string(surface.mesh.vertex_count()) + " and " +
              std::to_string(surface.mesh.triangle_count()));
}

void check_traceable(const Surface& surface, const StripePattern& pattern) {
  check_belongs(surface, pattern);
  if (surface.mesh.triangles.empty()) throw Error("curves need triangles; points have none");
}

}  // namespace

StripeTracer::StripeTracer(const Surface& surface, const Progress& progress)
    : state_(std::make_unique<State>(State{surface, {}})) {
  if (surface.mesh.triangles.empty()) return;
  state_->edges = mesh_edges(surface.mesh, *surface.neighborhood, progress);
}

StripeTracer::~StripeTracer() = default;
StripeTracer::StripeTracer(StripeTracer&&) noexcept = default;
StripeTracer& StripeTracer::operator=(StripeTracer&&) noexcept = default;

StripeCurves StripeTracer::curves(const StripePattern& pattern, const CurveOptions& options,
                                  const Progress& progress) const {
  check_traceable(state_->surface, pattern);
  check_curve_options(options);
  const LiftedWaves lifted(state_->waves_of(pattern), progress.part(0, 0.2));
  return brindle::stripe_curves(lifted, options, progress.part(0.2, 1));
}

std::optional<CurveSpacing> StripeTracer::spacing(const StripePattern& pattern,
                                                  const StripeCurves& curves,
                                                  const Progress& progress) const {
  check_traceable(state_->surface, pattern);
  if (!has_point_trees()) return std::nullopt;
  const CurveSpacing spacing = measure_curve_spacing(
      state_->waves_of(pattern), curves, kMostSpacingPoints, pattern.frequencies_wanted, progress);
  if (spacing.measured == 0 && spacing.gaps.measured == 0) return std::nullopt;
  return spacing;
}

std::vector<Sample> StripeTracer::crossings(const StripePattern& u, const StripePattern& v,
                                            const Progress& progress) const {
  const Surface& surface = state_->surface;
  check_belongs(surface, u);
  check_belongs(surface, v);
  if (surface.mesh.triangles.empty()) {
    return point_samples(*surface.neighborhood, surface.normals, {u.waves, u.solution.z},
                         {v.waves, v.solution.z});
  }
  const LiftedWaves lifted_u(state_->waves_of(u), progress.part(0, 0.2));
  const LiftedWaves lifted_v(state_->waves_of(v), progress.part(0.2, 0.4));
  return wave_samples(lifted_u, lifted_v, progress.part(0.4, 1));
}

namespace {

/// Makes wave directions consistent across creases, too.
void run_alike(const Surface& surface, StripePattern& pattern) {
  const std::vector<Vec3> before = pattern.waves.directions;
  orient_alike(surface, pattern.waves.directions);
  for (std::size_t v = 0; v < before.size(); ++v) {
    Complex& z = pattern.solution.z[v];
    if (pattern.waves.directions[v].dot(before[v]) < 0) z = -std::conj(z);
  }
}

}  // namespace

std::size_t shift_stripes(const Surface& surface, float periods, StripePattern& pattern) {
  check_belongs(surface, pattern);
  if (!surface.creases.empty()) run_alike(surface, pattern);
  return shift_phases(*surface.neighborhood, periods, pattern.waves, pattern.solution.z);
}

StripeCurves stripe_curves(const Surface& surface, const StripePattern& pattern,
                           const CurveOptions& options, const Progress& progress) {
  check_traceable(surface, pattern);
  JobStages stages(progress, {{"edges", 3}, {"trace", 12}});
  const StripeTracer tracer(surface, stages.begin("edges"));
  StripeCurves curves = tracer.curves(pattern, options, stages.begin("trace"));
  stages.finish();
  return curves;
}

CurveMeasures measure_curves(const Surface& surface, const StripePattern& pattern,
                             const StripeCurves& curves, double path_width,
                             const Progress& progress) {
  check_traceable(surface, pattern);
  JobStages stages(progress, {{"lengths", 1}, {"gaps", 10}, {"coverage", 5}});
  stages.begin("lengths");
  CurveMeasures measures;
  measures.lengths = curve_lengths(curves.lines);
  const Progress measuring = stages.begin("gaps");
  const StripeTracer tracer(surface, measuring.part(0, 0.1));
  const auto spacing = tracer.spacing(pattern, curves, measuring.part(0.1, 1));
  if (spacing && spacing->gaps.measured > 0) measures.gaps = spacing->gaps;
  if (path_width != 0) {
    const CurveCoverage coverage =
        measure_coverage(surface.mesh, curves.lines, path_width, stages.begin("coverage"));
    measures.coverage = coverage.once;
    measures.covered_twice = coverage.twice;
  }
  stages.finish();
  return measures;
}

std::vector<Sample> stripe_samples(const Surface& surface, const StripePattern& u,
                                   const StripePattern& v, const Progress& progress) {
  check_belongs(surface, u);
  check_belongs(surface, v);
  JobStages stages(progress, {{"edges", 2}, {"crossings", 7}, {"doubles", 3}});
  const StripeTracer tracer(surface, stages.begin("edges"));
  std::vector<Sample> samples = tracer.crossings(u, v, stages.begin("crossings"));
  drop_doubles(samples, kDoubleShare, stages.begin("doubles"));
  stages.finish();
  return samples;
}

}  // namespace brindle
