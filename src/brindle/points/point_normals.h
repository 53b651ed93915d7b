/// Normals of points without triangles.
#pragma once

#include <span>
#include <vector>

#include "brindle/progress.h"
#include "brindle/types.h"

namespace brindle {

/// One unit normal per point, of the plane that fits it and its neighbours best (principal
/// component analysis), up to sign. Zero where these lie on one line or are fewer than two.
std::vector<Vec3> fitted_normals(std::span<const Vec3> positions, const Adjacency& neighborhood,
                                 const Progress& progress = {});

/// Whether the points fill a volume rather than lie on a surface, however noisy: at half of some of
/// them, neighbours spread as far across the plane that fits them best as along it. Of fewer than
/// 50 points there is no telling.
bool fill_volume(std::span<const Vec3> positions, std::span<const Index> used,
                 const Adjacency& neighborhood);

/// Turns normals round so that neighbours agree, spreading along the edges where normals differ
/// least (Hoppe et al. 1992: minimum spanning tree). Those of every component then point outwards,
/// or up (z) where it encloses nothing. Normals that are zero stay, and orientation does not spread
/// across them. Where the surface cannot be oriented, or sheets are closer than points, some
/// neighbours keep disagreeing.
void orient_normals(std::span<const Vec3> positions, const Adjacency& neighborhood,
                    std::span<Vec3> normals, const Progress& progress = {});

}  // namespace brindle
