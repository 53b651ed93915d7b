/// Surface samples where the peaks of two wave patterns cross (paper, 5.1).
#pragma once

#include <span>
#include <vector>

#include "brindle/pattern/lifted_waves.h"
#include "brindle/phase_graph.h"
#include "brindle/samples.h"
#include "brindle/types.h"

namespace brindle {

/// Returns all crossings of U's and V's centre lines (`stripe_pieces`), triangle by triangle. The
/// order of line ends around a triangle decides whether two lines cross in it. Neighbouring
/// triangles agree on this order, so a crossing on an edge or vertex is found once. U and V may
/// have any frequencies. Both must be of the same surface. Throws Error for more than 2^24
/// crossings in 4096 triangles and if memory does not suffice; Cancelled if `progress` cancels.
std::vector<Sample> wave_samples(const LiftedWaves& u, const LiftedWaves& v,
                                 const Progress& progress = {});

// Samples on points without triangles, where the peaks of two wave patterns cross.

/// One of the two patterns: one wave and one phase exp(i Phi) per point.
struct PointWaves {
  const WaveSet& waves;
  std::span<const Complex> z;
};

/// Returns the crossings of U's and V's peaks, by each point's two waves in its tangent plane,
/// unless a neighbour is nearer. Waves of neighbours differ slightly, so both may find a crossing
/// midway. Crossings up to a tenth farther from their point than from a neighbour are therefore
/// kept, and `drop_doubles` with its default share removes doubles. `Sample::triangle` is the
/// number of the point, with barycentric coordinates 1, 0, 0. The search radius is three quarters
/// of the mean distance to the neighbours. Time and memory are linear in points and samples. Throws
/// Error in a build without nanoflann.
std::vector<Sample> point_samples(const Adjacency& neighborhood, std::span<const Vec3> normals,
                                  const PointWaves& u, const PointWaves& v);

}  // namespace brindle
