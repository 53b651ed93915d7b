#include "brindle/pipeline/frames/last_phases.h"

#include "brindle/base/parallel.h"
#include "brindle/pattern/triangle_kernels.h"
#include "brindle/phases/sliced_graph.h"

namespace brindle {
namespace {

PhaseSteps steps_of_slice(const Complex* z, const Complex* last_z, const float* degree) {
  static_assert(kLanes == kTriangleLanes);
  PhaseSteps steps;
  alignas(64) float distances[kLanes];
  triangle_kernels::phase_distances(z, last_z, distances);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (degree[lane] <= 0 || last_z[lane] == Complex(0)) continue;
    steps.angle += static_cast<double>(distances[lane]);
    steps.count += 1;
  }
  return steps;
}

}  // namespace

void set_anchors(std::span<const float> degree, std::span<const Complex> last_z, float lambda,
                 std::vector<Complex>& anchor) {
  anchor.resize(degree.size());
  parallel_for(degree.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t slot = begin; slot < end; ++slot) {
      anchor[slot] = lambda * degree[slot] * last_z[slot];
    }
  });
}

PhaseSteps phase_steps(std::span<const Complex> z, std::span<const Complex> last_z,
                       std::span<const float> degree) {
  return parallel_sum<PhaseSteps>(
      degree.size() / kLanes,
      [&](std::size_t begin, std::size_t end) {
        PhaseSteps steps;
        for (std::size_t slice = begin; slice < end; ++slice) {
          const std::size_t first = slice * kLanes;
          steps = steps +
                  steps_of_slice(z.data() + first, last_z.data() + first, degree.data() + first);
        }
        return steps;
      },
      kSliceGrain);
}

}  // namespace brindle
