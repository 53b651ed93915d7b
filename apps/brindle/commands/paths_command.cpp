#include <iostream>

#include "brindle/base/parallel.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "jobs/paths_job.h"

namespace brindle::tool {
namespace {

constexpr const char* kPathsExamples = R"(Examples:
  brindle paths shape:tube,bend=0 --field curvature,min --order spiral --output vase.gcode
  brindle paths scan.obj --order boustrophedon --gcode plain --output mill.gcode
  brindle paths horse.ply --spacing 4% --cut-length 10% --fair 0.25 --output fibre.csv
  brindle paths horse.ply --scale 50:1 --axes 5 --output robot.gcode --report robot.json
  brindle paths shape:hemisphere --order layers --output layers.png)";

void run_paths(const CLI::App& command, const PathsArguments& given) {
  const Outputs outputs =
      plan_outputs(paths_inputs(given), given.outputs, given.report, planned_paths);
  check_paths_options(command, given, outputs);
  const PathsArguments arguments = completed(given);
  check_curves_points(arguments);
  const ThreadLimit threads(arguments.solving.threads);
  const PathsJob job = make_and_write(
      command, outputs, arguments.quiet, paths_stages(arguments),
      [&](ProgressDisplay& display) { return make_paths_job(arguments, display); },
      [&](const Output& output, const PathsJob& made, ProgressDisplay& display) {
        write_paths_file(output, command, arguments, made, display);
      });
  if (arguments.quiet) return;
  print(std::cout, job);
  print_written(std::cout, outputs);
}

}  // namespace

Command add_paths_command(CLI::App& app) {
  return add_command<PathsArguments>(app, "paths", "Make tool paths of the stripes, as G-code",
                                     kPathsExamples, add_paths_options, run_paths);
}

}  // namespace brindle::tool
