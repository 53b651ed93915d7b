/// Input checks and frequency relaxation, shared by all animators.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

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

/// Relaxes the frequencies of frames; none without slack. Throws Error as `check_slack` does.
RelaxedFrequencySolver frame_relaxation(const Surface& surface, const Slack& slack);

/// What relaxation sees of a frame.
inline FrequencyInput relaxation_of(const FrameInput& input) {
  return {input.positions, input.directions, input.frequencies};
}

/// The input with relaxed frequencies, or as it is. Throws Cancelled if `progress` cancels.
FrameInput relaxed_input(RelaxedFrequencySolver& solver, const FrameInput& input,
                         const Progress& progress);

}  // namespace brindle
