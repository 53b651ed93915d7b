#include "jobs/sample_arguments.h"

#include <utility>

#include "brindle/base/file_names.h"
#include "brindle/files.h"
#include "brindle/points.h"
#include "cli/command_line.h"
#include "cli/option_fields.h"
#include "pictures/paper.h"

namespace brindle::tool {

void add_sample_options(CLI::App& command, SampleArguments& arguments) {
  add_surface_options(command, arguments.surface);
  add_point_options(command, arguments.surface);
  add_wave_options(command, arguments.waves);
  add_fields(command, arguments.second);
  add_field(command, "--min-distance", arguments.min_distance);
  add_solver_option(command, arguments.solving);
  add_solving_options(command, arguments.solving);
  add_output_options(command, arguments);
  arguments.picture = add_camera_options(command);
  add_paper_options(command, *arguments.picture);
  add_glyph_options(command, arguments.glyphs);
}

OutputKind planned_sample(const std::filesystem::path& path) {
  const std::string kind = lower_extension(path);
  if (kind == ".json") return OutputKind::report;
  if (kind == ".png") return OutputKind::picture;
  if (is_sample_format(path)) return OutputKind::samples;
  refuse_output(path, "'" + kind +
                          "' files hold no samples; use .csv, .ply or .vtp, .png for a picture, "
                          ".json for a report");
}

void check_sample_options(const CLI::App& command, const SampleArguments& arguments,
                          const Outputs& outputs) {
  check_field_options(command, arguments.waves);
  check_solving_options(command, arguments.solving);
  check_glyph_options(command, arguments.glyphs);
  if (!has(outputs, OutputKind::picture)) {
    refuse_style_options(command, "no picture is written; add --output FILE.png");
    refuse_picture_options(command, arguments.waves,
                           "no picture is written; add --output FILE.png");
  }
  check_paper_options(command, *arguments.picture, has(outputs, OutputKind::picture), false);
  if (!has_point_trees()) {
    refuse_given(command, {"--min-distance"},
                 "this build has no nanoflann; configure with -DBRINDLE_NANOFLANN=ON");
  }
}

void check_sample_points(const CLI::App& command, const SampleArguments& arguments,
                         const Outputs& outputs) {
  if (!is_points(arguments.surface)) return;
  refuse_triangle_options(command);
  for (const Output& output : outputs) {
    if (output.kind == OutputKind::picture) {
      refuse_output(output.path, "samples are drawn on meshes alone; write .csv, .ply or .vtp");
    }
  }
  refuse_usage([&] { check_min_distance_on_points(arguments.min_distance); });
}

std::vector<UsedFile> sample_inputs(const SampleArguments& arguments) {
  std::vector<UsedFile> inputs = job_inputs(arguments);
  if (!arguments.second.field.empty()) inputs.push_back({"--field-v", arguments.second.field});
  for (UsedFile& file : glyph_files(arguments.glyphs)) inputs.push_back(std::move(file));
  return inputs;
}

}  // namespace brindle::tool
