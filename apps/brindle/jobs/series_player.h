/// A time series played step by step, and its figures.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "input/carried_pattern.h"
#include "jobs/animation.h"
#include "jobs/series.h"

namespace brindle::tool {

/// What a series is played with.
struct SeriesPlay {
  SeriesOptions series;
  AnimatorOptions animator;
  MatchOptions match;
  bool compare_from_scratch = false;
};

/// Stripes that follow each other while meshes change or stay.
class SeriesAnimator {
 public:
  SeriesAnimator(const AnimatorOptions& options, MatchOptions match);

  struct Result {
    FrameResult frame;                   ///< valid until the next one
    std::optional<Matching> matched_by;  ///< not in the first frame
    std::size_t unmatched = 0;
  };

  /// `arrays` are those of points, for ids; `name` is the file's, for messages. Throws Error as
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

/// Receives every step, after `ShowFrame` has had its frame.
using ShowStep = std::function<void(const SeriesStep& step, const SolvedFrame& frame)>;

/// Solves and measures all frames; `show` and `show_step` may be empty. Throws what reading and
/// solving do, and Error, naming the files, if there are to be frames between steps whose triangles
/// differ.
AnimationReport play(Series& series, const SeriesPlay& options, const ShowFrame& show,
                     const ShowStep& show_step, ProgressDisplay& display);

}  // namespace brindle::tool
