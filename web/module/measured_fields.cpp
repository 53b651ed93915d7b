#include <emscripten/bind.h>

#include "brindle/measured_field.h"
#include "objects.h"

namespace brindle::web {
namespace {

val smoothed_field(const SurfaceObject& object, val directions, val frequencies, val given) {
  return guarded([&] {
    FieldSmoothingOptions options;
    options.symmetry = int_of(given, "symmetry");
    options.periods = float_of(given, "periods");
    options.fill = float_of(given, "fill");
    const val singularities = given["singularities"];
    if (!singularities.isNull() && !singularities.isUndefined()) {
      options.singularities = singularities.as<std::size_t>();
    }
    MeasuredField measured;
    measured.directions = vectors_of(directions);
    measured.confidence = floats_of(given["confidence"]);
    FieldSmoothing smoothing(object.surface, options);
    const SmoothedField field = smoothing.frame(measured, floats_of(frequencies));
    val result = val::object();
    put(result, "directions", array_of(std::span<const Vec3>(field.directions)));
    put(result, "coherence", array_of(std::span<const float>(field.coherence)));
    put(result, "filled", array_of(std::span<const std::uint8_t>(field.filled)));
    return result;
  });
}

}  // namespace

void bind_measured_fields() { emscripten::function("smoothedField", &smoothed_field); }

}  // namespace brindle::web
