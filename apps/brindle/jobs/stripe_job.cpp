#include "jobs/stripe_job.h"

#include <utility>

#include "brindle/pattern_of.h"
#include "cli/command_line.h"
#include "device/device.h"
#include "input/followed_field.h"

namespace brindle::tool {
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
                       style.input, *arguments.picture, listener.progress());
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
    return write_made_mesh(output.path, made, *arguments.picture, listener);
  }
  if (styled != nullptr || output.kind == OutputKind::drawing) {
    return write_styled(output, arguments, job, styled, listener);
  }
  write_picture(output.path, *job.surface, job.result, *arguments.picture, listener.progress());
}

}  // namespace brindle::tool
