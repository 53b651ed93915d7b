/// How well a pattern on points follows its field.
#pragma once

#include <span>

#include "brindle/quality.h"
#include "brindle/types.h"

namespace brindle {

/// Angle and spacing errors of the phase's gradient at every point: the least-squares solution for
/// the lifted steps to its neighbours, in the tangent plane. Without triangles there is nothing to
/// go round, so branches and singularities are not counted. Points without a wave, or whose
/// neighbours with one lie on a line through them, do not count in the means; all others count
/// alike. `normals`, `waves` and `z` have one entry per point.
PatternQuality measure_point_quality(const Adjacency& neighborhood, std::span<const Vec3> normals,
                                     const WaveSet& waves, std::span<const Complex> z,
                                     PhaseShiftKind kind, const Progress& progress = {});

}  // namespace brindle
