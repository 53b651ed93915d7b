/// Surface samples where the peaks of two wave patterns cross (paper, 5.1).
#pragma once

#include <array>
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

/// Waves corner by corner, as `TextureWaves` has them, also those of a cross field. They must
/// outlive the result.
SampledWaves sampled_waves(const Mesh& mesh, std::span<const CornerWaves> corners,
                           PhaseShiftKind kind = PhaseShiftKind::aligned);

/// All crossings of U's and V's centre lines (`stripe_pieces`), triangle by triangle. Whether two
/// lines cross in a triangle follows from the order of their ends around it, which neighbouring
/// triangles agree on: a crossing on an edge or vertex is found once. U and V may have any
/// frequencies. `normals` has one unit vector per vertex. Throws Error if there are far more
/// crossings than triangles: 2^24 in 4096 of these; Cancelled if `progress` asks for it.
std::vector<Sample> wave_samples(const Mesh& mesh, std::span<const Vec3> normals,
                                 const SampledWaves& u, const SampledWaves& v,
                                 const Progress& progress = {});

}  // namespace brindle
