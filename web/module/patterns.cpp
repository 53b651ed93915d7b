#include <tuple>

#include <emscripten/bind.h>

#include "brindle/broken_tiles.h"
#include "brindle/corner_phases.h"
#include "brindle/error.h"
#include "brindle/pattern_warnings.h"
#include "brindle/polylines.h"
#include "brindle/render/parsed_words.h"
#include "brindle/renderer.h"
#include "brindle/samples.h"
#include "brindle/texture_coordinates.h"
#include "objects.h"

namespace brindle::web {
namespace {

StripeOptions options_of(const val& given) {
  StripeOptions options;
  options.slack = given["slack"].as<float>();
  options.solver.cycles = given["cycles"].as<int>();
  options.last_phases = [&] {
    const std::vector<float> parts = floats_of(given["lastPhases"]);
    std::vector<Complex> phases(parts.size() / 2);
    for (std::size_t i = 0; i < phases.size(); ++i) phases[i] = {parts[2 * i], parts[2 * i + 1]};
    return phases;
  }();
  return options;
}

std::shared_ptr<PatternObject> stripes(std::shared_ptr<SurfaceObject> surface, val directions,
                                       val frequencies, val given) {
  return guarded([&] {
    StripePattern pattern = stripe_pattern(surface->surface, vectors_of(directions),
                                           floats_of(frequencies), options_of(given));
    return std::make_shared<PatternObject>(PatternObject{surface, std::move(pattern)});
  });
}

std::shared_ptr<TextureObject> texture(std::shared_ptr<SurfaceObject> surface, val directions,
                                       float frequency, bool oriented, val given) {
  return guarded([&] {
    TextureOptions options;
    options.oriented = oriented;
    options.stripes = options_of(given);
    TexturePattern pattern =
        texture_pattern(surface->surface, vectors_of(directions), frequency, options);
    return std::make_shared<TextureObject>(TextureObject{surface, std::move(pattern)});
  });
}

BuiltInTile tile_named(const std::string& name) {
  const auto tile = parse_built_in_tile(name);
  if (tile) return *tile;
  throw Error("there is no tile '" + name + "'; there are " + std::string(built_in_tile_names()));
}

val figures_of(const PatternObject& object) {
  const StripePattern& p = object.pattern;
  val figures = val::object();
  figures.set("energy", p.solution.energy);
  figures.set("branches", p.quality.branches);
  figures.set("fieldSingularities", p.quality.field_singularities);
  figures.set("angleErrorMean", p.quality.angle_error_mean_deg);
  figures.set("spacingErrorMean", p.quality.spacing_error_mean);
  figures.set("verticesWithoutWave", p.quality.vertices_without_wave);
  val milliseconds = val::object();
  milliseconds.set("topology", p.milliseconds.topology);
  milliseconds.set("frequency", p.milliseconds.frequency);
  milliseconds.set("couple", p.milliseconds.couple);
  milliseconds.set("solve", p.milliseconds.solve);
  milliseconds.set("pattern", p.milliseconds.pattern);
  figures.set("milliseconds", milliseconds);
  if (p.frequency_change) {
    val change = val::object();
    change.set("ratioMin", p.frequency_change->ratio_min);
    change.set("ratioMax", p.frequency_change->ratio_max);
    figures.set("frequencyChange", change);
  }
  return figures;
}

val kinds_of(const PatternObject& object) {
  std::vector<std::uint8_t> kinds;
  kinds.reserve(object.pattern.corners.size());
  for (const CornerPhases& corners : object.pattern.corners) {
    kinds.push_back(static_cast<std::uint8_t>(corners.kind));
  }
  return array_of(std::span<const std::uint8_t>(kinds));
}

val lines_of(const Polylines& lines) {
  val result = val::object();
  result.set("points", array_of(std::span<const Vec3>(lines.points)));
  result.set("normals", array_of(std::span<const Vec3>(lines.normals)));
  result.set("offsets", array_of(std::span<const std::uint32_t>(lines.offsets)));
  result.set("closed", array_of(std::span<const std::uint8_t>(lines.closed)));
  return result;
}

val curves_of(const PatternObject& object, bool join, float trim) {
  return guarded([&] {
    CurveOptions options;
    options.join = join;
    options.trim = trim;
    const StripeCurves curves = stripe_curves(object.surface->surface, object.pattern, options);
    val result = lines_of(curves.lines);
    std::vector<std::uint8_t> ends;
    for (const auto& both : curves.ends) {
      for (const CurveEnd end : both) ends.push_back(static_cast<std::uint8_t>(end));
    }
    result.set("ends", array_of(std::span<const std::uint8_t>(ends)));
    return result;
  });
}

val samples_of(const PatternObject& u, const PatternObject& v) {
  return guarded([&] {
    const std::vector<Sample> samples = stripe_samples(u.surface->surface, u.pattern, v.pattern);
    std::vector<Vec3> positions, normals;
    std::vector<std::uint32_t> triangles;
    std::vector<Vec3> barycentric;
    for (const Sample& sample : samples) {
      positions.push_back(sample.position);
      normals.push_back(sample.normal);
      triangles.push_back(sample.triangle);
      barycentric.push_back(sample.barycentric);
    }
    val result = val::object();
    result.set("positions", array_of(std::span<const Vec3>(positions)));
    result.set("normals", array_of(std::span<const Vec3>(normals)));
    result.set("triangles", array_of(std::span<const std::uint32_t>(triangles)));
    result.set("barycentric", array_of(std::span<const Vec3>(barycentric)));
    return result;
  });
}

val textured_mesh_of(const TextureObject& object) {
  return guarded([&] {
    const TexturedMesh textured = texture_coordinates(object.surface->surface, object.pattern);
    const std::vector<Triangle>& triangles = textured.mesh.triangles;
    val result = val::object();
    result.set("positions", array_of(std::span<const Vec3>(textured.mesh.positions)));
    result.set("triangles", array_of(std::span<const std::uint32_t>(triangles.data()->data(),
                                                                    3 * triangles.size())));
    const auto* const numbers = reinterpret_cast<const float*>(textured.coordinates.data());
    const Surface& surface = object.surface->surface;
    const auto* const normal = reinterpret_cast<const float*>(surface.normals.data());
    const std::vector<float> normals =
        carried_values(textured, std::span<const float>(normal, 3 * surface.normals.size()), 3);
    result.set("normals", array_of(std::span<const float>(normals)));
    result.set("uvs", array_of(std::span<const float>(numbers, 2 * textured.coordinates.size())));
    return result;
  });
}

/// Direction, frequency and phase at all corners, as shaders of textures read them.
val packed(const std::vector<CornerWaves>& triangles) {
  std::vector<float> numbers;
  numbers.reserve(18 * triangles.size());
  for (const CornerWaves& corners : triangles) {
    for (const auto& [wave, z] : corners) {
      numbers.insert(numbers.end(), wave.direction.begin(), wave.direction.end());
      numbers.insert(numbers.end(), {wave.frequency, z.real(), z.imag()});
    }
  }
  return array_of(std::span<const float>(numbers));
}

val texture_waves_of(const TextureObject& object) {
  return guarded([&] {
    val result = val::object();
    result.set("u", packed(object.pattern.waves.u));
    result.set("v", packed(object.pattern.waves.v));
    return result;
  });
}

/// What is in a triangle of U, or if that is regular, of V.
val texture_kinds_of(const TextureObject& object) {
  const auto& [u, v] = std::tie(object.pattern.u.corners, object.pattern.v.corners);
  std::vector<std::uint8_t> kinds;
  kinds.reserve(u.size());
  for (std::size_t t = 0; t < u.size(); ++t) {
    const TriangleKind kind = u[t].kind == TriangleKind::regular ? v[t].kind : u[t].kind;
    kinds.push_back(static_cast<std::uint8_t>(kind));
  }
  return array_of(std::span<const std::uint8_t>(kinds));
}

val texture_figures_of(const TextureObject& object) {
  const StripePattern &u = object.pattern.u, &v = object.pattern.v;
  val figures = val::object();
  figures.set("branches", u.quality.branches + v.quality.branches);
  figures.set("energy", (u.solution.energy + v.solution.energy) / 2);
  return figures;
}

/// The figures of a tile that branches, seams and borders cut, where the tile is to have none.
val broken_tiles_of(const TextureObject& object, std::string name) {
  return guarded([&] {
    const TextureTile tile = tile_named(name);
    BrokenTiles broken;
    if (has_own_shape(tile)) {
      broken = broken_tiles(object.surface->surface.mesh.triangles, object.pattern.waves,
                            tile_figures(tile));
    }
    val result = val::object();
    result.set("words", array_of(std::span<const std::uint32_t>(broken.words)));
    result.set("layout", static_cast<int>(broken.layout));
    result.set("split", broken.split);
    return result;
  });
}

/// Distances from the middles of side x side texels to the figure, row by row from V = 0.
val tile_distances(std::string name, int side) {
  return guarded([&] {
    const BuiltInTile tile = tile_named(name);
    const auto sides = static_cast<float>(side);
    std::vector<float> distances;
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        distances.push_back(tile_distance(tile, (static_cast<float>(x) + 0.5f) / sides,
                                          (static_cast<float>(y) + 0.5f) / sides));
      }
    }
    return array_of(std::span<const float>(distances));
  });
}

