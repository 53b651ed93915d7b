#include <emscripten/bind.h>

#include "brindle/corner_phases.h"
#include "brindle/pattern_warnings.h"
#include "brindle/polylines.h"
#include "brindle/samples.h"
#include "brindle/texture_coordinates.h"
#include "objects.h"

namespace brindle::web {
namespace {

StripeOptions options_of(const val& given) {
  StripeOptions options;
  options.slack = given["slack"].as<float>();
  options.solver.cycles = given["cycles"].as<int>();
  options.last_phases = [&] {
    const std::vector<float> parts = floats_of(given["lastPhases"]);
    std::vector<Complex> phases(parts.size() / 2);
    for (std::size_t i = 0; i < phases.size(); ++i) phases[i] = {parts[2 * i], parts[2 * i + 1]};
    return phases;
  }();
  return options;
}

std::shared_ptr<PatternObject> stripes(std::shared_ptr<SurfaceObject> surface, val directions,
                                       val frequencies, val given) {
  return guarded([&] {
    StripePattern pattern = stripe_pattern(surface->surface, vectors_of(directions),
                                           floats_of(frequencies), options_of(given));
    return std::make_shared<PatternObject>(PatternObject{surface, std::move(pattern)});
  });
}

std::shared_ptr<TextureObject> texture(std::shared_ptr<SurfaceObject> surface, val directions,
                                       float frequency, bool oriented, val given) {
  return guarded([&] {
    TextureOptions options;
    options.oriented = oriented;
    options.stripes = options_of(given);
    TexturePattern pattern =
        texture_pattern(surface->surface, vectors_of(directions), frequency, options);
    return std::make_shared<TextureObject>(TextureObject{surface, std::move(pattern)});
  });
}

val figures_of(const PatternObject& object) {
  const StripePattern& p = object.pattern;
  val figures = val::object();
  figures.set("energy", p.solution.energy);
  figures.set("branches", p.quality.branches);
  figures.set("fieldSingularities", p.quality.field_singularities);
  figures.set("angleErrorMean", p.quality.angle_error_mean_deg);
  figures.set("spacingErrorMean", p.quality.spacing_error_mean);
  figures.set("verticesWithoutWave", p.quality.vertices_without_wave);
  val milliseconds = val::object();
  milliseconds.set("topology", p.milliseconds.topology);
  milliseconds.set("frequency", p.milliseconds.frequency);
  milliseconds.set("couple", p.milliseconds.couple);
  milliseconds.set("solve", p.milliseconds.solve);
  milliseconds.set("pattern", p.milliseconds.pattern);
  figures.set("milliseconds", milliseconds);
  if (p.frequency_change) {
    val change = val::object();
    change.set("ratioMin", p.frequency_change->ratio_min);
    change.set("ratioMax", p.frequency_change->ratio_max);
    figures.set("frequencyChange", change);
  }
  return figures;
}

val kinds_of(const PatternObject& object) {
  std::vector<std::uint8_t> kinds;
  kinds.reserve(object.pattern.corners.size());
  for (const CornerPhases& corners : object.pattern.corners) {
    kinds.push_back(static_cast<std::uint8_t>(corners.kind));
  }
  return array_of(std::span<const std::uint8_t>(kinds));
}

val lines_of(const Polylines& lines) {
  val result = val::object();
  result.set("points", array_of(std::span<const Vec3>(lines.points)));
  result.set("normals", array_of(std::span<const Vec3>(lines.normals)));
  result.set("offsets", array_of(std::span<const std::uint32_t>(lines.offsets)));
  result.set("closed", array_of(std::span<const std::uint8_t>(lines.closed)));
  return result;
}

val curves_of(const PatternObject& object, bool join, float trim) {
  return guarded([&] {
    CurveOptions options;
    options.join = join;
    options.trim = trim;
    const StripeCurves curves = stripe_curves(object.surface->surface, object.pattern, options);
    val result = lines_of(curves.lines);
    std::vector<std::uint8_t> ends;
    for (const auto& both : curves.ends) {
      for (const CurveEnd end : both) ends.push_back(static_cast<std::uint8_t>(end));
    }
    result.set("ends", array_of(std::span<const std::uint8_t>(ends)));
    return result;
  });
}

val samples_of(const PatternObject& u, const PatternObject& v) {
  return guarded([&] {
    const std::vector<Sample> samples = stripe_samples(u.surface->surface, u.pattern, v.pattern);
    std::vector<Vec3> positions, normals;
    std::vector<std::uint32_t> triangles;
    std::vector<Vec3> barycentric;
    for (const Sample& sample : samples) {
      positions.push_back(sample.position);
      normals.push_back(sample.normal);
      triangles.push_back(sample.triangle);
      barycentric.push_back(sample.barycentric);
    }
    val result = val::object();
    result.set("positions", array_of(std::span<const Vec3>(positions)));
    result.set("normals", array_of(std::span<const Vec3>(normals)));
    result.set("triangles", array_of(std::span<const std::uint32_t>(triangles)));
    result.set("barycentric", array_of(std::span<const Vec3>(barycentric)));
    return result;
  });
}

val textured_mesh_of(const TextureObject& object) {
  return guarded([&] {
    const TexturedMesh textured = texture_coordinates(object.surface->surface, object.pattern);
    const std::vector<Triangle>& triangles = textured.mesh.triangles;
    val result = val::object();
    result.set("positions", array_of(std::span<const Vec3>(textured.mesh.positions)));
    result.set("triangles", array_of(std::span<const std::uint32_t>(triangles.data()->data(),
                                                                    3 * triangles.size())));
    const auto* const numbers = reinterpret_cast<const float*>(textured.coordinates.data());
    const Surface& surface = object.surface->surface;
    const auto* const normal = reinterpret_cast<const float*>(surface.normals.data());
    const std::vector<float> normals =
        carried_values(textured, std::span<const float>(normal, 3 * surface.normals.size()), 3);
    result.set("normals", array_of(std::span<const float>(normals)));
    result.set("uvs", array_of(std::span<const float>(numbers, 2 * textured.coordinates.size())));
    return result;
  });
}

val corner_uvs_of(const TextureObject& object) {
  return guarded([&] {
    const std::vector<float> uvs =
        corner_texture_coordinates(object.pattern.waves, object.pattern.phase_shift);
    return array_of(std::span<const float>(uvs));
  });
}

}  // namespace

void bind_patterns() {
  using namespace emscripten;
  class_<PatternObject>("PatternObject")
      .smart_ptr<std::shared_ptr<PatternObject>>("PatternPointer")
      .function("figures", &figures_of)
      .function("kinds", &kinds_of)
      .function("phases", optional_override([](const PatternObject& p) {
                  return array_of(std::span<const Complex>(p.pattern.solution.z));
                }))
      .function("directions", optional_override([](const PatternObject& p) {
                  return array_of(std::span<const Vec3>(p.pattern.waves.directions));
                }))
      .function("frequencies", optional_override([](const PatternObject& p) {
                  return array_of(std::span<const float>(p.pattern.waves.frequencies));
                }))
      .function("warnings", optional_override([](const PatternObject& p) {
                  return guarded(
                      [&] { return array_of(pattern_warnings(p.surface->surface, p.pattern)); });
                }))
      .function("curves", &curves_of);
  class_<TextureObject>("TextureObject")
      .smart_ptr<std::shared_ptr<TextureObject>>("TexturePointer")
      .function("cornerUVs", &corner_uvs_of)
      .function("mesh", &textured_mesh_of);
  function("stripes", &stripes);
  function("texture", &texture);
  function("samples", &samples_of);
}

}  // namespace brindle::web
