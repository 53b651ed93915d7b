#include "session/live_pattern.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <filesystem>
#include <limits>
#include <span>
#include <utility>

#include "brindle/base/elementary.h"
#include "brindle/base/stopwatch.h"
#include "brindle/base/text.h"
#include "brindle/carried_phases.h"
#include "brindle/error.h"
#include "brindle/pattern_of.h"
#include "brindle/phase_graph.h"
#include "brindle/recipe/report.h"
#include "brindle/stripe_animator.h"
#include "input/vertex_values.h"
#include "jobs/curves_report.h"
#include "pictures/picture.h"
#include "session/stage_keys.h"
#include "session/tile_follower.h"

namespace brindle::tool {
namespace {

/// Passes progress on and collects notes.
class NoteKeeper : public JobListener {
 public:
  explicit NoteKeeper(const Progress& progress) : progress_(progress) {}

  void note(const std::string& text) override {
    std::size_t begin = 0;
    while (begin < text.size()) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      if (end > begin) notes_.push_back(text.substr(begin, end - begin));
      begin = end + 1;
    }
  }

  std::vector<std::string> take() { return std::exchange(notes_, {}); }

 private:
  Progress whole_progress() override { return progress_; }

  Progress progress_;
  std::vector<std::string> notes_;
};

/// A cached result: valid as long as its key stays the same.
template <class Made>
struct Stage {
  std::string key;
  std::shared_ptr<const Made> made;
  std::vector<std::string> notes;

