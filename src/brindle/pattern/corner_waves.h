/// The waves that meet in a triangle, corner by corner.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "brindle/types.h"
#include "brindle/geometry/mesh.h"
#include "brindle/waves/phase_graph.h"

namespace brindle {

/// A wave with its phase, z = exp(i Phi).
struct CornerWave {
  Wave wave;
  Complex z;
};

/// The same wave running the other way: -d with pi - Phi, that is -conj(z).
CornerWave flipped(const CornerWave& corner);

/// The corners of one triangle, each with the wave of its vertex, as it stands there.
std::array<CornerWave, 3> corner_waves(const Triangle& triangle, const WaveSet& waves,
                                       std::span<const Complex> z);

}  // namespace brindle
