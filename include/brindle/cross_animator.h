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
  FrameInput waves;  ///< one of each cross's directions, whichever of the four; waves.normals are
                     ///< not looked at
  std::span<const Vec3> normals = {};  ///< unit vectors; empty: those of the surface
};

/// How a frame's crosses belong together along edges.
enum class CrossMatching {
  afresh,  ///< found in the first frame
  kept,    ///< as in the last frame, and with it all that depends on connectivity
  renewed  ///< otherwise than in the last frame: singularities of the field have moved
};

struct CrossFrameMilliseconds {
  double match = 0;    ///< which crosses belong together; when renewed, the cover with its topology
  double solve = 0;    ///< the frame's phases
  double orient = 0;   ///< the waves at all corners
  double measure = 0;  ///< corner phases, branches, errors, distortion
};

/// Everything is valid until the next frame.
struct CrossFrameResult {
  FrameResult stripes;        ///< of the cover's nodes
  const CrossCover& cover;    ///< with the waves that the phases are of
  const Mesh& mesh;           ///< what the texture is drawn on, as CrossTexture::surface
  const TextureWaves& waves;  ///< at the corners of that mesh's triangles
  PatternQuality quality;     ///< of both waves together, as CrossPattern has it
  TextureQuality texture;     ///< distortion, as `measure_texture` finds it
  CrossMatching matching = CrossMatching::afresh;
  CrossFrameMilliseconds milliseconds;
};

/// Lays stripes and a texture along both waves of a cross field that changes from frame to frame.
/// Phases follow as StripeAnimator lets them, whichever of its four directions each cross is given
/// by. As long as crosses belong together as they did, a frame takes time linear in the number of
/// edges; where singularities move, the cover is made anew, and the phases go on from the last
/// ones all the same.
class CrossAnimator {
 public:
  /// Keeps what it needs of the surface. `edge_weights` are those of the surface's directed edges.
  /// Throws Error for options out of range, and for a surface without triangles.
  explicit CrossAnimator(const Surface& surface, const AnimatorOptions& options = {});
  ~CrossAnimator();
  CrossAnimator(CrossAnimator&&) noexcept;
  CrossAnimator& operator=(CrossAnimator&&) noexcept;

  /// Solves for the next frame and measures it. Throws Error as `cross_pattern` does, and for
  /// normals that are not one per vertex; Cancelled if `progress` asks for it. The animator then is
  /// as it was before the call.
  CrossFrameResult frame(const CrossFrameInput& input, const Progress& progress = {});

  /// The energy of the last frame's phases, over both waves, as `energy` of phase_graph.h defines
  /// it. Throws Error before the first frame.
  double energy() const;

  /// Forgets the last frame: the next one is matched and solved afresh.
  void restart();

  /// Lets the next frame follow these phases instead of the last frame's: a unit number per node of
  /// `cover`, for the waves that it has, or 0 where none is known; as a CrossPattern or a frame of
  /// another animator of the surface has them. Crosses are matched afresh. Throws Error for other
  /// phases and for the cover of another surface, and leaves all as it was.
  void set_last_phases(const CrossCover& cover, std::span<const Complex> z);

  /// As StripeAnimator's; of slack and calm by vertex both waves have the same.
  void set_slack(const Slack& slack);

 private:
  struct State;
  Pimpl<State> state_;
};

}  // namespace brindle
