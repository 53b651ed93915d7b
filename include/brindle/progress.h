/// Progress reports and cancellation of long jobs.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "brindle/error.h"
#include "brindle/export.h"

namespace BRINDLE_EXPORT brindle {

/// Thrown by a job whose progress callback cancels it.
class Cancelled : public Error {
 public:
  using Error::Error;
};

/// A stage of a job.
struct JobStage {
  std::string name;
  double weight = 1;  ///< relative duration; above 0
};

/// A report of a running job.
struct ProgressReport {
  double fraction = 0;               ///< share of the whole job done, in [0, 1]; never falls
  std::string_view step;             ///< the current stage, or a step within it
  double step_fraction = 0;          ///< share of that step done, in [0, 1]
  std::span<const JobStage> stages;  ///< of the whole job, in their order; weights sum to 1
  std::size_t stage = 0;             ///< the number of the current one
};

#if defined(BRINDLE_SILENT)

/// In builds without progress (CMake's BRINDLE_PROGRESS): jobs report nothing, cannot be cancelled,
/// and are a tenth smaller.
class Progress {
 public:
  using Callback = std::function<bool(std::string_view step, double fraction)>;
  using JobCallback = std::function<bool(const ProgressReport& report)>;

  Progress() = default;
  explicit Progress(const Callback&) {}
  explicit Progress(const JobCallback&) {}
  void report(std::string_view, double) const {}
  void report(double) const {}
  void report(const ProgressReport&) const {}
  void tick() const {}
  Progress part(double, double) const { return {}; }
  Progress step(std::string_view) const { return {}; }
  std::span<const JobStage> stages() const { return {}; }
  static constexpr bool is_heard() { return false; }
};

/// Stages in builds without progress.
class JobStages {
 public:
  JobStages(const Progress&, const std::vector<JobStage>&) {}
  Progress begin(std::string_view) { return {}; }
  void finish() const {}
};

#else

/// Progress of a long job; a default-constructed one is silent and never cancels. Jobs report on
/// the thread that called them. A Progress serves one job at a time.
class Progress {
 public:
  /// Receives the step's name and the share of it done, in [0, 1]. Returning false cancels.
  using Callback = std::function<bool(std::string_view step, double fraction)>;
  /// As above, with the position in the whole job.
  using JobCallback = std::function<bool(const ProgressReport& report)>;

  Progress() = default;
  explicit Progress(Callback callback);
  explicit Progress(JobCallback callback);

  /// Reports the share done of a step, which is also the share done of this part of the job. Throws
  /// Cancelled if the callback cancels.
  void report(std::string_view step, double fraction) const;

  /// As above for the stage of this object.
  void report(double fraction) const;

  /// Forwards the report of an inner job, which is all of this part.
  void report(const ProgressReport& inner) const;

  /// Repeats the last report, for long loops without a known share of a stage. Throws Cancelled if
  /// the callback cancels.
  void tick() const;

  /// A part of this progress, from `begin` to `end`, in [0, 1].
  Progress part(double begin, double end) const;

  /// The same progress, with another name for steps of `report(fraction)`.
  Progress step(std::string_view name) const;

  /// The stages of the whole job, once it has begun, as in `ProgressReport`.
  std::span<const JobStage> stages() const;

  /// Whether there is a callback.
  bool is_heard() const { return state_ != nullptr; }

 private:
  friend class JobStages;
  struct State;

  void tell(double whole, std::string_view step, double fraction) const;

  std::shared_ptr<State> state_;
  bool is_whole_ = true;        // a job that begins with this is the whole one
  double begin_ = 0, end_ = 1;  // in the whole job
  std::string step_;            // the stage of this object
  double from_ = 0, to_ = 1;    // within that stage
};

/// Divides the progress of a job into stages. `ProgressReport` lists the stages of the outermost
/// job.
class JobStages {
 public:
  /// Throws Error without stages, and for a weight that is not above 0.
  JobStages(const Progress& progress, std::vector<JobStage> stages);

  /// Begins the next stage of that name and ends those before it. Pass the result to the work of
  /// the stage. The report may throw Cancelled. Throws Error for an unknown name.
  Progress begin(std::string_view name);

  /// Reports the end of the job, which may throw Cancelled.
  void finish() const;

 private:
  Progress progress_;
  std::vector<JobStage> stages_;
  std::vector<double> begins_;  // of all stages, and the end of the last
  std::size_t next_ = 0;
};

#endif

}  // namespace brindle
