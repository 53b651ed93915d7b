#include "jobs/animation.h"

#include <algorithm>
#include <numbers>
#include <ostream>
#include <string>
#include <utility>

#include "brindle/base/parallel.h"
#include "brindle/base/stopwatch.h"
#include "brindle/base/text.h"
#include "brindle/direction_field.h"
#include "brindle/phase_graph.h"
#include "brindle/recipe/report.h"
#include "input/preparation.h"

namespace brindle::tool {
namespace {

constexpr int kPrintedRows = 12;

FrameInput input_of(const WaveSet& waves) {
  return {waves.positions, waves.directions, waves.frequencies};
}

double total(const FrameMilliseconds& time) {
  return time.frequency + time.couple + time.sum + time.solve;
}

/// The mean over the frames after the first.
template <class Value>
double mean(const std::vector<FrameReport>& frames, Value value) {
  if (frames.size() < 2) return 0;
  double sum = 0;
  for (std::size_t n = 1; n < frames.size(); ++n) sum += value(frames[n]);
  return sum / static_cast<double>(frames.size() - 1);
}

double ratio(double value, double other) { return other > 0 ? value / other : 0; }

nlohmann::ordered_json to_json(const FrameQuality& metrics) {
  return {{"energy", metrics.energy},
          {"branches", metrics.quality.branches},
          {"angle_error_mean_deg", metrics.quality.angle_error_mean_deg},
          {"phase_step", metrics.phase_step}};
}

void add_to_json(const SeriesFrameReport& series, nlohmann::ordered_json& json) {
  json["file"] = nullptr;
  if (!series.file.empty()) json["file"] = series.file;
  json["time"] = series.time;
  if (!series.matched_by) return;
  json["matched_by"] = name_of(*series.matched_by);
  json["vertices_unmatched"] = series.vertices_unmatched;
  if (series.field_turned_deg) json["field_turned_deg"] = *series.field_turned_deg;
}

nlohmann::ordered_json to_json(const FrameReport& report, std::size_t number) {
  nlohmann::ordered_json json = {{"frame", number}};
  if (report.series) add_to_json(*report.series, json);
  json.update(to_json(report.metrics));
  json["unchanged"] = report.unchanged;
  json["milliseconds"] = {{"scene", report.scene_milliseconds},
                          {"couple", report.milliseconds.couple},
                          {"sum", report.milliseconds.sum},
                          {"solve", report.milliseconds.solve},
                          {"render", report.render_milliseconds}};
  if (report.frequency) {
    json["milliseconds"]["frequency"] = report.milliseconds.frequency;
    json["frequency_change"] = to_json(*report.frequency);
  }
  if (report.from_scratch) json["from_scratch"] = to_json(*report.from_scratch);
  return json;
}

/// The metrics of `metrics` relative to those of `scratch`.
nlohmann::ordered_json comparison(const FrameQuality& metrics, const FrameQuality& scratch) {
  return {{"energy_ratio", ratio(metrics.energy, scratch.energy)},
          {"phase_step_ratio", ratio(metrics.phase_step, scratch.phase_step)},
          {"angle_error_above_deg",
           metrics.quality.angle_error_mean_deg - scratch.quality.angle_error_mean_deg},
          {"branches_ratio", ratio(static_cast<double>(metrics.quality.branches),
                                   static_cast<double>(scratch.quality.branches))}};
}

nlohmann::ordered_json means(const std::vector<FrameReport>& frames) {
  const auto of = [&](auto value) { return mean(frames, value); };
  return {{"energy", of([](const FrameReport& f) { return f.metrics.energy; })},
          {"phase_step", of([](const FrameReport& f) { return f.metrics.phase_step; })},
          {"milliseconds",
           {{"scene", of([](const FrameReport& f) { return f.scene_milliseconds; })},
            {"couple", of([](const FrameReport& f) { return f.milliseconds.couple; })},
            {"sum", of([](const FrameReport& f) { return f.milliseconds.sum; })},
            {"solve", of([](const FrameReport& f) { return f.milliseconds.solve; })},
            {"render", of([](const FrameReport& f) { return f.render_milliseconds; })}}}};
}

/// Mean over the steps whose field continued the last one; empty if none did.
std::optional<double> mean_field_turn(const std::vector<FrameReport>& frames) {
  double sum = 0;
  std::size_t count = 0;
  for (const FrameReport& frame : frames) {
    if (!frame.series || !frame.series->field_turned_deg) continue;
    sum += *frame.series->field_turned_deg;
    ++count;
  }
  if (count == 0) return std::nullopt;
  return sum / static_cast<double>(count);
}

std::string row(std::size_t number, const FrameReport& report) {
  const FrameQuality& metrics = report.metrics;
  std::string text =
      formatted("%5zu %9.6f %9zu %9.2f %9.4f %7.2f %7.2f %7.2f", number, metrics.energy,
                metrics.quality.branches, metrics.quality.angle_error_mean_deg, metrics.phase_step,
                report.milliseconds.couple, report.milliseconds.sum, report.milliseconds.solve);
  if (report.from_scratch) {
    const FrameQuality& scratch = *report.from_scratch;
    text += formatted("  | %9.6f %9zu %9.2f %9.4f", scratch.energy, scratch.quality.branches,
                      scratch.quality.angle_error_mean_deg, scratch.phase_step);
  }
  if (report.series) text += "  " + report.series->file;
  return text + '\n';
}

void print_comparison(std::ostream& out, std::size_t number, const FrameReport& report) {
  const FrameQuality& metrics = report.metrics;
  const FrameQuality& scratch = *report.from_scratch;
  out << formatted("frame %zu against from scratch\n", number)
      << formatted("  energy       %.6f / %.6f = %.3f\n", metrics.energy, scratch.energy,
                   ratio(metrics.energy, scratch.energy))
      << formatted("  phase step   %.4f / %.4f = %.3f\n", metrics.phase_step, scratch.phase_step,
                   ratio(metrics.phase_step, scratch.phase_step))
      << formatted("  angle error  %.2f - %.2f = %.2f degrees\n",
                   metrics.quality.angle_error_mean_deg, scratch.quality.angle_error_mean_deg,
                   metrics.quality.angle_error_mean_deg - scratch.quality.angle_error_mean_deg);
}

/// A scene's frames with stripes along its field.
class TurnedScene {
 public:
  TurnedScene(const Surface& surface, const AnimationOptions& options)
      : scene_(surface, options.scene), along_(options.along) {}

