/// The pattern of a document that changes.
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

/// How a pattern comes about.
enum class Follow {
  afresh,  ///< of the document alone
  last,    ///< near to the last pattern where the surface is the same, unless that is outdone
  loosely  ///< near to it whatever it is like, also where no document could keep it: for drafts
};

/// How far a pattern that followed others, or whose phases a document has, may fall behind one that
/// is made of the document alone: its energy may be so many times the other's and so much more
/// (both, because the other's may be nearly zero), and its mean spacing error, a share of the
/// period, so much more. Where it is worse than that it is outdone, and the other takes its place.
inline constexpr double kMostEnergyTimes = 1.5, kMostEnergyMore = 0.01;
inline constexpr double kMostSpacingErrorMore = 0.03;

/// A document's mesh cannot be read, whatever its options are.
class UnreadMesh : public Error {
 public:
  using Error::Error;
};

/// What there is to say of a pattern.
struct LiveFigures {
  std::vector<std::pair<std::string, double>> milliseconds;  ///< of stages that were run, in order
  std::size_t vertices = 0, triangles = 0;
  std::size_t branches = 0;       ///< as reports count them: those at singularities, too
  std::size_t singularities = 0;  ///< of the field
  double energy = 0;
  double mean_angle_error_deg = 0, mean_spacing_error = 0;
  double edges_per_period = 0;  ///< at half of the vertices, or fewer; 0: no edge along any wave
  /// Of curves or samples; not a number: a winding that there is none of.
  std::vector<std::pair<std::string, double>> shown;
  double phase_step = 0;  ///< how far phases moved on average, in radians, where they followed
  bool followed = false;
};

/// A document's pattern and all that is drawn with it. What it points to is shared and never
/// changes.
struct LiveState {
  SessionDocument document;
  std::shared_ptr<const ParsedSession> parsed;
  std::shared_ptr<const StripeJob> job;   ///< surface, pattern or texture, report, data
  std::shared_ptr<const StyleJob> style;  ///< null if the picture has no style
  /// Other surfaces as they were read, with their arrays; null if the picture has no style.
  std::shared_ptr<const std::vector<Preparation>> others;
  std::shared_ptr<const PreparationFigures> prepared;  ///< null if no curves are shown
  std::shared_ptr<const ShownCurves> curves;           ///< null if they are not shown
  std::shared_ptr<const ShownSamples> samples;         ///< null if they are not shown
  std::shared_ptr<const std::vector<float>> phases;    ///< angles, of a pattern that has followed
  LiveFigures figures;
  std::vector<std::string> notes;  ///< lines for the user: repairs, warnings
  std::uint64_t pattern = 0;  ///< another number whenever what is drawn changes, but the camera
};

/// What is drawn instead of stripes; null for stripes.
const ShownOrnaments* ornaments_of(const LiveState& state);

/// Keeps the stages whose inputs did not change.
class LivePattern {
 public:
  /// How much is measured of curves that are shown, unless patterns follow loosely.
  explicit LivePattern(CurveFigures figures = CurveFigures::few);
  ~LivePattern();

  /// Brings the state to the document. Throws CLI::ValidationError or Error as `brindle stripe`
  /// does, UnreadMesh among them, and Cancelled if `progress` asks for it, at any report; the state
  /// then is as it was.
  void update(const SessionDocument& document, Follow follow, const Progress& progress = {});

  /// Null before the first update.
  std::shared_ptr<const LiveState> state() const { return state_; }

 private:
  struct Stages;
  CurveFigures figures_;
  std::unique_ptr<Stages> stages_;
  std::shared_ptr<const LiveState> state_;
};

}  // namespace brindle::tool
