#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "animation.h"
#include "brindle/base/parallel.h"
#include "command_line.h"
#include "commands.h"
#include "formatted.h"
#include "frame_output.h"
#include "moving_picture.h"
#include "option_values.h"
#include "outputs.h"
#include "picture.h"
#include "progress_display.h"
#include "surface_options.h"
#include "used_files.h"
#include "wave_options.h"
#include "written_files.h"

namespace brindle::tool {
namespace {

constexpr const char* kExamples = R"(Examples:
  brindle animate horse.ply --scene zoom --output zoom.mp4
  brindle animate horse.ply --scene vortices --size 640x480 --output frames/%04d.png
  brindle animate horse.ply --scene zoom --compare-from-scratch --report zoom.json
  brindle animate horse.ply --scene rotate --solver relaxation --iterations 3 --output paper.mp4
  brindle animate horse.ply --scene vortices --device gpu --output gpu.mp4
  brindle animate shape:trefoil --scene brush --frames 150 --output brush.mp4

Scenes: zoom, the frequency grows by 1 % a frame; vortices, two vortex cores orbit the surface;
rotate, the direction turns by 1 degree a frame; wobble, a wave moves the vertices; brush, a stroke
is drawn and a smooth field follows it. Frames are numbered from 0. Without --output the frames are
solved and measured only.)";

struct AnimateArguments {
  SurfaceOptions surface;
  AnimationOptions animation;
  WaveOptions waves;
  DeviceKind device = DeviceKind::cpu;
  int threads = 0;
  int frames_per_second = 30;
  std::shared_ptr<PictureOptions> picture;
  std::optional<FrameOutput> output;
  std::string report;
  bool quiet = false;
};

std::optional<FrameSolver> parse_frame_solver(std::string_view name) {
  if (name == "multilevel") return FrameSolver::multilevel;
  if (name == "relaxation") return FrameSolver::relaxation;
  return std::nullopt;
}

std::optional<PhaseShiftKind> parse_smooth_phase_shift(std::string_view name) {
  const auto kind = parse_phase_shift_kind(name);
  return kind == PhaseShiftKind::common_source ? std::nullopt : kind;
}

void add_scene_options(CLI::App& app, AnimateArguments& arguments) {
  AnimationOptions& animation = arguments.animation;
  add_named_option(app, "--scene", animation.scene.kind, parse_scene_kind,
                   "zoom|vortices|rotate|wobble|brush", "what changes (default zoom)");
  app.add_option("--frames", animation.frames, "how many (default 121: frames 0 to 120)")
      ->type_name("N")
      ->check(CLI::Range(1, 1000000));
  add_direction_option(app, arguments.waves)
      ->description("zoom, rotate, wobble: the global vector (default 0.31,0.9,0.27)");
  add_along_option(app, arguments.waves);
  add_frequency_options(app, arguments.waves);
}

void add_animator_options(CLI::App& app, AnimatorOptions& animator) {
  add_named_option(app, "--solver", animator.solver, parse_frame_solver, "multilevel|relaxation",
                   "multilevel (default), or the paper's iterations from the last frame's phases");
  add_parsed_option(app, "--lambda", animator.lambda, parse_weight,
                    "multilevel: how strongly a frame holds on to the last one; 0: not at all "
                    "(default " +
                        formatted("%g", animator.lambda) + ")")
      ->type_name("L");
  app.add_option("--sweeps", animator.sweeps, "multilevel: sweeps on each level")
      ->type_name("N")
      ->check(CLI::Range(0, 10000));
  app.add_option("--iterations", animator.iterations, "relaxation: iterations a frame (default 3)")
      ->type_name("N")
      ->check(CLI::Range(1, 10000));
  add_named_option(app, "--phase-shift", animator.phase_shift, parse_smooth_phase_shift,
                   "aligned|trapezoid", "distance between two waves");
}

void add_output_options(CLI::App& app, AnimateArguments& arguments) {
  add_parsed_option(app, "-o,--output", arguments.output, parse_frame_output,
                    "one picture a frame, or a video through the ffmpeg program")
      ->type_name("%04d.png|FILE.mp4");
  app.add_option("--fps", arguments.frames_per_second, "video: frames a second (default 30)")
      ->type_name("N")
      ->check(CLI::Range(1, 1000));
  app.add_flag("--compare-from-scratch", arguments.animation.compare_from_scratch,
               "also solve every frame without its last one, and print both");
  app.add_option("--report", arguments.report, "write the figures of all frames here")
      ->type_name("FILE.json");
}

std::vector<std::filesystem::path> files_of(const AnimateArguments& arguments) {
  if (!arguments.output) return {};
  return frame_files(*arguments.output, arguments.animation.frames);
}

void check_outputs(const AnimateArguments& arguments) {
  std::vector<UsedFile> outputs;
  for (const auto& path : files_of(arguments)) outputs.push_back({"--output", path});
  if (!arguments.report.empty()) outputs.push_back({"--report", arguments.report});
  check_files(input_files(arguments.surface, {}), outputs);
  if (arguments.output) {
    check_pictures_available();
    check_frame_output(*arguments.output);
  }
  check_report("--report", arguments.report);
}

// Options that would change nothing.
void check_options(const CLI::App& command, const AnimateArguments& arguments) {
  const AnimationOptions& animation = arguments.animation;
  if (animation.animator.solver == FrameSolver::multilevel) {
    refuse_given(command, {"--iterations"}, "it is for --solver relaxation");
  } else {
    refuse_given(command, {"--lambda"}, "it is for --solver multilevel");
    // Frames from scratch are solved by multilevel.
    if (!animation.compare_from_scratch) {
      refuse_given(command, {"--sweeps"}, "it is for --solver multilevel");
    }
  }
  if (!arguments.output) {
    refuse_picture_options(command, "no picture is written; add --output");
  }
  if (!arguments.output || !arguments.output->is_video()) {
    refuse_given(command, {"--fps"}, "no video is written; add --output FILE.mp4");
  }
  const SceneKind kind = arguments.animation.scene.kind;
  if (arguments.waves.direction && (kind == SceneKind::vortices || kind == SceneKind::brush)) {
    throw CLI::ValidationError(
        "--direction", "the scene '" + std::string(name_of(kind)) + "' has a field of its own");
  }
}

void run(const CLI::App& command, AnimateArguments arguments) {
  refuse_points(arguments.surface, "animate");
  check_options(command, arguments);
  check_outputs(arguments);
  if (is_shape(arguments.surface)) stand_on_z(*arguments.picture);
  const ThreadLimit threads(arguments.threads);
  AnimationReport report;
  {
    ProgressDisplay display(arguments.quiet);
    display.stage("loading " + arguments.surface.mesh);
    LoadedMesh loaded = load_mesh(arguments.surface);
    display.note(describe(loaded));
    const Surface surface = make_surface(std::move(loaded.mesh));
    AnimationOptions& animation = arguments.animation;
    animation.scene.direction = arguments.waves.direction.value_or(animation.scene.direction);
    animation.scene.frequency = constant_frequency(surface.mesh, arguments.waves);
    animation.along = arguments.waves.along;
    const Device device(arguments.device);
    std::optional<MovingPicture> picture;
    ShowFrame show;
    if (arguments.output) {
      picture.emplace(*arguments.output, *arguments.picture, arguments.frames_per_second,
                      !device.has_context());
      show = [&](const SolvedFrame& frame) { picture->add(frame); };
    }
    report = play(surface, animation, device, show, display);
    report.invocation = invocation_of(command);
    device.check_errors("solving on the GPU");
    if (picture) picture->finish();
    if (!arguments.report.empty()) write_json(arguments.report, to_json(report));
  }
  if (arguments.quiet) return;
  print_report(std::cout, report);
  print_written(std::cout, files_of(arguments));
  if (!arguments.report.empty()) print_written(std::cout, std::filesystem::path(arguments.report));
}

void add_options(CLI::App& command, AnimateArguments& arguments) {
  add_surface_options(command, arguments.surface);
  add_scene_options(command, arguments);
  add_animator_options(command, arguments.animation.animator);
  add_device_option(command, arguments.device);
  command.add_option("--threads", arguments.threads, "0: all that the machine has (default)")
      ->type_name("N")
      ->check(CLI::Range(0, 1024));
  add_output_options(command, arguments);
  arguments.picture = add_picture_options(command);
  command.add_flag("-q,--quiet", arguments.quiet, "print nothing but errors");
}

}  // namespace

Command add_animate_command(CLI::App& app) {
  return add_command<AnimateArguments>(app, "animate", "Let stripes follow changing input",
                                       kExamples, add_options, run);
}

}  // namespace brindle::tool
