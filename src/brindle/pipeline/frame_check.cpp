#include "brindle/pipeline/frame_check.h"

#include <algorithm>

#include "brindle/waves/fineness.h"
#include "brindle/waves/wave_check.h"

namespace brindle {

void check_values(const FrameInput& input, const Adjacency& neighborhood,
                  const NormalsInPlace& in_place) {
  check_waves(input.positions, input.directions, input.frequencies);
  if (!input.normals.empty()) {
    check_tangent(input.normals, input.directions);
  } else if (std::ranges::equal(input.positions, in_place.positions)) {
    check_tangent(in_place.normals, input.directions);
  }
  check_fineness(neighborhood, input.positions, input.directions, input.frequencies);
}

}  // namespace brindle
