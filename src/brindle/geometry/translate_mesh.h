/// A mesh somewhere else.
#pragma once

#include "brindle/mesh.h"

namespace brindle {

/// Adds `way` to all positions; the origin stays.
inline void translate(Mesh& mesh, const Vec3& way) {
  for (Vec3& position : mesh.positions) position += way;
}

}  // namespace brindle