  bool holds(const std::string& wanted) const { return made && key == wanted; }
};

/// Key suffix of results that continue others in a way that documents cannot store.
constexpr const char* kFollowed = " followed";

/// Key suffix of curves with all metrics.
constexpr const char* kMeasured = " measured";

/// A pattern, and whether it continued another one.
struct SolvedPattern {
  StripeJob job;
  std::shared_ptr<const std::vector<float>> phases;  ///< null if it depends on the document alone
  double phase_step = 0;
  bool loosely = false;  ///< it continued a state that documents cannot store
  /// Phases of the document that it replaces.
  std::shared_ptr<const std::vector<float>> outdone = nullptr;
};

/// The score by which patterns of the same waves are compared. It depends on the phases alone, so
/// that a pattern kept once is also kept when read from a file.
struct Score {
  double energy;
  double spacing_error;
};

Score score_of(const StripeJob& job) {
  const StripePattern& pattern = job.result.stripes();
  const PhaseGraph graph =
      build_phase_graph(job.surface->neighborhood, pattern.waves, pattern.phase_shift, {});
  return {energy(graph, pattern.solution.z), pattern.quality.spacing_error_mean};
}

bool is_worse(const Score& followed, const Score& anew) {
  return followed.energy > kMostEnergyTimes * anew.energy + kMostEnergyMore ||
         followed.spacing_error > anew.spacing_error + kMostSpacingErrorMore;
}

std::string outdone_note(const Score& followed, const Score& anew) {
  return formatted(
      "solved again: phases that had followed fell behind, with energy %.3g instead of %.3g and a "
      "mean spacing error of %.1f instead of %.1f %%",
      followed.energy, anew.energy, 100 * followed.spacing_error, 100 * anew.spacing_error);
}

bool same_angles(const std::shared_ptr<const std::vector<float>>& a,
                 const std::shared_ptr<const std::vector<float>>& b) {
  return a == b || (a && b && *a == *b);
}

std::vector<float> angles_of(std::span<const Complex> z) {
  std::vector<float> angles(z.size());
  for (std::size_t v = 0; v < z.size(); ++v) angles[v] = elementary::arg(z[v]);
  return angles;
}

std::vector<Complex> phases_of(std::span<const float> angles) {
  std::vector<Complex> z(angles.size());
  for (std::size_t v = 0; v < z.size(); ++v) z[v] = elementary::polar(1.0f, angles[v]);
  return z;
}

/// The stripes that this pattern may continue.
const StripePattern* followed(const StripeArguments& arguments, const SolvedPattern* last,
                              Follow follow) {
  const bool can = follow == Follow::loosely ? can_follow_loosely(arguments)
                                             : follow == Follow::last && can_follow(arguments);
  if (last == nullptr || last->job.result.texture() != nullptr || !can) return nullptr;
  return last->job.surface->mesh.triangles.empty() ? nullptr : &last->job.result.stripes();
}

InputData data_of(const Preparation& prepared, const PreparedWaves& waves) {
  return {prepared.arrays, prepared.original_ids, prepared.partners, waves.turn_deg, waves.support};
}

PreparationMetrics metrics_of(const Preparation& prepared, const PreparedWaves& waves) {
  PreparationMetrics metrics = prepared;
  static_cast<FieldMetrics&>(metrics) = waves;
  return metrics;
}

/// A job with known phases and, for frames with a spacing tolerance, their frequencies.
SolvedPattern pattern_of_angles(const StripeArguments& arguments,
                                const std::shared_ptr<const Preparation>& prepared,
                                const PreparedWaves& waves,
                                std::shared_ptr<const std::vector<float>> angles,
                                const FrameResult& frame = {}, double energy = 0) {
  Stopwatch watch;
  StripePattern pattern =
      pattern_of_frame(frame, waves.waves, energy, arguments.solving.stripes.phase_shift);
  pattern.solution.z = phases_of(*angles);
  measure_pattern(prepared->surface, {}, pattern);
  pattern.milliseconds.pattern = watch.lap();
  const std::shared_ptr<const Surface> surface(prepared, &prepared->surface);
  Report report = make_report(*surface, metrics_of(*prepared, waves), pattern,
                              arguments.solving.stripes.solver.solver);
  return {{surface, {std::move(pattern)}, std::move(report), data_of(*prepared, waves)},
          std::move(angles),
          0};
}

SolvedPattern given_pattern(const StripeArguments& arguments,
                            const std::shared_ptr<const Preparation>& prepared,
                            const PreparedWaves& waves,
                            std::shared_ptr<const std::vector<float>> angles) {
  const std::size_t vertices = prepared->surface.mesh.vertex_count();
  if (prepared->points || angles->size() != vertices) {
    throw Error("phases: there are " + std::to_string(angles->size()) + " of another surface; " +
                shown(arguments.surface.mesh) + " has " + std::to_string(vertices) +
                (prepared->points ? " points" : " vertices") +
                ": leave 'phases' out of the session");
  }
  SolvedPattern solved = pattern_of_angles(arguments, prepared, waves, std::move(angles));
  const PhaseGraph graph = build_phase_graph(prepared->surface.neighborhood, waves.waves,
                                             arguments.solving.stripes.phase_shift, {});
  solved.job.report.energy = energy(graph, solved.job.result.stripes().solution.z);
  return solved;
}

/// Frames on one surface, each continuing the last.
struct Follower {
  std::string
      key;  ///< of the surface and the solver options, without the value of the spacing tolerance
  std::string options;  ///< with the spacing tolerance
  StripeAnimator animator;
};

AnimatorOptions animator_options(const StripeArguments& arguments, const Preparation& prepared) {
  AnimatorOptions options = frame_options(arguments.solving.stripes);
  options.slack = stripe_options(arguments.solving, prepared).slack;
  return options;
}

/// The tolerance may change while an animator runs, but not whether there is one.
std::string follower_key(const SessionDocument& document, const SolvingOptions& solving) {
  SessionDocument without = document;
  without.options.erase("slack");
  return options_key(without, OptionStage::phases) + (solving.slack.slack > 0 ? "slack" : "");
}

double no_less(double value) { return std::max(value, 0.0); }

using StageTimes = std::vector<std::pair<std::string, double>>;

void add_times(const Report& report, StageTimes& times) {
  const StripeMilliseconds& ms = report.milliseconds;
  if (ms.frequency > 0) times.emplace_back("spacing", ms.frequency);
  times.emplace_back("couple", no_less(ms.couple));
  times.emplace_back("solve", no_less(ms.solve));
  times.emplace_back("measure", no_less(ms.pattern));
}

/// Winding numbers of the surface's loops; NaN if undefined.
void add_windings(const CurveFamily& family, std::vector<std::pair<std::string, double>>& metrics) {
  const FabricationMetrics& fabrication = family.fabrication;
  for (std::size_t i = 0; i < std::min(kMostWindings, fabrication.loops.size()); ++i) {
    const Winding& winding = fabrication.windings[i];
    metrics.emplace_back("winding " + fabrication.loops[i].name + " (" + family.name + ")",
                         winding ? *winding : std::numeric_limits<double>::quiet_NaN());
  }
}

void add_curve_metrics(const CurveFamily& family,
                       std::vector<std::pair<std::string, double>>& metrics) {
  for (const CurveMetric& metric : metrics_of(family)) {
    const auto value = metric.value.get<double>();
    const bool seen = !metric.words.empty() && !(metric.if_any && value == 0);
    if (seen) metrics.emplace_back(metric.words, metric.scale * value);
  }
  add_windings(family, metrics);
}

void add_shown_metrics(LiveState& state) {
  auto& metrics = state.metrics.shown;
  if (state.curves) {
    for (const CurveFamily& family : state.curves->families) add_curve_metrics(family, metrics);
  }
  if (!state.samples) return;
  metrics.emplace_back("samples", state.samples->taken.samples.size());
  metrics.emplace_back("too near to others", state.samples->taken.doubles);
}

/// The stages of a style besides the pattern.
struct StyleStages {
  Stage<std::vector<Preparation>> read;    ///< other surfaces
  Stage<std::vector<OtherSurface>> drawn;  ///< the same with their patterns
  Stage<StyleValues> values;
  Stage<StripePattern> crossing;
  std::shared_ptr<const StyleJob> job;
};

/// The stages of curves or samples, shown instead of stripes.
struct ShownStages {
  Stage<StripeTracer> tracer;
  Stage<MadeStripes> second;  ///< V
  Stage<ShownCurves> curves;
  Stage<ShownSamples> samples;
};

/// Textures or crosses, each frame continuing the last.
struct Tiles {
  std::string key;  ///< as that of a Follower, with the kind of tiles
  std::shared_ptr<TileFollower> made;
};

std::string tiles_key(const StripeArguments& arguments) {
  return arguments.waves.cross ? "cross" : arguments.waves.oriented ? "oriented" : "texture";
}

struct LiveStages {
  Stage<Preparation> surface;
  Stage<BaseField> field;
  Stage<PreparedWaves> waves;
  Stage<SolvedPattern> pattern;
  std::shared_ptr<const SolvedPattern> compared;  ///< the last one that passed the comparison
  StyleStages style;
  ShownStages shown;
  std::string looks;  ///< all options of the style
  std::shared_ptr<Follower> follower, crossing_follower;
  Tiles tiles;
  std::uint64_t patterns = 0;  ///< number of computed patterns
  std::uint64_t changes = 0;   ///< number of changes of what is drawn
};

/// Updates the stages for a document.
class StageUpdate {
 public:
  StageUpdate(LiveStages& stages, const SessionDocument& document, Follow follow,
              CurveMetrics metrics, const Progress& progress)
      : stages_(stages),
        document_(document),
        follow_(follow),
        // Drafts follow the mouse.
        metrics_(follow == Follow::loosely ? CurveMetrics::few : metrics),
        progress_(progress),
        listener_(progress),
        parsed_(std::make_shared<const ParsedSession>(document)) {}

