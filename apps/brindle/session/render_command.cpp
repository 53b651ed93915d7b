#include <algorithm>
#include <array>
#include <iostream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "brindle/base/file_names.h"
#include "brindle/base/output_file.h"
#include "brindle/base/stopwatch.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/threads.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/option_values.h"
#include "cli/progress_display.h"
#include "jobs/curves_output.h"
#include "outputs/written_files.h"
#include "pictures/drawing_file.h"
#include "pictures/picture_options.h"
#include "session/session.h"
#include "session/session_export.h"

namespace brindle::tool {
namespace {

constexpr const char* kRenderExamples =
    R"(The window saves sessions: a surface, options, strokes, a camera. The picture is the one that
the window shows when it rests, bit for bit.

Examples:
  brindle render session.json --output horse.png
  brindle render session.json --size 3840x2160 --output large.png
  brindle render session.json --size 3840x2160 --transparent --dpi 300 --output print.png
  brindle render session.json --output horse.svg
  brindle render session.json --replay events.jsonl --output after.png
  brindle render session.json --output horse.vtp --output horse_report.json

Outputs: .png the picture; .svg or .pdf a drawing of stripes or curves; .ply .vtp .obj .gltf .glb a
mesh and .json a report, as from 'brindle stripe'. If a session shows curves or samples, all but
.json are as from 'brindle curves' or 'brindle sample'. --replay runs commands first, one per line,
as docs/sessions.md lists them.)";

struct RenderArguments {
  std::string session;
  std::vector<std::string> outputs;
  std::string replay;
  std::shared_ptr<PictureOptions> picture;  ///< --size and --quality alone
  PictureChanges changes;                   ///< except for the size
  int threads = 0;
  bool quiet = false;
};

void add_render_options(CLI::App& command, RenderArguments& arguments) {
  command.add_option("SESSION", arguments.session, "a session's file (.json)")->required();
  command.add_option("-o,--output", arguments.outputs, "files to write, by extension; repeatable")
      ->type_name("FILE")
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false)
      ->required()
      ->group("Output");
  command.add_option("--replay", arguments.replay, "commands to run first, one per line")
      ->type_name("FILE.jsonl");
  arguments.picture = add_size_options(command);
  command
      .add_flag("--scale-widths", arguments.changes.scaled_widths,
                "scale widths in pixels with --size")
      ->needs("--size");
  command
      .add_option("--dpi", arguments.changes.dpi, "pixels per inch, stored in PNG files for print")
      ->type_name("D")
      ->check(CLI::Range(1.0, 1e6));
  command.add_flag("--transparent", arguments.changes.transparent,
                   "no background, whatever the session has");
  command.add_option("--threads", arguments.threads, "number of threads (default 0: all)")
      ->type_name("N")
      ->check(CLI::Range(0, 1024));
  command.add_flag("-q,--quiet", arguments.quiet, "print nothing but errors");
}

bool is_picture(const std::string& path) {
  return lower_extension(path) == ".png" || is_drawing_file(path);
}

/// Accepts the files of `brindle stripe` except for drawings.
void refuse_unknown_extension(const std::string& path) {
  constexpr std::array kKnown = {".obj", ".ply", ".vtp", ".gltf", ".glb", ".stl", ".off", ".json"};
  const std::string extension = lower_extension(path);
  if (std::ranges::find(kKnown, extension) != kKnown.end()) return;
  refuse_output(path,
                "unknown extension '" + extension +
                    "'; use .png for a picture, .svg or .pdf for a drawing, .obj, .ply, .vtp, "
                    ".gltf or .glb for a mesh, .json for a report");
}

/// Checks other files than pictures: a mesh or a report of stripes, or files of curves and samples.
void check_file(const std::string& path, const ParsedSession& parsed) {
  const bool report = lower_extension(path) == ".json";
  if (parsed.curves() != nullptr && !report) {
    planned_curves(path, parsed.curves()->tube_radius.has_value());
  } else if (parsed.samples() != nullptr && !report) {
    planned_sample(path);
  } else {
    refuse_unknown_extension(path);
    plan_outputs({path}, "", false);
  }
}

