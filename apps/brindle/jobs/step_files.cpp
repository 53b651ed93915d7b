#include "jobs/step_files.h"

#include <utility>

#include "brindle/files.h"
#include "outputs/mesh_output.h"

namespace brindle::tool {

StepFiles::StepFiles(std::vector<FrameOutput> outputs, PhaseShiftKind phase_shift,
                     const PictureOptions& picture, ProgressDisplay& display)
    : outputs_(std::move(outputs)),
      phase_shift_(phase_shift),
      picture_(picture),
      display_(display) {}

void StepFiles::add(const SeriesStep& step, const SolvedFrame& solved) {
  const Preparation& prepared = step.prepared;
  if (!outputs_.empty()) {
    StripePattern pattern;
    pattern.waves = solved.scene.waves;
    pattern.frequencies_wanted.assign(solved.frequencies_wanted.begin(),
                                      solved.frequencies_wanted.end());
    pattern.phase_shift = phase_shift_;
    pattern.solution.z.assign(solved.z.begin(), solved.z.end());
    pattern.corners.assign(solved.corners.begin(), solved.corners.end());
    const StripeResult result{std::move(pattern)};
    const InputData data{prepared.arrays, prepared.original_ids, prepared.partners,
                         prepared.turn_deg};
    for (const FrameOutput& output : outputs_) {
      write_made_mesh(frame_path(output, times_.size()),
                      {prepared.surface, result, data, phase_shift_}, picture_, display_);
    }
  }
  times_.push_back(step.source.time);
}

void StepFiles::finish() const {
  for (const FrameOutput& output : outputs_) {
    std::vector<TimedFile> files;
    for (std::size_t step = 0; step < times_.size(); ++step) {
      files.push_back({times_[step], frame_path(output, step)});
    }
    write_pvd(collection_path(output), files);
  }
}

}  // namespace brindle::tool
