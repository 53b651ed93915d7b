/// What renderers of your own draw of frames, in the place of the last one (docs/gpu.md): normals
/// of vertices that move, corner phases, and the vertices that shaders read.
#pragma once

#include <span>

#include "brindle/corner_phases.h"
#include "brindle/export.h"
#include "brindle/pattern_buffers.h"
#include "brindle/stripe_animator.h"
#include "brindle/surface.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// Frames of one surface, of StripeAnimator or of another one with the same input and result. What
/// depends on the triangles alone is found once; every call but the first allocates nothing.
class PatternFrames {
 public:
  /// Nothing refers to the surface afterwards. Throws Error for one without triangles.
  explicit PatternFrames(const Surface& surface);
  ~PatternFrames();
  PatternFrames(PatternFrames&&) noexcept;
  PatternFrames& operator=(PatternFrames&&) noexcept;

  /// One unit normal per vertex, as `vertex_normals` finds them where vertices stand at
  /// `positions`. Valid until the next call; positions of the last call are not looked at again.
  /// Throws Error unless there is one position per vertex.
  std::span<const Vec3> normals(std::span<const Vec3> positions);

  /// One entry per triangle, as `corner_phases` finds them for `input`, with slack for the
  /// frequencies of `frame`. Valid until the next call. Throws Error if sizes differ.
  std::span<const CornerPhases> corners(const FrameInput& input, const FrameResult& frame,
                                        PhaseShiftKind kind = PhaseShiftKind::aligned);

  /// Fills one entry per vertex: into memory of yours, such as a mapped buffer. Normals are those
  /// of the input, or if it has none, `normals` of its positions. Throws Error as
  /// `fill_pattern_vertices` does.
  void fill(const FrameInput& input, const FrameResult& frame, std::span<PatternVertex> vertices);

 private:
  struct State;
  Pimpl<State> state_;
};

}  // namespace brindle
