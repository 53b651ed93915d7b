#include "jobs/stripe_job.h"

#include <algorithm>
#include <utility>

#include "brindle/base/text.h"
#include "brindle/pattern_of.h"
#include "cli/command_line.h"
#include "cli/option_fields.h"
#include "device/device.h"
#include "input/carried_pattern.h"
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
  refuse_usage([&] { check_view_of_points(shows_stripes(arguments.picture)); });
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
  refuse_usage([&] { check_view_of_crosses(shows_stripes(arguments.picture)); });
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
  if (!shows_stripes(arguments.picture)) refuse("--view has colours; write .png");
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
  check_paper_options(command, arguments.picture, has(outputs, OutputKind::picture),
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
  if (!shows_stripes(arguments.picture)) {
    const PictureOptions& picture = arguments.picture;
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
  add_picture_options(command, arguments.picture);
  add_paper_options(command, arguments.picture);
  add_style_options(command, arguments.style);
  add_field(command, "--min-area", arguments.style.min_area);
}

namespace {

PatternKind kind_of(const StripeArguments& arguments, const std::optional<TextureTile>& tile) {
  if (arguments.waves.cross) return PatternKind::crosses;
  return tile ? PatternKind::texture : PatternKind::stripes;
}

PatternRequest request_of(const StripeArguments& arguments, Preparation& prepared,
                          PatternKind kind) {
  PatternRequest request{kind, arguments.solving.stripes, arguments.fabrication};
  if (kind == PatternKind::texture) {
    request.frequencies_v = std::move(prepared.frequencies_v);
    request.oriented = arguments.waves.oriented;
  }
  return request;
}

Texture drawn_texture(TexturePattern pattern, std::optional<TextureTile> tile,
                      const StripeArguments& arguments) {
  return {std::move(pattern), tile ? std::move(*tile) : TextureTile(BuiltInTile::checker),
          WholeTiles(arguments.texture.whole)};
}

StripeJob make_job(Preparation prepared, const StripeArguments& arguments,
                   std::optional<TextureTile> tile, const Progress& progress) {
  const PatternRequest request = request_of(arguments, prepared, kind_of(arguments, tile));
  PatternResult made = pattern_of(prepared.surface, std::move(prepared.waves), request, progress);
  StripeJob job;
  job.report = make_report(prepared.surface, prepared, made, request.solving.solver.solver);
  job.fabrication = std::move(made.fabrication);
  job.data = take_input_data(prepared);
  if (auto* crosses = std::get_if<CrossResult>(&made.of)) {
    CrossTexture& texture = crosses->texture;
    job.data = on_cross_texture(std::move(job.data), prepared.surface.mesh.triangles,
                                crosses->cross.cover);
    job.result = {drawn_texture(std::move(texture.pattern), std::move(tile), arguments)};
    job.surface = std::make_shared<const Surface>(std::move(texture.surface));
    return job;
  }
  if (auto* texture = std::get_if<TexturePattern>(&made.of)) {
    job.result = {drawn_texture(std::move(*texture), std::move(tile), arguments)};
  } else {
    job.result = {std::get<StripePattern>(std::move(made.of))};
  }
  job.surface = std::make_shared<const Surface>(std::move(prepared.surface));
  return job;
}

// The phases of the pattern that this one continues.
CarriedPattern carried_pattern(const StripeArguments& arguments, const Preparation& prepared) {
  const Follower follower{arguments.surface.mesh, prepared.surface.mesh, prepared.waves,
                          prepared.arrays.points};
  if (prepared.previous) return carry(*prepared.previous, follower, arguments.match);
  return carry(read_pattern(arguments.previous), follower, arguments.match);
}

FollowedReport followed_report(const StripeArguments& arguments, const CarriedPattern& carried,
                               const StripePattern& pattern,
                               const std::optional<FieldStep>& field_step) {
  const PhaseStep step = phase_step(pattern.waves, pattern.solution.z, carried.z);
  FollowedReport followed{arguments.previous, arguments.solving.stripes.lambda,
                          std::string(name_of(carried.matched_by)), carried.unmatched, step.mean};
  if (field_step) followed.field_turned_deg = field_step->mean_deg;
  return followed;
}

}  // namespace

FindLastDirections previous_directions(const StripeArguments& arguments) {
  if (arguments.previous.empty() || arguments.solving.stripes.lambda == 0) return {};
  return [&arguments](Preparation& prepared) -> LastDirections {
    const auto previous = std::make_shared<const KeptPattern>(read_pattern(arguments.previous));
    prepared.previous = previous;
    const KeptField field = field_of(*previous, arguments.surface.neighbors);
    return {carry_field(field, arguments.surface.mesh, prepared, arguments.waves, arguments.match),
            false, turn_note(*previous, arguments.waves)};
  };
}

StripeJob make_stripe_job(StripeArguments arguments, Preparation prepared,
                          std::optional<TextureTile> tile, const Progress& progress) {
  arguments.solving.stripes = stripe_options(arguments.solving, prepared);
  std::optional<CarriedPattern> carried;
  if (!arguments.previous.empty()) {
    progress.report("reading " + arguments.previous, 0);
    carried = carried_pattern(arguments, prepared);
    arguments.solving.stripes.last_phases = carried->z;
  }
  const std::optional<FieldStep> field_step = prepared.field_step;
  prepared.previous = nullptr;
  const Device device(arguments.device);
  arguments.solving.stripes.solve = device.solver();
  StripeJob job = make_job(std::move(prepared), arguments, std::move(tile), progress);
  job.report.device = device.description();
  if (carried)
    job.report.followed = followed_report(arguments, *carried, job.result.stripes(), field_step);
  return job;
}

namespace {

/// Drawings are outlines of a style, even of a plain one.
void write_styled(const Output& output, const StripeArguments& arguments, const StripeJob& job,
                  const StyleJob* styled, JobListener& listener) {
  StyleJob plain;
  plain.patterns.others = std::make_shared<const std::vector<OtherSurface>>();
  const StyleJob& style = styled != nullptr ? *styled : plain;
  write_styled_picture(output.path, *job.surface, job.result, style.patterns, arguments.style,
                       style.input, arguments.picture, listener.progress());
}

void write_stripe_report(const Output& output, const CLI::App& command, Report report,
                         JobListener& listener) {
  report.invocation = invocation_of(command);
  write_json(output.path, to_json(report), listener.progress());
}

}  // namespace

void write_stripes(const Output& output, const CLI::App& command, const StripeArguments& arguments,
                   const StripeJob& job, const StyleJob* styled, JobListener& listener) {
  if (output.kind == OutputKind::report) {
    return write_stripe_report(output, command, job.report, listener);
  }
  if (output.kind == OutputKind::mesh) {
    const MadeMesh made{*job.surface, job.result, job.data, arguments.solving.stripes.phase_shift,
                        arguments.uv};
    return write_made_mesh(output.path, made, arguments.picture, listener);
  }
  if (styled != nullptr || output.kind == OutputKind::drawing) {
    return write_styled(output, arguments, job, styled, listener);
  }
  write_picture(output.path, *job.surface, job.result, arguments.picture, listener.progress());
}

}  // namespace brindle::tool