val corner_uvs_of(const TextureObject& object) {
  return guarded([&] {
    const std::vector<float> uvs =
        corner_texture_coordinates(object.pattern.waves, object.pattern.phase_shift);
    return array_of(std::span<const float>(uvs));
  });
}

}  // namespace

void bind_patterns() {
  using namespace emscripten;
  class_<PatternObject>("PatternObject")
      .smart_ptr<std::shared_ptr<PatternObject>>("PatternPointer")
      .function("figures", &figures_of)
      .function("kinds", &kinds_of)
      .function("phases", optional_override([](const PatternObject& p) {
                  return array_of(std::span<const Complex>(p.pattern.solution.z));
                }))
      .function("directions", optional_override([](const PatternObject& p) {
                  return array_of(std::span<const Vec3>(p.pattern.waves.directions));
                }))
      .function("frequencies", optional_override([](const PatternObject& p) {
                  return array_of(std::span<const float>(p.pattern.waves.frequencies));
                }))
      .function("warnings", optional_override([](const PatternObject& p) {
                  return guarded(
                      [&] { return array_of(pattern_warnings(p.surface->surface, p.pattern)); });
                }))
      .function("curves", &curves_of);
  class_<TextureObject>("TextureObject")
      .smart_ptr<std::shared_ptr<TextureObject>>("TexturePointer")
      .function("cornerUVs", &corner_uvs_of)
      .function("waves", &texture_waves_of)
      .function("kinds", &texture_kinds_of)
      .function("figures", &texture_figures_of)
      .function("brokenTiles", &broken_tiles_of)
      .function("mesh", &textured_mesh_of);
  function("stripes", &stripes);
  function("texture", &texture);
  function("samples", &samples_of);
  function("tileDistances", &tile_distances);
  function("tileNames", optional_override([] { return std::string(built_in_tile_names()); }));
}

}  // namespace brindle::web
