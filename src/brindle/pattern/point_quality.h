/// Errors of a pattern on points relative to its field.
#pragma once

#include <span>

#include "brindle/quality.h"
#include "brindle/types.h"

namespace brindle {

/// Measures angle and spacing errors of the phase gradient at every point: the least-squares fit to
/// the lifted steps to its neighbours, in the tangent plane. Without triangles, branches and
/// singularities are not counted. The means weigh points equally. They exclude points without a
/// wave and points whose neighbours with a wave are collinear with them. `normals`, `waves` and `z`
/// have one entry per point.
PatternQuality measure_point_quality(const Adjacency& neighborhood, std::span<const Vec3> normals,
                                     const WaveSet& waves, std::span<const Complex> z,
                                     PhaseShiftKind kind, const Progress& progress = {});

}  // namespace brindle
