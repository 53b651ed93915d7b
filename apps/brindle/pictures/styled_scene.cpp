#include "pictures/styled_scene.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "brindle/direction_field.h"
#include "brindle/feature_lines.h"
#include "brindle/ink.h"
#include "brindle/mesh.h"
#include "brindle/render/drawing/pen_order.h"
#include "brindle/render/parsed_words.h"
#include "pictures/picture.h"
#include "pictures/texture_options.h"

namespace brindle::tool {
namespace {

constexpr ValueRange kTones{0.3f, 0.95f};
constexpr WidthRange kLightWidths{0, 0.8f, WidthUnit::period};

Preparation prepare_other(const OtherSurfaceChoice& choice, const WaveOptions& waves,
                          float frequency, const Viewpoint& viewpoint, JobListener& listener) {
  const SurfaceOptions options{.mesh = choice.mesh, .moved = choice.moved.cast<float>()};
  refuse_points(options, "stripe --with");
  if (!choice.has_pattern()) return prepare_surface(options, listener);
  WaveOptions own = waves;
  // They are on MESH.
  own.strokes.clear();
  own.drawn_strokes.clear();
  own.stripes_v.reset();
  own.frequency_v.reset();
  own.stripes = choice.stripes;
  own.frequency.reset();
  own.spacing.reset();
  if (!choice.stripes) {
    own.frequency = frequency;  // the density of MESH
    own.frequency_factor = 1;   // already included
  }
  if (choice.rotate_deg) own.rotate_deg = *choice.rotate_deg;
  return prepare(options, own, listener, viewpoint);
}

}  // namespace

float mean_frequency(const WaveSet& waves) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t v = 0; v < waves.directions.size(); ++v) {
    if (waves.directions[v].isZero(0)) continue;
    sum += static_cast<double>(waves.frequencies[v]);
    ++count;
  }
  return static_cast<float>(sum / static_cast<double>(std::max<std::size_t>(count, 1)));
}

std::vector<Preparation> read_others(const StyleOptions& style, const WaveOptions& waves,
                                     float frequency, const Viewpoint& viewpoint,
                                     JobListener& listener) {
  std::vector<Preparation> others;
  for (const OtherSurfaceChoice& choice : style.others) {
    others.push_back(prepare_other(choice, waves, frequency, viewpoint, listener));
  }
  return others;
}

std::vector<OtherSurface> solve_others(const StyleOptions& style, std::vector<Preparation> read,
                                       const StripeOptions& options, const Progress& progress) {
  std::vector<OtherSurface> others;
  for (std::size_t i = 0; i < read.size(); ++i) {
    OtherSurface other{std::move(read[i].surface), std::nullopt};
    const OtherSurfaceChoice& choice = style.others[i];
    if (choice.striped) {
      other.result.emplace(
          StripeResult{stripe_pattern(other.surface, std::move(read[i].waves), options, progress)});
    } else if (const auto tile = parse_built_in_tile(choice.tile)) {
      other.result.emplace(StripeResult{Texture{
          texture_pattern(other.surface, std::move(read[i].waves), {.stripes = options}, progress),
          *tile, WholeTiles()}});
    }
    others.push_back(std::move(other));
  }
  return others;
}

Mesh framed_mesh(const Mesh& mesh, std::span<const Preparation> others) {
  Mesh framed = mesh;
  for (const Preparation& other : others) append(other.surface.mesh, framed);
  return framed;
}

StyledOptions styled_options(const StyleOptions& style, const PictureOptions& picture,
                             const Eigen::Vector3d& origin, const StyleBindings& followed) {
  StyledOptions options;
  options.render = render_options(picture, origin);
  options.render.transparent = style.transparent;
  options.depth_cue = style.depth_cue;
  options.occlusion = style.occlusion;
  options.ground_shadow = style.ground_shadow;
  options.scale = followed.scale;
  options.right_margin =
      legend_width(followed.legends, options.render.width, options.render.height);
  return options;
}

