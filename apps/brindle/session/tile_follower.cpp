#include "session/tile_follower.h"

#include <utility>

#include "brindle/pattern_of.h"

namespace brindle::tool {
namespace {

FrameInput frame_input(const WaveSet& waves) {
  return {waves.positions, waves.directions, waves.frequencies};
}

/// The motifs that pictures will need, if known before the first frame.
std::optional<TileMotifs> motifs_in_frames(const WholeTiles& whole, const TextureTile& tile,
                                           const StyleOptions& style) {
  if (!style.tile_size_by.empty()) return std::nullopt;
  return whole.motifs_of(tile, style.texture_shift);
}

}  // namespace

TileFollower::TileFollower(const StripeArguments& arguments,
                           std::shared_ptr<const Preparation> prepared)
    : prepared_(std::move(prepared)) {
  if (arguments.waves.cross) {
    cross_.emplace(prepared_->surface, frame_options(arguments.solving.stripes));
  } else {
    texture_.emplace(
        prepared_->surface,
        TextureAnimatorOptions{arguments.waves.oriented, frame_options(arguments.solving.stripes)});
  }
}

void TileFollower::restart() {
  if (texture_) texture_->restart();
  if (cross_) cross_->restart();
}

StripeJob TileFollower::next(const StripeArguments& arguments, const PreparedWaves& waves,
                             const PreparationMetrics& metrics, const Progress& progress) {
  progress.report("tiles", 0);
  return cross_ ? next_cross(arguments, waves, metrics, progress)
                : next_texture(arguments, waves, metrics);
}

StripeJob TileFollower::next_texture(const StripeArguments& arguments, const PreparedWaves& waves,
                                     const PreparationMetrics& metrics) {
  const Surface& surface = prepared_->surface;
  TextureTile tile = chosen_tile(arguments.texture, false).value();
  whole_ = whole_.of_next_texture(arguments.texture.whole);
  const std::optional<TileMotifs> motifs_left_out = motifs_in_frames(whole_, tile, arguments.style);
  texture_->set_whole_tiles(motifs_left_out);
  const TextureFrameResult frame =
      texture_->frame({frame_input(waves.waves), waves.frequencies_v, {}});
  if (frame.broken != nullptr) whole_.know(*motifs_left_out, *frame.broken);
  phase_step_ = frame.u.phase_step;
  TexturePattern pattern = pattern_of_frame(frame, *texture_);
  Report report = make_report(surface, metrics, pattern, arguments.solving.stripes.solver.solver);
  return {{prepared_, &surface},
          {Texture{std::move(pattern), std::move(tile), whole_}},
          std::move(report),
          {prepared_->arrays, prepared_->original_ids, prepared_->partners}};
}

StripeJob TileFollower::next_cross(const StripeArguments& arguments, const PreparedWaves& waves,
                                   const PreparationMetrics& metrics, const Progress& progress) {
  const CrossFrameResult frame = cross_->frame({frame_input(waves.waves), {}}, progress);
  phase_step_ = frame.stripes.phase_step;
  if (frame.matching != CrossMatching::kept || !cross_surface_) {
    cross_surface_ = std::make_shared<const Surface>(make_surface(frame.mesh));
    whole_ = WholeTiles();
    cross_data_ =
        on_cross_texture({prepared_->arrays, prepared_->original_ids, prepared_->partners},
                         prepared_->surface.mesh.triangles, frame.cover);
  }
  CrossTexture texture{{}, pattern_of_frame(frame, *cross_, arguments.solving.stripes.phase_shift)};
  // As for a pattern from scratch: of the surface without the parts of singular triangles.
  Report report =
      make_report(prepared_->surface, metrics, texture, arguments.solving.stripes.solver.solver);
  whole_ = whole_.of_next_texture(arguments.texture.whole);
  Texture drawn{std::move(texture.pattern),
                chosen_tile(arguments.texture, true).value_or(BuiltInTile::checker), whole_};
  return {cross_surface_, {std::move(drawn)}, std::move(report), cross_data_};
}

}  // namespace brindle::tool
