/// How a frame follows the last one's phases.
#pragma once

#include <span>
#include <vector>

#include "brindle/types.h"

namespace brindle {

/// T_i = lambda deg_i z_i of the last frame, by slot.
void set_anchors(std::span<const float> degree, std::span<const Complex> last_z, float lambda,
                 std::vector<Complex>& anchor);

/// Sums over slots with a wave and a last phase.
struct PhaseSteps {
  double angle = 0;  ///< of |arg(z conj(last_z))|, in radians
  double count = 0;

  PhaseSteps operator+(const PhaseSteps& other) const {
    return {angle + other.angle, count + other.count};
  }
  double mean() const { return count > 0 ? angle / count : 0; }
};

/// By slot, in whole slices. A slot without degree has no wave.
PhaseSteps phase_steps(std::span<const Complex> z, std::span<const Complex> last_z,
                       std::span<const float> degree);

}  // namespace brindle
