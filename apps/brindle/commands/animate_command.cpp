#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "brindle/base/parallel.h"
#include "brindle/base/text.h"
#include "brindle/waves/parsed_words.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/option_fields.h"
#include "cli/progress_display.h"
#include "input/solving_options.h"
#include "input/surface_options.h"
#include "input/used_files.h"
#include "input/wave_options.h"
#include "jobs/animation.h"
#include "jobs/moving_picture.h"
#include "jobs/series.h"
#include "jobs/series_player.h"
#include "jobs/styled_frames.h"
#include "outputs/outputs.h"
#include "pictures/frame_output.h"
#include "pictures/picture.h"
#include "pictures/style_options.h"
#include "pictures/texture_options.h"

namespace brindle::tool {
namespace {

constexpr const char* kAnimateExamples = R"(Examples:
  brindle animate horse.ply --scene zoom --output zoom.mp4
  brindle animate horse.ply --scene vortices --size 640x480 --output frames/%04d.png
  brindle animate horse.ply --scene wobble --quality interactive --output draft.mp4
  brindle animate horse.ply --scene zoom --compare-from-scratch --report zoom.json
  brindle animate horse.ply --scene rotate --solver relaxation,iterations=3 --output paper.mp4
  brindle animate horse.ply --scene vortices --device gpu --output gpu.mp4
  brindle animate shape:trefoil --scene brush --frames 150 --output brush.mp4
  brindle animate --series 'v%04d.vtp' --field array:velocity --output out.mp4
  brindle animate --series run.pvd --field array:velocity --output 'out%04d.vtp'
  brindle animate scan.obj --series 'wind%04d.csv' --interpolate 3 --output frames/%04d.png
  brindle animate shape:sphere --scene vortices --texture arrows,flow=1 --output flow.mp4
  brindle animate --series run.pvd --field array:velocity --color-by array:speed --output speed.mp4

A series has one file per step: meshes, or fields (.csv) over MESH. Its stripes stay near to those
of the last step, even if the mesh changes. .vtp outputs come with a .pvd that lists them for
ParaView.

Scenes: zoom, the frequency grows by 1 % per frame; vortices, two vortex cores orbit the surface;
rotate, the direction turns by 1 degree per frame; wobble, a wave moves the vertices; brush, a
stroke is drawn and a smooth field follows it. Frames are numbered from 0. Without --output, frames
are solved and measured only.)";

struct AnimateArguments {
  SurfaceOptions surface;
  AnimationOptions animation;
  WaveOptions waves;
  DeviceKind device = DeviceKind::cpu;
  int threads = 0;
  int frames_per_second = 30;
  PictureOptions picture;
  SeriesOptions series;
  MatchOptions match;
  SlackOptions slack;
  StyleOptions style;
  TextureChoice texture;
  std::vector<FrameOutput> outputs;
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

/// Options of fields and waves for series only, not for scenes.
std::vector<std::string> series_options() {
  const std::set<std::string_view> of_scenes = {"direction", "along", "stripes", "frequency",
                                                "spacing"};
  std::vector<std::string> options;
  for (const OptionInfo& row : option_table()) {
    const bool of_waves =
        row.group == "Field" || (row.group == "Stripes" && has(row.stale, OptionStage::waves));
    if (!row.is_for(PatternJob::animate) || !of_waves || of_scenes.contains(row.name)) continue;
    options.push_back("--" + std::string(row.name));
  }
  return options;
}

void add_scene_options(CLI::App& app, AnimateArguments& arguments) {
  AnimationOptions& animation = arguments.animation;
  add_named_option(app, "--scene", animation.scene.kind, parse_scene_kind);
  app.add_option("--frames", animation.frames);
  add_wave_options(app, arguments.waves);
  add_number_option(app, "--temporal-smoothing", arguments.waves.smoothing.memory);
  describe_options(app, PatternJob::animate);
  for (const std::string& option : series_options()) {
    CLI::Option* added = app.get_option(option);
    added->description("series: " + added->get_description());
  }
}

void add_series_options(CLI::App& app, AnimateArguments& arguments) {
  app.get_option("MESH")->required(false);
  app.add_option("--series", arguments.series.name)->check([](const std::string& name) {
    return std::string(name.empty() ? "expected names of files, got an empty one" : "");
  });
  app.add_option("--interpolate", arguments.series.between);
  add_match_option(app, arguments.match);
}

void add_animator_options(CLI::App& app, AnimatorOptions& animator) {
  add_named_option(app, "--solver", animator.solver, parse_frame_solver);
  add_number_option(app, "--lambda", animator.lambda);
  app.add_option("--sweeps", animator.sweeps);
  app.add_option("--iterations", animator.iterations);
  add_named_option(app, "--phase-shift", animator.phase_shift, parse_smooth_phase_shift);
}

void add_frame_output_options(CLI::App& app, AnimateArguments& arguments) {
  app.add_option_function<std::vector<std::string>>(
         "-o,--output",
         [&arguments](const std::vector<std::string>& texts) {
           for (const std::string& text : texts) {
             arguments.outputs.push_back(parse_frame_output("--output", text));
           }
         })
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);  // what follows is MESH
  app.add_option("--fps", arguments.frames_per_second);
  app.add_flag("--compare-from-scratch", arguments.animation.compare_from_scratch);
  app.add_option("--report", arguments.report);
}

bool is_series(const AnimateArguments& arguments) { return !arguments.series.name.empty(); }

/// Number of frames and steps.
struct Counts {
  std::size_t frames = 0, steps = 0;
};

Counts counts_of(const AnimateArguments& arguments, const std::optional<Series>& series) {
  if (!series) return {static_cast<std::size_t>(arguments.animation.frames), 0};
  const std::size_t steps = series->step_count();
  return {frame_count(arguments.series, steps), steps};
}

std::vector<std::filesystem::path> files_of(const FrameOutput& output, const Counts& counts) {
  return frame_files(output, output.meshes ? counts.steps : counts.frames);
}

bool draws(const AnimateArguments& arguments) {
  return std::ranges::any_of(arguments.outputs,
                             [](const FrameOutput& output) { return !output.meshes; });
}

std::vector<UsedFile> inputs_of(const AnimateArguments& arguments,
                                const std::optional<Series>& series) {
  std::vector<UsedFile> inputs = style_files(arguments.style);
  if (!arguments.texture.tile.empty()) inputs.push_back({"--texture", arguments.texture.tile});
  add_slack_files(arguments.slack, inputs);
  if (!series) {
    for (UsedFile& file : input_files(arguments.surface, {})) inputs.push_back(std::move(file));
    return inputs;
  }
  if (!arguments.surface.mesh.empty()) {
    for (UsedFile& file : input_files(arguments.surface, {})) inputs.push_back(std::move(file));
  }
  for (const TimedFile& step : series->files()) inputs.push_back({"--series", step.file});
  inputs.push_back({"--series", arguments.series.name});
  for (UsedFile& file : field_files(arguments.waves)) inputs.push_back(std::move(file));
  return inputs;
}

void check_outputs(const AnimateArguments& arguments, const std::optional<Series>& series) {
  std::vector<UsedFile> outputs;
  for (const FrameOutput& output : arguments.outputs) {
    for (const auto& path : files_of(output, counts_of(arguments, series))) {
      outputs.push_back({"--output", path});
    }
  }
  if (!arguments.report.empty()) outputs.push_back({"--report", arguments.report});
  check_files(inputs_of(arguments, series), outputs);
  for (const FrameOutput& output : arguments.outputs) check_frame_output(output);
  check_report("--report", arguments.report);
}

void check_series_options(const CLI::App& command, const AnimateArguments& arguments) {
  refuse_given(command, {"--scene", "--frames"}, "the files of --series are what changes");
  if (arguments.device != DeviceKind::cpu) {
    throw CLI::ValidationError("--device", "series are solved on the processor");
  }
  refuse_given(command, {"--avoid-branches"}, "the mesh of a series may change; it is for scenes");
  if (arguments.series.between > 0) {
    refuse_given(command, {"--match"}, "--interpolate interpolates vertices by their number");
  }
  if (!arguments.surface.mesh.empty()) {
    refuse_given(command, {"--field", "--direction"}, "the files of --series are the field");
  }
  WaveOptions waves = arguments.waves;
  if (!arguments.surface.mesh.empty()) waves.field = arguments.series.name;
  check_field_options(command, waves);
}

void check_scene_options(const CLI::App& command, const AnimateArguments& arguments) {
  refuse_given(command, {"--interpolate", "--match"}, "it is for --series");
  refuse_given(command, series_options(), "scenes have fields of their own; add --series");
  if (!arguments.waves.arrays.frequency.empty()) {
    throw CLI::ValidationError("--frequency", "arrays are for --series");
  }
  for (const FrameOutput& output : arguments.outputs) {
    if (output.meshes) {
      throw CLI::ValidationError("--output", "meshes are written of a --series alone");
    }
  }
  const SceneKind kind = arguments.animation.scene.kind;
  if (arguments.waves.direction && (kind == SceneKind::vortices || kind == SceneKind::brush)) {
    throw CLI::ValidationError(
        "--direction", "the scene '" + std::string(name_of(kind)) + "' has a field of its own");
  }
}

void check_styles(const CLI::App& command, const AnimateArguments& arguments) {
  const bool texture = !arguments.texture.tile.empty();
  check_style_options(command, arguments.style, drawn_by(arguments.texture, texture));
  check_light_option(command, arguments.style, arguments.waves);
  const auto refuse = [&](const char* why) {
    refuse_style_options(command, why);
    refuse_given(command, {"--texture", "--tiles"}, why);
  };
  if (!draws(arguments)) refuse("no picture is written; add --output");
  if (!shows_stripes(arguments.picture)) refuse("--view has colours of its own");
  if (texture) {
    refuse_given(command, {"--stripe-width"}, "the texture's tile is drawn as it is");
  }
}

// Rejects options without effect.
void check_options(const CLI::App& command, const AnimateArguments& arguments) {
  const AnimationOptions& animation = arguments.animation;
  if (animation.animator.solver == FrameSolver::multilevel) {
    refuse_given(command, {"--iterations"}, "it is for --solver relaxation");
  } else {
    refuse_given(command, {"--lambda"}, "it is for --solver multilevel");
    // Frames from scratch use multilevel.
    if (!animation.compare_from_scratch) {
      refuse_given(command, {"--sweeps"}, "it is for --solver multilevel");
    }
  }
  if (!draws(arguments)) {
    refuse_picture_options(command, arguments.waves, "no picture is written; add --output");
  }
  check_styles(command, arguments);
  // Textures flow at a speed per second.
  if (std::ranges::none_of(arguments.outputs, &FrameOutput::is_video) &&
      arguments.style.texture_flow.isZero(0)) {
    refuse_given(command, {"--fps"}, "no video is written; add --output FILE.mp4");
  }
  check_slack_options(command, arguments.slack);
  is_series(arguments) ? check_series_options(command, arguments)
                       : check_scene_options(command, arguments);
}

AnimationReport play_scene(const AnimateArguments& arguments, const Device& device,
                           const ShowFrame& show, ProgressDisplay& display) {
  std::vector<JobStage> stages = preparation_stages(arguments.surface);
  stages.back() = {"frames", 2 + 0.5 * arguments.animation.frames};  // scenes make fields
  display.plan(std::move(stages));
  const Preparation prepared = prepare_surface(arguments.surface, display);
  const Surface& surface = prepared.surface;
  AnimationOptions animation = arguments.animation;
  animation.scene.direction = arguments.waves.direction.value_or(animation.scene.direction);
  animation.scene.frequency = constant_frequency(surface.mesh, arguments.waves);
  animation.along = arguments.waves.along;
  animation.subdivided = arguments.surface.subdivide;
  animation.animator.slack = make_slack(arguments.slack, surface, prepared.vertex_of_row);
  const FrameData data{surface, prepared.arrays, arguments.surface.mesh, prepared.vertex_of_row};
  display.stage("frames");
  return play(data, animation, device, show, display);
}

/// Whether smooth fields follow the last frame, as phases do.
SeriesFields smooth_fields(const AnimateArguments& arguments) {
  const AnimatorOptions& animator = arguments.animation.animator;
  const bool follow = animator.solver == FrameSolver::relaxation || animator.lambda > 0;
  return {follow, arguments.animation.compare_from_scratch, arguments.match};
}

std::vector<FrameOutput> of_kind(const std::vector<FrameOutput>& outputs, bool meshes) {
  std::vector<FrameOutput> result;
  std::ranges::copy_if(outputs, std::back_inserter(result),
                       [&](const FrameOutput& output) { return output.meshes == meshes; });
  return result;
}

AnimationReport play_series(const AnimateArguments& arguments, Series& series,
                            const ShowFrame& show, ProgressDisplay& display) {
  StepFiles files(of_kind(arguments.outputs, true), arguments.animation.animator.phase_shift,
                  arguments.picture, display);
  AnimatorOptions animator = arguments.animation.animator;
  animator.slack = arguments.slack.slack;
  const SeriesPlay options{arguments.series, animator, arguments.match,
                           arguments.animation.compare_from_scratch};
  AnimationReport report = play(
      series, options, show,
      [&](const SeriesStep& step, const SolvedFrame& solved) { files.add(step, solved); }, display);
  files.finish();
  return report;
}

// Empty if frames are drawn without a style.
std::optional<FrameStyle> frame_style(const CLI::App& command, const AnimateArguments& arguments,
                                      ProgressDisplay& display) {
  std::optional<TextureTile> tile = chosen_tile(arguments.texture, false);
  if (!tile && !is_styled(command)) return std::nullopt;
  return FrameStyle{.style = arguments.style,
                    .tile = std::move(tile),
                    .oriented = arguments.waves.oriented,
                    .whole_tiles = arguments.texture.whole,
                    .waves = arguments.waves,
                    .animator = arguments.animation.animator,
                    .match = arguments.match,
                    .frames_per_second = arguments.frames_per_second,
                    .display = display};
}

/// Warnings of frames, which are printed for the first such frame; of those in which the slice
/// leaves nothing the number, too.
class FrameWarnings {
 public:
  void note(const FrameNotes& notes, JobListener& listener) {
    if (!notes.nothing_left.empty() && empty_++ == 0) {
      listener.note("warning: frame " + std::to_string(frames_) + ": " + notes.nothing_left);
    }
    if (!notes.few_tiles.empty() && !std::exchange(had_few_tiles_, true)) {
      listener.note(notes.few_tiles);
    }
    ++frames_;
  }

