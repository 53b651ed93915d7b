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

/// Which waves agree across a shared edge: both triangles have the same waves at its vertices, up
/// to sign.
using EdgeAgreement = std::uint8_t;

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
