/// Times of frames on the GPU, by stage, for `brindle bench`.
#pragma once

#include <string>
#include <vector>

#include "bench/measurements.h"
#include "input/device.h"

namespace brindle::tool {

/// A stage of GpuAnimator.
struct GpuStage {
  std::string name;
  Spread time;            ///< on the device, sum over fields
  std::size_t bytes = 0;  ///< that it moves at least, sum over fields; 0: not known
};

/// A frame of GpuAnimator, from changed waves to phases, all fields of a subject.
struct GpuFrameFigures {
  double topology_milliseconds = 0;  ///< on the processor, once for all fields
  std::vector<GpuStage> stages;
  Spread device;    ///< sum of all stages, of input that is on the device already
  Spread wall;      ///< from the call until the device has finished, input from the processor
  Spread resident;  ///< the same of input that is on the device already
  Spread picture;   ///< of the first field in 1920 x 1080, from its buffer, and its way back
  std::size_t dispatches = 0;  ///< sum over fields
  Quality quality;             ///< of the last frame
};

/// Frames change as those of `measure_frames`.
GpuFrameFigures measure_gpu_frames(const Device& device, const Subject& subject,
                                   const Repetitions& repetitions, const Progress& progress);

/// Bytes a second, read and written, that the current context copies from buffer to buffer; the
/// best of a few times.
double copy_bandwidth();

}  // namespace brindle::tool
