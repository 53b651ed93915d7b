#include <limits>

#include <emscripten/bind.h>

#include "objects.h"

namespace brindle::web {
namespace {

std::shared_ptr<AnimatorObject> animator(const std::shared_ptr<SurfaceObject>& surface,
                                         const val& given) {
  StripeAnimator follower(surface->surface, animator_options(given));
  return std::make_shared<AnimatorObject>(AnimatorObject{surface, std::move(follower), {}, {}});
}

bool is_given(const val& array) { return !array.isUndefined() && !array.isNull(); }

/// Fills JavaScript arrays of the right sizes.
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

val frame_of(AnimatorObject& object, const val& input) {
  const GivenFrame given(object.surface->surface.mesh, input);
  const FrameInput& frame = given.input;
  const FrameResult made = object.animator.frame(frame);
  draw_into(object, input, frame, made);
  val result = val::object();
  put(result, "phases", array_of(made.z));
  put(result, "phaseStep", made.phase_step);
  put(result, "unchanged", val(made.unchanged));
  put(result, "milliseconds",
      made.milliseconds.frequency + made.milliseconds.couple + made.milliseconds.sum +
          made.milliseconds.solve);
  if (!made.frequencies.empty()) put(result, "frequencies", array_of(made.frequencies));
  return result;
}

double energy_of(const AnimatorObject& object) { return object.animator.energy(); }

void restart(AnimatorObject& object) { object.animator.restart(); }

}  // namespace

AnimatorOptions animator_options(const val& given) {
  AnimatorOptions options;
  options.lambda = float_of(given, "lambda");
  options.cycles = int_of(given, "cycles");
  options.slack = float_of(given, "slack");
  return options;
}

GivenFrame::GivenFrame(const Mesh& mesh, const val& given)
    : positions_(vectors_of(given["positions"])),
      normals_(vectors_of(given["normals"])),
      directions_(vectors_of(given["directions"])),
      frequencies_(floats_of(given["frequencies"])) {
  input.positions = positions_.empty() ? std::span<const Vec3>(mesh.positions) : positions_;
  input.directions = directions_;
  input.frequencies = frequencies_;
  input.normals = normals_;
}

void bind_animators() {
  using namespace emscripten;
  class_<AnimatorObject>("AnimatorObject")
      .smart_ptr<std::shared_ptr<AnimatorObject>>("AnimatorPointer")
      .function("frame", guarded<frame_of>)
      .function("energy", guarded<energy_of>)
      .function("restart", guarded<restart>);
  function("animator", guarded<animator>);
}

}  // namespace brindle::web
