/// Textures that follow changing input, frame by frame.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "brindle/broken_tiles.h"
#include "brindle/export.h"
#include "brindle/quality.h"
#include "brindle/stripe_animator.h"
#include "brindle/surface.h"
#include "brindle/texture_pattern.h"

namespace BRINDLE_EXPORT brindle {

struct TextureAnimatorOptions {
  /// Whether the directions are vectors, whose signs are meant, as TextureOptions has it.
  bool oriented = false;
  AnimatorOptions stripes;  ///< of both patterns
  /// Figures to look after: frames then say which of them are broken. Nothing: nobody asks.
  std::optional<TileFigures> whole_tiles = std::nullopt;
};

/// One frame's input, one entry per vertex each. Spans are read during the call only.
struct TextureFrameInput {
  FrameInput u;  ///< V runs along u.directions turned by 90 degrees; u.normals are not looked at
  std::span<const float> frequencies_v = {};  ///< stripes per unit length of V; empty: those of U
  std::span<const Vec3> normals = {};         ///< unit vectors; empty: those of the surface
};

/// How a frame's orientation follows from the last frame's.
enum class FrameOrientation {
  afresh,     ///< as `texture_pattern` finds it: the first frame
  kept,       ///< of every triangle as it was: none had to be looked at again
  continued,  ///< triangles run as they ran; those that had no orientation follow their neighbours
  shortened   ///< the same, and the seam, grown too long, was laid anew between its ends
};

struct TextureFrameMilliseconds {
  double solve = 0;    ///< frames of both patterns
  double orient = 0;   ///< orientation, seams, and the waves at all corners
  double measure = 0;  ///< corner phases, branches, errors, distortion
  double tiles = 0;    ///< finding broken ones: how much longer that takes than measuring, which
                       ///< goes on at the same time
};

struct TextureFrameResult {
  /// As `texture_pattern` has it, but for energies, which `energy_u` and `energy_v` compute. Valid
  /// until the next frame, as everything is.
  const TexturePattern& pattern;
  FrameResult u, v;  ///< how the phases of both patterns were found
  FrameOrientation orientation = FrameOrientation::afresh;
  TextureFrameMilliseconds milliseconds;
  const BrokenTiles* broken = nullptr;  ///< of TextureAnimatorOptions::whole_tiles; null without
};

/// Lays a texture over one surface for a field that changes from frame to frame. The stripes of U
/// and V follow as StripeAnimator lets them. Triangles go on running as they ran, whatever the
/// signs of the directions do, so that the seam stays where it is but at its ends, which follow the
/// field's singularities. Where nothing has changed that orientation goes by, everything is kept,
/// and is what computing it afresh would give.
class TextureAnimator {
 public:
  /// Keeps what it needs of the surface. With slack, frequencies of both patterns yield as those of
  /// StripeAnimator do. Throws Error for options out of range, and for a surface without triangles.
  explicit TextureAnimator(const Surface& surface, const TextureAnimatorOptions& options = {});
  ~TextureAnimator();
  TextureAnimator(TextureAnimator&&) noexcept;
  TextureAnimator& operator=(TextureAnimator&&) noexcept;

  /// Solves for the next frame of both patterns, orients and measures it. `progress` hears of both
  /// as StripeAnimator's does, and of the orientation. Throws Error as `texture_pattern` does, and
  /// for normals or frequencies that are not one per vertex; Cancelled if `progress` asks for it.
  /// Whatever it throws, both patterns and the orientation then are as they were before the call.
  TextureFrameResult frame(const TextureFrameInput& input, const Progress& progress = {});

  /// The energies of the last frame's phases, as `energy` of phase_graph.h defines it. Throw Error
  /// before the first frame.
  double energy_u() const;
  double energy_v() const;

  /// Forgets the last frame: the next one is solved and oriented afresh.
  void restart();

  /// As StripeAnimator's, of both patterns. How triangles run is not theirs: it goes on, or is
  /// found afresh.
  void set_last_phases(std::span<const Complex> u, std::span<const Complex> v);

  /// As StripeAnimator's, for both patterns.
  void set_slack(const Slack& slack);

  /// Figures to look after from the next frame on, as TextureAnimatorOptions has them. Throws Error
  /// for extents that reach beyond half a tile, and leaves all as it was.
  void set_whole_tiles(const std::optional<TileFigures>& figures);

 private:
  struct State;
  Pimpl<State> state_;
};

}  // namespace brindle
