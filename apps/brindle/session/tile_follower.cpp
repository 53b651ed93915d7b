#include "session/tile_follower.h"

#include <utility>

#include "brindle/pattern_of.h"

namespace brindle::tool {
namespace {

FrameInput frame_input(const WaveSet& waves) {
  return {waves.positions, waves.directions, waves.frequencies};
}

}  // namespace

TileFollower::TileFollower(const StripeArguments& arguments,
                           std::shared_ptr<const Preparation> prepared)
    : prepared_(std::move(prepared)) {
  if (arguments.waves.cross) {
    cross_.emplace(prepared_->surface, frame_options(arguments.solving.stripes));
  } else {
    texture_.emplace(prepared_->surface,
                     TextureAnimatorOptions{arguments.texture.oriented,
                                            frame_options(arguments.solving.stripes)});
  }
}

void TileFollower::restart() {
  if (texture_) texture_->restart();
  if (cross_) cross_->restart();
}

StripeJob TileFollower::next(const StripeArguments& arguments, const PreparedWaves& waves,
                             const PreparationFigures& figures, const Progress& progress) {
  progress.report("tiles", 0);
  return cross_ ? next_cross(arguments, waves, figures, progress)
                : next_texture(arguments, waves, figures);
}

StripeJob TileFollower::next_texture(const StripeArguments& arguments, const PreparedWaves& waves,
                                     const PreparationFigures& figures) {
  const Surface& surface = prepared_->surface;
  const PhaseShiftKind kind = arguments.solving.stripes.phase_shift;
  const TextureFrameResult frame =
      texture_->frame({frame_input(waves.waves), waves.frequencies_v, {}});
  phase_step_ = frame.u.stripes.phase_step;
  TexturePattern pattern =
      pattern_of_frame(frame, *texture_, waves.waves, waves.frequencies_v, surface.normals, kind);
  Report report = make_report(surface, figures, pattern, arguments.solving.stripes.solver.solver);
  Texture drawn = with_tile(surface, std::move(pattern),
                            chosen_tile(arguments.texture, false).value(), arguments);
  return {{prepared_, &surface},
          {std::move(drawn)},
          std::move(report),
          {prepared_->arrays, prepared_->original_ids, prepared_->partners}};
}

StripeJob TileFollower::next_cross(const StripeArguments& arguments, const PreparedWaves& waves,
                                   const PreparationFigures& figures, const Progress& progress) {
  const CrossFrameResult frame = cross_->frame({frame_input(waves.waves), {}}, progress);
  phase_step_ = frame.stripes.phase_step;
  if (frame.matching != CrossMatching::kept || !cross_surface_) {
    cross_surface_ = std::make_shared<const Surface>(make_surface(frame.mesh));
    finder_ = nullptr;
    cross_data_ =
        on_cross_texture({prepared_->arrays, prepared_->original_ids, prepared_->partners},
                         prepared_->surface.mesh.triangles, frame.cover);
  }
  CrossTexture texture{{}, pattern_of_frame(frame, *cross_, arguments.solving.stripes.phase_shift)};
  // As of a pattern that is made at once: of the surface without the parts of singular triangles.
  Report report =
      make_report(prepared_->surface, figures, texture, arguments.solving.stripes.solver.solver);
  const TextureTile tile = chosen_tile(arguments.texture, true).value_or(BuiltInTile::checker);
  Texture drawn = with_tile(*cross_surface_, std::move(texture.pattern), tile, arguments);
  return {cross_surface_, {std::move(drawn)}, std::move(report), cross_data_};
}

Texture TileFollower::with_tile(const Surface& surface, TexturePattern pattern, TextureTile tile,
                                const StripeArguments& arguments) {
  Texture texture = texture_of(surface.mesh, std::move(pattern), std::move(tile),
                               {arguments.texture.whole, finder_});
  finder_ = texture.whole.finder;
  return texture;
}

}  // namespace brindle::tool
