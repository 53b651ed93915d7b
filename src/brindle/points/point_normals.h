/// Normals of points without triangles.
#pragma once

#include <span>
#include <vector>

#include "brindle/progress.h"
#include "brindle/types.h"

namespace brindle {

/// One unit normal per point, up to sign: that of the plane that best fits it and its neighbours
/// (principal component analysis). Zero if these are collinear or fewer than two.
std::vector<Vec3> fitted_normals(std::span<const Vec3> positions, const Adjacency& neighborhood,
                                 const Progress& progress = {});

/// Whether the points fill a volume rather than a surface, even a noisy one. Compares, at sample
/// points, how far neighbours spread across and along their best-fitting plane. False below 50
/// points, which are too few to decide.
bool fill_volume(std::span<const Vec3> positions, std::span<const Index> used,
                 const Adjacency& neighborhood);

/// Flips normals so that neighbours agree, along a minimum spanning tree of normal differences
/// (Hoppe et al. 1992). Each component then points outwards, or up (z) if it encloses nothing. Zero
/// normals stay, and orientation does not propagate across them. Some neighbours still disagree on
/// surfaces that are not orientable, and where sheets are closer than points.
void orient_normals(std::span<const Vec3> positions, const Adjacency& neighborhood,
                    std::span<Vec3> normals, const Progress& progress = {});

}  // namespace brindle
