/// Frame data for your own renderer, updated in place: normals of moving vertices, corner phases,
/// and the vertices that shaders read (docs/gpu.md).
#pragma once

#include <span>

#include "brindle/corner_phases.h"
#include "brindle/export.h"
#include "brindle/pattern_buffers.h"
#include "brindle/stripe_animator.h"
#include "brindle/surface.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// Frames of one surface, from StripeAnimator or another animator with the same input and result.
/// Computes once what depends only on the triangles; every call but the first allocates nothing.
class PatternFrames {
 public:
  /// Does not refer to the surface afterwards. Throws Error for a surface without triangles.
  explicit PatternFrames(const Surface& surface);
  ~PatternFrames();
  PatternFrames(PatternFrames&&) noexcept;
  PatternFrames& operator=(PatternFrames&&) noexcept;

  /// One unit normal per vertex, as `make_surface` computes for vertices at `positions`. Valid
  /// until the next call; the last call's positions are not read again. Throws Error unless there
  /// is one position per vertex.
  std::span<const Vec3> normals(std::span<const Vec3> positions);

  /// One entry per triangle, as `corner_phases` computes for `input`; with slack, for the
  /// frequencies of `frame`. Valid until the next call. Throws Error if sizes differ.
  std::span<const CornerPhases> corners(const FrameInput& input, const FrameResult& frame,
                                        PhaseShiftKind kind = PhaseShiftKind::aligned);

  /// Fills one entry per vertex in your own memory, such as a mapped buffer. Normals are those of
  /// the input or, if it has none, `normals` of its positions. Throws Error as
  /// `fill_pattern_vertices` does.
  void fill(const FrameInput& input, const FrameResult& frame, std::span<PatternVertex> vertices);

 private:
  struct State;
  Pimpl<State> state_;
};

}  // namespace brindle
