/// `brindle paths`: its arguments, and the tool paths.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <vector>

#include <nlohmann/json.hpp>

#include "brindle/tool_paths.h"
#include "jobs/curves_job.h"

namespace brindle::tool {

struct PathsArguments : CurvesArguments {
  PathOrder order = PathOrder::nearest;
  std::optional<Length> connect;  ///< default: two widths
  Length least_radius, cut_length;
  enum class Axes { three, five } axes = Axes::three;
  Machine machine;

  /// Calls `add("--option", field)` for each option that sets a field.
  template <class Add>
  void visit_paths(const Add& add) {
    add("--order", order);
    add("--connect", connect);
    add("--least-radius", least_radius);
    add("--cut-length", cut_length);
    add("--gcode", machine.dialect);
    add("--axes", axes);
    add("--thickness", machine.thickness);
    add("--filament", machine.filament);
    add("--speed", machine.speed);
    add("--travel-speed", machine.travel_speed);
    add("--lift", machine.lift);
  }
};

void add_paths_options(CLI::App& command, PathsArguments& arguments);

/// The kind of a file: .png a picture, .json a report, others `lines`. Throws CLI::ValidationError
/// with a remedy for other files.
OutputKind planned_paths(const std::filesystem::path& path);

/// Throws CLI::ValidationError for options without effect on these files or beside other options.
void check_paths_options(const CLI::App& command, const PathsArguments& arguments,
                         const Outputs& outputs);

/// The arguments with what follows from others: the axis that is up, and a spiral's winding.
PathsArguments completed(PathsArguments arguments);

/// All input files.
std::vector<UsedFile> paths_inputs(const PathsArguments& arguments);

struct PathsJob : DrawingTime {
  CurvesJob curves;
  ToolPaths paths;
  CurveCoverage coverage;
  MachineMetrics machine;
  double order_milliseconds = 0;
};

/// Its stages, in order, for `JobListener`.
std::vector<JobStage> paths_stages(const PathsArguments& arguments);

PathsJob make_paths_job(const PathsArguments& arguments, JobListener& listener);

nlohmann::ordered_json to_json(const PathsJob& job, const PathsArguments& arguments);

/// The same as text.
void print(std::ostream& out, const PathsJob& job);

/// Writes any kind. Throws Error if the file cannot be written.
void write_paths_file(const Output& output, const CLI::App& command,
                      const PathsArguments& arguments, const PathsJob& job, JobListener& listener);

}  // namespace brindle::tool