  std::shared_ptr<const LiveState> run() {
    check_document(document_, *parsed_);
    make_surface();
    make_field();
    make_waves();
    make_pattern();
    make_style();
    make_shown();
    listener_.stage("ready");
    return state();
  }

 private:
  const StripeArguments& arguments() const { return parsed_->arguments(); }

  // Here, only the file itself can cause a failure.
  static auto read_mesh(const auto& read) {
    try {
      return read();
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& error) {
      throw UnreadMesh(error.what());
    }
  }

  /// Makes a stage's result unless it is valid. Returns whether it did.
  template <class Made, class Make>
  bool renew(Stage<Made>& stage, const std::string& key, const Make& make) {
    if (stage.holds(key)) return false;
    auto made = std::make_shared<const Made>(make());
    stage = {key, std::move(made), listener_.take()};
    return true;
  }

  void make_surface() {
    Stage<Preparation>& stage = stages_.surface;
    const std::string key = surface_key(document_);
    if (stage.holds(key)) return;
    const SurfaceOptions& surface = arguments().surface;
    read_mesh([&] { return is_points(surface); });
    check_session_points(*parsed_);
    auto made = std::make_shared<Preparation>(
        surface.subdivide > 0 || surface.neighbors
            ? prepare_surface(surface, listener_)
            : read_mesh([&] { return prepare_surface(surface, listener_); }));
    times_.emplace_back("load", made->load_milliseconds);
    times_.emplace_back("neighbourhood", made->topology_milliseconds);
    LiveStages anew;
    anew.surface = {key, std::move(made), listener_.take()};
    anew.patterns = stages_.patterns;
    anew.changes = stages_.changes;
    stages_ = std::move(anew);
  }

