/// Input that changes from frame to frame, for measuring, and what frames leave of it.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "bench/measurements.h"
#include "brindle/quality.h"
#include "brindle/stripe_animator.h"

namespace brindle::tool {

/// Two inputs to go back and forth between: the second one is turned by a degree about the normals
/// and its frequencies are higher by 1 %.
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

/// One for every field.
std::vector<ChangingInput> changing_inputs(const Subject& subject);

/// Adds the figures of one of `fields` fields.
void add(Quality& sum, double energy, const PatternQuality& quality, std::size_t fields);

/// What the phases of frame `number` are worth, one vector a field.
Quality quality_of(const Subject& subject, const std::vector<ChangingInput>& inputs, int number,
                   std::span<const std::vector<Complex>> z);

}  // namespace brindle::tool
