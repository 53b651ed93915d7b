#include "scenes/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "brindle/base/elementary.h"
#include "brindle/base/parallel.h"
#include "brindle/direction_field.h"
#include "brindle/error.h"
#include "brindle/normals.h"

namespace brindle {
namespace {

constexpr float kTurn = 2 * std::numbers::pi_v<float>;
constexpr float kDegree = kTurn / 360;

constexpr float kZoomGrowth = 1.01f;    // of the frequency, per frame
constexpr float kVortexRadius = 0.05f;  // of the rigid core of a vortex, relative to the diagonal
constexpr float kWobbleHeight = 0.01f;  // relative to the diagonal
constexpr float kWobbleLength = 0.5f;   // of the travelling wave, relative to the diagonal
constexpr float kWobbleFrames = 60;     // per period
constexpr float kBrushRadius = 0.04f;   // relative to the diagonal
constexpr float kBrushWeight = 2;       // in the middle of the stroke
constexpr float kBrushFrames = 120;     // per stroke

constexpr std::array<std::string_view, 5> kNames{"zoom", "vortices", "rotate", "wobble", "brush"};

void check(const SceneOptions& options) {
  if (!(options.frequency > 0) || !std::isfinite(options.frequency)) {
    throw Error("scene: the frequency must be a finite number above zero");
  }
  if (!options.direction.allFinite() || options.direction.isZero(0)) {
    throw Error("scene: the direction must be finite and not zero");
  }
}

/// Sets all directions from `vector_at(vertex)`.
template <class VectorAt>
void set_directions(SceneFrame& frame, const VectorAt& vector_at) {
  parallel_for(frame.normals.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      frame.waves.directions[v] = tangent_direction(vector_at(v), frame.normals[v]);
    }
  });
}

/// Two cores on opposite sides of the ellipsoid in the bounding box. Their orbits are tilted by 40
/// degrees against each other, so that the cores are always at least 140 degrees apart.
std::array<Vec3, 2> cores_at(const BoundingBox& box, int frame) {
  const float angle = static_cast<float>(frame % 360) * kDegree;
  const float tilt = 40 * kDegree;
  const Vec3 first(elementary::cos(angle), elementary::sin(angle), 0);
  const Vec3 second(-elementary::cos(angle), -elementary::sin(angle) * elementary::cos(tilt),
                    -elementary::sin(angle) * elementary::sin(tilt));
  const Vec3 half = 0.5f * (box.upper - box.lower);
  return {box.center() + half.cwiseProduct(first), box.center() + half.cwiseProduct(second)};
}

/// A vortex around `core`, turned back by a quarter turn: it decays outside its rigid core.
Vec3 arm_of_vortex(const Vec3& core, const Vec3& point, float radius) {
  const Vec3 arm = point - core;
  return arm / (arm.squaredNorm() + radius * radius);
}

void zoom(const SceneOptions& options, int number, SceneFrame& frame) {
  const float frequency =
      options.frequency * elementary::pow(kZoomGrowth, static_cast<float>(number));
  std::ranges::fill(frame.waves.frequencies, frequency);
}

void vortices(const BoundingBox& box, int number, SceneFrame& frame) {
  const auto cores = cores_at(box, number);
  const float radius = kVortexRadius * box.diagonal();
  set_directions(frame, [&](std::size_t v) -> Vec3 {
    const Vec3& p = frame.mesh.positions[v];
    return frame.normals[v].cross(arm_of_vortex(cores[0], p, radius) -
                                  arm_of_vortex(cores[1], p, radius));
  });
  frame.points = {cores[0], cores[1]};
}

void rotate(const SceneOptions& options, int number, SceneFrame& frame) {
  const Vec3 from = options.direction.normalized();
  const Vec3 across = from.unitOrthogonal();
  const float angle = static_cast<float>(number % 360) * kDegree;
  const Vec3 direction = elementary::cos(angle) * from + elementary::sin(angle) * across;
  set_directions(frame, [&](std::size_t) { return direction; });
}

