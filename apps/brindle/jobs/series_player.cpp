#include "jobs/series_player.h"

#include <algorithm>
#include <utility>

#include "brindle/base/parallel.h"
#include "brindle/base/stopwatch.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "outputs/mesh_output.h"

namespace brindle::tool {
namespace {

SceneFrame frame_of(const Preparation& prepared, const WaveSet& waves) {
  return {prepared.surface.mesh, prepared.surface.normals, waves, {}};
}

/// A frame, and its version with a field computed from scratch.
struct FramePair {
  SceneFrame frame;
  std::optional<SceneFrame> afresh;  ///< empty: the same

  const SceneFrame& alone() const { return afresh ? *afresh : frame; }
};

FramePair pair_of(const SeriesStep& step) {
  const Preparation& prepared = step.prepared;
  FramePair pair{frame_of(prepared, prepared.waves), std::nullopt};
  if (step.waves_afresh) pair.afresh = frame_of(prepared, *step.waves_afresh);
  return pair;
}

FramePair pair_between(const FramePair& a, const FramePair& b, float share) {
  FramePair pair{between(a.frame, b.frame, share), std::nullopt};
  if (a.afresh || b.afresh) pair.afresh = between(a.alone(), b.alone(), share);
  return pair;
}

/// The origin of a frame.
struct Source {
  std::shared_ptr<const Adjacency> neighborhood;
  std::span<const DataArray> arrays;
  std::string file;  ///< empty between two steps
  double time = 0;
};

/// Plays a series and collects its report.
class Player {
 public:
  Player(const SeriesPlay& options, std::size_t steps, const ShowFrame& show,
         const ShowStep& show_step, ProgressDisplay& display)
      : options_(options),
        show_(show),
        show_step_(show_step),
        display_(display),
        frames_(frame_count(options.series, steps)),
        anchored_(options.animator, options.match) {
    if (options.compare_from_scratch) {
      AnimatorOptions without_last = options.animator;
      without_last.solver = FrameSolver::multilevel;
      without_last.lambda = 0;
      scratch_.emplace(without_last, options.match);
    }
    report_.series = {options.series.name, steps, options.series.between};
    report_.options = options.animator;
    report_.threads = ThreadLimit::current();
    report_.device = {{"kind", "cpu"}};
  }

  void add(const SeriesStep& step, double read_milliseconds) {
    const Preparation& prepared = step.prepared;
    FramePair frame = pair_of(step);
    const Source source{prepared.surface.neighborhood, prepared.arrays.points,
                        step.source.file.string(), step.source.time};
    if (report_.frames.empty()) {
      begin(prepared);
    } else if (options_.series.between > 0) {
      add_between(frame, source, step);
    }
    solve(frame, source, step, 1);
    ++steps_;
    report_.frames.back().scene_milliseconds = read_milliseconds;
    if (prepared.field_step) {
      report_.frames.back().series->field_turned_deg = prepared.field_step->mean_deg;
    }
    last_ = std::move(frame);
    last_source_ = {source.neighborhood, {}, source.file, source.time};  // releases the step
  }

  /// Progress of a part of the next frame.
  Progress begin_part(double begin, double end) {
    const auto number = static_cast<double>(report_.frames.size());
    const auto all = static_cast<double>(frames_);
    display_.narrow((number + begin) / all, (number + end) / all);
    return display_.progress().step("frames");
  }

  AnimationReport finish() {
    report_.topology_milliseconds = anchored_.topology_milliseconds();
    return std::move(report_);
  }

 private:
  void begin(const Preparation& prepared) {
    report_.vertices = prepared.surface.mesh.vertex_count();
    report_.triangles = prepared.surface.mesh.triangle_count();
    report_.edges = prepared.surface.neighborhood->edge_count();
    report_.waves = prepared.metrics;
  }

  void add_between(const FramePair& frame, const Source& source, const SeriesStep& next) {
    if (!same_connectivity(last_.frame.mesh, frame.frame.mesh)) {
      throw Error(source.file + ": has other triangles than " + last_source_.file +
                  ", so that nothing can be interpolated between both; leave out --interpolate");
    }
    const FramePair first = std::move(last_);
    for (int k = 1; k <= options_.series.between; ++k) {
      Stopwatch watch;
      const double share = static_cast<double>(k) / (options_.series.between + 1);
      const FramePair middle = pair_between(first, frame, static_cast<float>(share));
      const double milliseconds = watch.lap();
      solve(middle,
            {last_source_.neighborhood,
             {},
             "",
             (1 - share) * last_source_.time + share * source.time},
            next, static_cast<float>(share));
      report_.frames.back().scene_milliseconds = milliseconds;
    }
  }

