#include "brindle/pipeline/frames/frame_input.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "brindle/base/standard.h"
#include "brindle/error.h"
#include "brindle/pipeline/sewn_faces.h"
#include "brindle/waves/wave_check.h"

namespace brindle {
void check_animator_options(const AnimatorOptions& options) {
  const auto require = [](bool holds, const char* message) {
    if (!holds) throw Error(std::string("animator options: ") + message);
  };
  require(is_weight(options.lambda), "lambda must be from 0 to 1e6");
  require(options.sweeps >= 0, "sweeps must be 0 or above");
  require(options.cycles >= 0, "cycles must be 0 or above");
  require(options.iterations > 0, "iterations must be above 0");
}

void check_frame_input(const FrameInput& input, std::size_t vertices) {
  if (input.positions.size() == vertices && input.directions.size() == vertices &&
      input.frequencies.size() == vertices &&
      (input.normals.empty() || input.normals.size() == vertices)) {
    return;
  }
  throw Error("animator: a frame needs one position, direction and frequency for each of " +
              std::to_string(vertices) + " vertices, and as many normals, or none");
}

MovingNormals::MovingNormals(const Surface& surface)
    : mesh_(surface.mesh), around_(vertex_triangles(surface.mesh)), turned_(surface.turned) {}

std::span<const Vec3> MovingNormals::at(std::span<const Vec3> positions) {
  if (!normals_.empty() && ranges::equal(mesh_.positions, positions)) return normals_;
  mesh_.positions.assign(positions.begin(), positions.end());
  fill_vertex_normals(mesh_, around_, turned_, angles_, normals_);
  return normals_;
}

FrameSewing::FrameSewing(const Surface& surface) {
  if (surface.creases.empty()) return;
  surface_.neighborhood = surface.neighborhood;
  surface_.creases = surface.creases;
  moving_ = MovingNormals(surface);
}

void FrameSewing::sew(const FrameInput& input, std::span<Complex> z) {
  const std::span<const Vec3> normals = moving_.at(input.positions);
  surface_.normals.assign(normals.begin(), normals.end());
  const WaveSet waves{{input.positions.begin(), input.positions.end()},
                      {input.directions.begin(), input.directions.end()},
                      {input.frequencies.begin(), input.frequencies.end()}};
  sew_faces(surface_, waves, z);
}

void check_values(const FrameInput& input, const Adjacency& neighborhood,
                  const RestNormals& in_place) {
  check_waves(input.positions, input.directions, input.frequencies);
  if (!input.normals.empty()) {
    check_tangent(input.normals, input.directions);
  } else if (ranges::equal(input.positions, in_place.positions)) {
    check_tangent(in_place.normals, input.directions);
  }
  check_fineness(neighborhood, input.positions, input.directions, input.frequencies);
}

AnimatorOptions without_slack(AnimatorOptions options) {
  options.slack = {};
  return options;
}

void refuse_slack(const AnimatorOptions& options) {
  if (!options.slack.relaxes()) return;
  throw Error("animator options: slack needs the surface; make the animator of a Surface");
}

void check_made_with_slack(bool made_with_slack) {
  if (made_with_slack) return;
  throw Error("animator: it was made without slack; make it of a Surface with some");
}

RelaxedFrequencySolver frame_relaxation(const Surface& surface, const Slack& slack) {
  check_slack(slack, surface.mesh.vertex_count());
  if (!slack.relaxes()) return {};
  return RelaxedFrequencySolver(relaxed_setting(surface, slack));
}

FrameInput relaxed_input(RelaxedFrequencySolver& solver, const FrameInput& input,
                         const Progress& progress) {
  if (!solver.relaxes()) return input;
  return {input.positions, input.directions, solver.solve(relaxation_of(input), progress)};
}

}  // namespace brindle
