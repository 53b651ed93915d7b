#include <memory>
#include <string>
#include <vector>

#include "brindle/base/file_names.h"
#include "brindle/base/output_file.h"
#include "brindle/error.h"
#include "brindle/render/parsed_words.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/option_values.h"
#include "outputs/outputs.h"
#include "session/session_export.h"
#include "session/stage_keys.h"
#include "window/viewer.h"

namespace brindle::tool {
namespace {

constexpr const char* kViewExamples =
    R"(The window's panel has all options of 'brindle stripe', 'curves' and 'sample'; those of
'brindle stripe' are options here, too. Further meshes are shown beside the first, as by --with.

Examples:
  brindle view
  brindle view horse.ply --stripes 60
  brindle view scan.obj --field curvature --along
  brindle view shell.ply inside.ply --between nothing
  brindle view scan.obj --show curves
  brindle view horse.json

Press ? in the window for keys. 'brindle render' draws a saved session without a window.)";

struct ViewArguments {
  std::vector<std::string> meshes;
  OptionValues options;
  std::optional<Shown> shown;
  std::string camera;
  ViewerOptions viewer;
  bool light = false;
  bool dark = false;
};

// Validated by the session.
void add_session_options(CLI::App& command, OptionValues& options) {
  for (const OptionInfo* option : session_options()) {
    const std::string name(option->name), help(option->help);
    if (option->kind == OptionKind::flag) {
      command
          .add_flag_callback(
              "--" + name, [&options, name] { options[name] = {}; }, help)
          ->group(std::string(option->group));
      continue;
    }
    CLI::Option* added = command.add_option_function<std::vector<std::string>>(
        "--" + name,
        [&options, name](const std::vector<std::string>& values) { options[name] = values; }, help);
    added->type_name(std::string(option->form))->expected(1)->group(std::string(option->group));
    if (option->several) added->take_all();
  }
}

void set_window_size(ViewerOptions& viewer, const std::string& text) {
  const auto parts = split(text, 'x');
  const auto side = [&](const std::string& part) {
    const float value = parse_positive_number("--window", part);
    if (value < 320 || value > 16384) {
      wrong_usage("--window", "sides from 320 to 16384", text);
    }
    return static_cast<int>(value);
  };
  if (parts.size() != 2) wrong_usage("--window", "WIDTHxHEIGHT", text);
  viewer.width = side(parts[0]);
  viewer.height = side(parts[1]);
}

void add_window_options(CLI::App& command, ViewArguments& arguments) {
  ViewerOptions& viewer = arguments.viewer;
  command
      .add_option_function<std::string>(
          "--window", [&viewer](const std::string& text) { set_window_size(viewer, text); },
          "size of the window (default 1280x800)")
      ->type_name("WIDTHxHEIGHT");
  command.add_option("--scale", viewer.scale, "size of text and widgets (default: the display's)")
      ->type_name("S")
      ->check(CLI::Range(0.5, 4.0));
  CLI::Option* light = command.add_flag("--light", arguments.light, "light colours");
  command.add_flag("--dark", arguments.dark, "dark colours (default at first: as it was left)")
      ->excludes(light);
  command
      .add_option("-o,--output", viewer.output,
                  "write a picture of the window once all is drawn, and close")
      ->type_name("FILE.png")
      ->group("Output");
  command
      .add_option("--log", viewer.log,
                  "write what the window does as lines of JSON, for bug reports")
      ->type_name("FILE.jsonl");
  command
      .add_option("--record-commands", viewer.commands,
                  "write all commands, for 'brindle render --replay'")
      ->type_name("FILE.jsonl");
}

void add_view_options(CLI::App& command, ViewArguments& arguments) {
  command.add_option("MESH", arguments.meshes,
                     "meshes, shapes such as shape:torus or a session (.json)");
  add_named_option(command, "--show", arguments.shown, parse_shown,
                   "what the picture shows (default stripes)")
      ->type_name("stripes|curves|samples");
  command.add_option("--camera", arguments.camera, "view direction, in degrees (default 30,20)")
      ->type_name("AZIMUTH,ELEVATION[,ZOOM]");
  add_session_options(command, arguments.options);
  add_window_options(command, arguments);
}

SessionDocument first_document(const ViewArguments& arguments) {
  const std::string& name = arguments.meshes.front();
  if (lower_extension(name) == ".json") return read_session(name);
  SessionDocument document;
  document.mesh = name;
  return document;
}

SessionDocument document_of(const ViewArguments& arguments) {
  SessionDocument opened;
  if (!arguments.meshes.empty()) opened = first_document(arguments);
  SessionDocument document = opened;
  if (arguments.shown) document.shown = *arguments.shown;
  for (const auto& [name, values] : arguments.options) document.options[name] = values;
  for (std::size_t i = 1; i < arguments.meshes.size(); ++i) {
    document.options["with"].push_back(arguments.meshes[i]);
  }
  if (!arguments.camera.empty()) {
    const auto view = parse_camera_view(arguments.camera);
    if (!view) {
      wrong_usage("--camera", kCameraViewForm, arguments.camera);
    }
    document.camera = *view;
  }
  // Stored phases may belong to other waves.
  if (pattern_key(opened) != pattern_key(document)) document.phases = nullptr;
  check_document(document);
  return document;
}

void run_view(const CLI::App&, const ViewArguments& arguments) {
  ViewerOptions options = arguments.viewer;
  if (arguments.light || arguments.dark) options.dark = arguments.dark;
  if (options.output.empty()) {
    options.settings = settings_path();
  } else {
    const std::string refusal = picture_refusal(options.output);
    if (!refusal.empty()) refuse_output(options.output, refusal);
    check_output_path(options.output);
  }
  const bool session =
      !arguments.meshes.empty() && lower_extension(arguments.meshes.front()) == ".json";
  Viewer viewer(document_of(arguments), session ? arguments.meshes.front() : "", options);
  if (!arguments.meshes.empty()) viewer.remember_opened(arguments.meshes.front());
  viewer.run();
}

}  // namespace

Command add_view_command(CLI::App& app) {
  return add_command<ViewArguments>(app, "view", "Open a window: stripes live, fields by strokes",
                                    kViewExamples, add_view_options, run_view);
}

}  // namespace brindle::tool
