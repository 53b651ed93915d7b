#include <limits>

#include <emscripten/bind.h>

#include "objects.h"

namespace brindle::web {
namespace {

std::shared_ptr<AnimatorObject> animator(std::shared_ptr<SurfaceObject> surface, val given) {
  return guarded([&] {
    AnimatorOptions options;
    options.lambda = given["lambda"].as<float>();
    options.cycles = given["cycles"].as<int>();
    options.slack = given["slack"].as<float>();
    return std::make_shared<AnimatorObject>(
        AnimatorObject{surface, StripeAnimator(surface->surface, options), {}, {}});
  });
}

bool is_given(const val& array) { return !array.isUndefined() && !array.isNull(); }

/// Into arrays of JavaScript's own, which have the right sizes.
void draw_into(AnimatorObject& object, const val& input, const FrameInput& frame,
               const FrameResult& made) {
  const val vertices = input["vertices"], corners = input["corners"];
  if (!is_given(vertices) && !is_given(corners)) return;
  if (!object.frames) object.frames.emplace(object.surface->surface);
  if (is_given(vertices)) {
    object.vertices.resize(frame.positions.size());
    object.frames->fill(frame, made, object.vertices);
    fill_array(vertices, {reinterpret_cast<const float*>(object.vertices.data()),
                          object.vertices.size() * sizeof(PatternVertex) / sizeof(float)});
  }
  if (!is_given(corners)) return;
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  std::vector<float> phases;
  phases.reserve(3 * object.surface->surface.mesh.triangle_count());
  for (const CornerPhases& lifted : object.frames->corners(frame, made)) {
    for (const float phase : lifted.phase) phases.push_back(is_lifted(lifted.kind) ? phase : kNone);
  }
  fill_array(corners, phases);
}

val frame_of(AnimatorObject& object, val input) {
  return guarded([&] {
    const Mesh& mesh = object.surface->surface.mesh;
    const std::vector<Vec3> moved = vectors_of(input["positions"]);
    const std::vector<Vec3> normals = vectors_of(input["normals"]);
    const std::vector<Vec3> directions = vectors_of(input["directions"]);
    const std::vector<float> frequencies = floats_of(input["frequencies"]);
    FrameInput frame;
    frame.positions = moved.empty() ? std::span<const Vec3>(mesh.positions) : moved;
    frame.directions = directions;
    frame.frequencies = frequencies;
    frame.normals = normals;
    const FrameResult made = object.animator.frame(frame);
    draw_into(object, input, frame, made);
    val result = val::object();
    result.set("phases", array_of(made.z));
    result.set("phaseStep", made.phase_step);
    result.set("unchanged", made.unchanged);
    result.set("milliseconds", made.milliseconds.frequency + made.milliseconds.couple +
                                   made.milliseconds.sum + made.milliseconds.solve);
    if (!made.frequencies.empty()) result.set("frequencies", array_of(made.frequencies));
    return result;
  });
}

}  // namespace

void bind_animators() {
  using namespace emscripten;
  class_<AnimatorObject>("AnimatorObject")
      .smart_ptr<std::shared_ptr<AnimatorObject>>("AnimatorPointer")
      .function("frame", &frame_of)
      .function("energy", optional_override([](const AnimatorObject& a) {
                  return guarded([&] { return a.animator.energy(); });
                }))
      .function("restart", optional_override([](AnimatorObject& a) {
                  guarded([&] {
                    a.animator.restart();
                    return 0;
                  });
                }));
  function("animator", &animator);
}

}  // namespace brindle::web