  void make_field() {
    Stopwatch watch;
    const bool made = renew(stages_.field, stages_.surface.key + field_key(document_), [&] {
      return prepare_field(*stages_.surface.made, arguments().surface, arguments().waves, listener_,
                           last_directions());
    });
    if (!made) return;
    field_milliseconds_ = watch.lap();
    times_.emplace_back("field", field_milliseconds_);
  }

  // The field that a smooth field starts from.
  LastDirections last_directions() {
    const FindLastDirections find_last = previous_directions(arguments());
    if (!find_last || !is_smooth(arguments().waves)) return {};
    Preparation surface = *stages_.surface.made;
    LastDirections last = find_last(surface);
    listener_.note(last.notes);
    return last;
  }

  void make_waves() {
    renew(stages_.waves, stages_.field.key + waves_key(document_), [&] {
      listener_.stage("waves");
      PreparedWaves made =
          prepare_waves(*stages_.surface.made, arguments().surface, arguments().waves,
                        *stages_.field.made, listener_, viewpoint_of(arguments().picture));
      times_.emplace_back("waves", made.field_milliseconds);
      made.field_milliseconds += field_milliseconds_;
      return made;
    });
  }

  bool has_pattern(const std::string& key) const {
    const Stage<SolvedPattern>& stage = stages_.pattern;
    if (!stage.holds(key)) return false;
    const SolvedPattern& made = *stage.made;
    if (made.loosely) return follow_ == Follow::loosely;
    if (document_.phases) {
      return same_angles(made.phases, document_.phases) ||
             same_angles(made.outdone, document_.phases);
    }
    return !made.phases || follow_ != Follow::afresh;
  }

  void make_pattern() {
    Stage<SolvedPattern>& stage = stages_.pattern;
    if (!has_pattern(key_of_pattern())) take_pattern(solved());
    if (!is_to_be_compared()) return;
    Stopwatch watch;
    SolvedPattern anew = made_afresh();
    const Score followed = score_of(stage.made->job), alone = score_of(anew.job);
    times_.emplace_back("compare", watch.lap());
    if (!is_worse(followed, alone)) {
      stages_.compared = stage.made;
      return;
    }
    anew.outdone = document_.phases;
    listener_.note(outdone_note(followed, alone));
    take_pattern(std::move(anew));
  }

  // Drafts continue whatever the quality; the document's pattern must be good.
  bool is_to_be_compared() const {
    const std::shared_ptr<const SolvedPattern>& made = stages_.pattern.made;
    const bool rests = follow_ != Follow::loosely || document_.phases;
    return rests && made->phases && !made->loosely && stages_.compared != made;
  }

  void take_pattern(SolvedPattern pattern) {
    auto made = std::make_shared<SolvedPattern>(std::move(pattern));
    const Report& report = made->job.report;
    add_times(report, times_);
    listener_.note(quality_warning(report.waves, report.quality, report.triangles));
    listener_.note(warning_of_tiles(made->job.result.texture(), made->job.surface->mesh));
    stages_.pattern = {key_of_pattern(), std::move(made), listener_.take()};
    ++stages_.patterns;
    ++stages_.changes;
  }

  std::string key_of_pattern() const {
    return stages_.waves.key + options_key(document_, OptionStage::phases);
  }

  SolvedPattern solved() {
    if (document_.phases) {
      return given_pattern(arguments(), stages_.surface.made, *stages_.waves.made,
                           document_.phases);
    }
    const StripePattern* last = followed(arguments(), stages_.pattern.made.get(), follow_);
    if (last != nullptr) return next_frame(*last);
    if (follow_ == Follow::loosely && can_follow_tiles(arguments())) return next_tiles();
    // The next draft continues this result.
    if (stages_.tiles.made) stages_.tiles.made->restart();
    return made_afresh();
  }

  SolvedPattern made_afresh() {
    Preparation prepared = *stages_.surface.made;
    take_waves(*stages_.waves.made, prepared);
    return {make_stripe_job(arguments(), std::move(prepared),
                            chosen_tile(arguments().texture, arguments().waves.cross), progress_),
            nullptr, 0};
  }

