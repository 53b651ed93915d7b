/// Positions in binary PLY files: floats, or doubles where they have an origin.
#pragma once

#include "brindle/files/binary_output.h"
#include "brindle/local_positions.h"

namespace brindle {

/// The header's lines.
inline const char* position_properties(const Eigen::Vector3d& origin) {
  return origin.isZero(0) ? "property float x\nproperty float y\nproperty float z\n"
                          : "property double x\nproperty double y\nproperty double z\n";
}

inline void put_position(BinaryOutput& binary, const Vec3& position,
                         const Eigen::Vector3d& origin) {
  if (origin.isZero(0)) {
    binary.put(position.data(), 3);
  } else {
    binary.put(placed(position, origin).data(), 3);
  }
}

}  // namespace brindle
