#include <iostream>

#include "brindle/base/parallel.h"
#include "cli/command_line.h"
#include "jobs/rank_jobs.h"
#include "jobs/sample_job.h"
#include "outputs/outputs.h"

namespace brindle::tool {
namespace {

constexpr const char* kSampleExamples = R"(Examples:
  brindle sample horse.ply --stripes 100 --output samples.csv
  brindle sample scan.obj --stripes 30 --stripes-v 90 --output anisotropic.ply
  brindle sample scan.obj --field importance.csv --output samples.vtp --report samples.json
  brindle sample shape:torus --output samples.png
  brindle sample scan.obj --glyph arrow --size-by curvature --output arrows.png
  brindle sample points.ply --stripes 50 --output samples.csv
  brindle sample flow.vtp --frequency-by array:speed --output samples.csv)";

void run_sample(const CLI::App& command, const SampleArguments& arguments) {
  const Outputs outputs =
      plan_outputs(sample_inputs(arguments), arguments.outputs, arguments.report, planned_sample);
  check_sample_options(command, arguments, outputs);
  check_sample_points(command, arguments, outputs);
  const ThreadLimit threads(arguments.solving.threads);
  const std::optional<Image> picture = read_glyph_picture(arguments.glyphs);
  const SampleJob job = make_and_write(
      command, outputs, arguments.quiet, sample_stages(arguments),
      [&](ProgressDisplay& display) {
        SampleJob made = make_sample_job(arguments, display);
        if (is_styled(command)) {
          made.glyphs = read_glyph_input(arguments.glyphs, made.prepared, arguments.surface,
                                         arguments.waves, arguments.picture);
          made.glyphs.picture = picture;
        }
        return made;
      },
      [&](const Output& output, const SampleJob& made, ProgressDisplay& display) {
        write_sample_file(output, command, arguments, made, display);
      });
  if (arguments.quiet) return;
  print(std::cout, job);
  print_written(std::cout, outputs);
}

}  // namespace

Command add_sample_command(CLI::App& app, RankJobs* ranks) {
  return add_rank_command<SampleArguments>(app, ranks, "sample",
                                           "Sample a surface where two patterns cross",
                                           kSampleExamples, add_sample_options, run_sample);
}

}  // namespace brindle::tool
