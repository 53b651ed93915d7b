#include <emscripten/bind.h>

#include "brindle/broken_tiles.h"
#include "brindle/corner_phases.h"
#include "brindle/cross_texture.h"
#include "brindle/error.h"
#include "brindle/pattern_of.h"
#include "brindle/pattern_warnings.h"
#include "brindle/render/parsed_words.h"
#include "brindle/renderer.h"
#include "brindle/texture_animator.h"
#include "brindle/texture_coordinates.h"
#include "objects.h"

namespace brindle::web {
namespace {

BuiltInTile tile_named(const std::string& name) {
  const auto tile = parse_built_in_tile(name);
  if (tile) return *tile;
  throw Error("there is no tile '" + name + "'; there are " + std::string(built_in_tile_names()));
}

/// Direction, frequency and phase at all corners, in the layout of texture shaders.
val packed(const std::vector<CornerWaves>& triangles) {
  std::vector<float> numbers;
  numbers.reserve(18 * triangles.size());
  for (const CornerWaves& corners : triangles) {
    for (const auto& [wave, z] : corners) {
      numbers.insert(numbers.end(), wave.direction.begin(), wave.direction.end());
      numbers.insert(numbers.end(), {wave.frequency, z.real(), z.imag()});
    }
  }
  return array_of(numbers);
}

val value_of(const TextureWaves& waves) {
  val result = val::object();
  put(result, "u", packed(waves.u));
  put(result, "v", packed(waves.v));
  return result;
}

/// The kind of a triangle in U or, if regular there, in V.
val kinds_shown(std::span<const CornerPhases> u, std::span<const CornerPhases> v) {
  std::vector<CornerPhases> shown(u.begin(), u.end());
  for (std::size_t t = 0; t < shown.size(); ++t) {
    if (shown[t].kind == TriangleKind::regular) shown[t].kind = v[t].kind;
  }
  return kinds_of(shown);
}

val value_of(const BrokenTiles& broken) {
  val result = val::object();
  put(result, "words", array_of(broken.words));
  put(result, "layout", static_cast<int>(broken.layout));
  put(result, "split", val(broken.split));
  return result;
}

std::shared_ptr<TextureObject> texture(const std::shared_ptr<SurfaceObject>& surface,
                                       const val& directions, float frequency, bool oriented,
                                       const val& given) {
  TextureOptions options;
  options.oriented = oriented;
  options.stripes = stripe_options(given);
  TexturePattern pattern =
      texture_pattern(surface->surface, vectors_of(directions), frequency, options);
  return std::make_shared<TextureObject>(TextureObject{surface, std::move(pattern)});
}

std::shared_ptr<TextureObject> crosses(const std::shared_ptr<SurfaceObject>& surface,
                                       const val& directions, const val& frequencies,
                                       const val& given) {
  const WaveSet waves{surface->surface.mesh.positions, vectors_of(directions),
                      floats_of(frequencies)};
  const CrossPattern cross = cross_pattern(surface->surface, waves, stripe_options(given));
  CrossTexture texture = cross_texture(surface->surface, cross);
  texture.pattern.u.quality = texture.pattern.v.quality = cross.quality;
  texture.pattern.u.solution.energy = texture.pattern.v.solution.energy =
      cross.pattern.solution.energy;
  auto split = std::make_shared<SurfaceObject>();
  split->surface = std::move(texture.surface);
  split->subdivided = surface->subdivided;
  return std::make_shared<TextureObject>(
      TextureObject{std::move(split), std::move(texture.pattern), true});
}

val textured_mesh_of(const TextureObject& object) {
  const TexturedMesh textured = texture_coordinates(object.surface->surface, object.pattern);
  val result = val::object();
  put(result, "positions", array_of(textured.mesh.positions));
  put(result, "triangles", array_of(textured.mesh.triangles));
  const auto* const numbers = reinterpret_cast<const float*>(textured.coordinates.data());
  const Surface& surface = object.surface->surface;
  const auto* const normal = reinterpret_cast<const float*>(surface.normals.data());
  const std::vector<float> normals =
      carried_values(textured, std::span<const float>(normal, 3 * surface.normals.size()), 3);
  put(result, "normals", array_of(normals));
  put(result, "uvs", array_of(std::span<const float>(numbers, 2 * textured.coordinates.size())));
  return result;
}

val texture_metrics_of(const TextureObject& object) {
  const StripePattern &u = object.pattern.u, &v = object.pattern.v;
  val metrics = val::object();
  put(metrics, "branches", u.quality.branches + (object.crosses ? 0 : v.quality.branches));
  put(metrics, "energy", (u.solution.energy + v.solution.energy) / 2);
  return metrics;
}

val waves_of_texture(const TextureObject& object) { return value_of(object.pattern.waves); }

val warnings_of(const TextureObject& object) {
  const SurfaceObject& surface = *object.surface;
  return array_of(pattern_warnings(surface.surface, object.pattern, words_for(surface)));
}

/// The broken motifs of a tile that is drawn whole.
val broken_tiles_of(const TextureObject& object, const std::string& name) {
  const TextureTile tile = tile_named(name);
  BrokenTiles broken;
  if (has_own_shape(tile)) {
    broken = broken_tiles(object.surface->surface.mesh.triangles, object.pattern.waves,
                          tile_motifs(tile));
  }
  return value_of(broken);
}

/// Distances of the centres of side x side texels to the motif, row by row from V = 0.
val tile_distances(const std::string& name, int side) {
  const BuiltInTile tile = tile_named(name);
  const auto sides = static_cast<float>(side);
  std::vector<float> distances;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      distances.push_back(tile_distance(tile, (static_cast<float>(x) + 0.5f) / sides,
                                        (static_cast<float>(y) + 0.5f) / sides));
    }
  }
  return array_of(distances);
}

