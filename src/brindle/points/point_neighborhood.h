/// Who is next to whom among points.
#pragma once

#include <span>

#include "brindle/adjacency.h"
#include "brindle/progress.h"
#include "brindle/types.h"

namespace brindle {

/// Joins each of the `used` points to the `count` nearest others of them; j is a neighbour of i if
/// either is among the nearest of the other. `used` is in ascending order; all other points have no
/// neighbours. Positions are finite and different from each other where used. Of points equally far
/// away any may be taken, the same ones in every run. Throws Error for a count below 1, and in a
/// build without nanoflann; TooLarge (memory.h) for neighbours that memory does not hold.
Adjacency point_neighborhood(std::span<const Vec3> positions, std::span<const Index> used,
                             int count, const Progress& progress = {});

}  // namespace brindle
