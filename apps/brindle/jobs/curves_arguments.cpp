#include "jobs/curves_arguments.h"

#include "brindle/error.h"
#include "cli/command_line.h"
#include "cli/option_fields.h"
#include "pictures/paper.h"

namespace brindle::tool {
namespace {

WantedWinding parse_wales(const std::string& option, const std::string& text) {
  WantedWinding wales = parse_winding(option, text);
  if (wales.periods < 1) wrong_usage(option, "a number from 1 to 1000000", text);
  return wales;
}

}  // namespace

void add_traced_options(CLI::App& command, CurvesArguments& arguments) {
  add_surface_options(command, arguments.surface);
  add_wave_options(command, arguments.waves);
  add_fields(command, arguments.second);
  add_fabrication_options(command, arguments.fabrication);
  add_parsed_option(command, "--wales", arguments.second.wales, parse_wales);
  add_solver_option(command, arguments.solving);
  add_solving_options(command, arguments.solving);
  add_output_options(command, arguments);
  arguments.picture = add_camera_options(command);
}

void add_curves_options(CLI::App& command, CurvesArguments& arguments) {
  add_traced_options(command, arguments);
  add_fields<TracingOptions>(command, arguments);
  add_field(command, "--creases", arguments.crease_deg);
  add_paper_options(command, *arguments.picture);
}

void check_traced_options(const CLI::App& command, const CurvesArguments& arguments) {
  check_field_options(command, arguments.waves);
  check_solving_options(command, arguments.solving);
  check_fabrication_options(arguments.fabrication, arguments.solving.stripes.solver.solver);
  if (arguments.traced == TracedWaves::v) {
    refuse_given(command, {"--winding", "--anchor-boundary"}, "U is not traced; leave out --lines");
  }
  if (arguments.second.wales.periods > 0) {
    refuse_given(command, {"--field-v", "--stripes-v", "--frequency-v"},
                 "--wales says how many stripes of V there are, and where they run");
  }
  if (arguments.traced == TracedWaves::u) {
    refuse_given(command, {"--field-v", "--stripes-v", "--frequency-v", "--wales"},
                 "V is not traced; add --lines v or --lines both");
  }
}

void check_curves_options(const CLI::App& command, const CurvesArguments& arguments,
                          const Outputs& outputs) {
  check_traced_options(command, arguments);
  const bool picture = has(outputs, OutputKind::picture);
  if (!picture && !has(outputs, OutputKind::drawing)) {
    refuse_picture_options(command, arguments.waves,
                           "nothing is drawn; add --output FILE.svg or FILE.png");
  }
  check_paper_options(command, *arguments.picture, picture, has(outputs, OutputKind::drawing));
  if (!picture && has(outputs, OutputKind::drawing)) {
    refuse_given(command, {"--quality"}, "a drawing of lines has but one; add --output FILE.png");
    if (arguments.traced == TracedWaves::v) {
      refuse_given(command, {"--colors"},
                   "a drawing has lines alone, and those of V have a colour of their own; add "
                   "--output FILE.png");
    }
    refuse_light_option(command, arguments.waves,
                        "a drawing of lines shows no light; add --output FILE.png");
  }
  if (!has(outputs, OutputKind::lines)) {
    refuse_given(command, {"--creases"},
                 "no lines are written; add --output FILE.obj, .ply, .vtp or .csv (drawings have "
                 "their outline)");
  }
  if (!picture && !has(outputs, OutputKind::tubes)) {
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
  std::vector<UsedFile> inputs = job_inputs(arguments);
  if (!arguments.second.field.empty()) inputs.push_back({"--field-v", arguments.second.field});
  return inputs;
}

}  // namespace brindle::tool
