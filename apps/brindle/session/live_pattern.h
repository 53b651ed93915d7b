/// The pattern of a document that is being edited.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "brindle/error.h"
#include "brindle/progress.h"
#include "jobs/stripe_job.h"
#include "session/session_options.h"
#include "session/shown_pattern.h"

namespace brindle::tool {

/// The start of a pattern.
enum class Follow {
  afresh,  ///< from scratch: depends on the document alone
  last,    ///< from the last pattern on the same surface, unless that is worse
  loosely  ///< for drafts: from the last pattern in any case, even if no document can store it
};

/// The limits on how much worse a continued or stored pattern may be than one computed from
/// scratch: a factor and a difference of the energy (both, because the other's may be nearly zero),
/// and a difference of the mean spacing error as a share of the period. Beyond these limits, the
/// pattern from scratch replaces it.
inline constexpr double kMostEnergyTimes = 1.5, kMostEnergyMore = 0.01;
inline constexpr double kMostSpacingErrorMore = 0.03;

/// A document's mesh cannot be read, independently of its options.
class UnreadMesh : public Error {
 public:
  using Error::Error;
};

/// Numbers that the pattern's report lacks.
struct LiveMetrics {
  std::vector<std::pair<std::string, double>> milliseconds;  ///< of executed stages, in order
  /// Of curves or samples; NaN for undefined winding numbers.
  std::vector<std::pair<std::string, double>> shown;
  double phase_step = 0;  ///< mean change of phases in radians, for continued patterns
};

/// A document's pattern and everything drawn with it. The pointed-to objects are shared and
/// immutable.
struct LiveState {
  SessionDocument document;
  std::shared_ptr<const ParsedSession> parsed;
  std::shared_ptr<const StripeJob> job;   ///< surface, pattern or texture, report, data
  std::shared_ptr<const StyleJob> style;  ///< null if the picture has no style
  /// Other surfaces as read, with their arrays; null without a style.
  std::shared_ptr<const std::vector<Preparation>> others;
  std::shared_ptr<const PreparationMetrics> prepared;  ///< null if no curves are shown
  std::shared_ptr<const ShownCurves> curves;           ///< null if they are not shown
  std::shared_ptr<const ShownSamples> samples;         ///< null if they are not shown
  std::shared_ptr<const std::vector<float>> phases;    ///< angles of a continued pattern
  LiveMetrics metrics;
  std::vector<std::string> notes;  ///< lines for the user: repairs, warnings
  std::uint64_t pattern = 0;  ///< changes whenever anything drawn except for the camera changes

  const Report& report() const { return job->report; }
};

/// The ornaments drawn instead of stripes; null for stripes.
const ShownOrnaments* ornaments_of(const LiveState& state);

/// Caches the stages whose inputs did not change.
class LivePattern {
 public:
  /// `metrics`: the extent of curve measurements, except for drafts.
  explicit LivePattern(CurveMetrics metrics = CurveMetrics::few);
  ~LivePattern();

  /// Updates the state for the document. Throws CLI::ValidationError or Error as `brindle stripe`
  /// does, including UnreadMesh, and Cancelled; the state then stays unchanged.
  void update(const SessionDocument& document, Follow follow, const Progress& progress = {});

  /// Null before the first update.
  std::shared_ptr<const LiveState> state() const { return state_; }

 private:
  struct Stages;
  CurveMetrics metrics_;
  std::unique_ptr<Stages> stages_;
  std::shared_ptr<const LiveState> state_;
};

}  // namespace brindle::tool
