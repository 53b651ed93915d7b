#include <emscripten/bind.h>

#include "brindle/corner_phases.h"
#include "brindle/pattern_warnings.h"
#include "brindle/quality.h"
#include "objects.h"

namespace brindle::web {
namespace {

std::shared_ptr<PatternObject> stripes(const std::shared_ptr<SurfaceObject>& surface,
                                       const val& directions, const val& frequencies,
                                       const val& given) {
  StripePattern pattern = stripe_pattern(surface->surface, vectors_of(directions),
                                         floats_of(frequencies), stripe_options(given));
  return std::make_shared<PatternObject>(PatternObject{surface, std::move(pattern)});
}

val metrics_of(const PatternObject& object) {
  const StripePattern& p = object.pattern;
  val metrics = val::object();
  put(metrics, "energy", p.solution.energy);
  put(metrics, "branches", p.quality.branches);
  put(metrics, "fieldSingularities", p.quality.field_singularities);
  put(metrics, "angleErrorMean", p.quality.angle_error_mean_deg);
  put(metrics, "spacingErrorMean", p.quality.spacing_error_mean);
  put(metrics, "verticesWithoutWave", p.quality.vertices_without_wave);
  val milliseconds = val::object();
  put(milliseconds, "topology", p.milliseconds.topology);
  put(milliseconds, "frequency", p.milliseconds.frequency);
  put(milliseconds, "couple", p.milliseconds.couple);
  put(milliseconds, "solve", p.milliseconds.solve);
  put(milliseconds, "pattern", p.milliseconds.pattern);
  put(metrics, "milliseconds", milliseconds);
  if (p.frequency_change) {
    val change = val::object();
    put(change, "ratioMin", p.frequency_change->ratio_min);
    put(change, "ratioMax", p.frequency_change->ratio_max);
    put(metrics, "frequencyChange", change);
  }
  if (const auto slip = crease_slip(object.surface->surface, p.waves, p.solution.z)) {
    put(metrics, "creaseSlipMean", slip->mean_deg);
    put(metrics, "creaseSlipShare", slip->share);
  }
  return metrics;
}

val warnings_of(const PatternObject& object) {
  const SurfaceObject& surface = *object.surface;
  return array_of(pattern_warnings(surface.surface, object.pattern, words_for(surface)));
}

}  // namespace

StripeOptions stripe_options(const val& given) {
  StripeOptions options;
  options.slack = float_of(given, "slack");
  options.solver.cycles = int_of(given, "cycles");
  options.last_phases = [&] {
    const std::vector<float> parts = floats_of(given["lastPhases"]);
    std::vector<Complex> phases(parts.size() / 2);
    for (std::size_t i = 0; i < phases.size(); ++i) phases[i] = {parts[2 * i], parts[2 * i + 1]};
    return phases;
  }();
  return options;
}

val kinds_of(std::span<const CornerPhases> triangles) {
  std::vector<std::uint8_t> kinds;
  kinds.reserve(triangles.size());
  for (const CornerPhases& corners : triangles) {
    kinds.push_back(static_cast<std::uint8_t>(corners.kind));
  }
  return array_of(kinds);
}

void bind_patterns() {
  using namespace emscripten;
  class_<PatternObject>("PatternObject")
      .smart_ptr<std::shared_ptr<PatternObject>>("PatternPointer")
      .function("metrics", &metrics_of)
      .function("kinds", optional_override(
                             [](const PatternObject& p) { return kinds_of(p.pattern.corners); }))
      .function("phases", optional_override([](const PatternObject& p) {
                  return array_of(p.pattern.solution.z);
                }))
      .function("directions", optional_override([](const PatternObject& p) {
                  return array_of(p.pattern.waves.directions);
                }))
      .function("frequencies", optional_override([](const PatternObject& p) {
                  return array_of(p.pattern.waves.frequencies);
                }))
      .function("warnings", guarded<warnings_of>);
  function("stripes", guarded<stripes>);
}

}  // namespace brindle::web
