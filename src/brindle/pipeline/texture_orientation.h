/// Orientation of each triangle's texture, and the seams where it changes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "brindle/base/archive.h"
#include "brindle/base/compressed_rows.h"
#include "brindle/geometry/topology.h"
#include "brindle/pattern/corner_signs.h"
#include "brindle/progress.h"
#include "brindle/texture_animator.h"
#include "brindle/texture_waves.h"
#include "brindle/types.h"

namespace brindle {

// Flips triangles until neighbours are oriented consistently.

/// Agreement of two neighbouring triangles. 1: their waves point the same way; -1: one has to be
/// flipped; 0: flipping does not help.
struct TriangleLink {
  Index neighbor;
  float coupling;
};

/// Triangles to flip (1) so that as many neighbours as possible agree. `links` stores each link in
/// the rows of both triangles. Large meshes are solved in blocks first, then triangle by triangle
/// around the remaining seams. Throws Cancelled if `progress` asks for it.
std::vector<std::uint8_t> agreeing_turns(const CompressedRows<TriangleLink>& links,
                                         const Progress& progress = {});

/// Which waves agree across a shared edge: both triangles have the same waves at its vertices, up
/// to sign.
using EdgeAgreement = std::uint8_t;
inline constexpr EdgeAgreement kUAlike = 1;
inline constexpr EdgeAgreement kVAlike = 2;
inline constexpr EdgeAgreement kNoAgreement = 4;  ///< a triangle without orientation

/// Agreement of all shared edges, from the corner signs.
void agreements(std::span<const CornerSigns> signs, std::span<const SharedEdge> edges,
                std::vector<EdgeAgreement>& result);

/// Updates agreements after flipping the triangles with a 1.
void turn_agreements(std::span<const std::uint8_t> turned, std::span<const SharedEdge> edges,
                     std::span<EdgeAgreement> agreement);

/// Triangles to flip (1; U and V together) for a short seam; the seam is empty if the field is
/// orientable. Triangles are nodes of a phase graph with phases +i (keep) and -i (flip) whose
/// energy counts seam edges. The multilevel solver's seam is then replaced by shortest paths
/// (`shortening_turns`). Of two opposite solutions, each connected component takes the one that
/// keeps most triangles. `edges` are shared by `triangles`; triangles with a 0 in `oriented` have
/// no orientation.
std::vector<std::uint8_t> orienting_turns(std::span<const Triangle> triangles,
                                          std::span<const std::uint8_t> oriented,
                                          std::span<const SharedEdge> edges,
                                          std::span<const EdgeAgreement> agreement,
                                          const Progress& progress = {});

/// Its second half alone: flips that shorten a seam.
std::vector<std::uint8_t> shortening_turns(std::span<const Triangle> triangles,
                                           std::span<const std::uint8_t> oriented,
                                           std::span<const SharedEdge> edges,
                                           std::span<const EdgeAgreement> agreement,
                                           const Progress& progress = {});

/// 1 for triangles with an orientation.
std::vector<std::uint8_t> oriented_triangles(std::span<const CornerSigns> signs);

/// Counts the seams; skips edges of triangles without orientation.
TextureSeams texture_seams(std::span<const std::uint8_t> oriented,
                           std::span<const EdgeAgreement> agreement);

/// The orientation of a texture from frame to frame. A static pattern is a first frame.
class TextureOrientation {
 public:
  /// `triangles` must outlive it.
  explicit TextureOrientation(std::span<const Triangle> triangles);

  /// Orients a frame with these vertex directions. With `as_given`, triangles stay as
  /// `corner_signs` leaves them. On any exception, including Cancelled if `progress` asks for it,
  /// the last frame's orientation stays.
  FrameOrientation follow(std::span<const Vec3> u, std::span<const Vec3> v, bool as_given,
                          const Progress& progress = {});

  /// Corner signs of the last frame.
  std::span<const CornerSigns> signs() const { return shown_; }
  const TextureSeams& seams() const { return seams_; }

  /// Saves the last frame's orientation, or restores it for the same triangles.
  void archive(Archive& archive, std::size_t vertices);

  /// Orients the next frame from scratch.
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
  CompressedRows<Index> edges_of_;  ///< shared edges by triangle; empty until used

  std::vector<CornerSigns> signs_;        ///< from `corner_signs`
  std::vector<CornerSigns> last_signs_;   ///< those of the last frame
  std::vector<std::uint8_t> turned_;      ///< 1 for flipped triangles
  std::vector<CornerSigns> shown_;        ///< signs after flips
  std::vector<CornerSigns> last_shown_;   ///< of the last frame
  std::vector<Vec3> last_directions_;     ///< of U; empty: no last frame
  std::vector<std::uint8_t> flipped_;     ///< vertices whose direction has reversed
  std::vector<EdgeAgreement> agreement_;  ///< after flips
  TextureSeams seams_;
  std::size_t shortest_ = 0;  ///< fewest seam edges since the last recomputation
};

}  // namespace brindle
