/// Samples on points without triangles, where the peaks of two wave patterns cross.
#pragma once

#include <span>
#include <vector>

#include "brindle/pattern/sampling.h"
#include "brindle/phase_graph.h"
#include "brindle/types.h"

namespace brindle {

/// One of the two patterns: one wave and one phase exp(i Phi) per point.
struct PointWaves {
  const WaveSet& waves;
  std::span<const Complex> z;
};

/// The crossings of U's and V's peaks that each point's own two waves have in its tangent plane, as
/// long as no neighbour is nearer to them. Neighbours' waves are not quite the same, so that a
/// crossing midway may be found by both: those that are a tenth nearer to a neighbour are kept,
/// too, and `drop_doubles` with its default share is done. `Sample::triangle` is the number of the
/// point, with barycentric coordinates 1, 0, 0. Around a point as far as three quarters of the mean
/// distance to its neighbours is looked at; time and memory are linear in points and samples.
/// Throws Error in a build without nanoflann.
std::vector<Sample> point_samples(const Adjacency& neighborhood, std::span<const Vec3> normals,
                                  const PointWaves& u, const PointWaves& v);

}  // namespace brindle
