/// Waves on the two sides of a crease, at one vertex.
#pragma once

#include "brindle/types.h"

namespace brindle {

/// <R d_j, d_i> with the smallest rotation R from the unit normal n_j to n_i: how the waves run to
/// each other once the surface is unfolded about the crease. Zero where it is folded flat upon
/// itself.
inline float cosine_across(const Vec3& d_j, const Vec3& n_j, const Vec3& d_i, const Vec3& n_i) {
  constexpr float kFolded = 1e-3f;
  const float unfolded = 1 + n_i.dot(n_j);
  if (unfolded < kFolded) return 0;
  return d_i.dot(d_j) - d_j.dot(n_i) * d_i.dot(n_j) / unfolded;
}

/// The coupling of a link, direct where it is positive, reflecting where it is negative. The phase
/// shift is zero, since both waves are at one place. Links are weak: they choose where the stripes
/// of a face lie, and do not bend them where the other face has another frequency along the crease.
inline float coupling_across(const Vec3& d_j, const Vec3& n_j, const Vec3& d_i, const Vec3& n_i) {
  constexpr float kWeight = 0.01f;
  return kWeight * cosine_across(d_j, n_j, d_i, n_i);
}

}  // namespace brindle
