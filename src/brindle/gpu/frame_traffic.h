/// The floor under a frame's time: what has to go through the device's memory.
#pragma once

#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include "brindle/gpu_animator.h"

namespace brindle {

class GpuTopology;

/// Bytes read and written by the stages of a multilevel frame with anchors if every pass over a
/// level (a sweep is one) reads and writes each item once: gathers that miss the caches come on
/// top, levels that fit into them stay below.
std::vector<StageBytes> frame_traffic(const GpuTopology& topology);

}  // namespace brindle
