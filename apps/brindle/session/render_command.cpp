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
#include "outputs/outputs.h"
#include "pictures/drawing_file.h"
#include "pictures/picture.h"
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
  PictureOptions picture;  ///< --size and --quality alone
  PictureChanges changes;  ///< except for the size
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
  add_size_options(command, arguments.picture);
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

/// Reports are of stripes; all other files, of what is shown.
OutputKind planned(const std::filesystem::path& path, const ParsedSession& parsed) {
  const bool shown = lower_extension(path) != ".json";
  if (shown && parsed.curves() != nullptr) {
    return planned_curves(path, parsed.curves()->tube_radius.has_value());
  }
  return shown && parsed.samples() != nullptr ? planned_sample(path) : planned_stripes(path);
}

bool is_picture(const Output& output) {
  return output.kind == OutputKind::picture || output.kind == OutputKind::drawing;
}

Outputs checked_outputs(const CLI::App& command, const RenderArguments& arguments,
                        const ParsedSession& parsed) {
  std::vector<UsedFile> inputs = parsed.inputs();
  inputs.push_back({"SESSION", arguments.session});
  if (!arguments.replay.empty()) inputs.push_back({"--replay", arguments.replay});
  Outputs outputs = plan_outputs(
      inputs, arguments.outputs, "",
      [&](const std::filesystem::path& path) { return planned(path, parsed); },
      has_tiles(parsed.arguments()));
  if (!draws(outputs)) {
    refuse_given(command, {"--size", "--quality", "--scale-widths", "--transparent", "--dpi"},
                 "no picture is written; add --output FILE.png");
    return outputs;
  }
  std::vector<std::filesystem::path> pictures;
  for (const Output& output : outputs) {
    if (is_picture(output)) pictures.push_back(output.path);
  }
  check_picture_files(parsed, pictures);
  if (!has(outputs, OutputKind::picture)) {
    refuse_given(command, {"--quality", "--dpi"}, "it is for pixels; add --output FILE.png");
  }
  return outputs;
}

/// Runs the file's commands until the first one that is rejected.
void replay(Session& session, const std::string& path) {
  std::size_t number = 0;
  for (const SessionCommand& command : read_commands(path)) {
    ++number;
    const std::size_t messages = session.messages().size();
    const bool keeps = command.at("command") == "keep_phases";
    if (session.apply(command) || keeps) continue;
    const std::string why = session.messages().size() > messages
                                ? session.messages().back().text
                                : std::string("there is nothing to do");
    throw Error(shown(path) + ": command " + std::to_string(number) + ", " +
                command.at("command").get<std::string>() + ": " + why);
  }
  session.end_drag();
}

SessionDocument document_of(const CLI::App& command, const RenderArguments& arguments) {
  Session session(read_session(arguments.session));
  if (!arguments.replay.empty()) replay(session, arguments.replay);
  const RenderOptions& render = arguments.picture.render;
  PictureChanges changes = arguments.changes;
  if (is_given(command, "--size")) changes.size = {render.width, render.height};
  return with_changes(session.document(), changes);
}

void write_outputs(const RenderArguments& arguments, const Outputs& outputs,
                   const std::shared_ptr<const LiveState>& state, ProgressDisplay& display) {
  PictureWriter pictures(arguments.picture.render.quality, arguments.changes.dpi);
  for (const Output& output : outputs) {
    if (is_picture(output)) {
      pictures.write(state, output.path, display);
      continue;
    }
    display.stage("writing " + shown(output.path.native()));
    const bool report = output.kind == OutputKind::report;
    const auto write = state->curves               ? export_curves
                       : state->samples && !report ? export_samples
                                                   : export_pattern;
    write(*state, output.path, display);
  }
}

void run_render(const CLI::App& command, const RenderArguments& arguments) {
  const SessionDocument document = document_of(command, arguments);
  const ParsedSession parsed(document);
  const Outputs outputs = checked_outputs(command, arguments, parsed);
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
    write_outputs(arguments, outputs, pattern.state(), display);
  }
  if (arguments.quiet) return;
  print_report(std::cout, pattern.state()->job->report);
  print_written(std::cout, outputs);
}

}  // namespace

Command add_render_command(CLI::App& app) {
  return add_command<RenderArguments>(app, "render", "Draw a session, without a window",
                                      kRenderExamples, add_render_options, run_render);
}

}  // namespace brindle::tool
