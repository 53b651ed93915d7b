/// How large pictures are drawn while something moves.
#pragma once

#include <cstddef>

#include "brindle/image.h"

namespace brindle::tool {

/// Drafts are drawn with shorter sides and enlarged, so that there are enough of them a second. How
/// much shorter follows from how long drawing took, and all that came before it.
class DraftSize {
 public:
  static constexpr std::size_t kFirst = 2;  ///< of all reductions

  /// How many times shorter, from 1 to 4.
  float reduction() const;

  /// Says how long drawing has taken at `reduction()`, which may then be another one, and what the
  /// frame took that does not depend on it. Both in milliseconds.
  void note(double drawing, double before);

 private:
  std::size_t step_ = kFirst;
};

/// A side of a picture in this reduction, at least a pixel.
int reduced_side(int side, float reduction);

/// The picture in another size, up to which pixels are mixed linearly; alpha like colours.
Image enlarged(const Image& image, int width, int height);

}  // namespace brindle::tool
