#include <iostream>

#include "brindle/base/parallel.h"
#include "brindle/recipe/report.h"
#include "cli/command_line.h"
#include "jobs/curves_output.h"
#include "jobs/curves_report.h"
#include "jobs/rank_jobs.h"

namespace brindle::tool {
namespace {

constexpr const char* kCurvesExamples = R"(Examples:
  brindle curves horse.ply --stripes 100 --output horse.svg --camera 60,15
  brindle curves scan.obj --lines both --stripes 30 --stripes-v 60 --output grid.obj
  brindle curves shape:torus --tube-radius 0.4% --output tubes.glb
  brindle curves scan.obj --offset 0.5 --min-length 2% --simplify 0.05% --output gaps.csv
  brindle curves shape:torus --stripes 60 --path-width 0.8% --report torus.json
  brindle curves shape:tube --field curvature,min --winding 1 --output vase.vtp
  brindle curves shape:trefoil --join --output curves.vtp --report curves.json
  brindle curves plate.vtp --field array:stress --along --lines both --output stress.svg)";

void run_curves(const CLI::App& command, const CurvesArguments& arguments) {
  const Outputs outputs =
      plan_outputs(curves_inputs(arguments), arguments.outputs, arguments.report,
                   [&](const std::filesystem::path& path) {
                     return planned_curves(path, arguments.tube_radius.has_value());
                   });
  check_curves_options(command, arguments, outputs);
  check_curves_points(arguments);
  const ThreadLimit threads(arguments.solving.threads);
  const CurvesJob job = make_and_write(
      command, outputs, arguments.quiet, curves_stages(arguments),
      [&](ProgressDisplay& display) { return make_curves_job(arguments, display); },
      [&](const Output& output, const CurvesJob& made, ProgressDisplay& display) {
        write_curves_file(output, command, arguments, made, display);
      });
  if (arguments.quiet) return;
  print(std::cout, job);
  print_written(std::cout, outputs);
}

}  // namespace

Command add_curves_command(CLI::App& app, RankJobs* ranks) {
  return add_rank_command<CurvesArguments>(app, ranks, "curves", "Trace the stripes as curves",
                                           kCurvesExamples, add_curves_options, run_curves);
}

}  // namespace brindle::tool
