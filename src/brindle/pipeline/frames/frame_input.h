/// What all animators take: input that they check, and frequencies that yield before a frame is
/// solved.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "brindle/geometry/normals_around.h"
#include "brindle/geometry/topology.h"
#include "brindle/stripe_animator.h"
#include "brindle/waves/yielding_solver.h"

namespace brindle {

/// Throw Error for options out of range, and for input without one entry for each of so many
/// vertices. Values are not looked at.
void check_animator_options(const AnimatorOptions& options);
void check_frame_input(const FrameInput& input, std::size_t vertices);

/// What directions must be tangent to, as long as vertices stand where they stood.
struct RestNormals {
  std::vector<Vec3> positions, normals;  ///< empty: nothing is known
};

/// The normals of vertices wherever they stand, for links over creases.
class MovingNormals {
 public:
  MovingNormals() = default;
  explicit MovingNormals(const Mesh& mesh);

  /// Valid until the next call.
  std::span<const Vec3> at(std::span<const Vec3> positions);

 private:
  Mesh mesh_;
  VertexTriangles around_;
  std::vector<TriangleAngles> angles_;
  std::vector<Vec3> normals_;
};

/// Those that are given, or those in place, or what `moving` makes of the positions.
std::span<const Vec3> normals_of(const FrameInput& input, const RestNormals& in_place,
                                 MovingNormals& moving);

/// Throws Error for what `check_waves` and `check_fineness` refuse, and for what `check_tangent`
/// does, where the input has normals or vertices stand in place.
void check_values(const FrameInput& input, const Adjacency& neighborhood,
                  const RestNormals& in_place);

/// The options of an animator that frequencies have nothing to do with; and throws Error unless
/// these are such.
AnimatorOptions without_slack(AnimatorOptions options);
void refuse_slack(const AnimatorOptions& options);

/// Throws Error for an animator that was made without slack and is to take another one.
void check_made_with_slack(bool made_with_slack);

class FrameFrequencies {
 public:
  /// Frequencies stay as they are.
  FrameFrequencies() = default;

  /// The same where there is no slack. Throws Error for slack that `check` refuses.
  FrameFrequencies(const Surface& surface, const Slack& slack);

  /// Of a part of a surface, with input of own vertices and others'.
  explicit FrameFrequencies(YieldingSolver solver) : yielding_(std::move(solver)) {}

  bool yields() const { return yielding_.has_value(); }

  /// Another one for the same surface and slack.
  FrameFrequencies sibling() const;

  /// As StripeAnimator's.
  void set_slack(const Slack& slack);

  /// As YieldingSolver's, where frequencies yield.
  void set_setting(std::shared_ptr<const YieldingSetting> setting, bool weighs_as_before);
  const YieldingSetting& setting() const { return yielding_->setting(); }

  /// Whether frequencies yield and the input is that which was kept last.
  bool is_kept(const FrameInput& input) const;

  /// The input with the frequencies to solve for. Throws what `YieldingFrequency::solve` does.
  FrameInput yielded(const FrameInput& input, const Progress& progress);

  /// Makes the input yielded last the last frame's. Cannot fail.
  void keep(const FrameInput& input);
  void restart();

  /// Of the last frame that was kept; empty where nothing yields.
  std::span<const float> frequencies() const;
  const FrequencyChange& change() const { return change_; }

 private:
  std::optional<YieldingSolver> yielding_;
  bool has_kept_ = false;
  std::vector<Vec3> positions_, directions_;  ///< kept
  std::vector<float> wanted_;
  FrequencyChange change_;
};

}  // namespace brindle
