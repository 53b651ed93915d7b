/// A time series of files, step by step, and what lies between two of its steps.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "brindle/time_series.h"
#include "cli/progress_display.h"
#include "input/followed_field.h"
#include "input/preparation.h"
#include "scenes/scene.h"

namespace brindle::tool {

/// What `brindle animate --series` was asked for.
struct SeriesOptions {
  std::string name;  ///< what stands for the files; empty: no series
  int between = 0;   ///< frames between two steps
};

/// How many frames there are of so many steps (1 or more).
std::size_t frame_count(const SeriesOptions& options, std::size_t steps);

/// A step as it was read.
struct SeriesStep {
  TimedFile source;
  Preparation prepared;
  std::optional<WaveSet> waves_afresh;  ///< those of a field that went on from none, if they differ
};

/// How smooth fields go on from step to step.
struct SeriesFields {
  bool follow = true;   ///< each starts from the last step's and stays near to it; else anew
  bool afresh = false;  ///< those that are found anew are wanted, too
  MatchOptions match;
};

/// Reads the steps of a series, one after the other: files with a mesh each, or fields (.csv) over
/// one mesh.
class Series {
 public:
  /// Throws CLI::ValidationError if the files need a mesh, or have one and another is given; Error
  /// as `series_files` does.
  Series(const SeriesOptions& options, SurfaceOptions surface, WaveOptions waves,
         SeriesFields smooth_fields, std::optional<Viewpoint> viewpoint);

  std::size_t step_count() const { return files_.size(); }
  const std::vector<TimedFile>& files() const { return files_; }

  /// The next step. As many stripes per unit length as asked for along the diagonal of the first
  /// one's mesh; positions are relative to the first one's origin. Throws Error, naming the file,
  /// as `prepare` does, and for coordinates that are not finite.
  SeriesStep read(ProgressDisplay& display);

 private:
  Preparation prepare_step(ProgressDisplay& display) const;
  void keep(const SeriesStep& step);

  std::vector<TimedFile> files_;
  SurfaceOptions surface_;
  WaveOptions waves_;
  std::optional<Viewpoint> viewpoint_;  ///< frames the first step's mesh
  bool fields_ = false;                 ///< the files are fields over one mesh
  SeriesFields smooth_fields_;
  std::size_t next_ = 0;
  std::optional<KeptField> last_;  ///< if the next field goes on from it
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
};

/// The frame between two steps of the same triangles, at `share` of the way: positions, directions
/// (as lines: turned round where that makes them alike) and frequencies are interpolated linearly.
/// Where one of both has no wave, the nearer step says whether there is one.
SceneFrame between(const SceneFrame& a, const SceneFrame& b, float share);

}  // namespace brindle::tool