  StripeAnimator& animator(std::shared_ptr<Follower>& follower) {
    const Preparation& prepared = *stages_.surface.made;
    const std::string key = stages_.surface.key + follower_key(document_, arguments().solving);
    const std::string options = options_key(document_, OptionStage::phases);
    if (!follower || follower->key != key) {
      follower = std::make_shared<Follower>(Follower{
          key, options, StripeAnimator(prepared.surface, animator_options(arguments(), prepared))});
    } else if (follower->options != options) {
      follower->animator.set_slack(animator_options(arguments(), prepared).slack);
      follower->options = options;
    }
    return follower->animator;
  }

  // The crossing pattern, continued from the last draft.
  StripePattern next_crossing(const StripePattern& last, WaveSet waves) {
    StripeAnimator& frames = animator(stages_.crossing_follower);
    frames.set_last_phases(
        matched_phases({stages_.surface.made->surface.mesh, last.waves, last.solution.z}, waves));
    const FrameResult frame =
        frames.frame({waves.positions, waves.directions, waves.frequencies}, progress_);
    return pattern_of_frame(frame, std::move(waves), frames.energy(),
                            arguments().solving.stripes.phase_shift);
  }

  // Whether the crossing pattern may continue these stripes.
  template <class Made>
  bool can_go_on(const Stage<Made>& crossing) const {
    return follow_ == Follow::loosely && crossing.made && can_follow(arguments()) &&
           !stages_.surface.made->points;
  }

  // In drafts, continued results are good enough.
  template <class Made>
  bool holds_crossing(const Stage<Made>& crossing, const std::string& key) const {
    return crossing.holds(key) || (follow_ == Follow::loosely && crossing.holds(key + kFollowed));
  }

  // Drafts only: no document could store their phases. The first one is solved from scratch.
  SolvedPattern next_tiles() {
    const std::string key =
        stages_.surface.key + options_key(document_, OptionStage::phases) + tiles_key(arguments());
    if (stages_.tiles.key != key) {
      stages_.tiles = {key, std::make_shared<TileFollower>(arguments(), stages_.surface.made)};
    }
    const PreparedWaves& waves = *stages_.waves.made;
    SolvedPattern solved;
    solved.job = stages_.tiles.made->next(arguments(), waves,
                                          metrics_of(*stages_.surface.made, waves), progress_);
    solved.phase_step = stages_.tiles.made->phase_step();
    solved.loosely = true;
    return solved;
  }

  SolvedPattern next_frame(const StripePattern& last) {
    const WaveSet& waves = stages_.waves.made->waves;
    StripeAnimator& frames = animator(stages_.follower);
    frames.set_last_phases(
        matched_phases({stages_.surface.made->surface.mesh, last.waves, last.solution.z}, waves));
    const FrameResult frame =
        frames.frame({waves.positions, waves.directions, waves.frequencies}, progress_);
    SolvedPattern solved = pattern_of_angles(
        arguments(), stages_.surface.made, *stages_.waves.made,
        std::make_shared<const std::vector<float>>(angles_of(frame.z)), frame, frames.energy());
    solved.loosely = !frame.frequencies.empty();
    solved.phase_step = frame.phase_step;
    return solved;
  }

  void make_style() {
    const std::string looks =
        std::string(name_of(document_.shown)) + '\n' + options_key(document_, OptionStage::style);
    if (stages_.looks != looks) ++stages_.changes;
    stages_.looks = looks;
    if (document_.shown != Shown::stripes || !is_styled(parsed_->command())) {
      stages_.style = {};
      return;
    }
    StyleStages& style = stages_.style;
    Stopwatch watch;
    const bool others = make_others();
    const bool values = make_values();
    const bool crossing = make_crossing_strokes();
    if (!others && !values && !crossing) return;
    style.job = std::make_shared<const StyleJob>(
        StyleJob{{*style.values.made, {}}, {style.crossing.made, style.drawn.made}});
    times_.emplace_back("style", watch.lap());
    ++stages_.changes;
  }

