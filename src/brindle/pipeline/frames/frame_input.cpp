#include "brindle/pipeline/frames/frame_input.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "brindle/base/standard.h"
#include "brindle/error.h"
#include "brindle/pipeline/frames/animator_archive.h"
#include "brindle/pipeline/sewn_faces.h"
#include "brindle/waves/wave_check.h"

namespace brindle {
namespace {

bool same_bits(const Vec3& a, const Vec3& b) { return a == b; }

/// Copies without allocating if there is room.
void assign(const FrameInput& input, WaveSet& waves) {
  waves.positions.assign(input.positions.begin(), input.positions.end());
  waves.directions.assign(input.directions.begin(), input.directions.end());
  waves.frequencies.assign(input.frequencies.begin(), input.frequencies.end());
}

}  // namespace

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

FrameFrequencies::FrameFrequencies(const Surface& surface, const Slack& slack) {
  check_slack(slack, surface.mesh.vertex_count());
  if (slack.relaxes()) relaxed_.emplace(relaxed_setting(surface, slack));
}

FrameFrequencies FrameFrequencies::sibling() const {
  FrameFrequencies other;
  if (relaxed_) other.relaxed_.emplace(relaxed_->sibling());
  return other;
}

void FrameFrequencies::set_slack(const Slack& slack) {
  check_made_with_slack(relaxes());
  relaxed_->set_slack(slack);
  has_kept_ = false;
}

void FrameFrequencies::set_setting(std::shared_ptr<const RelaxedFrequencySetting> setting,
                                   bool weighs_as_before) {
  relaxed_->set_setting(std::move(setting), weighs_as_before);
  has_kept_ = false;
}

bool FrameFrequencies::is_kept(const FrameInput& input) const {
  return relaxed_ && has_kept_ && ranges::equal(input.frequencies, kept_.frequencies) &&
         ranges::equal(input.directions, kept_.directions, same_bits) &&
         ranges::equal(input.positions, kept_.positions, same_bits);
}

FrameInput FrameFrequencies::relaxed_input(const FrameInput& input, const Progress& progress) {
  if (!relaxed_) return input;
  for (WaveSet* kept : {&kept_, &built_for_}) {
    kept->positions.reserve(input.positions.size());
    kept->directions.reserve(input.directions.size());
    kept->frequencies.reserve(input.frequencies.size());
  }
  return {input.positions, input.directions,
          relaxed_->solve({input.positions, input.directions, input.frequencies}, progress)};
}

void FrameFrequencies::keep(const FrameInput& input) {
  if (!relaxed_) return;
  if (!relaxed_->is_settled()) assign(input, built_for_);
  relaxed_->keep();
  has_kept_ = true;
  change_ = relaxed_->change();
  assign(input, kept_);
}

void archive_waves(Archive& archive, std::size_t nodes, WaveSet& waves) {
  archive.list_of(nodes, waves.positions);
  archive.list_of(nodes, waves.directions);
  archive.list_of(nodes, waves.frequencies);
  check_waves(waves.positions, waves.directions, waves.frequencies);
}

void archive_change(Archive& archive, FrequencyChange& change) {
  archive(change.ratio_min, change.ratio_max, change.ratio_mean, change.share_at_bounds,
          change.sweeps, change.residual);
}

void FrameFrequencies::archive(Archive& archive) {
  if (!relaxed_) return;
  const std::size_t vertices = setting().slack.size();
  bool settled = relaxed_->is_settled();
  archive(settled, has_kept_);
  if (settled) {
    archive_waves(archive, vertices, built_for_);
    relaxed_->archive(archive,
                      {built_for_.positions, built_for_.directions, built_for_.frequencies});
  }
  if (!has_kept_) return;
  archive_waves(archive, vertices, kept_);
  archive_change(archive, change_);
}

void FrameFrequencies::restart() {
  if (relaxed_) relaxed_->restart();
}

std::span<const float> FrameFrequencies::frequencies() const {
  return relaxed_ ? relaxed_->frequencies() : std::span<const float>();
}

}  // namespace brindle
