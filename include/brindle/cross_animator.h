/// Stripes and textures of cross fields that follow changing input, frame by frame.
#pragma once

#include <span>

#include "brindle/cross_cover.h"
#include "brindle/export.h"
#include "brindle/quality.h"
#include "brindle/stripe_animator.h"
#include "brindle/surface.h"
#include "brindle/texture_waves.h"

namespace BRINDLE_EXPORT brindle {

/// One frame's input, one entry per vertex each. Spans are read during the call only.
struct CrossFrameInput {
  FrameInput waves;  ///< any one of each cross's four directions; waves.normals is ignored
  std::span<const Vec3> normals = {};  ///< unit vectors; empty: those of the surface
};

/// The pairing of a frame's crosses along edges.
enum class CrossMatching {
  afresh,  ///< computed in the first frame
  kept,    ///< as in the last frame, with all that depends on connectivity
  renewed  ///< different from the last frame: singularities of the field have moved
};

/// Times of a frame's stages.
struct CrossFrameMilliseconds {
  double match = 0;    ///< pairing of crosses; when renewed, the cover with its topology
  double solve = 0;    ///< the frame's phases
  double orient = 0;   ///< the waves at all corners
  double measure = 0;  ///< corner phases, branches, errors, distortion
};

/// A frame's result, valid until the next frame.
struct CrossFrameResult {
  FrameResult stripes;        ///< at the cover's nodes
  const CrossCover& cover;    ///< with the waves of these phases
  const Mesh& mesh;           ///< the mesh of the texture, as CrossTexture::surface
  const TextureWaves& waves;  ///< at the corners of that mesh's triangles
  PatternQuality quality;     ///< of both waves together, as in CrossPattern
  TextureQuality texture;     ///< distortion, from `measure_texture`
  CrossMatching matching = CrossMatching::afresh;
  CrossFrameMilliseconds milliseconds;
};

/// Lays stripes and a texture along both waves of a cross field that changes from frame to frame.
/// Phases follow as in StripeAnimator, for any of the four directions of each cross. While the
/// pairing of crosses is kept, a frame takes time linear in the number of edges. Where
/// singularities move, the cover is rebuilt, and the phases still continue from the last ones.
class CrossAnimator {
 public:
  /// Keeps its own data of the surface. `edge_weights` are those of the surface's directed edges.
  /// Throws Error for options out of range, and for a surface without triangles.
  explicit CrossAnimator(const Surface& surface, const AnimatorOptions& options = {});
  ~CrossAnimator();
  CrossAnimator(CrossAnimator&&) noexcept;
  CrossAnimator& operator=(CrossAnimator&&) noexcept;

  /// Solves and measures the next frame. Throws Error as `cross_pattern` does, and unless there is
  /// one normal per vertex; Cancelled if `progress` cancels. Then the animator is unchanged.
  CrossFrameResult frame(const CrossFrameInput& input, const Progress& progress = {});

  /// The energy of the last frame's phases, over both waves, as `energy` of phase_graph.h defines
  /// it. Throws Error before the first frame.
  double energy() const;

  /// Forgets the last frame: the next one is matched and solved from scratch.
  void restart();

  /// Makes the next frame follow these phases instead of the last frame's: a unit number per node
  /// of `cover`, for its waves, or 0 if unknown, as in a CrossPattern or a frame of another
  /// animator of the surface. Crosses are matched from scratch. Throws Error for other phases and
  /// for the cover of another surface, and then changes nothing.
  void set_last_phases(const CrossCover& cover, std::span<const Complex> z);

  /// As in StripeAnimator. Values by vertex apply to both waves.
  void set_slack(const Slack& slack);

 private:
  struct State;
  friend struct AnimatorArchive;  // saved.h
  Pimpl<State> state_;
};

}  // namespace brindle
