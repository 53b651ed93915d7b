#include "jobs/paths_job.h"

#include <cmath>
#include <ostream>
#include <utility>

#include "brindle/base/file_names.h"
#include "brindle/base/output_file.h"
#include "brindle/base/stopwatch.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "cli/command_line.h"
#include "cli/option_fields.h"
#include "input/vertex_values.h"
#include "jobs/curves_report.h"
#include "outputs/outputs.h"
#include "pictures/paper.h"
#include "pictures/picture.h"

namespace brindle::tool {

void add_paths_options(CLI::App& command, PathsArguments& arguments) {
  add_traced_options(command, arguments);
  arguments.visit_lines(AddField(command));
  arguments.visit_paths(AddField(command));
  add_parsed_option(command, "--lids", arguments.surface.lids, parse_lids);
  add_parsed_option(command, "--place", arguments.machine.place, parse_place);
  add_parsed_option(command, "--scale", arguments.machine.unit, parse_scale);
}

OutputKind planned_paths(const std::filesystem::path& path) {
  const std::string kind = lower_extension(path);
  check_output_path(path);
  if (kind == ".json") return OutputKind::report;
  if (is_tool_path_format(path)) return OutputKind::lines;
  if (kind == ".png") return OutputKind::picture;
  if (kind == ".svg" || kind == ".pdf") {
    refuse_output(path, "'brindle curves' draws lines, in an order with little travel, too");
  }
  refuse_output(path, "unknown extension '" + kind +
                          "'; use .gcode, .dxf, .csv, .vtp, .ply or .obj for paths, .png for a "
                          "picture, .json for a report");
}

namespace {

bool writes(const Outputs& outputs, const std::string& extension) {
  return std::ranges::any_of(
      outputs, [&](const Output& output) { return lower_extension(output.path) == extension; });
}

void check_picture_options(const CLI::App& command, const PathsArguments& arguments) {
  constexpr const char* kWhy = "nothing is drawn; add --output FILE.png";
  refuse_light_option(command, arguments.waves, kWhy);
  refuse_given(command, {"--slice", "--quality", "--colors"}, kWhy);
  if (depends_on_camera(arguments.waves.arrays.frequency_by)) return;
  refuse_given(command, {"--camera", "--projection", "--size"}, kWhy);
}

void check_spiral(const CLI::App& command, const PathsArguments& arguments) {
  constexpr const char* kOne = "a spiral is one path";
  refuse_given(command, {"--connect", "--cut-length", "--least-radius"}, kOne);
  if (arguments.traced != TracedWaves::u) {
    refuse_given(command, {"--lines"}, "a spiral winds U; leave it out");
  }
}

}  // namespace

void check_paths_options(const CLI::App& command, const PathsArguments& arguments,
                         const Outputs& outputs) {
  check_traced_options(command, arguments);
  const bool picture = has(outputs, OutputKind::picture);
  const bool gcode = writes(outputs, ".gcode"), machine = gcode || writes(outputs, ".dxf");
  if (!picture) check_picture_options(command, arguments);
  if (arguments.traced == TracedWaves::both) {
    refuse_given(command, {"--lines"}, "paths of both would cross; make those of u, then of v");
  }
  if (arguments.order == PathOrder::spiral) check_spiral(command, arguments);
  if (!gcode) {
    refuse_given(command, {"--gcode", "--axes"}, "no G-code is written; add --output FILE.gcode");
  }
  if (!machine) {
    refuse_given(command, {"--place"}, "no machine moves; add --output FILE.gcode or FILE.dxf");
  }
  if (arguments.machine.dialect == GcodeDialect::plain) {
    refuse_given(command, {"--thickness", "--filament"},
                 "plain G-code extrudes nothing; leave out --gcode");
  }
  const bool sorted = arguments.order == PathOrder::layers || arguments.order == PathOrder::spiral;
  const bool lids = arguments.surface.lids && arguments.surface.lids->degrees;
  if (!picture && !machine && !sorted && !lids &&
      !depends_on_up(arguments.waves.arrays.frequency_by)) {
    refuse_given(command, {"--up"},
                 "no height counts; add --order layers, --lids, or --output FILE.gcode");
  }
}

PathsArguments completed(PathsArguments arguments) {
  PictureOptions& picture = arguments.picture;
  if (!picture.up) picture.up = UpAxis::z;
  arguments.machine.up = upright_axes(*picture.up).row(1).transpose();
  if (arguments.surface.lids) arguments.surface.lids->up = arguments.machine.up;
  if (arguments.axes == PathsArguments::Axes::five) arguments.machine.axes = 5;
  if (arguments.order == PathOrder::spiral && arguments.fabrication.windings.empty()) {
    arguments.fabrication.windings.push_back({"", 1});
  }
  return arguments;
}

std::vector<UsedFile> paths_inputs(const PathsArguments& arguments) {
  std::vector<UsedFile> inputs = curves_inputs(arguments);
  const auto& lids = arguments.surface.lids;
  if (lids && !lids->degrees) inputs.push_back({"--lids", lids->file});
  return inputs;
}

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
  nlohmann::ordered_json json = to_json(job.curves, arguments.picture);
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
      return write_ornaments(output.path, surface, ornaments, arguments.picture,
                             listener.progress());
    }
  }
}

}  // namespace brindle::tool
