#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "brindle/base/parallel.h"
#include "brindle/recipe/report.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/progress_display.h"
#include "input/preparation.h"
#include "input/solving_options.h"
#include "input/used_files.h"
#include "outputs/outputs.h"

namespace brindle::tool {
namespace {

constexpr const char* kCompareExamples = R"(Examples:
  brindle compare shape:vessels
  brindle compare horse.ply --direction 0.31,0.9,0.27 --stripes 160 --json horse.json
  brindle compare flow.vtp --field array:velocity --frequency-by array:speed)";

// In the order of the paper, then the reference.
const std::vector<Solver> kSolvers = {Solver::relaxation, Solver::averaged, Solver::multilevel,
#ifdef BRINDLE_HAS_CHOLMOD
                                      Solver::global
#endif
};

struct CompareArguments {
  SurfaceOptions surface;
  WaveOptions waves;
  SolvingOptions solving;
  std::string json;
  bool quiet = false;
};

std::vector<Report> reports_of_all(const CLI::App& command, const CompareArguments& arguments) {
  ProgressDisplay display(arguments.quiet, &command);
  std::vector<JobStage> stages = preparation_stages(arguments.surface);
  for (const Solver solver : kSolvers) {
    stages.push_back({std::string(name_of(solver)), solver == Solver::global ? 40.0 : 10.0});
  }
  display.plan(std::move(stages));
  const Preparation prepared = prepare(arguments.surface, arguments.waves, display);
  StripeOptions options = stripe_options(arguments.solving, prepared);
  std::vector<Report> reports;
  for (const Solver solver : kSolvers) {
    display.stage(name_of(solver));
    options.solver.solver = solver;
    const StripePattern pattern =
        stripe_pattern(prepared.surface, prepared.waves, options, display.progress());
    reports.push_back(make_report(prepared.surface, prepared, pattern, solver));
  }
  // For the last solver alone: all have the same waves.
  display.note(quality_warning(prepared.metrics, reports.back().quality, reports.back().triangles));
  return reports;
}

void check(const CLI::App& command, const CompareArguments& arguments) {
  std::vector<UsedFile> inputs = input_files(arguments.surface, arguments.waves);
  add_slack_files(arguments.solving.slack, inputs);
  check_report("--json", arguments.json);
  if (!arguments.json.empty()) check_files(inputs, {{"--json", arguments.json}});
  check_field_options(command, arguments.waves);
  check_slack_options(command, arguments.solving.slack);
  if (is_points(arguments.surface)) refuse_triangle_options(command);
}

void run_compare(const CLI::App& command, const CompareArguments& arguments) {
  check(command, arguments);
  const ThreadLimit threads(arguments.solving.threads);
  std::vector<Report> reports = reports_of_all(command, arguments);
  for (Report& report : reports) report.invocation = invocation_of(command);
  if (!arguments.json.empty()) {
    auto json = nlohmann::ordered_json::array();
    for (const Report& report : reports) json.push_back(to_json(report));
    write_json(arguments.json, json);
  }
  if (arguments.quiet) return;
  print_waves(std::cout, reports.front().waves);
  if (reports.front().frequency) print_frequency(std::cout, *reports.front().frequency);
  print_table(std::cout, reports);
  if (!arguments.json.empty()) print_written(std::cout, std::filesystem::path(arguments.json));
}

void add_compare_options(CLI::App& command, CompareArguments& arguments) {
  add_surface_options(command, arguments.surface);
  add_point_options(command, arguments.surface);
  add_wave_options(command, arguments.waves);
  add_solving_options(command, arguments.solving);
  command.add_option("--json", arguments.json, "write the reports here, as a list")
      ->type_name("FILE.json");
  command.add_flag("-q,--quiet", arguments.quiet);
}

}  // namespace

Command add_compare_command(CLI::App& app) {
  return add_command<CompareArguments>(app, "compare",
                                       "All solvers on the same input, in one table",
                                       kCompareExamples, add_compare_options, run_compare);
}

}  // namespace brindle::tool
