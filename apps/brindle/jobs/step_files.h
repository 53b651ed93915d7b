/// The meshes of a series from `brindle animate`.
#pragma once

#include <vector>

#include "cli/progress_display.h"
#include "jobs/series_player.h"
#include "pictures/frame_output.h"
#include "pictures/picture.h"

namespace brindle::tool {

/// A mesh per step, with the step's arrays and waves, and a .pvd that lists them.
class StepFiles {
 public:
  /// The arguments must outlive this object.
  StepFiles(std::vector<FrameOutput> outputs, PhaseShiftKind phase_shift,
            const PictureOptions& picture, ProgressDisplay& display);

  /// Writes the next step. Throws what writing does.
  void add(const SeriesStep& step, const SolvedFrame& solved);

  /// Writes the list of steps.
  void finish() const;

 private:
  std::vector<FrameOutput> outputs_;
  PhaseShiftKind phase_shift_;
  const PictureOptions& picture_;
  ProgressDisplay& display_;
  std::vector<double> times_;
};

}  // namespace brindle::tool
