#include "brindle/pipeline/frames/frame_check.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "brindle/base/standard.h"
#include "brindle/error.h"
#include "brindle/waves/fineness.h"
#include "brindle/waves/wave_check.h"
#include "brindle/waves/weight_check.h"

namespace brindle {

void check_animator_options(const AnimatorOptions& options) {
  const auto require = [](bool holds, const char* message) {
    if (!holds) throw Error(std::string("animator options: ") + message);
  };
  require(is_weight(options.lambda), "lambda must be from 0 to 1e6");
  require(options.sweeps >= 0, "sweeps must be 0 or above");
  require(options.cycles >= 0, "cycles must be 0 or above");
  require(options.iterations > 0, "iterations must be above 0");
}

void check_frame_input(const FrameInput& input, std::size_t vertices) {
  if (input.positions.size() == vertices && input.directions.size() == vertices &&
      input.frequencies.size() == vertices &&
      (input.normals.empty() || input.normals.size() == vertices)) {
    return;
  }
  throw Error("animator: a frame needs one position, direction and frequency for each of " +
              std::to_string(vertices) + " vertices, and as many normals, or none");
}

void check_values(const FrameInput& input, const Adjacency& neighborhood,
                  const NormalsInPlace& in_place) {
  check_waves(input.positions, input.directions, input.frequencies);
  if (!input.normals.empty()) {
    check_tangent(input.normals, input.directions);
  } else if (ranges::equal(input.positions, in_place.positions)) {
    check_tangent(in_place.normals, input.directions);
  }
  check_fineness(neighborhood, input.positions, input.directions, input.frequencies);
}

}  // namespace brindle
