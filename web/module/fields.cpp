#include <numbers>

#include <emscripten/bind.h>

#include "brindle/direction_field.h"
#include "brindle/error.h"
#include "brindle/smooth_field.h"
#include "brindle/strokes.h"
#include "objects.h"

namespace brindle::web {
namespace {

/// Points are relative to the surface's origin, as everywhere in JavaScript.
std::vector<FieldStroke> strokes_of(const val& list, const Eigen::Vector3d& origin) {
  std::vector<FieldStroke> strokes;
  for (std::size_t i = 0, count = list["length"].as<std::size_t>(); i < count; ++i) {
    FieldStroke stroke;
    for (const Vec3& point : vectors_of(list[i]["points"])) {
      stroke.points.push_back(origin + point.cast<double>());
    }
    stroke.radius = list[i]["radius"].as<double>();
    stroke.strength = list[i]["strength"].as<double>();
    strokes.push_back(std::move(stroke));
  }
  return strokes;
}

val smooth_field(const SurfaceObject& object, const val& given) {
  SmoothFieldOptions options;
  options.symmetry = int_of(given, "symmetry");
  options.curvature_anchor = float_of(given, "curvature");
  options.curvature_direction = curvature_direction(text_of(given, "curvatureDirection"));
  options.feature_anchor = float_of(given, "features");
  options.feature_angle_deg = float_of(given, "featureAngle");
  const std::vector<FieldStroke> strokes = strokes_of(given["strokes"], object.surface.mesh.origin);
  if (!strokes.empty()) options.anchors = stroke_anchors(object.surface, strokes);
  return array_of(smooth_direction_field(object.surface, options));
}

val projected_field(const SurfaceObject& object, float x, float y, float z) {
  return array_of(projected_direction_field(Vec3(x, y, z), object.surface.normals));
}

val curvature_field(const SurfaceObject& object, const std::string& direction) {
  const Surface& surface = object.surface;
  const auto curvatures =
      principal_curvatures(surface.mesh.positions, surface.normals, *surface.neighborhood);
  return array_of(curvature_direction_field(curvatures, curvature_direction(direction)));
}

void check_count(const SurfaceObject& object, std::size_t count, const char* what) {
  const std::size_t vertices = object.surface.mesh.vertex_count();
  if (count == vertices) return;
  throw Error(std::string(what) + " has " + std::to_string(count) + " entries for " +
              std::to_string(vertices) + " vertices");
}

val rotated_field(const SurfaceObject& object, const val& directions, float degrees) {
  const std::vector<Vec3> field = vectors_of(directions);
  check_count(object, field.size(), "the field");
  constexpr double kDegree = std::numbers::pi / 180;
  return array_of(rotated(field, object.surface.normals,
                          static_cast<float>(static_cast<double>(degrees) * kDegree)));
}

val tangent_field(const SurfaceObject& object, const val& vectors) {
  const std::vector<Vec3> given = vectors_of(vectors);
  check_count(object, given.size(), "the field");
  return array_of(tangent_directions(given, object.surface.normals));
}

}  // namespace

CurvatureDirection curvature_direction(const std::string& name) {
  return name == "min" ? CurvatureDirection::minimum : CurvatureDirection::maximum;
}

void bind_fields() {
  using namespace emscripten;
  function("smoothField", guarded<smooth_field>);
  function("projectedField", guarded<projected_field>);
  function("curvatureField", guarded<curvature_field>);
  function("rotatedField", guarded<rotated_field>);
  function("tangentField", guarded<tangent_field>);
}

}  // namespace brindle::web