  const SceneFrame& frame(int number) {
    const SceneFrame& frame = scene_.frame(number);
    if (!along_) return frame;
    turned_ = frame;
    turned_.waves.directions =
        rotated(frame.waves.directions, frame.normals, std::numbers::pi_v<float> / 2);
    return turned_;
  }

 private:
  Scene scene_;
  bool along_;
  SceneFrame turned_;
};

}  // namespace

MeasuredFrame measure(const SceneFrame& frame, const PhaseGraph& graph, const FrameResult& result,
                      PhaseShiftKind kind) {
  MeasuredFrame m;
  m.corners = corner_phases(frame.mesh.triangles, frame.waves, result.z, kind);
  m.metrics.energy = energy(graph, result.z);
  m.metrics.quality = measure_quality(frame.mesh, frame.waves, m.corners);
  m.metrics.phase_step = result.phase_step;
  return m;
}

RelaxedFrame::RelaxedFrame(const SceneFrame& wanted, const FrameResult& result) : wanted_(wanted) {
  if (result.frequencies.empty()) return;
  relaxed_ = wanted;
  relaxed_->waves.frequencies.assign(result.frequencies.begin(), result.frequencies.end());
}

std::span<const float> RelaxedFrame::frequencies_wanted() const {
  return relaxed_ ? std::span<const float>(wanted_.waves.frequencies) : std::span<const float>();
}

std::optional<FrequencyReport> RelaxedFrame::report(std::span<const CornerPhases> corners,
                                                    const FrameResult& result) const {
  if (!relaxed_) return std::nullopt;
  const PatternQuality quality = measure_quality(wanted_.mesh, wanted_.waves, corners);
  return FrequencyReport{result.frequency_change, quality.spacing_error_mean, {}};
}

FrameQuality measure_relaxed(const RelaxedFrame& relaxed,
                             std::shared_ptr<const Adjacency> neighborhood,
                             const FrameResult& result, PhaseShiftKind kind) {
  const SceneFrame& frame = relaxed.frame();
  const PhaseGraph graph = build_phase_graph(std::move(neighborhood), frame.waves, kind);
  return measure(frame, graph, result, kind).metrics;
}

AnimationReport play(const FrameData& data, const AnimationOptions& options, const Device& device,
                     const ShowFrame& show, ProgressDisplay& display) {
  const Surface& surface = data.surface;
  AnimationReport report;
  report.waves.subdivided = options.subdivided;
  report.scene = options.scene.kind;
  report.options = options.animator;
  report.vertices = surface.mesh.vertex_count();
  report.triangles = surface.mesh.triangle_count();
  report.edges = surface.neighborhood->edge_count();
  report.threads = ThreadLimit::current();
  report.device = device.description();
  TurnedScene scene(surface, options);
  const auto animator = device.animator(surface, options.animator);
  AnimatorOptions without_last = options.animator;
  without_last.solver = FrameSolver::multilevel;
  without_last.lambda = 0;
  const auto scratch = device.animator(surface, without_last);
  const PhaseShiftKind kind = options.animator.phase_shift;
  const std::string source = "the field of the scene '" + std::string(name_of(report.scene)) + "'";
  Stopwatch watch;
  for (int number = 0; number < options.frames; ++number) {
    const auto begin_part = [&](double begin, double end) {
      display.narrow((number + begin) / options.frames, (number + end) / options.frames);
      return display.progress().step("frames");
    };
    const Progress of_frame = begin_part(0, 0.7);
    of_frame.report(0);
    FrameReport& frame_report = report.frames.emplace_back();
    watch.lap();
    const SceneFrame& wanted = scene.frame(number);
    frame_report.scene_milliseconds = watch.lap();
    if (number == 0) {
      report.waves =
          noted_waves(measure_waves(surface, wanted.waves), source, display, report.waves);
    }
    const FrameResult result = animator->frame(input_of(wanted.waves), of_frame.part(0, 0.5));
    of_frame.report(0.5);
    const RelaxedFrame relaxed(wanted, result);
    const SceneFrame& frame = relaxed.frame();
    frame_report.milliseconds = result.milliseconds;
    frame_report.unchanged = result.unchanged;
    const PhaseGraph graph = build_phase_graph(surface.neighborhood, frame.waves, kind);
    const MeasuredFrame measured = measure(frame, graph, result, kind);
    frame_report.metrics = measured.metrics;
    frame_report.frequency = relaxed.report(measured.corners, result);
    of_frame.report(0.7);
    if (options.compare_from_scratch) {
      const FrameResult again = scratch->frame(input_of(wanted.waves), of_frame.part(0.7, 1));
      const RelaxedFrame own(wanted, again);
      frame_report.from_scratch = measure_relaxed(own, surface.neighborhood, again, kind);
    }
    watch.lap();
    begin_part(0.7, 1).report(0);
    if (show) {
      show({data, frame, result.z, animator->phase_buffer(), measured.corners,
            relaxed.frequencies_wanted()});
    }
    frame_report.render_milliseconds = watch.lap();
  }
  display.progress().report("frames", 1);
  report.topology_milliseconds = animator->topology_milliseconds();
  return report;
}

nlohmann::ordered_json to_json(const AnimationReport& report) {
  const bool multilevel = report.options.solver == FrameSolver::multilevel;
  nlohmann::ordered_json json = report.invocation;
  json["kind"] = "mesh";
  if (report.series) {
    json["series"] = report.series->name;
    json["steps"] = report.series->steps;
    json["interpolated"] = report.series->between;
  } else {
    json["scene"] = name_of(report.scene);
  }
  json.update(nlohmann::ordered_json{{"vertices", report.vertices},
                                     {"triangles", report.triangles},
                                     {"edges", report.edges},
                                     {"threads", report.threads},
                                     {"solver", multilevel ? "multilevel" : "relaxation"}});
  json.update(to_json(report.waves, std::nullopt));
  if (multilevel) {
    json["lambda"] = std::stod(formatted("%g", report.options.lambda));  // 0.02, not 0.01999999955
    json["sweeps"] = report.options.sweeps;
  } else {
    json["iterations"] = report.options.iterations;
  }
  json["device"] = report.device;
  if (!report.picture.is_null()) json.update(report.picture);
  json["topology_milliseconds"] = report.topology_milliseconds;
  json["mean"] = means(report.frames);
  if (const auto turned = mean_field_turn(report.frames)) {
    json["mean"]["field_turned_deg"] = *turned;
  }
  const FrameReport& last = report.frames.back();
  if (last.from_scratch) {
    json["last_against_from_scratch"] = comparison(last.metrics, *last.from_scratch);
  }
  json["frames"] = nlohmann::ordered_json::array();
  for (std::size_t n = 0; n < report.frames.size(); ++n) {
    json["frames"].push_back(to_json(report.frames[n], n));
  }
  return json;
}

void print_report(std::ostream& out, const AnimationReport& report) {
  const std::vector<FrameReport>& frames = report.frames;
  const bool compared = frames.front().from_scratch.has_value();
  out << (report.series ? formatted("series    %s, %zu steps, ", report.series->name.c_str(),
                                    report.series->steps)
                        : formatted("scene     %s, ", name_of(report.scene).data()))
      << formatted("%zu vertices, %zu triangles, %zu edges, %d thread%s\n", report.vertices,
                   report.triangles, report.edges, report.threads, report.threads == 1 ? "" : "s")
      << device_line(report.device);
  print_waves(out, report.waves);
  out << "                               angle     phase     couple     sum   solve"
      << (compared ? "  | from scratch\n" : "\n")
      << "frame    energy  branches     error      step      ms      ms      ms"
      << (compared ? "  |    energy  branches     error      step\n" : "\n");
  const std::size_t step = (frames.size() + kPrintedRows - 2) / kPrintedRows;
  for (std::size_t n = 0; n + 1 < frames.size(); n += std::max<std::size_t>(step, 1)) {
    out << row(n, frames[n]);
  }
  out << row(frames.size() - 1, frames.back())
      << formatted("mean      phase step %.4f; scene %.2f, frame %.2f, render %.2f ms\n",
                   mean(frames, [](const FrameReport& f) { return f.metrics.phase_step; }),
                   mean(frames, [](const FrameReport& f) { return f.scene_milliseconds; }),
                   mean(frames, [](const FrameReport& f) { return total(f.milliseconds); }),
                   mean(frames, [](const FrameReport& f) { return f.render_milliseconds; }))
      << formatted("topology  %.1f ms, once\n", report.topology_milliseconds);
  if (const auto turned = mean_field_turn(frames)) {
    out << formatted("field     turned by %.2f degrees a step\n", *turned);
  }
  if (compared) print_comparison(out, frames.size() - 1, frames.back());
}

}  // namespace brindle::tool
