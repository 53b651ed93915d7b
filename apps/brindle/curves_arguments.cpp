#include "curves_arguments.h"

#include <string_view>

#include "brindle/error.h"
#include "command_line.h"
#include "outputs.h"

namespace brindle::tool {
namespace {

std::optional<TracedWaves> parse_traced(std::string_view name) {
  if (name == "u") return TracedWaves::u;
  if (name == "v") return TracedWaves::v;
  if (name == "both") return TracedWaves::both;
  return std::nullopt;
}

}  // namespace

void add_lines_option(CLI::App& command, TracedWaves& traced) {
  add_named_option(command, "--lines", traced, parse_traced, "u|v|both",
                   "across the field (u, default), along it (v: stripes of the field turned by 90 "
                   "degrees), or both");
}

void add_min_length_option(CLI::App& command, Length& min_length) {
  add_parsed_option(command, "--min-length", min_length, parse_length, "leave out shorter curves")
      ->type_name("L|P%");
}

void add_join_option(CLI::App& command, bool& join) {
  command.add_flag(
      "--join", join,
      "join curves that end in the same triangle in pairs, and let others run on into their "
      "neighbours");
}

void add_offset_option(CLI::App& command, float& offset) {
  add_parsed_option(command, "--offset", offset, parse_number,
                    "in periods from the stripes' centres (default 0; 0.5: centres of the gaps)")
      ->type_name("P");
}

void add_line_shape_options(CLI::App& command, LineShape& shape) {
  add_parsed_option(command, "--simplify", shape.simplify, parse_length,
                    "leave out points up to this far from the curve")
      ->type_name("L|P%");
  add_parsed_option(
      command, "--resample", shape.resample, parse_positive_length,
      "points at equal distances, about this far apart; --simplify then leaves out some of "
      "them")
      ->type_name("L|P%");
}

void add_tube_options(CLI::App& command, LineShape& shape) {
  add_parsed_option(command, "--tube-radius", shape.tube_radius, parse_positive_length,
                    "write mesh files of tubes, not lines (pictures show tubes anyway)")
      ->type_name("L|P%");
  command.add_option("--tube-sides", shape.tube_sides, "3 to 64 (default 8)")
      ->type_name("N")
      ->check(CLI::Range(3, 64));
}

namespace {

void add_curve_options(CLI::App& command, CurvesArguments& arguments) {
  add_lines_option(command, arguments.traced);
  add_offset_option(command, arguments.offset);
  add_join_option(command, arguments.join);
  add_min_length_option(command, arguments.min_length);
  add_line_shape_options(command, arguments);
  add_parsed_option(command, "--line-width", arguments.line_width, parse_positive_length,
                    "report how much of the surface lines of this width cover")
      ->type_name("L|P%");
  add_tube_options(command, arguments);
}

}  // namespace

void add_curves_options(CLI::App& command, CurvesArguments& arguments) {
  add_surface_options(command, arguments.surface);
  add_wave_options(command, arguments.waves);
  add_second_wave_options(command, arguments.second);
  add_curve_options(command, arguments);
  add_making_options(command, arguments.making);
  command
      .add_option(
          "--wales", arguments.second.wales,
          "V: exactly N stripes round a surface with one way round, as the wales of a sleeve")
      ->type_name("N")
      ->check(CLI::Range(1, 1000000));
  add_solver_option(command, arguments.solving);
  add_solving_options(command, arguments.solving);
  add_output_options(command, arguments.outputs, arguments.report, arguments.quiet);
  arguments.picture = add_camera_options(command);
}

void check_curves_options(const CLI::App& command, const CurvesArguments& arguments,
                          const PlannedFiles<CurveOutput>& files) {
  check_field_options(command, arguments.waves);
  check_solving_options(command, arguments.solving);
  check_making_options(command, arguments.making, arguments.solving.stripes.solver.solver);
  if (arguments.traced == TracedWaves::v) {
    refuse_given(command, {"--winding", "--anchor-boundary"}, "U is not traced; leave out --lines");
  }
  if (arguments.second.wales > 0) {
    refuse_given(command, {"--field-v", "--stripes-v", "--frequency-v"},
                 "--wales says how many stripes of V there are, and where they run");
  }
  if (arguments.traced == TracedWaves::u) {
    refuse_given(command, {"--field-v", "--stripes-v", "--frequency-v", "--wales"},
                 "V is not traced; add --lines v or --lines both");
  }
  const bool picture = has(files, CurveOutput::picture);
  if (!picture && !has(files, CurveOutput::drawing)) {
    refuse_picture_options(command, arguments.waves,
                           "nothing is drawn; add --output FILE.svg or FILE.png");
  }
  if (!picture && has(files, CurveOutput::drawing)) {
    refuse_given(command, {"--quality"}, "a drawing of lines has but one; add --output FILE.png");
  }
  if (!picture && !has(files, CurveOutput::tubes)) {
    refuse_given(command, {"--tube-radius", "--tube-sides"},
                 "no tubes are written; add --output with a mesh file or FILE.png");
  }
}

void check_curves_points(const CurvesArguments& arguments) {
  if (!is_points(arguments.surface)) return;
  throw Error("curves need triangles, and '" + arguments.surface.mesh +
              "' has points alone; 'brindle stripe' and 'brindle sample' take points");
}

std::vector<UsedFile> curves_inputs(const CurvesArguments& arguments) {
  std::vector<UsedFile> inputs = input_files(arguments.surface, arguments.waves);
  if (!arguments.second.field.empty()) inputs.push_back({"--field-v", arguments.second.field});
  add_slack_files(arguments.solving.slack, inputs);
  return inputs;
}

}  // namespace brindle::tool
