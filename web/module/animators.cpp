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
        AnimatorObject{surface, StripeAnimator(surface->surface, options)});
  });
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
