#include "brindle/surface_tones.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <string>

#include "brindle/base/elementary.h"
#include "brindle/error.h"
#include "brindle/render/outer_side.h"
#include "brindle/render/surface_light.h"

namespace brindle {
namespace {

float smoothstep(float from, float to, float x) {
  const float t = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

/// The default direction; any length.
const Vec3 kUsualKey(-0.45f, 0.70f, 0.75f);

/// From the side opposite to the key light, by the same angle but no farther aside than the
/// default.
Vec3 fill_opposite(const Vec3& key) {
  const float aside = key.x() / kUsualKey.normalized().x();
  return Vec3(0.85f * std::clamp(aside, -1.0f, 1.0f), 0.05f, 0.50f).normalized();
}

/// Direction towards the light.
Vec3 key_from(const LightDirection& from) {
  const double azimuth = from.azimuth_deg * std::numbers::pi / 180;
  const double elevation = from.elevation_deg * std::numbers::pi / 180;
  const double level = elementary::cos(elevation);
  return Eigen::Vector3d(level * elementary::sin(azimuth), elementary::sin(elevation),
                         level * elementary::cos(azimuth))
      .cast<float>();
}

/// Twin of `lit` in light.glsl for a white surface: change both or neither.
Vec3 light_on_white(const Vec3& n, const Vec3& view_position, const Lights& lights) {
  const Vec3 v = -view_position.normalized();
  const float facing = std::clamp(n.dot(v), 0.0f, 1.0f);
  const float key = std::clamp((n.dot(lights.key) + 0.25f) / 1.25f, 0.0f, 1.0f);
  const float fill = std::clamp((n.dot(lights.fill) + 0.40f) / 1.40f, 0.0f, 1.0f);
  const float sky = 0.5f + 0.5f * n.dot(lights.sky);
  const Vec3 ground_light(0.17f, 0.165f, 0.16f), sky_light(0.30f, 0.31f, 0.33f);
  Vec3 light = key * Vec3(0.66f, 0.64f, 0.61f) + fill * Vec3(0.12f, 0.13f, 0.15f) + ground_light +
               sky * (sky_light - ground_light);
  light *= 0.62f + (1 - 0.62f) * smoothstep(0, 0.55f, facing);
  const float gloss =
      elementary::pow(std::clamp(n.dot((lights.key + v).normalized()), 0.0f, 1.0f), 40.0f);
  light += Vec3::Constant(0.035f * gloss);
  light += Vec3::Constant(0.03f * elementary::pow(1 - facing, 4.0f) * sky);
  return light;
}

/// Twin of tone.glsl.
float tone_of(const Vec3& light) {
  return elementary::pow(std::clamp(light.dot(Vec3(0.2126f, 0.7152f, 0.0722f)), 0.0f, 1.0f),
                         1 / 2.2f);
}

}  // namespace

Lights lights_of(const Camera& camera, const PictureLight& light) {
  const Eigen::Matrix3f turn = camera.view_from_world.topLeftCorner<3, 3>();
  const Vec3 key = light.from ? key_from(*light.from) : kUsualKey.normalized();
  return {key, fill_opposite(key), turn * upright_axes(light.up).row(1).transpose()};
}

float tone_at(const Vec3& view_normal, const Vec3& sight, const Lights& lights) {
  return tone_of(light_on_white(view_normal, sight, lights));
}

std::vector<float> surface_tones(const Mesh& mesh, std::span<const Vec3> normals,
                                 const Camera& camera, const PictureLight& light) {
  if (normals.size() != mesh.vertex_count()) {
    throw Error("light needs a normal for each of the " + std::to_string(mesh.vertex_count()) +
                " vertices, not " + std::to_string(normals.size()));
  }
  // A slice shows the inner side.
  const HiddenSide hidden = camera.slice ? HiddenSide::none : hidden_side(mesh);
  const Eigen::Matrix3f turn = camera.view_from_world.topLeftCorner<3, 3>();
  const Lights lights = lights_of(camera, light);
  std::vector<float> tones(normals.size(), std::numeric_limits<float>::quiet_NaN());
  for (std::size_t v = 0; v < tones.size(); ++v) {
    if (normals[v].isZero(0)) continue;
    const Vec3 relative = mesh.positions[v] - camera.origin;
    const Vec3 place = (camera.view_from_world * relative.homogeneous()).head<3>();
    Vec3 normal = turn * normals[v];
    const bool turned_away = normal.dot(place) > 0;
    if (hidden == HiddenSide::front || (hidden == HiddenSide::none && turned_away)) {
      normal = -normal;
    }
    tones[v] = tone_at(normal, place, lights);
  }
  return tones;
}

}  // namespace brindle
