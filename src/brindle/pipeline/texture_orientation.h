/// Which way round each triangle shows its texture, and where that has to change.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "brindle/base/compressed_rows.h"
#include "brindle/geometry/topology.h"
#include "brindle/pattern/corner_signs.h"
#include "brindle/progress.h"
#include "brindle/texture_animator.h"
#include "brindle/texture_waves.h"

namespace brindle {

/// How the waves on both sides of each shared edge agree: the triangles' corners at one vertex have
/// the same waves up to their signs.
using EdgeAgreement = std::uint8_t;
inline constexpr EdgeAgreement kUAlike = 1;
inline constexpr EdgeAgreement kVAlike = 2;
inline constexpr EdgeAgreement kNoAgreement = 4;  ///< a triangle without orientation

/// Agreements along all edges that triangles share, from how their corners are turned.
void agreements(std::span<const CornerSigns> signs, std::span<const SharedEdge> edges,
                std::vector<EdgeAgreement>& result);

/// Changes agreements to those after the triangles with a 1 have been turned round.
void turn_agreements(std::span<const std::uint8_t> turned, std::span<const SharedEdge> edges,
                     std::span<EdgeAgreement> agreement);

/// Which whole triangles to turn (1; U and V together) so that the seam runs along few edges: none
/// where the field has an orientation. Triangles are the nodes of a phase graph whose phases are +1
/// (as it stands) and -1 (turned), coupled along edges, whose energy counts the edges of the seam;
/// what the multilevel solver leaves is replaced by shortest paths (`shortening_turns`). Each piece
/// of the surface has most of its triangles as they stood. `edges` are those that `triangles`
/// share; triangles with a 0 in `oriented` have no orientation.
std::vector<std::uint8_t> orienting_turns(std::span<const Triangle> triangles,
                                          std::span<const std::uint8_t> oriented,
                                          std::span<const SharedEdge> edges,
                                          std::span<const EdgeAgreement> agreement,
                                          const Progress& progress = {});

/// The second half of it alone: turns that make a seam shorter.
std::vector<std::uint8_t> shortening_turns(std::span<const Triangle> triangles,
                                           std::span<const std::uint8_t> oriented,
                                           std::span<const SharedEdge> edges,
                                           std::span<const EdgeAgreement> agreement,
                                           const Progress& progress = {});

/// 1 for triangles with an orientation.
std::vector<std::uint8_t> oriented_triangles(std::span<const CornerSigns> signs);

/// Counts the seams. Edges of triangles without orientation are not counted.
TextureSeams texture_seams(std::span<const std::uint8_t> oriented,
                           std::span<const EdgeAgreement> agreement);

/// The orientation of a texture, kept from frame to frame. A pattern at once is a first frame.
class TextureOrientation {
 public:
  /// `triangles` must outlive it.
  explicit TextureOrientation(std::span<const Triangle> triangles);

  /// Orients a frame whose vertices have these directions. With `as_given` triangles stay as
  /// `corner_signs` leaves them. Whatever it throws, among it Cancelled if `progress` asks for it,
  /// the orientation stays that of the last frame.
  FrameOrientation follow(std::span<const Vec3> u, std::span<const Vec3> v, bool as_given,
                          const Progress& progress = {});

  /// How the corners of the last frame are turned.
  std::span<const CornerSigns> signs() const { return shown_; }
  const TextureSeams& seams() const { return seams_; }

  /// The next frame is oriented afresh.
  void forget() { last_directions_.clear(); }

 private:
  FrameOrientation orient(std::span<const Vec3> u, bool as_given, const Progress& progress);
  std::vector<Index> continue_last();
  void follow_neighbors(std::vector<Index> undecided);
  bool follow_neighbors_of(Index triangle, std::span<const std::uint8_t> decided);
  bool shorten();
  void show();

  std::span<const Triangle> triangles_;
  std::vector<SharedEdge> edges_;
  CompressedRows<Index> edges_of_;  ///< numbers of the edges that each triangle shares; empty
                                    ///< until a frame asks

  std::vector<CornerSigns> signs_;        ///< as `corner_signs` finds them
  std::vector<CornerSigns> last_signs_;   ///< those of the last frame
  std::vector<std::uint8_t> turned_;      ///< 1 where a triangle is shown turned round
  std::vector<CornerSigns> shown_;        ///< both together
  std::vector<CornerSigns> last_shown_;   ///< of the last frame
  std::vector<Vec3> last_directions_;     ///< of U; empty: no last frame
  std::vector<std::uint8_t> flipped_;     ///< vertices whose direction has turned round
  std::vector<EdgeAgreement> agreement_;  ///< of what is shown
  TextureSeams seams_;
  std::size_t shortest_ = 0;  ///< edges of the seam since it was laid, at the fewest
};

}  // namespace brindle
