#include "brindle/pattern_frames.h"

#include <memory>
#include <string>
#include <vector>

#include "brindle/error.h"
#include "brindle/pipeline/frames/frame_input.h"

namespace brindle {
namespace {

/// The frequencies that the phases belong to: with slack, the relaxed ones.
std::span<const float> frequencies_of(const FrameInput& input, const FrameResult& frame) {
  return frame.frequencies.empty() ? input.frequencies : frame.frequencies;
}

void check_phases(std::size_t phases, std::size_t vertices) {
  if (phases == vertices) return;
  throw Error("pattern frames: there are " + std::to_string(phases) + " phases for " +
              std::to_string(vertices) + " vertices");
}

}  // namespace

struct PatternFrames::State {
  explicit State(const Surface& surface)
      : vertices(surface.mesh.vertex_count()),
        moving(surface),
        corners(surface.mesh.triangle_count()) {}

  std::size_t vertices;
  MovingNormals moving;
  WaveSet waves;  ///< of the last corner phases
  std::vector<CornerPhases> corners;
};

PatternFrames::PatternFrames(const Surface& surface) {
  if (surface.mesh.triangles.empty()) {
    throw Error("pattern frames: the surface has no triangles; points have none to draw");
  }
  state_ = std::make_unique<State>(surface);
}

PatternFrames::~PatternFrames() = default;
PatternFrames::PatternFrames(PatternFrames&&) noexcept = default;
PatternFrames& PatternFrames::operator=(PatternFrames&&) noexcept = default;

std::span<const Vec3> PatternFrames::normals(std::span<const Vec3> positions) {
  State& s = *state_;
  if (positions.size() != s.vertices) {
    throw Error("pattern frames: there are " + std::to_string(positions.size()) +
                " positions for " + std::to_string(s.vertices) + " vertices");
  }
  return s.moving.at(positions);
}

std::span<const CornerPhases> PatternFrames::corners(const FrameInput& input,
                                                     const FrameResult& frame,
                                                     PhaseShiftKind kind) {
  State& s = *state_;
  check_frame_input(input, s.vertices);
  check_phases(frame.z.size(), s.vertices);
  const std::span<const float> frequencies = frequencies_of(input, frame);
  s.waves.positions.assign(input.positions.begin(), input.positions.end());
  s.waves.directions.assign(input.directions.begin(), input.directions.end());
  s.waves.frequencies.assign(frequencies.begin(), frequencies.end());
  fill_corner_phases(s.moving.triangles(), s.waves, frame.z, kind, s.corners);
  return s.corners;
}

void PatternFrames::fill(const FrameInput& input, const FrameResult& frame,
                         std::span<PatternVertex> vertices) {
  const std::span<const Vec3> own = input.normals;
  fill_pattern_vertices({.positions = input.positions,
                         .normals = own.empty() ? normals(input.positions) : own,
                         .directions = input.directions,
                         .frequencies = frequencies_of(input, frame),
                         .z = frame.z},
                        vertices);
}

}  // namespace brindle