val corner_uvs_of(const TextureObject& object) {
  return array_of(corner_texture_coordinates(object.pattern.waves, object.pattern.phase_shift));
}

/// Animates textures. JavaScript's arrays are copied, so that no spans into them remain.
struct TextureAnimatorObject {
  std::shared_ptr<SurfaceObject> surface;
  TextureAnimator animator;
};

std::shared_ptr<TextureAnimatorObject> texture_animator(
    const std::shared_ptr<SurfaceObject>& surface, const val& given) {
  TextureAnimatorOptions options;
  options.stripes = animator_options(given);
  options.oriented = given["oriented"].as<bool>();
  const std::string tile = text_of(given, "tile");
  if (!tile.empty()) {
    const TextureTile named = tile_named(tile);
    if (has_own_shape(named)) options.whole_tiles = tile_motifs(named);
  }
  return std::make_shared<TextureAnimatorObject>(
      TextureAnimatorObject{surface, TextureAnimator(surface->surface, options)});
}

val texture_frame(TextureAnimatorObject& object, const val& input) {
  const GivenFrame given(object.surface->surface.mesh, input);
  const TextureFrameInput frame{given.input, {}, given.input.normals};
  const TextureFrameResult made = object.animator.frame(frame);
  const TextureFrameMilliseconds& t = made.milliseconds;
  val result = val::object();
  put(result, "waves", value_of(made.pattern.waves));
  put(result, "triangleKinds", kinds_shown(made.pattern.u.corners, made.pattern.v.corners));
  put(result, "broken", value_of(made.broken ? *made.broken : BrokenTiles{}));
  put(result, "branches", made.pattern.u.quality.branches + made.pattern.v.quality.branches);
  put(result, "energy", (object.animator.energy_u() + object.animator.energy_v()) / 2);
  put(result, "unchanged", val(made.u.unchanged && made.v.unchanged));
  put(result, "milliseconds", t.solve + t.orient + t.measure + t.tiles);
  return result;
}

/// The next frame, on the surface's positions, as a permanent texture.
std::shared_ptr<TextureObject> frame_as_texture(TextureAnimatorObject& object, const val& input) {
  const GivenFrame given(object.surface->surface.mesh, input);
  const TextureFrameResult made = object.animator.frame({given.input, {}, {}});
  return std::make_shared<TextureObject>(
      TextureObject{object.surface, pattern_of_frame(made, object.animator)});
}

void follow(TextureAnimatorObject& object, const TextureObject& last) {
  object.animator.set_last_phases(last.pattern.u.solution.z, last.pattern.v.solution.z);
}

void restart(TextureAnimatorObject& object) { object.animator.restart(); }

}  // namespace

void bind_textures() {
  using namespace emscripten;
  class_<TextureObject>("TextureObject")
      .smart_ptr<std::shared_ptr<TextureObject>>("TexturePointer")
      .function("cornerUVs", guarded<corner_uvs_of>)
      .function("waves", guarded<waves_of_texture>)
      .function("kinds", optional_override([](const TextureObject& t) {
                  return kinds_shown(t.pattern.u.corners, t.pattern.v.corners);
                }))
      .function("metrics", &texture_metrics_of)
      .function("warnings", guarded<warnings_of>)
      .function("brokenTiles", guarded<broken_tiles_of>)
      .function("surface", optional_override([](const TextureObject& t) { return t.surface; }))
      .function("mesh", guarded<textured_mesh_of>);
  class_<TextureAnimatorObject>("TextureAnimatorObject")
      .smart_ptr<std::shared_ptr<TextureAnimatorObject>>("TextureAnimatorPointer")
      .function("frame", guarded<texture_frame>)
      .function("texture", guarded<frame_as_texture>)
      .function("follow", guarded<follow>)
      .function("restart", guarded<restart>);
  function("texture", guarded<texture>);
  function("crosses", guarded<crosses>);
  function("textureAnimator", guarded<texture_animator>);
  function("tileDistances", guarded<tile_distances>);
  function("tileNames", optional_override([] { return std::string(built_in_tile_names()); }));
}

}  // namespace brindle::web
