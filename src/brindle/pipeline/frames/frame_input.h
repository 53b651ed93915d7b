/// Input checks and frequency relaxation, shared by all animators.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "brindle/base/archive.h"
#include "brindle/geometry/normals_around.h"
#include "brindle/geometry/topology.h"
#include "brindle/stripe_animator.h"
#include "brindle/surface.h"
#include "brindle/waves/relaxed_frequency_solver.h"

namespace brindle {

/// Throw Error for options out of range, and for input whose arrays do not have `vertices` entries.
/// Values are not checked.
void check_animator_options(const AnimatorOptions& options);
void check_frame_input(const FrameInput& input, std::size_t vertices);

/// Normals for the tangency check, valid while the vertices stay at `positions`.
struct RestNormals {
  std::vector<Vec3> positions, normals;  ///< empty: no normals
};

/// Normals of moved vertices; computed again only where positions differ from the last ones.
class MovingNormals {
 public:
  MovingNormals() = default;
  explicit MovingNormals(const Surface& surface);

  /// The normals at these positions, valid until the next call.
  std::span<const Vec3> at(std::span<const Vec3> positions);

  std::span<const Triangle> triangles() const { return mesh_.triangles; }

 private:
  Mesh mesh_;  ///< with the positions of the last normals
  VertexTriangles around_;
  std::vector<std::uint8_t> turned_;
  std::vector<TriangleAngles> angles_;
  std::vector<Vec3> normals_;
};

/// Sews the faces of frames that do not follow another one.
class FrameSewing {
 public:
  /// For a surface without creases.
  FrameSewing() = default;
  explicit FrameSewing(const Surface& surface);

  bool has_creases() const { return !surface_.creases.empty(); }

  /// As `sew_faces`, for phases by vertex; needs creases.
  void sew(const FrameInput& input, std::span<Complex> z);

 private:
  Surface surface_;  ///< without a mesh
  MovingNormals moving_;
};

/// Throws Error as `check_waves` and `check_fineness` do; also as `check_tangent` does, if the
/// input has normals or vertices are at their rest positions.
void check_values(const FrameInput& input, const Adjacency& neighborhood,
                  const RestNormals& in_place);

/// Options without slack, for an animator with fixed frequencies; and a check that throws Error for
/// options with slack.
AnimatorOptions without_slack(AnimatorOptions options);
void refuse_slack(const AnimatorOptions& options);

/// Throws Error for an animator that was made without slack.
void check_made_with_slack(bool made_with_slack);

class FrameFrequencies {
 public:
  /// Keeps all frequencies fixed.
  FrameFrequencies() = default;

  /// Fixed frequencies if there is no slack. Throws Error as `check_slack` does.
  FrameFrequencies(const Surface& surface, const Slack& slack);

  /// For a part of a surface: input has own vertices first, then those of other processes.
  explicit FrameFrequencies(RelaxedFrequencySolver solver) : relaxed_(std::move(solver)) {}

  bool relaxes() const { return relaxed_.has_value(); }

  /// A new object for the same surface and slack.
  FrameFrequencies sibling() const;

  /// As StripeAnimator::set_slack.
  void set_slack(const Slack& slack);

  /// As RelaxedFrequencySolver::set_setting; needs slack.
  void set_setting(std::shared_ptr<const RelaxedFrequencySetting> setting, bool weighs_as_before);
  const RelaxedFrequencySetting& setting() const { return relaxed_->setting(); }

  /// Whether there is slack and the input equals the one kept last.
  bool is_kept(const FrameInput& input) const;

  /// The input with relaxed frequencies. Throws Cancelled if `progress` cancels.
  FrameInput relaxed_input(const FrameInput& input, const Progress& progress);

  /// Commits the last `relaxed_input` as the last frame. Does not throw.
  void keep(const FrameInput& input);
  void restart();

  /// Frequencies of the last kept frame; empty without slack.
  std::span<const float> frequencies() const;
  const FrequencyChange& change() const { return change_; }

  /// Saves the state, with slack, or restores it for the same setting. Throws Error for waves that
  /// `check_waves` rejects.
  void archive(Archive& archive);

 private:
  std::optional<RelaxedFrequencySolver> relaxed_;
  bool has_kept_ = false;
  WaveSet kept_;       ///< input of the kept frame
  WaveSet built_for_;  ///< input of the frame whose directions the solver's levels follow
  FrequencyChange change_;
};

}  // namespace brindle
