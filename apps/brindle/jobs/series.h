/// Reads a time series of files and interpolates between its steps.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "brindle/files.h"
#include "cli/progress_display.h"
#include "input/carried_pattern.h"
#include "input/preparation.h"
#include "scenes/scene.h"

namespace brindle::tool {

/// The steps of `name`, in order:
/// - a .pvd: its files, with its times;
/// - a name with %d or %04d: numbered files, from the first to the last, with numbers as times;
/// - a name with * or ?: all matching files, with numbers in numeric order and times 0, 1, 2 ...
/// Only the file name may be a pattern. Throws CLI::ValidationError with `option` for another kind
/// of name, Error if no file exists or a number is missing.
std::vector<TimedFile> series_files(const std::string& option, const std::string& name);

/// Options of `brindle animate --series`.
struct SeriesOptions {
  std::string name;  ///< name or pattern of the files; empty: no series
  int between = 0;   ///< frames between two steps
};

/// The number of frames for at least one step.
std::size_t frame_count(const SeriesOptions& options, std::size_t steps);

/// A step as it was read.
struct SeriesStep {
  TimedFile source;
  Preparation prepared;
  std::optional<WaveSet> waves_afresh;  ///< those of a field computed from scratch, if different
};

/// Continuation of smooth fields from step to step.
struct SeriesFields {
  bool follow = true;   ///< each field starts from the last one's and stays near to it
  bool afresh = false;  ///< also compute fields from scratch
  MatchOptions match;
};

/// Reads the steps of a series: a mesh per file, or fields (.csv) over one mesh.
class Series {
 public:
  /// Throws CLI::ValidationError if the files need a mesh, or contain meshes and another one is
  /// given; Error as `series_files` does.
  Series(const SeriesOptions& options, SurfaceOptions surface, WaveOptions waves,
         SeriesFields smooth_fields, std::optional<Viewpoint> viewpoint);

  std::size_t step_count() const { return files_.size(); }
  const std::vector<TimedFile>& files() const { return files_; }

  /// The next step, with the frequency of the first mesh's diagonal and positions relative to its
  /// origin. Throws Error with the file as `prepare` does, and for coordinates that are not finite.
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
  std::optional<KeptField> last_;  ///< if the next field starts from it
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
};

/// The frame between two steps of the same triangles at `share` of the way: linear interpolation of
/// positions, directions (as lines) and frequencies. If one step has no wave, the nearer step
/// decides.
SceneFrame between(const SceneFrame& a, const SceneFrame& b, float share);

}  // namespace brindle::tool
