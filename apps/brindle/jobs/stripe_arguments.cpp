#include "jobs/stripe_arguments.h"

#include <algorithm>
#include <utility>

#include "brindle/base/text.h"
#include "cli/command_line.h"
#include "cli/option_fields.h"
#include "outputs/mesh_output.h"
#include "pictures/paper.h"

namespace brindle::tool {
namespace {

// Rejects, before a long job, options that points or crosses do not support.
void check_points(const CLI::App& command, const StripeArguments& arguments,
                  const Outputs& outputs) {
  const auto refuse = [](const std::string& option, const std::string& what) {
    throw CLI::ValidationError(option, "points have no triangles: " + what);
  };
  if (arguments.waves.cross) {
    refuse("--cross", "a cross field is drawn on meshes alone; leave out --cross");
  }
  if (!arguments.texture.tile.empty()) {
    refuse("--texture", "a texture is drawn on meshes alone; leave out --texture");
  }
  refuse_usage([&] { check_view_of_points(shows_stripes(*arguments.picture)); });
  for (const Output& output : outputs) {
    if (output.kind == OutputKind::mesh && !holds_points(output.path)) {
      refuse("--output",
             "'" + shown(output.path.native()) + "' cannot hold them; write .ply or .vtp");
    }
  }
  refuse_given(command, {"--uv"}, "points have no triangles, and so no texture coordinates");
  refuse_usage(command, check_fabrication_on_points);
  refuse_style_options(command, "points are drawn as they are");
  refuse_triangle_options(command);
}

void check_cross(const StripeArguments& arguments) {
  refuse_usage([&] { check_view_of_crosses(shows_stripes(*arguments.picture)); });
}

void check_previous(const CLI::App& command, const StripeArguments& arguments, bool texture) {
  if (texture) {
    refuse_given(command, {"--previous"}, "it is for stripes, not for textures and cross fields");
  }
  refuse_usage(command, [&](const IsGiven& given) {
    check_following(given, !arguments.previous.empty(), arguments.solving.stripes.solver.solver);
  });
}

// Rejects options that drawings cannot show.
void check_drawings(const CLI::App& command, const StripeArguments& arguments,
                    const Outputs& outputs, bool texture) {
  const auto drawing = std::ranges::find(outputs, OutputKind::drawing, &Output::kind);
  if (drawing == outputs.end()) {
    refuse_given(command, {"--min-area"}, "no drawing is written; add --output FILE.svg");
    return;
  }
  const auto refuse = [&](const char* why) { refuse_output(drawing->path, why); };
  if (drawn_by(arguments.texture, texture) == Drawn::pictures) {
    refuse(
        "a drawing has outlines of motifs, and the tile is a picture of pixels; take a built-in "
        "tile, or write .png");
  }
  if (is_points(arguments.surface)) refuse("points have no outlines; write .png");
  if (!shows_stripes(*arguments.picture)) refuse("--view has colours; write .png");
  if (has(outputs, OutputKind::picture)) return;
  refuse_given(command, {"--quality"}, "a drawing has but one; it is for .png");
  refuse_for_outlines(command, arguments.style);
  if (!arguments.style.by_light()) {
    refuse_light_option(command, arguments.waves,
                        "outlines of stripes show it by their widths alone; add --width-by light");
  }
}

// Rejects options without effect.
void check_options(const CLI::App& command, const StripeArguments& arguments,
                   const Outputs& outputs, bool texture) {
  check_field_options(command, arguments.waves);
  check_solving_options(command, arguments.solving);
  check_previous(command, arguments, texture);
  check_fabrication_options(arguments.fabrication, arguments.solving.stripes.solver.solver);
  if (texture) refuse_usage(command, check_fabrication_of_textures);
  check_style_options(command, arguments.style, drawn_by(arguments.texture, texture));
  check_drawings(command, arguments, outputs, texture);
  check_light_option(command, arguments.style, arguments.waves);
  check_paper_options(command, *arguments.picture, has(outputs, OutputKind::picture),
                      has(outputs, OutputKind::drawing));
  const std::string no_picture = "no picture is written; add --output FILE.png";
  if (!draws(outputs)) {
    refuse_style_options(command, no_picture);
    refuse_given(command, {"--quality", "--view", "--stripe-width"}, no_picture);
    refuse_camera_options(command, arguments.waves, no_picture);
    // Meshes have an image of the tile in these colours.
    if (!texture || !has(outputs, OutputKind::mesh)) {
      refuse_given(command, {"--colors"}, no_picture);
    }
  }
  if (!shows_stripes(*arguments.picture)) {
    const PictureOptions& picture = *arguments.picture;
    refuse_style_options(command, "--view has colours of its own");
    const bool has_background = picture.render.background_center == picture.render.background_edge;
    if (!has_background) {
      refuse_given(command, {"--colors"}, "--view has colours of its own, but for a background");
    }
    if (picture.view == View::angle_error) {
      refuse_given(command, {"--stripe-width"}, "angle errors are shown without stripes");
    }
  }
  if (texture) {
    if (arguments.waves.cross) refuse_style_options(command, "crosses are drawn as they are");
    refuse_given(command, {"--stripe-width"}, "the texture's tile is drawn as it is");
    refuse_given(command, {"--uv"}, "meshes with a texture have coordinates anyway");
  }
  if (!draws(outputs) && std::ranges::none_of(outputs, [](const Output& output) {
        return output.kind == OutputKind::mesh && holds_cells(output.path);
      })) {
    refuse_given(command, {"--tiles"},
                 "neither a picture nor a mesh with values of triangles is written; add --output "
                 "FILE.png, .vtp or .ply");
  }
  if (!has(outputs, OutputKind::mesh)) {
    refuse_given(command, {"--uv"},
                 "no mesh is written; add --output FILE.vtp, .ply, .glb or .obj");
  }
}

}  // namespace

std::vector<UsedFile> stripe_inputs(const StripeArguments& arguments) {
  std::vector<UsedFile> inputs = job_inputs(arguments);
  if (!arguments.texture.tile.empty()) inputs.push_back({"--texture", arguments.texture.tile});
  if (!arguments.previous.empty()) inputs.push_back({"--previous", arguments.previous});
  for (UsedFile& file : style_files(arguments.style)) inputs.push_back(std::move(file));
  return inputs;
}

bool has_tiles(const StripeArguments& arguments) {
  return !arguments.texture.tile.empty() || arguments.waves.cross;
}

void check_stripe_options(const CLI::App& command, const StripeArguments& arguments,
                          const Outputs& outputs) {
  check_options(command, arguments, outputs, has_tiles(arguments));
  if (arguments.waves.cross) check_cross(arguments);
}

void check_stripe_points(const CLI::App& command, const StripeArguments& arguments,
                         const Outputs& outputs) {
  if (is_points(arguments.surface)) check_points(command, arguments, outputs);
}

Outputs checked_outputs(const CLI::App& command, const StripeArguments& arguments) {
  Outputs outputs = plan_outputs(stripe_inputs(arguments), arguments.outputs, arguments.report,
                                 planned_stripes, has_tiles(arguments));
  check_stripe_options(command, arguments, outputs);
  check_stripe_points(command, arguments, outputs);
  return outputs;
}

namespace {

void add_previous_options(CLI::App& command, StripeArguments& arguments) {
  command.add_option("--previous", arguments.previous);
  add_field(command, "--lambda", arguments.solving.stripes.lambda);
  add_match_option(command, arguments.match);
}

}  // namespace

void add_stripe_options(CLI::App& command, StripeArguments& arguments) {
  add_surface_options(command, arguments.surface);
  add_point_options(command, arguments.surface);
  add_wave_options(command, arguments.waves);
  add_cross_option(command, arguments.waves);
  add_solver_option(command, arguments.solving);
  add_solving_options(command, arguments.solving);
  add_field(command, "--device", arguments.device);
  add_previous_options(command, arguments);
  add_fabrication_options(command, arguments.fabrication);
  add_texture_options(command, arguments.texture, arguments.waves);
  command.add_flag("--uv", arguments.uv);
  add_output_options(command, arguments);
  arguments.picture = add_picture_options(command);
  add_paper_options(command, *arguments.picture);
  add_style_options(command, arguments.style);
  add_field(command, "--min-area", arguments.style.min_area);
}

}  // namespace brindle::tool
