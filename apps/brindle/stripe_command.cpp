#include <iostream>
#include <memory>

#include "brindle/base/parallel.h"
#include "commands.h"
#include "outputs.h"
#include "picture.h"
#include "preparation.h"
#include "report.h"
#include "solving_options.h"

namespace brindle::tool {
namespace {

constexpr const char* kExamples = R"(Examples:
  brindle stripe shape:torus --output torus.png
  brindle stripe horse.ply --direction 0.31,0.9,0.27 --stripes 40 --output horse.png
  brindle stripe scan.obj --field curvature --rotate 90 --output scan.glb --report scan.json
  brindle stripe scan.obj --field wind.csv --frequency 12 --output wind.png
  brindle stripe shape:torus,resolution=64,noise=0.2 --view branches --output branches.png

Files by extension: .png a picture; .ply .vtp .gltf .glb a mesh with phase (radians), direction,
frequency and branch (1 at the corners of triangles where a stripe begins or ends) at every vertex;
.obj the mesh alone; .json a report.)";

struct StripeArguments {
  SurfaceOptions surface;
  WaveOptions waves;
  SolvingOptions solving;
  std::shared_ptr<PictureOptions> picture;
  std::vector<std::string> outputs;
  std::string report;
  bool quiet = false;
};

void run(const StripeArguments& arguments) {
  std::vector<Output> outputs = plan_outputs(arguments.outputs);
  if (is_shape(arguments.surface)) stand_on_z(*arguments.picture);
  if (!arguments.report.empty()) outputs.push_back(plan_report(arguments.report));

  const ThreadLimit threads(arguments.solving.threads);
  Report report;
  {
    ProgressDisplay display(arguments.quiet);
    Preparation prepared = prepare(arguments.surface, arguments.waves, display);
    const StripePattern pattern = stripe_pattern(prepared.surface, std::move(prepared.waves),
                                                 arguments.solving.stripes, display.progress());
    report = make_report(prepared, pattern, arguments.solving.stripes.solver.solver);
    for (const Output& output : outputs) {
      display.stage("writing " + output.path.string());
      write_output(output, prepared.surface, pattern, report, *arguments.picture);
    }
  }
  if (!arguments.quiet) print_report(std::cout, report);
}

}  // namespace

Command add_stripe_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("stripe", "Lay stripes over a surface");
  command->footer(kExamples);
  const auto arguments = std::make_shared<StripeArguments>();
  add_surface_options(*command, arguments->surface);
  add_wave_options(*command, arguments->waves);
  add_solver_option(*command, arguments->solving);
  add_solving_options(*command, arguments->solving);
  add_output_options(*command, arguments->outputs, arguments->report, arguments->quiet);
  arguments->picture = add_picture_options(*command);
  return {command, [arguments] { run(*arguments); }};
}

}  // namespace brindle::tool
