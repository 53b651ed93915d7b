/// Surface samples where the peaks of two wave patterns cross (paper, 5.1).
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "brindle/pattern/lifted_waves.h"
#include "brindle/samples.h"
#include "brindle/texture_waves.h"

namespace brindle {

/// One of the two patterns, triangle by triangle.
struct SampledWaves {
  std::function<LiftedTriangle(std::size_t)> lifted;
  std::function<CornerWaves(std::size_t)> corners;
};

/// The waves of a pattern's vertices, which must outlive the result.
SampledWaves sampled_waves(const LiftedWaves& waves);

/// Waves by corner, as in `TextureWaves` (also of cross fields), which must outlive the result.
SampledWaves sampled_waves(const Mesh& mesh, std::span<const CornerWaves> corners,
                           PhaseShiftKind kind = PhaseShiftKind::aligned);

/// Returns all crossings of U's and V's centre lines (`stripe_pieces`), triangle by triangle. The
/// order of line ends around a triangle decides whether two lines cross in it. Neighbouring
/// triangles agree on this order, so a crossing on an edge or vertex is found once. U and V may
/// have any frequencies. `normals` has one unit vector per vertex. Throws Error for more than 2^24
/// crossings in 4096 triangles and if memory does not suffice; Cancelled if `progress` cancels.
std::vector<Sample> wave_samples(const Mesh& mesh, std::span<const Vec3> normals,
                                 const SampledWaves& u, const SampledWaves& v,
                                 const Progress& progress = {});

}  // namespace brindle
