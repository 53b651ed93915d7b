/// A part of a surface, and the rest of it.
#pragma once

#include <cstdint>

namespace brindle {

/// What the rest of the surface has at an edge of the part.
enum class EdgeBeyond : std::uint8_t {
  nothing,
  triangle,    ///< the other one of two
  nonmanifold  ///< so many that with the part's own there are three or more
};

}  // namespace brindle
