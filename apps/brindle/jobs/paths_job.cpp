#include "jobs/paths_job.h"

#include <cmath>
#include <ostream>
#include <utility>

#include "brindle/base/stopwatch.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "jobs/curves_report.h"
#include "outputs/outputs.h"

namespace brindle::tool {
namespace {

constexpr const char* kPaths = "paths";
constexpr const char* kCoverage = "coverage of paths";

/// The coverage is that of paths, not of curves.
CurvesArguments curves_of(const PathsArguments& arguments) {
  CurvesArguments curves = arguments;
  curves.path_width.reset();
  return curves;
}

ToolPathOptions options_of(const PathsArguments& arguments, const CurvesJob& job) {
  const float diagonal = bounding_box(job.prepared.surface.mesh).diagonal();
  ToolPathOptions options;
  options.order = arguments.order;
  options.up = arguments.machine.up;
  options.width =
      arguments.path_width
          ? arguments.path_width->on(diagonal)
          : static_cast<float>(mean_spacing(job.families.front().pattern.waves.frequencies));
  options.least_radius = arguments.least_radius.on(diagonal);
  options.least_length = arguments.min_length.on(diagonal);
  options.cut_length = arguments.cut_length.on(diagonal);
  if (arguments.connect) options.connect = arguments.connect->on(diagonal);
  return options;
}

void check_spiral(const PathsArguments& arguments, const CurveFamily& family) {
  const std::size_t curves = family.curves.lines.count();
  if (arguments.order != PathOrder::spiral || curves == 1) return;
  throw Error(
      "--order spiral: the stripes are " + std::to_string(curves) + " curves with " +
      std::to_string(family.pattern.quality.branches) +
      " branches, and a spiral is one curve on a sleeve; try --min-length if the rims "
      "are jagged, another --direction or --field, --slack or --cancel-branches, or --order "
      "layers");
}

}  // namespace

std::vector<JobStage> paths_stages(const PathsArguments& arguments) {
  std::vector<JobStage> stages = curves_stages(curves_of(arguments));
  stages.insert(stages.end(), {{kPaths, 4}, {kCoverage, 2}});
  return stages;
}

PathsJob make_paths_job(const PathsArguments& arguments, JobListener& listener) {
  PathsJob job;
  job.curves = make_curves_job(curves_of(arguments), listener);
  const Mesh& mesh = job.curves.prepared.surface.mesh;
  const ToolPathOptions options = options_of(arguments, job.curves);
  listener.stage(kPaths);
  Stopwatch watch;
  const CurveFamily& family = job.curves.families.front();
  check_spiral(arguments, family);
  job.paths = tool_paths(mesh, family.curves.lines, options, listener.progress());
  job.order_milliseconds = watch.lap();
  listener.stage(kCoverage);
  job.coverage = measure_coverage(mesh, job.paths.lines, static_cast<double>(options.width),
                                  listener.progress());
  job.machine = machine_metrics(job.paths, arguments.machine);
  return job;
}

nlohmann::ordered_json to_json(const PathsJob& job, const PathsArguments& arguments) {
  nlohmann::ordered_json json = to_json(job.curves, *arguments.picture);
  const ToolPathMetrics& metrics = job.paths.metrics;
  nlohmann::ordered_json& paths = json["paths"] = {{"paths", job.paths.lines.count()},
                                                   {"curves", metrics.curves},
                                                   {"bends_cut", metrics.bends_cut},
                                                   {"left_out", metrics.left_out},
                                                   {"joins", metrics.joins},
                                                   {"length", metrics.length},
                                                   {"joined_length", metrics.joined_length},
                                                   {"travel", metrics.travel},
                                                   {"travel_nearest", metrics.travel_nearest},
                                                   {"lifts", job.machine.lifts},
                                                   {"width", job.paths.width},
                                                   {"widths",
                                                    {{"least", metrics.least_width},
                                                     {"mean", metrics.mean_width},
                                                     {"most", metrics.most_width}}},
                                                   {"coverage", job.coverage.once},
                                                   {"covered_twice", job.coverage.twice},
                                                   {"seconds", job.machine.seconds}};
  if (std::isfinite(metrics.least_radius)) paths["least_radius"] = metrics.least_radius;
  if (arguments.machine.dialect == GcodeDialect::marlin) paths["filament"] = job.machine.extrusion;
  json["milliseconds"]["order"] = job.order_milliseconds;
  if (job.draw_milliseconds) json["milliseconds"]["draw"] = *job.draw_milliseconds;
  return json;
}

void print(std::ostream& out, const PathsJob& job) {
  print(out, job.curves);
  const ToolPathMetrics& metrics = job.paths.metrics;
  out << formatted("paths  %zu of %zu curves, %zu joins, length %g\n", job.paths.lines.count(),
                   metrics.curves, metrics.joins, metrics.length)
      << formatted("   travel %g, %zu lifts, %g s\n", metrics.travel, job.machine.lifts,
                   job.machine.seconds)
      << formatted("   width %g to %g, on average %g; %g wide they cover %.1f %%, %.1f %% twice\n",
                   metrics.least_width, metrics.most_width, metrics.mean_width,
                   static_cast<double>(job.paths.width), 100 * job.coverage.once,
                   100 * job.coverage.twice);
  if (std::isfinite(metrics.least_radius)) {
    out << formatted("   least radius %g\n", metrics.least_radius);
  }
  if (metrics.bends_cut + metrics.left_out > 0) {
    out << formatted("   cut at %zu bends, %zu curves too short\n", metrics.bends_cut,
                     metrics.left_out);
  }
}

namespace {

/// Straight lines from the end of each path to the next one.
Polylines travel_lines(const Polylines& lines) {
  Polylines travel;
  travel.origin = lines.origin;
  for (std::size_t line = 1; line < lines.count(); ++line) {
    for (const std::size_t i : {lines.offsets[line] - 1, lines.offsets[line]}) {
      travel.add(lines.points[i], lines.normals[i]);
    }
    travel.end_line(false);
  }
  return travel;
}

}  // namespace

void write_paths_file(const Output& output, const CLI::App& command,
                      const PathsArguments& arguments, const PathsJob& job, JobListener& listener) {
  const Surface& surface = job.curves.prepared.surface;
  switch (output.kind) {
    case OutputKind::report:
      return write_report(output.path, command, surface.mesh, to_json(job, arguments),
                          listener.progress());
    case OutputKind::lines:
      if (job.paths.lines.count() == 0) {
        throw Error("cannot write '" + shown(output.path.native()) + "': there are no paths");
      }
      return write_tool_paths(output.path, job.paths, arguments.machine, listener.progress());
    default: {
      const float radius = job.paths.width / 6;
      const std::vector<Ornament> ornaments = {
          {tubes(job.paths.lines, {.radius = radius}), false},
          {tubes(travel_lines(job.paths.lines), {.radius = radius}), true}};
      return write_ornaments(output.path, surface, ornaments, *arguments.picture,
                             listener.progress());
    }
  }
}

}  // namespace brindle::tool
