/// Textures that follow changing input, frame by frame.
#pragma once

#include <optional>
#include <span>

#include "brindle/broken_tiles.h"
#include "brindle/export.h"
#include "brindle/quality.h"
#include "brindle/stripe_animator.h"
#include "brindle/surface.h"
#include "brindle/texture_pattern.h"

namespace BRINDLE_EXPORT brindle {

/// Options of TextureAnimator.
struct TextureAnimatorOptions {
  /// Whether the signs of directions count, as in TextureOptions.
  bool oriented = false;
  AnimatorOptions stripes;  ///< of both patterns
  /// Motifs to keep whole: frames then report which of them are broken. Empty: not checked.
  std::optional<TileMotifs> whole_tiles = std::nullopt;
};

/// One frame's input, one entry per vertex each. Spans are read during the call only.
struct TextureFrameInput {
  FrameInput u;  ///< V runs along u.directions turned by 90 degrees; u.normals is ignored
  std::span<const float> frequencies_v = {};  ///< stripes per unit length of V; empty: those of U
  std::span<const Vec3> normals = {};         ///< unit vectors; empty: those of the surface
};

/// The relation of a frame's orientation to the last frame's.
enum class FrameOrientation {
  afresh,     ///< computed as in `texture_pattern`: the first frame
  kept,       ///< unchanged in every triangle; none had to be checked again
  continued,  ///< triangles keep their orientation; those without one follow their neighbours
  shortened   ///< as `continued`, with a new, shorter seam between the same ends
};

/// Times of a frame's stages.
struct TextureFrameMilliseconds {
  double solve = 0;    ///< frames of both patterns
  double orient = 0;   ///< orientation, seams, and the waves at all corners
  double measure = 0;  ///< corner phases, branches, errors, distortion
  double tiles = 0;  ///< finding broken ones: additional time to measuring, which runs concurrently
};

/// A frame's texture, valid until the next frame.
struct TextureFrameResult {
  /// As from `texture_pattern`, except energies, which `energy_u` and `energy_v` compute.
  const TexturePattern& pattern;
  FrameResult u, v;  ///< phases of both patterns
  FrameOrientation orientation = FrameOrientation::afresh;
  TextureFrameMilliseconds milliseconds;
  const BrokenTiles* broken = nullptr;  ///< of TextureAnimatorOptions::whole_tiles; null without
};

/// Lays a texture on one surface for a field that changes from frame to frame. The stripes of U and
/// V follow as in StripeAnimator. Triangles keep their orientation for any signs of the directions.
/// Seams therefore stay in place except at their ends, which follow the field's singularities.
/// Where nothing relevant to orientation changes, it is kept, and equals a computation from
/// scratch.
class TextureAnimator {
 public:
  /// Keeps its own data of the surface. With slack, frequencies of both patterns vary as in
  /// StripeAnimator. Throws Error for options out of range, and for a surface without triangles.
  explicit TextureAnimator(const Surface& surface, const TextureAnimatorOptions& options = {});
  ~TextureAnimator();
  TextureAnimator(TextureAnimator&&) noexcept;
  TextureAnimator& operator=(TextureAnimator&&) noexcept;

  /// Solves, orients and measures the next frame of both patterns. `progress` reports both as in
  /// StripeAnimator, and the orientation. Throws Error as `texture_pattern` does, and unless
  /// normals and frequencies are one per vertex; Cancelled if `progress` cancels. Failed or
  /// cancelled calls leave both patterns and the orientation unchanged.
  TextureFrameResult frame(const TextureFrameInput& input, const Progress& progress = {});

  /// The energies of the last frame's phases, as `energy` of phase_graph.h defines it. Throw Error
  /// before the first frame.
  double energy_u() const;
  double energy_v() const;

  /// Forgets the last frame: the next one is solved and oriented from scratch.
  void restart();

  /// As in StripeAnimator, for both patterns. They do not determine the orientation, which
  /// continues or is computed from scratch.
  void set_last_phases(std::span<const Complex> u, std::span<const Complex> v);

  /// As in StripeAnimator, for both patterns.
  void set_slack(const Slack& slack);

  /// Motifs to keep whole from the next frame on, as in TextureAnimatorOptions. Throws Error for
  /// extents beyond half a tile, and then changes nothing.
  void set_whole_tiles(const std::optional<TileMotifs>& motifs);

 private:
  struct State;
  friend struct AnimatorArchive;  // saved.h
  Pimpl<State> state_;
};

}  // namespace brindle
