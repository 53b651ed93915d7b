/// Plays a time series: solves the frames of its steps, and writes the steps as meshes.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/progress_display.h"
#include "input/carried_pattern.h"
#include "jobs/animation.h"
#include "jobs/series.h"
#include "pictures/frame_output.h"
#include "pictures/picture.h"

namespace brindle::tool {

/// Options of a played series.
struct SeriesPlay {
  SeriesOptions series;
  AnimatorOptions animator;
  MatchOptions match;
  bool compare_from_scratch = false;
};

/// Stripes that continue from frame to frame, even if meshes change.
class SeriesAnimator {
 public:
  SeriesAnimator(const AnimatorOptions& options, MatchOptions match);

  struct Result {
    FrameResult frame;                   ///< valid until the next one
    std::optional<Matching> matched_by;  ///< empty in the first frame
    std::size_t unmatched = 0;
  };

  /// `arrays` are point arrays, for ids; `name` is the file's, for messages. Throws Error as
  /// `carry` and `StripeAnimator::frame` do.
  Result frame(const SceneFrame& input, std::shared_ptr<const Adjacency> neighborhood,
               std::span<const DataArray> arrays, const std::string& name,
               const Progress& progress = {});

  double topology_milliseconds() const { return topology_milliseconds_; }

 private:
  AnimatorOptions options_;
  MatchOptions match_;
  std::optional<StripeAnimator> animator_;
  std::optional<KeptPattern> last_;
  double topology_milliseconds_ = 0;
};

/// Receives every step, after `ShowFrame` received its frame.
using ShowStep = std::function<void(const SeriesStep& step, const SolvedFrame& frame)>;

/// Solves and measures all frames; `show` and `show_step` may be empty. Throws what reading and
/// solving throw, and Error with the files for frames between steps of different triangles.
AnimationReport play(Series& series, const SeriesPlay& options, const ShowFrame& show,
                     const ShowStep& show_step, ProgressDisplay& display);

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
