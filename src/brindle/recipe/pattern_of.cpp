#include "brindle/pattern_of.h"

#include <utility>

#include "brindle/base/standard.h"
#include "brindle/boundary_phases.h"
#include "brindle/error.h"
#include "brindle/pipeline/measured_pattern.h"
#include "brindle/waves_of.h"

namespace brindle {
namespace {

// The options with phases fixed at boundaries, if that is requested.
StripeOptions with_boundary(const Surface& surface, const WaveSet& waves, StripeOptions stripes,
                            const FabricationOptions& options, FabricationMetrics& metrics) {
  if (!options.anchor_boundary) return stripes;
  stripes.fixed_phases = boundary_phases(surface, waves, *options.anchor_boundary);
  metrics.fixed_vertices = static_cast<std::size_t>(
      ranges::count_if(stripes.fixed_phases, [](const Complex& z) { return z != Complex(0); }));
  if (metrics.fixed_vertices == 0) {
    throw Error(
        "--anchor-boundary: nowhere do stripes run along a boundary, within 45 degrees; turn the "
        "field by --along or --rotate, or leave out the option");
  }
  return stripes;
}

// The pattern with the requested winding numbers; fixes phases of `stripes` at boundaries.
StripePattern wound_pattern(const Surface& surface, WaveSet waves, StripeOptions& stripes,
                            const FabricationOptions& options, const Progress& progress,
                            FabricationMetrics& metrics) {
  if (options.windings.empty()) {
    stripes = with_boundary(surface, waves, stripes, options, metrics);
    return stripe_pattern(surface, std::move(waves), stripes, progress);
  }
  WoundPattern wound = wind(surface, stripe_pattern(surface, std::move(waves), stripes, progress),
                            options.windings, stripes, progress);
  metrics.windings_before = wound.before;
  metrics.energy_before = wound.energy_before;
  metrics.largest_turn_deg = wound.largest_turn_deg;
  metrics.mean_turn_deg = wound.mean_turn_deg;
  metrics.largest_frequency_change = wound.largest_frequency_change;
  if (!options.anchor_boundary) return std::move(wound.pattern);
  stripes = with_boundary(surface, wound.pattern.waves, stripes, options, metrics);
  WaveSet turned = wound.pattern.waves;
  return resolve_with_frequencies(surface, std::move(turned), wound.pattern, stripes, progress);
}

// Cancels pairs of branches as requested.
template <class Pattern, class Options>
void cancel_pairs(const Surface& surface, const FabricationOptions& fabrication,
                  const Options& options, const Progress& progress, Pattern& pattern,
                  FabricationMetrics& metrics) {
  if (!fabrication.cancel_branches) return;
  CancellationOptions cancellation{static_cast<double>(*fabrication.cancel_branches)};
  if (fabrication.cancel_distance)
    cancellation.distance = static_cast<double>(*fabrication.cancel_distance);
  metrics.cancelled_branches = cancel_branches(surface, pattern, cancellation, options, progress);
}

StripePattern made_stripes(const Surface& surface, WaveSet waves, StripeOptions stripes,
                           const FabricationOptions& options, const Progress& progress,
                           FabricationMetrics& metrics) {
  StripePattern pattern =
      wound_pattern(surface, std::move(waves), stripes, options, progress, metrics);
  cancel_pairs(surface, options, stripes, progress, pattern, metrics);
  return pattern;
}

PatternResult made_texture(const Surface& surface, WaveSet waves, const PatternRequest& request,
                           const Progress& progress) {
  const TextureOptions options{request.frequencies_v, request.oriented, request.solving};
  FabricationMetrics metrics;
  TexturePattern texture = texture_pattern(surface, std::move(waves), options, progress);
  cancel_pairs(surface, request.fabrication, options, progress, texture, metrics);
  return {std::move(texture), std::move(metrics)};
}

PatternResult made_crosses(const Surface& surface, const WaveSet& waves,
                           const PatternRequest& request, const Progress& progress) {
  const bool cancels = request.fabrication.cancel_branches.has_value();
  FabricationMetrics metrics;
  CrossPattern cross =
      cross_pattern(surface, waves, request.solving, progress.part(0, cancels ? 0.5 : 0.9));
  cancel_pairs(surface, request.fabrication, request.solving, progress.part(0.5, 0.9), cross,
               metrics);
  CrossTexture texture = cross_texture(surface, cross, request.solving.phase_shift,
                                       progress.part(0.9, 1).step("texture"));
  return {CrossResult{std::move(cross), std::move(texture)}, std::move(metrics)};
}

bool winds_or_begins(const FabricationOptions& fabrication) {
  return fabrication.anchor_boundary || !fabrication.windings.empty() ||
         fabrication.measure_windings;
}

void check_request(const PatternRequest& request) {
  if (request.kind != PatternKind::stripes && winds_or_begins(request.fabrication)) {
    throw Error(
        "windings and anchored boundaries are for stripes: ask for no texture and no crosses, or "
        "leave them out");
  }
  if (request.kind != PatternKind::texture &&
      (request.oriented || !request.frequencies_v.empty())) {
    throw Error(
        "frequencies of V and directions that are vectors are for textures: ask for one, or leave "
        "them out");
  }
}

}  // namespace

PatternResult pattern_of(const Surface& surface, WaveSet waves, const PatternRequest& request,
                         const Progress& progress) {
  check_request(request);
  switch (request.kind) {
    case PatternKind::stripes:
      break;
    case PatternKind::texture:
      return made_texture(surface, std::move(waves), request, progress);
    case PatternKind::crosses:
      return made_crosses(surface, waves, request, progress);
  }
  FabricationMetrics metrics;
  StripePattern stripes = made_stripes(surface, std::move(waves), request.solving,
                                       request.fabrication, progress, metrics);
  const bool winds = request.fabrication.measure_windings || !request.fabrication.windings.empty();
  if (winds) measure_windings(surface, stripes, metrics);
  return {std::move(stripes), std::move(metrics)};
}

void measure_windings(const Surface& surface, const StripePattern& pattern,
                      FabricationMetrics& metrics) {
  metrics.loops = surface_loops(surface);
  metrics.windings = windings(surface, metrics.loops, pattern);
  metrics.branches.clear();
  metrics.centers.clear();
  for (const SurfaceLoop& loop : metrics.loops) {
    metrics.branches.push_back(branches_of_piece(surface, loop, pattern));
    metrics.centers.push_back(loop.center + surface.mesh.origin);
  }
  metrics.sums = winding_sums(surface, metrics.loops, pattern);
}

StripePattern pattern_of_frame(const FrameResult& frame, WaveSet waves, double energy,
                               PhaseShiftKind phase_shift) {
  StripePattern pattern;
  set_frame(std::move(waves), frame, pattern);
  pattern.phase_shift = phase_shift;
  pattern.solution.energy = energy;
  return pattern;
}

TexturePattern pattern_of_frame(const TextureFrameResult& frame, const TextureAnimator& animator) {
  TexturePattern pattern = frame.pattern;
  pattern.u.solution.energy = animator.energy_u();
  pattern.v.solution.energy = animator.energy_v();
  return pattern;
}

TexturePattern pattern_of_frame(const CrossFrameResult& frame, const CrossAnimator& animator,
                                PhaseShiftKind phase_shift) {
  TexturePattern pattern;
  StripePattern& u = pattern.u;
  const WaveSet& nodes = frame.cover.waves;
  u.waves.positions = frame.mesh.positions;
  u.waves.directions.assign(frame.mesh.vertex_count(), Vec3::Zero());
  u.waves.frequencies.assign(frame.mesh.vertex_count(), nodes.frequencies.front());
  for (std::size_t i = 0; 2 * i < nodes.directions.size(); ++i) {
    u.waves.directions[i] = nodes.directions[2 * i];
    u.waves.frequencies[i] = nodes.frequencies[2 * i];
  }
  u.corners = corner_phases(frame.waves.u, phase_shift);
  for (std::size_t t = frame.cover.base.size(); t < u.corners.size(); ++t) {
    u.corners[t].kind = TriangleKind::field_singularity;  // parts of singular triangles
  }
  u.phase_shift = phase_shift;
  u.solution.energy = animator.energy();
  u.quality = frame.quality;
  u.milliseconds = times_of(frame.stripes.milliseconds);
  pattern.waves = frame.waves;
  pattern.quality = frame.texture;
  pattern.phase_shift = phase_shift;
  pattern.orientation_milliseconds = frame.milliseconds.orient + frame.milliseconds.measure;
  return pattern;
}

}  // namespace brindle
