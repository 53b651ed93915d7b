#include "jobs/paths_arguments.h"

#include <utility>

#include "brindle/base/file_names.h"
#include "brindle/base/output_file.h"
#include "brindle/files.h"
#include "cli/command_line.h"
#include "cli/option_fields.h"
#include "input/vertex_values.h"
#include "outputs/outputs.h"
#include "pictures/paper.h"
#include "pictures/picture_options.h"

namespace brindle::tool {

void add_paths_options(CLI::App& command, PathsArguments& arguments) {
  add_traced_options(command, arguments);
  arguments.visit_lines(AddField(command));
  arguments.visit_paths(AddField(command));
  add_parsed_option(command, "--lids", arguments.surface.lids, parse_lids);
  add_parsed_option(command, "--place", arguments.machine.place, parse_place);
  add_parsed_option(command, "--scale", arguments.machine.unit, parse_scale);
}

OutputKind planned_paths(const std::filesystem::path& path) {
  const std::string kind = lower_extension(path);
  check_output_path(path);
  if (kind == ".json") return OutputKind::report;
  if (is_tool_path_format(path)) return OutputKind::lines;
  if (kind == ".png") return OutputKind::picture;
  if (kind == ".svg" || kind == ".pdf") {
    refuse_output(path, "'brindle curves' draws lines, in an order with little travel, too");
  }
  refuse_output(path, "unknown extension '" + kind +
                          "'; use .gcode, .dxf, .csv, .vtp, .ply or .obj for paths, .png for a "
                          "picture, .json for a report");
}

namespace {

bool writes(const Outputs& outputs, const std::string& extension) {
  return std::ranges::any_of(
      outputs, [&](const Output& output) { return lower_extension(output.path) == extension; });
}

void check_picture_options(const CLI::App& command, const PathsArguments& arguments) {
  constexpr const char* kWhy = "nothing is drawn; add --output FILE.png";
  refuse_light_option(command, arguments.waves, kWhy);
  refuse_given(command, {"--slice", "--quality", "--colors"}, kWhy);
  if (depends_on_camera(arguments.waves.arrays.frequency_by)) return;
  refuse_given(command, {"--camera", "--projection", "--size"}, kWhy);
}

void check_spiral(const CLI::App& command, const PathsArguments& arguments) {
  constexpr const char* kOne = "a spiral is one path";
  refuse_given(command, {"--connect", "--cut-length", "--least-radius"}, kOne);
  if (arguments.traced != TracedWaves::u) {
    refuse_given(command, {"--lines"}, "a spiral winds U; leave it out");
  }
}

}  // namespace

void check_paths_options(const CLI::App& command, const PathsArguments& arguments,
                         const Outputs& outputs) {
  check_traced_options(command, arguments);
  const bool picture = has(outputs, OutputKind::picture);
  const bool gcode = writes(outputs, ".gcode"), machine = gcode || writes(outputs, ".dxf");
  if (!picture) check_picture_options(command, arguments);
  if (arguments.traced == TracedWaves::both) {
    refuse_given(command, {"--lines"}, "paths of both would cross; make those of u, then of v");
  }
  if (arguments.order == PathOrder::spiral) check_spiral(command, arguments);
  if (!gcode) {
    refuse_given(command, {"--gcode", "--axes"}, "no G-code is written; add --output FILE.gcode");
  }
  if (!machine) {
    refuse_given(command, {"--place"}, "no machine moves; add --output FILE.gcode or FILE.dxf");
  }
  if (arguments.machine.dialect == GcodeDialect::plain) {
    refuse_given(command, {"--thickness", "--filament"},
                 "plain G-code extrudes nothing; leave out --gcode");
  }
  const bool sorted = arguments.order == PathOrder::layers || arguments.order == PathOrder::spiral;
  const bool lids = arguments.surface.lids && arguments.surface.lids->degrees;
  if (!picture && !machine && !sorted && !lids &&
      !depends_on_up(arguments.waves.arrays.frequency_by)) {
    refuse_given(command, {"--up"},
                 "no height counts; add --order layers, --lids, or --output FILE.gcode");
  }
}

PathsArguments completed(PathsArguments arguments) {
  PictureOptions& picture = *arguments.picture;
  if (!picture.up) picture.up = UpAxis::z;
  arguments.machine.up = upright_axes(*picture.up).row(1).transpose();
  if (arguments.surface.lids) arguments.surface.lids->up = arguments.machine.up;
  if (arguments.axes == PathsArguments::Axes::five) arguments.machine.axes = 5;
  if (arguments.order == PathOrder::spiral && arguments.fabrication.windings.empty()) {
    arguments.fabrication.windings.push_back({"", 1});
  }
  return arguments;
}

std::vector<UsedFile> paths_inputs(const PathsArguments& arguments) {
  std::vector<UsedFile> inputs = curves_inputs(arguments);
  const auto& lids = arguments.surface.lids;
  if (lids && !lids->degrees) inputs.push_back({"--lids", lids->file});
  return inputs;
}

}  // namespace brindle::tool