namespace {

Strokes strokes_of(const StripesView& pattern, const StyleOptions& style,
                   const RenderOptions& render, const StyleBindings& followed) {
  Strokes strokes{.waves = &pattern.waves, .z = pattern.z, .color = render.stripe_color};
  strokes.width = render.stripe_width;
  strokes.spacing = style.spacing.value_or(0.0f);
  strokes.opacities = followed.opacities;
  if (style.color_on != ColoredPart::surface) strokes.color_places = followed.places;
  if (style.pixel_width) {
    strokes.width = *style.pixel_width;
    strokes.unit = WidthUnit::pixels;
  } else if (style.by_light()) {
    const WidthRange widths = style.width_range.value_or(kLightWidths);
    const ValueRange tones = style.tones.value_or(kTones);
    const float widest = std::max(widths.last, 1e-6f);
    strokes.width = widths.last;
    strokes.unit = widths.unit;
    strokes.tone = ToneRange{tones.highest, tones.lowest, std::min(widths.first / widest, 1.0f)};
  } else if (!followed.widths.empty()) {
    strokes.widths = followed.widths;
    strokes.unit = style.width_range.value_or(WidthRange()).unit;
  }
  return strokes;
}

/// Crossing strokes are full at the darkest tone that the light of pictures leaves.
ToneRange crossing_tones(float lightest) {
  constexpr float kDarkest = 0.35f;
  return {lightest, std::min(kDarkest, 0.9f * lightest), 0};
}

RegionTexture region_texture(const TextureView& texture, const StyleOptions& style,
                             const RenderOptions& render, const StyleBindings& followed) {
  RegionTexture result{.waves = &texture.waves, .shift = texture.shift};
  result.tiles.push_back({texture.tile, render.stripe_color});
  for (const RegionChoice& region : style.regions) {
    result.tiles.push_back({region.tile, region.color.value_or(render.stripe_color), region.from});
  }
  for (std::size_t i = 0; i < texture.broken.size(); ++i) {
    result.tiles[i].broken = texture.broken[i].get();
  }
  result.values = followed.regions;
  result.sizes = followed.tile_sizes;
  return result;
}

/// The surface, which outlives the texture, owns the broken tiles.
RegionTexture texture_of(const OtherSurface& other, const Texture& texture, const Color& motif) {
  RegionTexture drawn{.waves = &texture.pattern.waves};
  drawn.tiles.push_back({texture.tile, motif, 0, texture.broken(other.surface.mesh).get()});
  return drawn;
}

/// `places`: of its colours, or empty.
StyledSurface other_surface(const OtherSurface& other, const OtherSurfaceChoice& choice,
                            const StyleOptions& style, const RenderOptions& render,
                            std::span<const float> places) {
  StyledSurface surface{.mesh = other.surface.mesh,
                        .normals = other.surface.normals,
                        .color = choice.color.value_or(kOtherColor),
                        .between = choice.between,
                        .shading = !style.flat,
                        .tinted = choice.tinted,
                        .sliced = !choice.whole};
  if (!choice.colors_pattern()) surface.color_places = places;
  if (!other.result) return surface;
  // If nothing of the surface is left, its colour is that of its pattern.
  const bool alone = choice.between == BetweenStrokes::discarded && choice.color;
  const Color color = choice.stripe_color.value_or(alone ? *choice.color : render.stripe_color);
  const std::span<const float> of_pattern =
      choice.colors_pattern() ? places : std::span<const float>();
  if (const Texture* texture = other.result->texture()) {
    surface.texture = texture_of(other, *texture, color);
    surface.texture->color_places = of_pattern;
    return surface;
  }
  const StripePattern& stripes = other.result->stripes();
  surface.strokes.push_back({.waves = &stripes.waves,
                             .z = stripes.solution.z,
                             .color = color,
                             .width = choice.stripe_width.value_or(render.stripe_width),
                             .color_places = of_pattern});
  return surface;
}

}  // namespace