  // Returns whether the other surfaces changed, as must all that depends on them.
  bool make_others() {
    StyleStages& style = stages_.style;
    const std::string key = stages_.surface.key + others_key(arguments().style, stages_.waves.key);
    const std::string solving = key + options_key(document_, OptionStage::phases);
    renew(style.read, key, [&] {
      return read_style_others(arguments().style, stages_.surface.made->surface.mesh,
                               stages_.waves.made->waves, arguments().waves, arguments().picture,
                               listener_);
    });
    return renew(style.drawn, solving, [&] {
      StripeOptions options = arguments().solving.stripes;
      options.last_phases.clear();
      return solve_others(arguments().style, *style.read.made, options, progress_);
    });
  }

  bool make_values() {
    StyleStages& style = stages_.style;
    const std::string key = stages_.surface.key +
                            values_key(document_, arguments().style, style.read.key) +
                            (arguments().style.follows_field() ? stages_.waves.key : "");
    return renew(style.values, key, [&] {
      return read_style_values(arguments().style, *stages_.surface.made, *style.read.made,
                               arguments().surface, arguments().waves, arguments().picture,
                               stages_.waves.made->support.coherence);
    });
  }

  bool make_crossing_strokes() {
    Stage<StripePattern>& crossing = stages_.style.crossing;
    if (!arguments().style.cross_hatch) {
      const bool was_there = crossing.made != nullptr;
      crossing = {"", nullptr, {}};
      return was_there;
    }
    const std::string key = std::to_string(stages_.patterns);
    if (holds_crossing(crossing, key)) return false;
    const StripeJob& job = stages_.pattern.made->job;
    if (can_go_on(crossing)) {
      WaveSet waves = waves_across(job.result.stripes().waves, job.surface->normals);
      crossing = {
          key + kFollowed,
          std::make_shared<const StripePattern>(next_crossing(*crossing.made, std::move(waves))),
          {}};
      return true;
    }
    crossing = {key,
                make_crossing(*job.surface, job.result, arguments().style,
                              arguments().solving.stripes, progress_),
                listener_.take()};
    return true;
  }

  void make_shown() {
    ShownStages& shown = stages_.shown;
    const bool curves = parsed_->curves() != nullptr, samples = parsed_->samples() != nullptr;
    if (!curves) shown.curves = {};
    if (!samples) shown.samples = {};
    const bool crossed = samples || (curves && parsed_->curves()->traced != TracedWaves::u);
    if (!crossed) shown.second = {};
    if (document_.shown == Shown::stripes) return;
    Stopwatch watch;
    const bool changed = document_.shown == Shown::curves ? make_curves() : make_samples();
    if (!changed) return;
    times_.emplace_back(name_of(document_.shown), watch.lap());
    ++stages_.changes;
  }

  FirstWaves first_waves() const {
    const Preparation& prepared = *stages_.surface.made;
    const PreparedWaves& waves = *stages_.waves.made;
    return {prepared.surface, waves.waves, waves.frequencies_v, prepared.vertex_of_row,
            waves.metrics.subdivided};
  }

  const SecondWaveOptions& second_options() const {
    return parsed_->samples() != nullptr ? parsed_->samples()->second : parsed_->curves()->second;
  }

  MadeStripes second_pattern(WaveSet waves) {
    const Preparation& prepared = *stages_.surface.made;
    const StripeOptions options = stripe_options(arguments().solving, prepared);
    if (parsed_->samples() != nullptr) {
      return {stripe_pattern(prepared.surface, std::move(waves), options, progress_)};
    }
    PatternResult made = pattern_of(
        prepared.surface, std::move(waves),
        {PatternKind::stripes, options, fabrication_of_v(*parsed_->curves())}, progress_);
    return {std::get<StripePattern>(std::move(made.of)), std::move(made.fabrication)};
  }

  const MadeStripes& second() {
    Stage<MadeStripes>& stage = stages_.shown.second;
    const std::string key = std::string(name_of(document_.shown)) + stages_.waves.key +
                            options_key(document_, OptionStage::phases) +
                            options_key(document_, OptionStage::second);
    if (holds_crossing(stage, key)) return *stage.made;
    const bool goes_on = can_go_on(stage) && second_options().wales.periods == 0;
    WaveSet waves = make_second_waves(first_waves(), second_options(), listener_);
    auto made = std::make_shared<const MadeStripes>(
        goes_on ? MadeStripes{next_crossing(stage.made->pattern, std::move(waves))}
                : second_pattern(std::move(waves)));
    stage = {goes_on ? key + kFollowed : key, std::move(made), listener_.take()};
    return *stage.made;
  }