void check_outputs(const CLI::App& command, const RenderArguments& arguments,
                   const ParsedSession& parsed) {
  std::vector<std::filesystem::path> pictures;
  for (const std::string& path : arguments.outputs) {
    if (!is_picture(path)) {
      check_file(path, parsed);
      continue;
    }
    pictures.emplace_back(path);
    check_output_path(path);
  }
  if (pictures.empty()) {
    return refuse_given(command,
                        {"--size", "--quality", "--scale-widths", "--transparent", "--dpi"},
                        "no picture is written; add --output FILE.png");
  }
  check_picture_files(parsed, pictures);
  if (std::ranges::all_of(pictures, is_drawing_file)) {
    refuse_given(command, {"--quality", "--dpi"}, "it is for pixels; add --output FILE.png");
  }
}

/// Runs the file's commands until the first one that is rejected.
void replay(Session& session, const std::string& path) {
  std::size_t number = 0;
  for (const SessionCommand& command : read_commands(path)) {
    ++number;
    const std::size_t messages = session.messages().size();
    const bool keeps = std::holds_alternative<commands::KeepPhases>(command);
    if (session.apply(command) || keeps) continue;
    const std::string why = session.messages().size() > messages
                                ? session.messages().back().text
                                : std::string("there is nothing to do");
    throw Error(shown(path) + ": command " + std::to_string(number) + ", " +
                std::string(command_name(command)) + ": " + why);
  }
  session.end_drag();
}

SessionDocument document_of(const CLI::App& command, const RenderArguments& arguments) {
  Session session(read_session(arguments.session));
  if (!arguments.replay.empty()) replay(session, arguments.replay);
  const RenderOptions& render = arguments.picture->render;
  PictureChanges changes = arguments.changes;
  if (is_given(command, "--size")) changes.size = {render.width, render.height};
  return with_changes(session.document(), changes);
}

void check_inputs(const RenderArguments& arguments, const ParsedSession& parsed) {
  std::vector<UsedFile> inputs = parsed.inputs();
  inputs.push_back({"SESSION", arguments.session});
  if (!arguments.replay.empty()) inputs.push_back({"--replay", arguments.replay});
  std::vector<Output> outputs;
  for (const std::string& path : arguments.outputs) {
    outputs.push_back({path, is_picture(path) ? OutputKind::picture : OutputKind::mesh});
    if (lower_extension(path) == ".json") outputs.back().kind = OutputKind::report;
  }
  check_files(inputs, files_of(outputs, has_tiles(parsed.arguments())));
}

void export_file(const LiveState& state, const std::string& path, JobListener& listener) {
  if (state.curves) return export_curves(state, path, listener);
  if (lower_extension(path) == ".json") return export_pattern(state, path, listener);
  if (state.samples) return export_samples(state, path, listener);
  export_pattern(state, path, listener);
}

void write_outputs(const RenderArguments& arguments, const std::shared_ptr<const LiveState>& state,
                   ProgressDisplay& display) {
  PictureWriter pictures(arguments.picture->render.quality, arguments.changes.dpi);
  for (const std::string& path : arguments.outputs) {
    if (is_picture(path)) {
      pictures.write(state, path, display);
      continue;
    }
    display.stage("writing " + shown(path));
    export_file(*state, path, display);
  }
}

void run_render(const CLI::App& command, const RenderArguments& arguments) {
  const SessionDocument document = document_of(command, arguments);
  const ParsedSession parsed(document);
  check_outputs(command, arguments, parsed);
  check_inputs(arguments, parsed);
  const ThreadLimit threads(arguments.threads);
  LivePattern pattern;
  {
    ProgressDisplay display(arguments.quiet);
    try {
      pattern.update(document, Follow::afresh, display.progress());
    } catch (const CLI::ValidationError& error) {  // of the session, not of this command line
      throw Error(shown(arguments.session) + ": " + error.what());
    }
    for (const std::string& note : pattern.state()->notes) display.note(note);
    write_outputs(arguments, pattern.state(), display);
  }
  if (arguments.quiet) return;
  print_report(std::cout, pattern.state()->job->report);
  for (const std::string& path : arguments.outputs) print_written(std::cout, path);
}

}  // namespace

Command add_render_command(CLI::App& app) {
  return add_command<RenderArguments>(app, "render", "Draw a session, without a window",
                                      kRenderExamples, add_render_options, run_render);
}

}  // namespace brindle::tool
