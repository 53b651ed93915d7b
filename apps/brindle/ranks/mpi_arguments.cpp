#include "ranks/mpi_arguments.h"

#include <filesystem>
#include <utility>

#include "brindle/base/file_names.h"
#include "cli/command_line.h"
#include "ranks/pvtp_pieces.h"
#include "ranks/request.h"

namespace brindle::tool {
namespace {

constexpr const char* kForOneProcess =
    "it needs the whole surface in one process; start 'brindle stripe' without mpirun";

}  // namespace

void add_bounds_options(CLI::App& command, std::size_t& plan_below) {
  command
      .add_option("--plan-below", plan_below,
                  "solve smaller surfaces, in vertices, on rank 0, as one process does")
      ->type_name("N")
      ->capture_default_str();
}

void add_mpi_options(CLI::App& command, MpiArguments& arguments) {
  add_surface_options(command, arguments.surface);
  add_wave_options(command, arguments.waves);
  add_solving_options(command, arguments.solving);
  add_bounds_options(command, arguments.plan_below);
  command
      .add_option("-o,--output", arguments.output,
                  "the mesh with its phases: a .pvtp that names one .vtp per rank")
      ->type_name("FILE.pvtp");
  command.add_option("--report", arguments.report, "write the report here")->type_name("FILE.json");
  command
      .add_option("--frames", arguments.frames,
                  "then measure N frames, each turned by a degree; no files have them")
      ->type_name("N")
      ->check(CLI::Range(0, 10000));
  command.add_flag("-q,--quiet", arguments.quiet, "print nothing but errors");
  // Known, to be rejected with a reason.
  for (const char* flag : {"--uv", "--cross"}) command.add_flag(flag)->group("");
  for (const char* option : {"--texture", "--previous"}) command.add_option(option)->group("");
}

namespace {

void check_extension(const std::string& option, const std::string& path, const char* extension) {
  if (path.empty() || lower_extension(path) == extension) return;
  throw CLI::ValidationError(option, "'" + path + "': the name must end in " + extension);
}

}  // namespace

void check_mpi_waves(const CLI::App& command, const WaveOptions& waves,
                     const SolvingOptions& solving) {
  refuse_given(command, {"--rounded"}, kForOneProcess);
  check_field_options(command, waves);
  check_solving_options(command, solving);
  if (solving.stripes.phase_shift == PhaseShiftKind::common_source) {
    throw CLI::ValidationError("--phase-shift",
                               "common_source is for one process; take aligned or trapezoid");
  }
}

void check_mpi_options(const CLI::App& command, const MpiArguments& arguments) {
  refuse_given(command, {"--uv", "--cross", "--texture", "--previous"}, kForOneProcess);
  check_mpi_waves(command, arguments.waves, arguments.solving);
  check_extension("--output", arguments.output, ".pvtp");
  if (!arguments.output.empty()) check_name_in_xml(arguments.output);
  check_extension("--report", arguments.report, ".json");
}

std::vector<UsedFile> mpi_inputs(Communicator& ranks, const SurfaceOptions& surface,
                                 const WaveOptions& waves, const SolvingOptions& solving) {
  std::vector<UsedFile> inputs = input_files(surface, waves);
  if (is_pvtp(surface.mesh)) {
    for (UsedFile& file : files_of_pvtp(ranks, surface.mesh)) inputs.push_back(std::move(file));
  }
  // Every rank reads these completely.
  std::vector<std::filesystem::path> of_all;
  for (const UsedFile& file : inputs) {
    if (file.option == "--field-mesh") of_all.push_back(file.path);
  }
  check_same_files(ranks, of_all);
  add_slack_files(solving.slack, inputs);
  return inputs;
}

}  // namespace brindle::tool
