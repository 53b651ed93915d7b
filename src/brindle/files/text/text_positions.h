/// Positions in text files, where they stood before they were made relative to an origin.
#pragma once

#include <span>
#include <string_view>

#include "brindle/base/output_file.h"
#include "brindle/local_positions.h"

namespace brindle {

/// Where a position stands, each coordinate after a `separator`. Of an origin other than zero,
/// doubles are written.
inline void write_position(TextOutput& text, char separator, const Vec3& position,
                           const Eigen::Vector3d& origin) {
  const bool local = !origin.isZero(0);
  const Eigen::Vector3d place = placed(position, origin);
  for (int axis = 0; axis < 3; ++axis) {
    text << separator;
    if (local) {
      text << place[axis];
    } else {
      text << position[axis];
    }
  }
}

/// A line per position: the keyword and where it stands.
inline void write_positions(TextOutput& text, std::string_view keyword,
                            std::span<const Vec3> positions, const Eigen::Vector3d& origin) {
  for (const Vec3& p : positions) {
    text << keyword;
    write_position(text, ' ', p, origin);
    text << '\n';
  }
}

}  // namespace brindle
