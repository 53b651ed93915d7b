/// The orientation of a texture's triangles, kept from frame to frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "brindle/base/compressed_rows.h"
#include "brindle/geometry/topology.h"
#include "brindle/pattern/corner_signs.h"
#include "brindle/pipeline/texture_orientation.h"
#include "brindle/texture_animator.h"

namespace brindle {

class KeptOrientation {
 public:
  explicit KeptOrientation(std::vector<Triangle> triangles);

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

  std::vector<Triangle> triangles_;
  std::vector<SharedEdge> edges_;
  CompressedRows<Index> edges_of_;  ///< numbers of the edges that each triangle shares

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