std::vector<LeftOutTiles> left_out_tiles(std::span<const Triangle> triangles,
                                         const TextureView& texture, const StyleOptions& style,
                                         const StyleBindings& followed, const WholeTiles& whole) {
  const std::vector<float>& sizes = followed.tile_sizes;
  // NaN counts as smaller than any number here.
  const float size = std::accumulate(sizes.begin(), sizes.end(), sizes.empty() ? 1.0f : 0.0f,
                                     [](float a, float b) { return b > a ? b : a; });
  const auto of = [&](const TextureTile& tile) {
    return whole.broken(triangles, texture.waves, tile, texture.shift, size);
  };
  std::vector<LeftOutTiles> broken;
  broken.push_back(of(texture.tile));
  for (const RegionChoice& region : style.regions) broken.push_back(of(region.tile));
  return broken;
}

StyledSurface main_surface(const StyledScene& scene, const StyleOptions& style,
                           const RenderOptions& render, const StyleBindings& followed) {
  StyledSurface surface{
      .mesh = scene.surface.mesh, .normals = scene.surface.normals, .color = render.base_color};
  if (scene.texture) {
    surface.texture = region_texture(*scene.texture, style, render, followed);
    (style.color_on == ColoredPart::motifs ? surface.texture->color_places : surface.color_places) =
        followed.places;
    surface.shading = !style.flat;
    if (style.discard) surface.between = BetweenStrokes::discarded;
    return surface;
  }
  surface.strokes.push_back(strokes_of(scene.pattern, style, render, followed));
  if (scene.crossing) {
    Strokes crossing = strokes_of(*scene.crossing, style, render, followed);
    crossing.tone = crossing_tones(*style.cross_hatch);
    surface.strokes.push_back(crossing);
  }
  if (style.color_on == ColoredPart::surface) surface.color_places = followed.places;
  if (style.discard) surface.between = BetweenStrokes::discarded;
  surface.shading = !style.flat && !style.by_light();
  return surface;
}

std::vector<StyledSurface> surfaces_of(const StyledScene& scene, const StyleOptions& style,
                                       const RenderOptions& render, const StyleBindings& followed) {
  std::vector<StyledSurface> surfaces{main_surface(scene, style, render, followed)};
  for (std::size_t i = 0; i < scene.others.size(); ++i) {
    const std::vector<std::vector<float>>& places = followed.other_places;
    surfaces.push_back(other_surface(scene.others[i], style.others[i], style, render,
                                     i < places.size() ? places[i] : std::span<const float>()));
  }
  return surfaces;
}

namespace {

/// The mesh that hides lines: all surfaces that are not discarded.
Mesh hiding_mesh(std::span<const StyledSurface> surfaces) {
  Mesh mesh;
  for (const StyledSurface& surface : surfaces) {
    if (surface.between == BetweenStrokes::surface) append(surface.mesh, mesh);
  }
  return mesh;
}

/// Outlines and creases of a picture's surfaces. `width` is that of lines.
class LineInk {
 public:
  LineInk(std::span<const StyledSurface> surfaces, const StyleOptions& style,
          const StyledOptions& options, float width, const Progress& progress)
      : style_(style),
        camera_(styled_camera(surfaces, options)),
        visibility_(hiding_mesh(surfaces), camera_, options.render.width, options.render.height,
                    progress),
        width_(width) {}

  void add_outline(const StyledSurface& surface, const StripesView* pattern,
                   const Progress& progress) {
    if (camera_.slice) {
      add(slice_lines(surface.mesh, surface.normals, *camera_.slice), progress);
    }
    const Polylines lines = silhouette_lines(surface.mesh, surface.normals, viewpoint_of(camera_));
    if (style_.outline == OutlineStyle::dashed && pattern != nullptr) {
      const bool shares = !surface.strokes.empty() && surface.strokes[0].width > 0 &&
                          surface.strokes[0].unit == WidthUnit::period;
      const float width = shares ? surface.strokes[0].width : 0.5f;
      add(dashes_of(lines, surface.mesh, pattern->waves, pattern->z, width), progress);
    } else {
      add(lines, progress);
    }
  }
  void add_creases(const StyledSurface& surface, const Progress& progress) {
    add(crease_lines(surface.mesh, surface.normals, *style_.crease_deg, progress.part(0, 0.5)),
        progress.part(0.5, 1));
  }

