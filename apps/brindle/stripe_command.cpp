#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <utility>

#include "brindle/base/parallel.h"
#include "brindle/base/stopwatch.h"
#include "brindle/cross_texture.h"
#include "brindle/error.h"
#include "carried_pattern.h"
#include "command_line.h"
#include "commands.h"
#include "device.h"
#include "formatted.h"
#include "option_values.h"
#include "outputs.h"
#include "picture.h"
#include "preparation.h"
#include "report.h"
#include "solving_options.h"
#include "texture_options.h"
#include "written_files.h"

namespace brindle::tool {
namespace {

constexpr const char* kExamples =
    R"(Stripes run ACROSS the direction: a wave runs along it, and stripes are the wave's crests. --along
turns them.

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
  brindle stripe scan.obj --cross --texture plus --output crosses.png
  brindle stripe points.csv --output points.png --output points.ply
  brindle stripe scan.obj --field wind.csv --oriented --texture arrows --output wind.png
  brindle stripe scan.obj --uv --output scan.vtp --output scan.ply
  brindle stripe scan.obj --texture cloth.png --stripes 20 --stripes-v 30 --output cloth.glb
  brindle stripe step2.vtp --field array:velocity --previous step1_stripes.vtp --output step2.png
  brindle stripe flow.vtp --field array:velocity --frequency-by array:speed --output flow.png
  brindle stripe plate.vtp --field array:stress --tensor minor --output plate.png
  brindle stripe scan.obj --field array:velocity --field-mesh flow.vtp --output scan.png

Files by extension: .png a picture; .ply .vtp .gltf .glb a mesh with phase (radians; not a number
where there is no wave, and valid is 0), its sine, which is 1 on the crests, direction, frequency,
branch (1 at the corners of triangles where a stripe begins or ends) and original_id (the number in
MESH) at every vertex, and all arrays that MESH has; .obj the mesh alone; .json a report. With
--texture, meshes have texture coordinates and show the tile: .gltf and .glb hold it, others have it
beside them; --uv gives coordinates alone.)";

struct StripeArguments {
  SurfaceOptions surface;
  WaveOptions waves;
  SolvingOptions solving;
  DeviceKind device = DeviceKind::cpu;
  std::string previous;  ///< file of the pattern to stay near to; empty: none
  MatchOptions match;
  TextureChoice texture;
  std::shared_ptr<PictureOptions> picture;
  bool uv = false;
  std::vector<std::string> outputs;
  std::string report;
  bool quiet = false;
};

Texture make_texture(Preparation& prepared, const StripeArguments& arguments, TextureTile tile,
                     const Progress& progress) {
  const TextureOptions options{std::move(prepared.frequencies_v), arguments.texture.oriented,
                               arguments.solving.stripes};
  return {texture_pattern(prepared.surface, std::move(prepared.waves), options, progress),
          std::move(tile)};
}

StripeResult make_result(Preparation& prepared, const StripeArguments& arguments,
                         std::optional<TextureTile> tile, const Progress& progress) {
  if (tile) return {make_texture(prepared, arguments, std::move(*tile), progress)};
  return {stripe_pattern(prepared.surface, std::move(prepared.waves), arguments.solving.stripes,
                         progress)};
}

// What was made, on the surface that it is drawn on, and its report.
struct Job {
  Surface surface;
  StripeResult result;
  Report report;
  InputData data;
};

Job make_cross(Preparation prepared, const StripeArguments& arguments, TextureTile tile,
               const Progress& progress) {
  const StripeOptions& options = arguments.solving.stripes;
  const CrossPattern cross = cross_pattern(prepared.surface, prepared.waves, options, progress);
  CrossTexture texture = cross_texture(prepared.surface, cross, options.phase_shift);
  const Report report = make_report(prepared, texture, options.solver.solver);
  InputData data =
      on_cross_texture(take_input_data(prepared), prepared.surface.mesh.triangles, cross.cover);
  return {std::move(texture.surface),
          {Texture{std::move(texture.pattern), std::move(tile)}},
          report,
          std::move(data)};
}

Job make_job(Preparation prepared, const StripeArguments& arguments,
             std::optional<TextureTile> tile, const Progress& progress) {
  if (arguments.waves.cross) {
    return make_cross(std::move(prepared), arguments, tile.value_or(BuiltInTile::checker),
                      progress);
  }
  StripeResult result = make_result(prepared, arguments, std::move(tile), progress);
  const Solver solver = arguments.solving.stripes.solver.solver;
  const Report report = result.texture() != nullptr
                            ? make_report(prepared, result.texture()->pattern, solver)
                            : make_report(prepared, result.stripes(), solver);
  InputData data = take_input_data(prepared);
  return {std::move(prepared.surface), std::move(result), report, std::move(data)};
}

// What cannot be laid over points or shown of crosses: better said before a long job.
void check_points(const CLI::App& command, const StripeArguments& arguments,
                  const std::vector<Output>& outputs) {
  const auto refuse = [](const std::string& option, const std::string& what) {
    throw CLI::ValidationError(option, "points have no triangles: " + what);
  };
  if (arguments.waves.cross) {
    refuse("--cross", "a cross field is drawn on meshes alone; leave out --cross");
  }
  if (!arguments.texture.tile.empty()) {
    refuse("--texture", "a texture is drawn on meshes alone; leave out --texture");
  }
  if (!shows_stripes(*arguments.picture)) {
    refuse("--view", "branches and angle errors are not drawn; take --view stripes");
  }
  for (const Output& output : outputs) {
    if (output.kind == OutputKind::mesh && !holds_points(output.path)) {
      refuse("--output", "'" + output.path.string() + "' cannot hold them; write .ply or .vtp");
    }
  }
  refuse_given(command, {"--uv"}, "points have no triangles, and so no texture coordinates");
  refuse_triangle_options(command);
}

void check_cross(const StripeArguments& arguments, const std::vector<Output>& outputs) {
  if (!shows_stripes(*arguments.picture)) {
    throw CLI::ValidationError(
        "--view", "of a cross field, branches and angle errors are not drawn; take --view stripes");
  }
  // The tile goes along with every mesh.
  for (const Output& output : outputs) {
    if (output.kind == OutputKind::mesh) check_pictures_available();
  }
}

// The phases of the pattern that this one stays near to.
CarriedPattern carried_pattern(const StripeArguments& arguments, const Preparation& prepared) {
  const Follower follower{arguments.surface.mesh, prepared.surface.mesh, prepared.waves,
                          prepared.arrays.points};
  return carry(read_pattern(arguments.previous), follower, arguments.match);
}

FollowedReport followed_report(const StripeArguments& arguments, const CarriedPattern& carried,
                               const StripePattern& pattern) {
  const PhaseStep step = phase_step(pattern.waves, pattern.solution.z, carried.z);
  return {arguments.previous, arguments.solving.stripes.lambda, carried.matched_by,
          carried.unmatched, step.mean};
}

/// Solves on the device, which is given back before anything is drawn.
Job solve(StripeArguments arguments, Preparation prepared, std::optional<TextureTile> tile,
          const Progress& progress) {
  std::optional<CarriedPattern> carried;
  if (!arguments.previous.empty()) {
    progress.report("reading " + arguments.previous, 0);
    carried = carried_pattern(arguments, prepared);
    arguments.solving.stripes.last_phases = carried->z;
  }
  const Device device(arguments.device);
  arguments.solving.stripes.solve = device.solver();
  Job job = make_job(std::move(prepared), arguments, std::move(tile), progress);
  job.report.device = device.description();
  if (carried) job.report.followed = followed_report(arguments, *carried, job.result.stripes());
  return job;
}

bool has(const std::vector<Output>& outputs, OutputKind kind) {
  return std::any_of(outputs.begin(), outputs.end(),
                     [kind](const Output& output) { return output.kind == kind; });
}

void check_previous(const CLI::App& command, const StripeArguments& arguments, bool texture) {
  if (arguments.previous.empty()) {
    refuse_given(command, {"--lambda", "--match"}, "no pattern is followed; add --previous FILE");
    return;
  }
  if (texture) {
    refuse_given(command, {"--previous"}, "it is for stripes, not for textures and cross fields");
  }
  if (arguments.solving.stripes.solver.solver != Solver::multilevel) {
    refuse_given(command, {"--previous"}, "it is for --solver multilevel");
  }
}

// Options that would change nothing.
void check_options(const CLI::App& command, const StripeArguments& arguments,
                   const std::vector<Output>& outputs, bool texture) {
  check_field_options(command, arguments.waves);
  check_solving_options(command, arguments.solving);
  check_previous(command, arguments, texture);
  const std::string no_picture = "no picture is written; add --output FILE.png";
  if (!has(outputs, OutputKind::picture)) {
    refuse_given(command, {"--camera", "--up", "--size", "--view", "--stripe-width"}, no_picture);
    // Meshes carry the tile in these colours.
    if (!texture || !has(outputs, OutputKind::mesh)) {
      refuse_given(command, {"--colors"}, no_picture);
    }
  }
  if (texture) {
    refuse_given(command, {"--stripe-width"}, "the texture's tile is drawn as it is");
    refuse_given(command, {"--uv"}, "meshes with a texture have coordinates anyway");
  }
  if (!has(outputs, OutputKind::mesh)) {
    refuse_given(command, {"--uv"},
                 "no mesh is written; add --output FILE.vtp, .ply, .glb or .obj");
  }
}

std::vector<UsedFile> inputs_of(const StripeArguments& arguments) {
  std::vector<UsedFile> inputs = input_files(arguments.surface, arguments.waves);
  if (!arguments.texture.tile.empty()) inputs.push_back({"--texture", arguments.texture.tile});
  if (!arguments.previous.empty()) inputs.push_back({"--previous", arguments.previous});
  return inputs;
}

// Everything that can be said before a long job.
std::vector<Output> checked_outputs(const CLI::App& command, const StripeArguments& arguments) {
  const bool texture = !arguments.texture.tile.empty() || arguments.waves.cross;
  std::vector<Output> outputs = plan_outputs(arguments.outputs, arguments.report, texture);
  check_files(inputs_of(arguments), files_of(outputs, texture));
  check_options(command, arguments, outputs, texture);
  if (arguments.waves.cross) check_cross(arguments, outputs);
  if (is_points(arguments.surface)) check_points(command, arguments, outputs);
  return outputs;
}

void write_outputs(const std::vector<Output>& outputs, Job& job, const StripeArguments& arguments,
                   ProgressDisplay& display) {
  const MadeMesh made{job.surface, job.result, job.data, arguments.solving.stripes.phase_shift,
                      arguments.uv};
  for (const Output& output : outputs) {
    display.stage("writing " + output.path.string());
    Stopwatch watch;
    write_output(output, made, job.report, *arguments.picture, display);
    if (output.kind == OutputKind::picture) {
      job.report.draw_milliseconds = job.report.draw_milliseconds.value_or(0) + watch.lap();
    }
  }
}

void run(const CLI::App& command, const StripeArguments& arguments) {
  check_solver(arguments.device, arguments.solving.stripes.solver);
  std::optional<TextureTile> tile = chosen_tile(arguments.texture, arguments.waves.cross);
  const std::vector<Output> outputs = checked_outputs(command, arguments);
  if (is_shape(arguments.surface)) stand_on_z(*arguments.picture);

  const ThreadLimit threads(arguments.solving.threads);
  const bool texture = tile.has_value() || arguments.waves.cross;
  Report report;
  {
    ProgressDisplay display(arguments.quiet);
    Preparation prepared = prepare(arguments.surface, arguments.waves, display);
    Job job = solve(arguments, std::move(prepared), std::move(tile), display.progress());
    job.report.invocation = invocation_of(command);
    display.note(
        branch_warning(job.report.waves, job.report.quality.branches, job.report.triangles));
    write_outputs(outputs, job, arguments, display);
    report = job.report;
  }
  if (arguments.quiet) return;
  print_report(std::cout, report);
  for (const UsedFile& file : files_of(outputs, texture)) print_written(std::cout, file.path);
}

void add_previous_options(CLI::App& command, StripeArguments& arguments) {
  StripeOptions& stripes = arguments.solving.stripes;
  command
      .add_option("--previous", arguments.previous,
                  "stay near to the stripes of this file, which an earlier run has written (.vtp, "
                  ".ply): one step of a time series at a time")
      ->type_name("FILE");
  add_parsed_option(
      command, "--lambda", stripes.lambda, parse_weight,
      "--previous: how near; 0: not at all (default " + formatted("%g", stripes.lambda) + ")")
      ->type_name("L");
  add_match_option(command, arguments.match);
}

void add_options(CLI::App& command, StripeArguments& arguments) {
  add_surface_options(command, arguments.surface);
  add_point_options(command, arguments.surface);
  add_wave_options(command, arguments.waves);
  CLI::Option* cross = add_cross_option(command, arguments.waves);
  add_solver_option(command, arguments.solving);
  add_solving_options(command, arguments.solving);
  add_device_option(command, arguments.device);
  add_previous_options(command, arguments);
  add_texture_options(command, arguments.texture, arguments.waves, cross);
  command.add_flag("--uv", arguments.uv,
                   "meshes with texture coordinates: U across the stripes, one unit a period; "
                   "vertices are split where it needs that (original_id: their number in MESH)");
  add_output_options(command, arguments.outputs, arguments.report, arguments.quiet);
  arguments.picture = add_picture_options(command);
}

}  // namespace

Command add_stripe_command(CLI::App& app) {
  return add_command<StripeArguments>(app, "stripe", "Lay stripes over a surface or a point cloud",
                                      kExamples, add_options, run);
}

}  // namespace brindle::tool
