/// Arguments of `brindle paths`.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "brindle/tool_paths.h"
#include "jobs/curves_arguments.h"

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

}  // namespace brindle::tool
