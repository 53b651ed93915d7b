#include "brindle/surface_tones.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/base/elementary.h"
#include "brindle/base/graph.h"
#include "brindle/base/random.h"
#include "brindle/base/standard.h"
#include "brindle/error.h"
#include "brindle/render/surface_light.h"

namespace brindle {
namespace {

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

/// Twin of `lit_by` in light.glsl for a white surface: change both or neither.
Vec3 light_on_white(const Vec3& n, const Vec3& view_position, const Lights& lights) {
  const Vec3 v = -view_position.normalized();
  const float facing = std::clamp(n.dot(v), 0.0f, 1.0f);
  const float key = std::clamp((n.dot(lights.key) + 0.25f) / 1.25f, 0.0f, 1.0f);
  const float fill = std::clamp((n.dot(lights.fill) + 0.40f) / 1.40f, 0.0f, 1.0f);
  const float sky = 0.5f + 0.5f * n.dot(lights.sky);
  const Vec3 ground_light(0.17f, 0.165f, 0.16f), sky_light(0.30f, 0.31f, 0.33f);
  Vec3 light = key * Vec3(0.66f, 0.64f, 0.61f) + fill * Vec3(0.12f, 0.13f, 0.15f) + ground_light +
               sky * (sky_light - ground_light);
  light *= 0.62f + (1 - 0.62f) * smooth_step(0, 0.55f, facing);
  const float gloss =
      elementary::pow(std::clamp(n.dot((lights.key + v).normalized()), 0.0f, 1.0f), 40.0f);
  light += Vec3::Constant(0.035f * gloss);
  light += Vec3::Constant(0.03f * elementary::pow(1 - facing, 4.0f) * sky);
  return light;
}

/// Twin of tone_at in strokes.glsl.
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

namespace {

/// A hash of an edge.
std::uint64_t number_of_edge(Index lower, Index upper) {
  return mixed_bits((std::uint64_t{lower} << 32 | upper) + kRandomStep);
}

/// Whether every edge is used equally often in both directions: signed edge hashes then cancel.
/// Another mesh passes with probability 2^-64.
bool is_closed(const Mesh& mesh) {
  std::uint64_t sum = 0;
  for (const Triangle& t : mesh.triangles) {
    for (int m = 0; m < 3; ++m) {
      const Index from = t[m], to = t[(m + 1) % 3];
      sum += from < to ? number_of_edge(from, to) : -number_of_edge(to, from);
    }
  }
  return sum == 0;
}

/// A representative vertex of the connected component, for every vertex.
std::vector<Index> connected_parts(const Mesh& mesh) {
  MergedSets parts(mesh.vertex_count());
  for (const Triangle& t : mesh.triangles) {
    parts.merge(t[0], t[1]);
    parts.merge(t[0], t[2]);
  }
  std::vector<Index> part_of(mesh.vertex_count());
  for (Index v = 0; v < part_of.size(); ++v) part_of[v] = parts.of(v);
  return part_of;
}

}  // namespace

HiddenSide hidden_side(const Mesh& mesh) {
  if (mesh.triangles.empty() || !is_closed(mesh)) return HiddenSide::none;
  const std::vector<Index> parts = connected_parts(mesh);
  const Vec3 near = mesh.positions[mesh.triangles[0][0]];
  std::vector<double> volumes(mesh.vertex_count());
  for (const Triangle& t : mesh.triangles) {
    const auto corner = [&](int m) -> Eigen::Vector3d {
      return (mesh.positions[t[m]] - near).cast<double>();
    };
    volumes[parts[t[0]]] += corner(0).dot(corner(1).cross(corner(2)));
  }
  const auto all_of_sign = [&](double sign) {
    return ranges::all_of(mesh.triangles,
                          [&](const Triangle& t) { return sign * volumes[parts[t[0]]] > 0; });
  };
  if (all_of_sign(1)) return HiddenSide::back;
  return all_of_sign(-1) ? HiddenSide::front : HiddenSide::none;
}

}  // namespace brindle
