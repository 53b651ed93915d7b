#include <iostream>

#include "brindle/base/file_names.h"
#include "brindle/base/output_file.h"
#include "brindle/base/parallel.h"
#include "brindle/files.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "jobs/relief_job.h"

namespace brindle::tool {
namespace {

constexpr const char* kReliefExamples = R"(Examples:
  brindle relief shape:bracket --texture knurl --height 1% --spacing 4% --output knurled.stl
  brindle relief scan.obj --texture bricks --height 0.02 --spacing 10% --output walls.3mf
  brindle relief scan.obj --texture weave --height 1% --spacing 8% --keep-flat --output grip.stl
  brindle relief scan.obj --texture cloth.png --height 1% --spacing 30% --only z@30 --output top.stl
  brindle relief scan.obj --texture stripes --height 0.2% --spacing 10% --inlay 1% --output inlay.3mf
  brindle relief scan.obj --texture dots --height 1% --spacing 10% --cut --output lamp.stl)";

OutputKind planned_relief(const std::filesystem::path& path) {
  check_output_path(path);
  const std::string extension = lower_extension(path);
  if (extension == ".json") return OutputKind::report;
  for (const char* mesh : {".stl", ".3mf", ".ply", ".obj", ".vtp", ".gltf", ".glb"}) {
    if (extension == mesh) return OutputKind::mesh;
  }
  refuse_output(path, "unknown extension '" + extension +
                          "'; use .stl, .3mf, .ply, .obj, .vtp, .gltf or .glb for a mesh, .json "
                          "for a report");
}

void run_relief(const CLI::App& command, const ReliefArguments& arguments) {
  const StripeArguments& pattern = arguments.pattern;
  const Outputs outputs =
      plan_outputs(relief_inputs(arguments), pattern.outputs, pattern.report, planned_relief);
  check_relief_options(command, arguments);
  refuse_points(pattern.surface, "relief");
  const ThreadLimit threads(pattern.solving.threads);
  const ReliefJob job = make_and_write(
      command, outputs, pattern.quiet, relief_stages(arguments),
      [&](ProgressDisplay& display) { return make_relief_job(arguments, display); },
      [&](const Output& output, const ReliefJob& made, ProgressDisplay& display) {
        const Mesh& mesh = made.relief.mesh;
        if (output.kind == OutputKind::mesh) {
          return write_mesh(output.path, mesh, {}, {}, display.progress());
        }
        write_report(output.path, command, mesh, to_json(made), display.progress());
      });
  if (pattern.quiet) return;
  print(std::cout, job);
  print_written(std::cout, outputs);
}

}  // namespace

Command add_relief_command(CLI::App& app) {
  return add_command<ReliefArguments>(app, "relief", "Raise a texture from a surface, for printing",
                                      kReliefExamples, add_relief_options, run_relief);
}

}  // namespace brindle::tool
