/// Input that changes from frame to frame, and the quality of its frames.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "bench/measurements.h"
#include "brindle/quality.h"
#include "brindle/stripe_animator.h"

namespace brindle::tool {

/// Two alternating inputs: the second is turned by a degree about the normals, with 1 % higher
/// frequencies.
struct ChangingInput {
  std::vector<Vec3> positions;
  std::array<std::vector<Vec3>, 2> directions;
  std::array<std::vector<float>, 2> frequencies;

  FrameInput frame(int number) const {
    const auto which = static_cast<std::size_t>(number % 2);
    return {positions, directions[which], frequencies[which]};
  }
  WaveSet waves(int number) const {
    const auto which = static_cast<std::size_t>(number % 2);
    return {positions, directions[which], frequencies[which]};
  }
};

ChangingInput changing_input(const Surface& surface, const WaveSet& waves);

/// One per field.
std::vector<ChangingInput> changing_inputs(const Subject& subject);

/// Adds the metrics of one of `fields` fields.
void add(Quality& sum, double energy, const PatternQuality& quality, std::size_t fields);

/// The quality of the phases of frame `number`, one vector per field.
Quality quality_of(const Subject& subject, const std::vector<ChangingInput>& inputs, int number,
                   std::span<const std::vector<Complex>> z);

}  // namespace brindle::tool
