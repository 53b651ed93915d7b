#include "session/tile_follower.h"

#include <algorithm>
#include <utility>

#include "brindle/cross_texture.h"

namespace brindle::tool {
namespace {

FrameInput frame_input(const WaveSet& waves) {
  return {waves.positions, waves.directions, waves.frequencies};
}

StripeMilliseconds times_of(const FrameMilliseconds& frame) {
  StripeMilliseconds times;
  times.couple = frame.couple;
  times.solve = frame.sum + frame.solve;
  return times;
}

StripePattern pattern_of(const TexturePatternFrame& frame, WaveSet waves, double energy,
                         PhaseShiftKind phase_shift) {
  StripePattern pattern;
  pattern.waves = std::move(waves);
  pattern.phase_shift = phase_shift;
  pattern.solution.z.assign(frame.stripes.z.begin(), frame.stripes.z.end());
  pattern.solution.energy = energy;
  pattern.corners.assign(frame.corners.begin(), frame.corners.end());
  pattern.quality = frame.quality;
  pattern.milliseconds = times_of(frame.stripes.milliseconds);
  return pattern;
}

/// The waves (i, 0) of a cross texture's vertices, with the figures of both waves together. Parts
/// of singular triangles are singular, and vertices in their middle have no wave.
StripePattern pattern_of(const CrossFrameResult& frame, double energy, PhaseShiftKind kind) {
  StripePattern pattern;
  const WaveSet& nodes = frame.cover.waves;
  pattern.waves.positions = frame.mesh.positions;
  pattern.waves.directions.assign(frame.mesh.vertex_count(), Vec3::Zero());
  pattern.waves.frequencies.assign(frame.mesh.vertex_count(), nodes.frequencies.front());
  for (std::size_t i = 0; 2 * i < nodes.directions.size(); ++i) {
    pattern.waves.directions[i] = nodes.directions[2 * i];
    pattern.waves.frequencies[i] = nodes.frequencies[2 * i];
  }
  pattern.corners = corner_phases(frame.waves.u, kind);
  for (std::size_t t = frame.cover.base.size(); t < pattern.corners.size(); ++t) {
    pattern.corners[t].kind = TriangleKind::field_singularity;
  }
  pattern.phase_shift = kind;
  pattern.solution.energy = energy;
  pattern.quality = frame.quality;
  pattern.milliseconds = times_of(frame.stripes.milliseconds);
  return pattern;
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
  WaveSet v = waves_across(waves.waves, surface.normals);
  if (!waves.frequencies_v.empty()) v.frequencies = waves.frequencies_v;
  TexturePattern pattern;
  pattern.u = pattern_of(frame.u, waves.waves, texture_->energy_u(), kind);
  pattern.v = pattern_of(frame.v, std::move(v), texture_->energy_v(), kind);
  pattern.waves = frame.waves;
  pattern.seams = frame.seams;
  pattern.quality = frame.quality;
  pattern.phase_shift = kind;
  pattern.orientation_milliseconds = frame.milliseconds.orient + frame.milliseconds.measure;
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
  CrossTexture texture;
  texture.pattern.u = pattern_of(frame, cross_->energy(), arguments.solving.stripes.phase_shift);
  texture.pattern.waves = frame.waves;
  texture.pattern.quality = frame.texture;
  texture.pattern.phase_shift = arguments.solving.stripes.phase_shift;
  texture.pattern.orientation_milliseconds = frame.milliseconds.orient + frame.milliseconds.measure;
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
