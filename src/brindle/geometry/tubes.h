/// Tubes along lines, to show or print them.
#pragma once

#include "brindle/geometry/mesh.h"
#include "brindle/geometry/polylines.h"

namespace brindle {

struct TubeOptions {
  float radius = 0.01f;  ///< in units of length, above zero
  int sides = 8;         ///< 3 to 64
};

/// A tube around every line: rings of `sides` vertices in the planes that halve the angles between
/// segments, the ends of open lines closed by flat caps. Points nearer to the one before than a
/// tenth of the radius are passed over; lines without length have no tube. Throws Error for options
/// out of range and for more vertices than an Index can count.
Mesh tubes(const Polylines& lines, const TubeOptions& options);

}  // namespace brindle