  void say(JobListener& listener) const {
    if (empty_ < 2) return;
    listener.note("warning: nothing of the surface is seen in " + std::to_string(empty_) + " of " +
                  std::to_string(frames_) + " frames");
  }

 private:
  std::size_t frames_ = 0, empty_ = 0;
  bool had_few_tiles_ = false;
};

void run_animate(const CLI::App& command, AnimateArguments arguments) {
  if (!is_series(arguments)) refuse_points(arguments.surface, "animate");
  check_options(command, arguments);
  stand_upright(arguments.picture,
                arguments.surface.mesh.empty() ? arguments.series.name : arguments.surface.mesh);
  std::optional<Series> series;
  if (is_series(arguments)) {
    series.emplace(arguments.series, arguments.surface, arguments.waves, smooth_fields(arguments),
                   viewpoint_of(arguments.picture));
  }
  check_outputs(arguments, series);
  const ThreadLimit threads(arguments.threads);
  AnimationReport report;
  {
    ProgressDisplay display(arguments.quiet, &command);
    const Device device(arguments.device);
    const std::optional<FrameStyle> style = frame_style(command, arguments, display);
    std::optional<MovingPicture> picture;
    FrameWarnings warnings;
    ShowFrame show;
    if (draws(arguments)) {
      picture.emplace(of_kind(arguments.outputs, false), arguments.picture,
                      arguments.frames_per_second, !device.has_context(),
                      style ? &*style : nullptr);
      show = [&](const SolvedFrame& frame) { warnings.note(picture->add(frame), display); };
    }
    report = series ? play_series(arguments, *series, show, display)
                    : play_scene(arguments, device, show, display);
    report.invocation = invocation_of(command);
    if (picture) report.picture = picture_json(arguments.picture);
    // One output stands for itself, as it did before there could be several.
    auto& options = report.invocation["options"];
    if (arguments.outputs.size() == 1) options["output"] = nlohmann::json(options["output"][0]);
    device.check_errors("solving on the GPU");
    if (picture) picture->finish();
    warnings.say(display);
    if (!arguments.report.empty()) {
      write_json(arguments.report, to_json(report), display.progress());
    }
  }
  if (arguments.quiet) return;
  print_report(std::cout, report);
  for (const FrameOutput& output : arguments.outputs) {
    std::vector<std::filesystem::path> files = files_of(output, counts_of(arguments, series));
    if (output.meshes) files.pop_back();  // the collection, of which there is one
    print_written(std::cout, files);
    if (output.meshes) print_written(std::cout, collection_path(output));
  }
  if (!arguments.report.empty()) print_written(std::cout, std::filesystem::path(arguments.report));
}

void add_animate_options(CLI::App& command, AnimateArguments& arguments) {
  add_surface_options(command, arguments.surface);
  add_scene_options(command, arguments);
  add_series_options(command, arguments);
  add_animator_options(command, arguments.animation.animator);
  add_fields(command, arguments.slack);
  add_field(command, "--device", arguments.device);
  command.add_option("--threads", arguments.threads);
  add_frame_output_options(command, arguments);
  add_picture_options(command, arguments.picture);
  add_style_options(command, arguments.style);
  add_flow_option(command, arguments.style);
  add_texture_options(command, arguments.texture, arguments.waves);
  command.add_flag("-q,--quiet", arguments.quiet);
}

}  // namespace

Command add_animate_command(CLI::App& app) {
  return add_command<AnimateArguments>(app, "animate", "Let stripes follow changing input",
                                       kAnimateExamples, add_animate_options, run_animate);
}

}  // namespace brindle::tool