  const StripeTracer& tracer() {
    Stage<StripeTracer>& stage = stages_.shown.tracer;
    if (!stage.holds(stages_.surface.key)) {
      struct Held {
        std::shared_ptr<const Preparation> prepared;
        StripeTracer tracer{prepared->surface};
      };
      const auto held = std::make_shared<const Held>(Held{stages_.surface.made});
      stage = {stages_.surface.key, {held, &held->tracer}, {}};
    }
    return *stage.made;
  }

  // The key of curves and samples, once V is known.
  std::string shown_key() const {
    return std::to_string(stages_.patterns) + '\n' + stages_.shown.second.key +
           ornaments_key(document_);
  }

  bool make_curves() {
    Stage<ShownCurves>& stage = stages_.shown.curves;
    const CurvesArguments& curves = *parsed_->curves();
    const MadeStripes* v = curves.traced == TracedWaves::u ? nullptr : &second();
    const std::string key = shown_key(), measured = key + kMeasured;
    // Fully measured results are good for drafts, too.
    if (stage.holds(measured) || (metrics_ == CurveMetrics::few && stage.holds(key))) return false;
    const StripeJob& job = stages_.pattern.made->job;
    return renew(stage, metrics_ == CurveMetrics::few ? key : measured, [&] {
      ShownCurves made = shown_curves(curves, job, v, tracer(), metrics_, listener_);
      for (const CurveFamily& family : made.families) {
        listener_.note(remarks_of(family.fabrication));
      }
      return made;
    });
  }

  bool make_samples() {
    const StripePattern& v = second().pattern;
    return renew(stages_.shown.samples, shown_key(), [&] {
      return shown_samples(parsed_->command(), *parsed_->samples(), stages_.surface.made,
                           stages_.pattern.made->job, v, listener_);
    });
  }

  std::shared_ptr<const LiveState> state() {
    const std::shared_ptr<const SolvedPattern>& pattern = stages_.pattern.made;
    LiveState result;
    result.document = document_;
    result.parsed = parsed_;
    result.job = {pattern, &pattern->job};
    result.style = stages_.style.job;
    result.others = stages_.style.read.made;
    result.curves = stages_.shown.curves.made;
    if (result.curves) {
      result.prepared = std::make_shared<const PreparationMetrics>(
          metrics_of(*stages_.surface.made, *stages_.waves.made));
    }
    result.samples = stages_.shown.samples.made;
    result.phases = pattern->phases;
    result.metrics.phase_step = pattern->phase_step;
    add_shown_metrics(result);
    result.metrics.milliseconds = std::move(times_);
    const StyleStages& style = stages_.style;
    for (const std::vector<std::string>* notes :
         std::initializer_list<const std::vector<std::string>*>{
             &stages_.surface.notes, &stages_.field.notes, &stages_.waves.notes,
             &stages_.pattern.notes, &style.read.notes, &style.drawn.notes, &style.values.notes,
             &style.crossing.notes, &stages_.shown.second.notes, &stages_.shown.curves.notes,
             &stages_.shown.samples.notes}) {
      result.notes.insert(result.notes.end(), notes->begin(), notes->end());
    }
    result.pattern = stages_.changes;
    return std::make_shared<const LiveState>(std::move(result));
  }

  LiveStages& stages_;
  const SessionDocument& document_;
  const Follow follow_;
  const CurveMetrics metrics_;
  const Progress& progress_;
  NoteKeeper listener_;
  std::shared_ptr<const ParsedSession> parsed_;
  StageTimes times_;
  double field_milliseconds_ = 0;
};

}  // namespace

const ShownOrnaments* ornaments_of(const LiveState& state) {
  if (state.curves) return &state.curves->drawn;
  return state.samples ? &state.samples->drawn : nullptr;
}

struct LivePattern::Stages : LiveStages {};

LivePattern::LivePattern(CurveMetrics metrics)
    : metrics_(metrics), stages_(std::make_unique<Stages>()) {}
LivePattern::~LivePattern() = default;

void LivePattern::update(const SessionDocument& document, Follow follow, const Progress& progress) {
  Stages next = *stages_;
  std::shared_ptr<const LiveState> state =
      StageUpdate(next, document, follow, metrics_, progress).run();
  *stages_ = std::move(next);
  state_ = std::move(state);
}

}  // namespace brindle::tool