/// A wave along the longest side of the bounding box that moves vertices along the shortest one.
/// Its amplitude grows from zero in the first period.
void wobble(const SceneOptions& options, const BoundingBox& box, std::span<const Vec3> at_rest,
            int number, SceneFrame& frame) {
  const Vec3 size = box.upper - box.lower;
  Eigen::Index longest = 0, shortest = 0;
  size.maxCoeff(&longest);
  size.minCoeff(&shortest);
  const float periods = static_cast<float>(number) / kWobbleFrames;
  const float grown = std::min(periods, 1.0f);
  const float height =
      kWobbleHeight * box.diagonal() * grown * grown * (3 - 2 * grown);  // smoothstep
  const float turns_per_length = kTurn / (kWobbleLength * box.diagonal());
  for (std::size_t v = 0; v < at_rest.size(); ++v) {
    const float along = at_rest[v][longest] - box.lower[longest];
    Vec3& position = frame.mesh.positions[v];
    position = at_rest[v];
    position[shortest] +=
        height * elementary::sin(turns_per_length * along - kTurn * std::fmod(periods, 1.0f));
  }
  frame.waves.positions = frame.mesh.positions;
  frame.normals = vertex_normals(frame.mesh);
  set_directions(frame, [&](std::size_t) { return options.direction; });
}

}  // namespace

std::optional<SceneKind> parse_scene_kind(std::string_view name) {
  const auto found = std::ranges::find(kNames, name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<SceneKind>(found - kNames.begin());
}

std::string_view name_of(SceneKind kind) { return kNames[static_cast<std::size_t>(kind)]; }

void Scene::brush(int number) {
  if (number < drawn_ || !field_) {
    field_.emplace(Surface{frame_.mesh, neighborhood_, frame_.normals});
    drawn_ = -1;
  }
  const float step = (stroke_.length + stroke_.radius) / kBrushFrames;
  for (; drawn_ < number; ++drawn_) {
    anchors_up_to(stroke_, static_cast<float>(drawn_ + 1) * step, anchors_);
    const std::span<const Vec3> directions = field_->frame(anchors_);
    frame_.waves.directions.assign(directions.begin(), directions.end());
  }
  if (!stroke_.path.empty()) {
    frame_.points = {brush_tip(stroke_, static_cast<float>(number) * step)};
  }
}

Scene::Scene(const Surface& surface, const SceneOptions& options)
    : options_(options), box_(bounding_box(surface.mesh)) {
  check(options);
  const std::size_t count = surface.mesh.vertex_count();
  frame_.mesh = surface.mesh;
  frame_.normals = surface.normals;
  frame_.waves = {surface.mesh.positions, DirectionField(count, Vec3::Zero()),
                  std::vector<float>(count, options.frequency)};
  if (options.kind == SceneKind::wobble) at_rest_ = surface.mesh.positions;
  if (options.kind == SceneKind::zoom) {
    set_directions(frame_, [&](std::size_t) { return options.direction; });
  }
  if (options.kind == SceneKind::brush) {
    neighborhood_ = surface.neighborhood;
    const float radius = std::max(kBrushRadius * box_.diagonal(), 1e-30f);
    stroke_ = make_brush_stroke(surface, radius, kBrushWeight);
  }
}

const SceneFrame& Scene::frame(int number) {
  if (number < 0) throw Error("scene: frames are numbered from 0");
  switch (options_.kind) {
    case SceneKind::zoom:
      zoom(options_, number, frame_);
      break;
    case SceneKind::vortices:
      vortices(box_, number, frame_);
      break;
    case SceneKind::rotate:
      rotate(options_, number, frame_);
      break;
    case SceneKind::wobble:
      wobble(options_, box_, at_rest_, number, frame_);
      break;
    case SceneKind::brush:
      brush(number);
      break;
  }
  return frame_;
}

}  // namespace brindle
