/// A surface that is no manifold and in parts.
#pragma once

#include <cmath>

#include "brindle/mesh.h"

namespace brindle::testing_support {

/// Three sheets that meet in an edge, twice, apart from each other, and a vertex alone.
inline Mesh torn_mesh() {
  Mesh mesh;
  for (int part = 0; part < 2; ++part) {
    for (int sheet = 0; sheet < 3; ++sheet) {
      const auto angle = static_cast<float>(2.1 * sheet);
      const auto first = static_cast<Index>(mesh.positions.size());
      constexpr Index kSide = 24;
      for (Index i = 0; i < kSide; ++i) {
        for (Index j = 0; j < kSide; ++j) {
          const float out = static_cast<float>(i) / (kSide - 1);
          mesh.positions.emplace_back(out * std::cos(angle) + 3 * static_cast<float>(part),
                                      out * std::sin(angle), static_cast<float>(j) / (kSide - 1));
        }
      }
      for (Index i = 0; i + 1 < kSide; ++i) {
        for (Index j = 0; j + 1 < kSide; ++j) {
          const Index a = first + i * kSide + j, b = a + kSide;
          mesh.triangles.push_back({a, b, a + 1});
          mesh.triangles.push_back({b, b + 1, a + 1});
        }
      }
    }
  }
  join_vertices(mesh);
  return mesh;
}

}  // namespace brindle::testing_support
