/// Waves on the two sides of a crease, at one vertex.
#pragma once

#include "brindle/types.h"

namespace brindle {

/// <R d_j, d_i> with the smallest rotation R from the unit normal n_j to n_i: the cosine between
/// the waves after unfolding the surface about the crease. Zero if it is folded flat onto itself.
inline float cosine_across(const Vec3& d_j, const Vec3& n_j, const Vec3& d_i, const Vec3& n_i) {
  constexpr float kFolded = 1e-3f;
  const float unfolded = 1 + n_i.dot(n_j);
  if (unfolded < kFolded) return 0;
  return d_i.dot(d_j) - d_j.dot(n_i) * d_i.dot(n_j) / unfolded;
}

}  // namespace brindle
