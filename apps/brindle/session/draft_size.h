/// Reduced resolution of pictures while something moves.
#pragma once

#include <cstddef>

#include "brindle/image.h"

namespace brindle::tool {

/// Drafts are drawn at a lower resolution and enlarged, for a fluent frame rate. The reduction
/// follows from the times of drawing and of the stages before it.
class DraftSize {
 public:
  static constexpr std::size_t kFirst = 2;  ///< of all reductions

  /// The factor by which sides are shorter, from 1 to 4.
  float reduction() const;

  /// Records the time of drawing at `reduction()`, which may then change, and the frame's time that
  /// does not depend on it. Both in milliseconds.
  void note(double drawing, double before);

 private:
  std::size_t step_ = kFirst;
};

/// A side of a picture in this reduction, at least one pixel.
int reduced_side(int side, float reduction);

/// The picture enlarged to this size by linear interpolation, alpha like colours.
Image enlarged(const Image& image, int width, int height);

}  // namespace brindle::tool
