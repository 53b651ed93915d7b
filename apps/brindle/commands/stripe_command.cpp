#include <iostream>
#include <optional>
#include <utility>

#include "brindle/base/parallel.h"
#include "cli/command_line.h"
#include "jobs/rank_jobs.h"
#include "jobs/stripe_job.h"
#include "outputs/outputs.h"

namespace brindle::tool {
namespace {

constexpr const char* kStripeExamples =
    R"(Stripes run ACROSS the direction: a wave runs along it, and stripes are its crests.
--along turns them.

    --direction 1,0,0    |  |  |  |        --direction 1,0,0    -----------
      or a field of      |  |  |  |          --along            -----------
      arrows like ->     |  |  |  |                             -----------

Examples:
  brindle stripe shape:torus --output torus.png
  brindle stripe horse.ply --direction 0.31,0.9,0.27 --stripes 40 --output horse.png
  brindle stripe scan.obj --field curvature --rotate 90 --output scan.glb --report scan.json
  brindle stripe scan.obj --field wind.csv --frequency 12 --output wind.png
  brindle stripe horse.ply --device gpu --report horse.json
  brindle stripe shape:torus,resolution=64,noise=0.2 --view branches --output branches.png
  brindle stripe shape:trefoil --cancel-branches 0.05 --output fewer.png
  brindle stripe scan.obj --cross --texture plus --output crosses.png
  brindle stripe points.csv --output points.png --output points.ply
  brindle stripe scan.obj --field wind.csv --oriented --texture arrows --output wind.png
  brindle stripe horse.ply --slack 0.25 --output horse.png --report horse.json
  brindle stripe scan.obj --slack 0.25 --avoid-branches face.csv --view branches --output face.png
  brindle stripe scan.obj --uv --output scan.vtp --output scan.ply
  brindle stripe scan.obj --texture cloth.png --stripes 20 --stripes-v 30 --output cloth.glb
  brindle stripe flow.vtp --width-by array:speed --color-by array:speed --output speed.png
  brindle stripe scan.obj --between nothing --with horse.ply@#b03a2e --output inside.png
  brindle stripe scan.obj --width-by light,cross-hatch=0.5 --outline solid --output ink.png
  brindle stripe step2.vtp --field array:velocity --previous step1_stripes.vtp --output step2.png
  brindle stripe flow.vtp --field array:velocity --frequency-by array:speed --output flow.png
  brindle stripe plate.vtp --field array:stress --tensor minor --output plate.png
  brindle stripe scan.obj --field array:velocity --field-mesh flow.vtp --output scan.png)";

constexpr const char* kStripes = "stripes";
constexpr const char* kStyle = "stripes of the style";

std::vector<JobStage> stages_of(const CLI::App& command, const StripeArguments& arguments) {
  std::vector<JobStage> stages = preparation_stages(arguments.surface);
  stages.push_back({kStripes, 6});
  if (is_styled(command)) stages.push_back({kStyle, 4});
  return stages;
}

/// Stripes, and what is solved for the style of their pictures.
struct DrawnStripes {
  StripeJob job;
  std::optional<StyleJob> styled;

  void drawn(OutputKind kind, double milliseconds) {
    if (kind != OutputKind::picture && kind != OutputKind::drawing) return;
    job.report.draw_milliseconds = job.report.draw_milliseconds.value_or(0) + milliseconds;
  }
};

DrawnStripes make_stripes(const CLI::App& command, const StripeArguments& arguments,
                          std::optional<TextureTile> tile, ProgressDisplay& display) {
  Preparation prepared = prepare(arguments.surface, arguments.waves, display,
                                 viewpoint_of(arguments.picture), previous_directions(arguments));
  std::optional<StyleInput> style;
  if (is_styled(command)) {
    style = read_style_input(arguments.style, prepared, prepared.waves, arguments.surface,
                             arguments.waves, arguments.picture, display);
  }
  display.stage(kStripes);
  StripeJob job =
      make_stripe_job(arguments, std::move(prepared), std::move(tile), display.progress());
  std::optional<StyleJob> styled;
  if (style) {
    display.stage(kStyle);
    StylePatterns patterns = make_style_patterns(*job.surface, job.result, arguments.style, *style,
                                                 arguments.solving.stripes, display.progress());
    styled.emplace(StyleJob{std::move(*style), std::move(patterns)});
  }
  display.note(quality_warning(job.report.waves, job.report.quality, job.report.triangles));
  display.note(warning_of_tiles(job.result.texture(), job.surface->mesh));
  return {std::move(job), std::move(styled)};
}

void run_stripe(const CLI::App& command, const StripeArguments& arguments) {
  check_solver(arguments.device, arguments.solving.stripes.solver);
  std::optional<TextureTile> tile = chosen_tile(arguments.texture, arguments.waves.cross);
  const Outputs outputs = checked_outputs(command, arguments);

  const ThreadLimit threads(arguments.solving.threads);
  const DrawnStripes made = make_and_write(
      command, outputs, arguments.quiet, stages_of(command, arguments),
      [&](ProgressDisplay& display) {
        DrawnStripes stripes = make_stripes(command, arguments, std::move(tile), display);
        if (draws(outputs)) stripes.job.report.picture = picture_json(arguments.picture);
        return stripes;
      },
      [&](const Output& output, const DrawnStripes& stripes, ProgressDisplay& display) {
        write_stripes(output, command, arguments, stripes.job,
                      stripes.styled ? &*stripes.styled : nullptr, display);
      });
  if (arguments.quiet) return;
  print_report(std::cout, made.job.report);
  print_written(std::cout, outputs);
}

}  // namespace

Command add_stripe_command(CLI::App& app, RankJobs* ranks) {
  return add_rank_command<StripeArguments>(app, ranks, "stripe",
                                           "Lay stripes over a surface or a point cloud",
                                           kStripeExamples, add_stripe_options, run_stripe);
}

}  // namespace brindle::tool
