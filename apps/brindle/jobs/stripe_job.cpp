#include "jobs/stripe_job.h"

#include <utility>

#include "brindle/cross_texture.h"
#include "input/device.h"
#include "input/followed_field.h"

namespace brindle::tool {
namespace {

Texture make_texture(Preparation& prepared, const StripeArguments& arguments, TextureTile tile,
                     const Progress& progress) {
  const TextureOptions options{std::move(prepared.frequencies_v), arguments.texture.oriented,
                               arguments.solving.stripes};
  TexturePattern pattern =
      texture_pattern(prepared.surface, std::move(prepared.waves), options, progress);
  return texture_of(prepared.surface.mesh, std::move(pattern), std::move(tile),
                    {arguments.texture.whole});
}

StripeResult make_result(Preparation& prepared, const StripeArguments& arguments,
                         std::optional<TextureTile> tile, const Progress& progress,
                         MakingFigures& figures) {
  if (tile) return {make_texture(prepared, arguments, std::move(*tile), progress)};
  const MakingOptions& making = arguments.making;
  StripePattern pattern = make_pattern(prepared.surface, std::move(prepared.waves),
                                       arguments.solving.stripes, making, progress, figures);
  if (!making.windings.empty()) measure_windings(prepared.surface, pattern, figures);
  return {std::move(pattern)};
}

StripeJob make_cross(Preparation prepared, const StripeArguments& arguments, TextureTile tile,
                     const Progress& progress) {
  const StripeOptions& options = arguments.solving.stripes;
  const CrossPattern cross = cross_pattern(prepared.surface, prepared.waves, options, progress);
  CrossTexture texture = cross_texture(prepared.surface, cross, options.phase_shift);
  const Report report = make_report(prepared.surface, prepared, texture, options.solver.solver);
  InputData data =
      on_cross_texture(take_input_data(prepared), prepared.surface.mesh.triangles, cross.cover);
  Texture drawn = texture_of(texture.surface.mesh, std::move(texture.pattern), std::move(tile),
                             {arguments.texture.whole});
  return {std::make_shared<const Surface>(std::move(texture.surface)),
          {std::move(drawn)},
          report,
          std::move(data)};
}

StripeJob make_job(Preparation prepared, const StripeArguments& arguments,
                   std::optional<TextureTile> tile, const Progress& progress) {
  if (arguments.waves.cross) {
    return make_cross(std::move(prepared), arguments, tile.value_or(BuiltInTile::checker),
                      progress);
  }
  MakingFigures figures;
  StripeResult result = make_result(prepared, arguments, std::move(tile), progress, figures);
  const Solver solver = arguments.solving.stripes.solver.solver;
  Report report = result.texture() != nullptr
                      ? make_report(prepared.surface, prepared, result.texture()->pattern, solver)
                      : make_report(prepared.surface, prepared, result.stripes(), solver);
  add_to_json(figures, report.making);
  report.making_lines = lines_of(figures);
  InputData data = take_input_data(prepared);
  return {std::make_shared<const Surface>(std::move(prepared.surface)), std::move(result), report,
          std::move(data)};
}

// The phases of the pattern that this one stays near to.
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
                          name_of(carried.matched_by), carried.unmatched, step.mean};
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

}  // namespace brindle::tool