  /// Solves a frame at `share` of the way to `step`.
  void solve(const FramePair& pair, const Source& source, const SeriesStep& step, float share) {
    const SceneFrame& frame = pair.frame;
    const Progress solving = begin_part(0.3, 0.7);
    solving.report(0);
    // The rest of the frame is for drawing and writing.
    const double number = static_cast<double>(report_.frames.size());
    FrameReport& report = report_.frames.emplace_back();
    const auto result = anchored_.frame(frame, source.neighborhood, source.arrays, source.file,
                                        solving.part(0, 0.5));
    solving.report(0.5);
    report.milliseconds = result.frame.milliseconds;
    report.unchanged = result.frame.unchanged;
    report.series = {source.file, source.time, result.matched_by, result.unmatched};
    const PhaseShiftKind kind = options_.animator.phase_shift;
    const RelaxedFrame relaxed(frame, result.frame);
    const WaveSet& waves = relaxed.frame().waves;
    const PhaseGraph graph = build_phase_graph(source.neighborhood, waves, kind);
    const MeasuredFrame measured = measure(relaxed.frame(), graph, result.frame, kind);
    report.metrics = measured.metrics;
    report.frequency = relaxed.report(measured.corners, result.frame);
    if (scratch_) {
      const SceneFrame& alone = pair.alone();
      const auto again = scratch_->frame(alone, source.neighborhood, source.arrays, source.file,
                                         solving.part(0.7, 1));
      report.from_scratch =
          measure_relaxed(RelaxedFrame(alone, again.frame), source.neighborhood, again.frame, kind);
    }
    display_.narrow((number + 0.7) / static_cast<double>(frames_),
                    (number + 1) / static_cast<double>(frames_));
    Stopwatch watch;
    const Preparation& prepared = step.prepared;
    const FrameData data{prepared.surface,       prepared.arrays, step.source.file.string(),
                         prepared.vertex_of_row, steps_,          share};
    const SolvedFrame solved{data, relaxed.frame(),  result.frame.z,
                             0,    measured.corners, relaxed.frequencies_wanted()};
    if (show_) show_(solved);
    if (show_step_ && share == 1) show_step_(step, solved);
    report.render_milliseconds = watch.lap();
  }

  const SeriesPlay& options_;
  const ShowFrame& show_;
  const ShowStep& show_step_;
  ProgressDisplay& display_;
  std::size_t frames_;
  std::size_t steps_ = 0;  ///< that have been shown
  SeriesAnimator anchored_;
  std::optional<SeriesAnimator> scratch_;
  AnimationReport report_;
  FramePair last_;
  Source last_source_;
};

bool lacks_last_wave(const KeptPattern& last, const SceneFrame& input) {
  for (std::size_t v = 0; v < last.z.size(); ++v) {
    if (last.waves.directions[v].isZero(0) && !input.waves.directions[v].isZero(0)) return true;
  }
  return false;
}

}  // namespace

SeriesAnimator::SeriesAnimator(const AnimatorOptions& options, MatchOptions match)
    : options_(options), match_(std::move(match)) {}

SeriesAnimator::Result SeriesAnimator::frame(const SceneFrame& input,
                                             std::shared_ptr<const Adjacency> neighborhood,
                                             std::span<const DataArray> arrays,
                                             const std::string& name, const Progress& progress) {
  Result result;
  const bool same = last_ && same_connectivity(last_->mesh, input.mesh);
  if (!same) {
    const Surface surface{input.mesh, std::move(neighborhood), input.normals};
    animator_.emplace(surface, options_);
  }
  if (last_) {
    result.matched_by = match_.by.value_or(same ? Matching::number : Matching::position);
    // Without remapping, an animator uses its own phases.
    if (!same || result.matched_by != Matching::number || lacks_last_wave(*last_, input)) {
      const CarriedPattern carried = carry(*last_, {name, input.mesh, input.waves, arrays}, match_);
      animator_->set_last_phases(carried.z);
      result.unmatched = carried.unmatched;
    }
  }
  const WaveSet& waves = input.waves;
  result.frame = animator_->frame({waves.positions, waves.directions, waves.frequencies}, progress);
  topology_milliseconds_ += same ? 0 : animator_->topology_milliseconds();
  last_ = KeptPattern{name,
                      input.mesh,
                      RelaxedFrame(input, result.frame).frame().waves,
                      {result.frame.z.begin(), result.frame.z.end()},
                      {arrays.begin(), arrays.end()}};
  return result;
}

AnimationReport play(Series& series, const SeriesPlay& options, const ShowFrame& show,
                     const ShowStep& show_step, ProgressDisplay& display) {
  Player player(options, series.step_count(), show, show_step, display);
  display.plan({{"frames", 1}});
  display.stage("frames");
  for (std::size_t step = 0; step < series.step_count(); ++step) {
    Stopwatch watch;
    player.begin_part(0, 0.3).report(0);
    const SeriesStep read = series.read(display);
    player.add(read, watch.lap());
  }
  return player.finish();
}

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
