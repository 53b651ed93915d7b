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

/// Thrown out of a job whose progress callback asked it to stop.
class Cancelled : public Error {
 public:
  using Error::Error;
};

/// A stage of a job.
struct JobStage {
  std::string name;
  double weight = 1;  ///< how long it takes, against the others'; above 0
};

/// A report of a running job.
struct ProgressReport {
  double fraction = 0;               ///< done of the whole job, in [0, 1]; never falls
  std::string_view step;             ///< what is being done: a stage, or a step within one
  double step_fraction = 0;          ///< done of that, in [0, 1]
  std::span<const JobStage> stages;  ///< of the whole job, in their order; weights sum to 1
  std::size_t stage = 0;             ///< the number of the one that is under way
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

class JobStages {
 public:
  JobStages(const Progress&, const std::vector<JobStage>&) {}
  Progress begin(std::string_view) { return {}; }
  void finish() const {}
};

#else

/// Handed into long jobs; a default-constructed one is silent and never cancels. Jobs report on the
/// thread that called them. One Progress serves one job after the other, not several at once.
class Progress {
 public:
  /// Receives the step's name and how much of it is done, in [0, 1]. Returning false cancels.
  using Callback = std::function<bool(std::string_view step, double fraction)>;
  /// Receives the same with where that is in the whole job.
  using JobCallback = std::function<bool(const ProgressReport& report)>;

  Progress() = default;
  explicit Progress(Callback callback);
  explicit Progress(JobCallback callback);

  /// Reports the fraction done of a step, which is also that of the share of the job that this
  /// stands for. Throws Cancelled if the callback asks for it.
  void report(std::string_view step, double fraction) const;

  /// The same for the stage that this was handed out for.
  void report(double fraction) const;

  /// Passes on the report of an inner job, the whole of which is the share that this stands for.
  void report(const ProgressReport& inner) const;

  /// Repeats the last report. Throws Cancelled if the callback asks for it. For long loops that do
  /// not know their share of a stage.
  void tick() const;

  /// For a job that does a share of this: `begin` to `end`, in [0, 1].
  Progress part(double begin, double end) const;

  /// The same as this, with another name for what `report(fraction)` is about.
  Progress step(std::string_view name) const;

  /// The stages of the whole job, once it has begun; `ProgressReport` has the same.
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
  std::string step_;            // the stage that this was handed out for
  double from_ = 0, to_ = 1;    // in that
};

/// Divides the progress that a job was handed into stages. The outermost job's stages are those
/// that `ProgressReport` lists.
class JobStages {
 public:
  /// Throws Error if no stage is given, or one whose weight is not above 0.
  JobStages(const Progress& progress, std::vector<JobStage> stages);

  /// The next stage of that name begins; those before it are over. Reports it, which may throw
  /// Cancelled. Hand the result to the work of the stage. Throws Error for an unknown name.
  Progress begin(std::string_view name);

  /// Reports that all is done, which may throw Cancelled.
  void finish() const;

 private:
  Progress progress_;
  std::vector<JobStage> stages_;
  std::vector<double> begins_;  // of all stages, and the end of the last
  std::size_t next_ = 0;
};

#endif

}  // namespace brindle
