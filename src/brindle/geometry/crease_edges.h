/// Edges and vertices of a surface at its creases.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "brindle/geometry/topology.h"
#include "brindle/surface.h"

namespace brindle {

/// The edges of a surface before its vertices were split at creases, with the original numbers. An
/// edge on a crease has two triangles, whose corners may be copies of its ends.
MeshEdges joined_edges(const Surface& surface, const Progress& progress = {});

/// Pairs of vertices at the same position on both sides of a crease, in both orders, sorted.
std::vector<std::array<Index, 2>> links_over_creases(const Creases& creases);

/// The neighbourhood with these links.
std::shared_ptr<const Adjacency> neighbors_over_creases(const Surface& surface);

/// <R d_j, d_i> with the smallest rotation R from the unit normal n_j to n_i: the cosine between
/// directions on the two sides of a crease after unfolding the surface about it. Zero if it is
/// folded flat onto itself.
inline float cosine_across(const Vec3& d_j, const Vec3& n_j, const Vec3& d_i, const Vec3& n_i) {
  constexpr float kFolded = 1e-3f;
  const float unfolded = 1 + n_i.dot(n_j);
  if (unfolded < kFolded) return 0;
  return d_i.dot(d_j) - d_j.dot(n_i) * d_i.dot(n_j) / unfolded;
}

/// Whether an edge is sharp enough for a crease or has three or more triangles. If not, no part of
/// the mesh is split. Throws as `split_at_creases` does.
bool may_have_creases(const Mesh& mesh, float angle_deg);

}  // namespace brindle