  /// Pens with coordinates times `scale`.
  std::vector<Pen> pens(float scale) const {
    const auto scaled = [&](std::vector<Stroke> strokes) {
      for (Stroke& stroke : strokes) {
        for (Eigen::Vector2f& point : stroke) point *= scale;
      }
      return strokes;
    };
    return {{"hidden", kLineColor, 0.6f * scale * width_, scaled(hidden_)},
            {"lines", kLineColor, scale * width_, scaled(seen_)}};
  }

  void draw(Image& image, float scale) const {
    constexpr std::array kOpacities = {0.75f, 1.0f};
    const std::vector<Pen> drawn = pens(scale);
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      ink(image, drawn[i].strokes, drawn[i].width, drawn[i].color, kOpacities[i]);
    }
  }

 private:
  void add(const Polylines& lines, const Progress& progress) {
    // Silhouettes are beside those of the depths.
    constexpr float kTolerance = 0.008f;
    const auto append_to = [](std::vector<Stroke>& strokes, std::vector<Stroke> more) {
      strokes.insert(strokes.end(), std::make_move_iterator(more.begin()),
                     std::make_move_iterator(more.end()));
    };
    append_to(seen_, visibility_.strokes(lines, kTolerance, false, progress.part(0, 0.5)));
    if (!style_.hidden_dashed) return;
    append_to(hidden_, dashed(visibility_.strokes(lines, kTolerance, true, progress.part(0.5, 1)),
                              3 * width_, 2.5f * width_));
  }

  static constexpr Color kLineColor{0.10f, 0.10f, 0.12f};

  const StyleOptions& style_;
  Camera camera_;
  Visibility visibility_;
  float width_;
  std::vector<Stroke> seen_, hidden_;
};

LineInk lines_of(const StyledScene& scene, std::span<const StyledSurface> surfaces,
                 const StyleOptions& style, const StyledOptions& options, float width,
                 const Progress& progress) {
  constexpr double kSeen = 0.3;
  LineInk lines(surfaces, style, options, width, progress.part(0, kSeen));
  const double share = (1 - kSeen) / static_cast<double>(surfaces.size());
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const bool main = i == 0;
    const double begin = kSeen + static_cast<double>(i) * share, middle = begin + 0.5 * share;
    if (style.outline != OutlineStyle::none || (!main && style.others[i - 1].outlined)) {
      lines.add_outline(surfaces[i], main ? &scene.pattern : nullptr, progress.part(begin, middle));
    }
    if (style.crease_deg) {
      lines.add_creases(surfaces[i], progress.part(middle, begin + share));
    }
  }
  return lines;
}

}  // namespace

float line_width_of(const StyleOptions& style, int height) {
  return style.line_width.value_or(std::max(1.2f, 0.0025f * static_cast<float>(height)));
}

void draw_lines(Image& image, const StyledScene& scene, std::span<const StyledSurface> surfaces,
                const StyleOptions& style, const StyledOptions& options, const Progress& progress) {
  if (!style.has_lines()) return;
  const float scale = static_cast<float>(image.height) / static_cast<float>(options.render.height);
  const float width = line_width_of(style, image.height) / scale;
  lines_of(scene, surfaces, style, options, width, progress).draw(image, scale);
}

std::vector<Pen> pens_of_lines(const StyledScene& scene, std::span<const StyledSurface> surfaces,
                               const StyleOptions& style, const StyledOptions& options, float scale,
                               const Progress& progress) {
  if (!style.has_lines()) return {};
  const float width = line_width_of(style, options.render.height);
  constexpr double kOrdered = 0.95;
  std::vector<Pen> pens =
      lines_of(scene, surfaces, style, options, width, progress.part(0, kOrdered)).pens(scale);
  order_strokes(pens, progress.part(kOrdered, 1));
  return pens;
}

}  // namespace brindle::tool
