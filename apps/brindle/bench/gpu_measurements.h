/// Times of GPU frames by stage, for `brindle bench`.
#pragma once

#include <string>
#include <vector>

#include "bench/measurements.h"
#include "device/device.h"

namespace brindle::tool {

/// A stage of GpuAnimator.
struct GpuStage {
  std::string name;
  Spread time;            ///< on the device, sum over fields
  std::size_t bytes = 0;  ///< least memory traffic, sum over fields; 0: unknown
};

/// A frame of GpuAnimator, from changed waves to phases, all fields of a subject.
struct GpuFrameMetrics {
  double topology_milliseconds = 0;  ///< on the processor, once for all fields
  std::vector<GpuStage> stages;
  Spread device;    ///< sum of all stages, with input on the device
  Spread wall;      ///< from the call until the device has finished, with input from the host
  Spread resident;  ///< the same with input on the device
  Spread picture;   ///< of the first field at 1920 x 1080, from its buffer, with readback
  std::size_t dispatches = 0;  ///< sum over fields
  Quality quality;             ///< of the last frame
};

/// Frames change as in `measure_frames`.
GpuFrameMetrics measure_gpu_frames(const Device& device, const Subject& subject,
                                   const Repetitions& repetitions, const Progress& progress);

/// The current context's copy bandwidth between buffers, bytes per second read and written; the
/// best of several runs.
double copy_bandwidth();

}  // namespace brindle::tool
