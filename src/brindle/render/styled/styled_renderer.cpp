#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "brindle/error.h"
#include "brindle/gl/gl_buffer.h"
#include "brindle/headless_context.h"
#include "brindle/mesh.h"
#include "brindle/render/gl_surface.h"
#include "brindle/render/gl_target.h"
#include "brindle/render/sample_groups.h"
#include "brindle/render/styled/gl_style.h"
#include "brindle/render/styled/ground_shadow.h"
#include "brindle/render/styled/styled_programs.h"
#include "brindle/render/tiled_picture.h"
#include "brindle/render/visible_triangles.h"
#include "brindle/styled_picture.h"

namespace brindle {
namespace {

constexpr int kVisibleSamples =
    2;  // along the side of a light sample, as visible_samples.glsl has it
constexpr GLuint kListsBinding = 4;
constexpr std::size_t kListedInPixel = 8;  // triangles, on average over all of a draft
constexpr int kMostListed = 1 << 19;       // pixels with lists, which take 100 bytes each
constexpr GLuint kShadowUnit = 14;
constexpr GLuint kSurroundingsUnit = 14;  // of surfaces, which the shadow is not laid on
constexpr GLuint kColorMapUnit = 15;
constexpr float kOcclusionReach = 0.11f;  // of the surfaces' diagonal

/// A surface and what was uploaded of it.
struct DrawnSurface {
  Mesh mesh;  ///< relative to the origin of the first surface
  GlSurface surface;
  GlStyle style;
  bool tinted = true;    ///< by the depth cue
  bool sliced = true;    ///< as the camera says
  int first_number = 0;  ///< of its triangles among those of all surfaces
};

/// Positions relative to `origin`.
Mesh moved_to(const Mesh& mesh, const Eigen::Vector3d& origin) {
  Mesh moved = mesh;
  const Vec3 offset = (mesh.origin - origin).cast<float>();
  for (Vec3& position : moved.positions) position += offset;
  moved.origin = origin;
  return moved;
}

GlTexture color_map_texture(ColorMap map) {
  constexpr int kTexels = 256;
  std::vector<Vec3> texels;
  for (int i = 0; i < kTexels; ++i) {
    texels.push_back(linear_light(map_color(map, static_cast<float>(i) / (kTexels - 1))));
  }
  GLuint name = 0;
  glCreateTextures(GL_TEXTURE_1D, 1, &name);
  GlTexture texture(name);
  glTextureStorage1D(texture, 1, GL_RGB32F, kTexels);
  glTextureSubImage1D(texture, 0, 0, kTexels, GL_RGB, GL_FLOAT, texels.data());
  glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTextureParameteri(texture, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTextureParameteri(texture, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  return texture;
}

/// Two axes along the ground and the one off it.
Eigen::Matrix3f ground_axes(UpAxis up) {
  Eigen::Matrix3f axes;
  if (up == UpAxis::z) {
    axes = Eigen::Matrix3f::Identity();
  } else {
    axes.col(0) = Vec3::UnitZ();
    axes.col(1) = Vec3::UnitX();
    axes.col(2) = Vec3::UnitY();
  }
  return axes;
}

GlTexture shadow_texture(const GroundShadow& shadow) {
  GLuint name = 0;
  glCreateTextures(GL_TEXTURE_2D, 1, &name);
  GlTexture texture(name);
  glTextureStorage2D(texture, 1, GL_R32F, GroundShadow::kSide, GroundShadow::kSide);
  glTextureSubImage2D(texture, 0, 0, 0, GroundShadow::kSide, GroundShadow::kSide, GL_RED, GL_FLOAT,
                      shadow.missing.data());
  glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTextureParameteri(texture, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTextureParameteri(texture, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(texture, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

/// Distances from the camera of the nearest and the farthest point.
Eigen::Vector2f depth_range(std::span<const Vec3> points, const Camera& camera) {
  Eigen::Vector2f range(std::numeric_limits<float>::max(), 0);
  for (const Vec3& point : points) {
    const Vec3 relative = point - camera.origin;
    const float depth = -(camera.view_from_world * relative.homogeneous()).z();
    range = {std::min(range[0], depth), std::max(range[1], depth)};
  }
  if (!(range[1] > range[0])) return {0, 1};
  return range;
}

/// Frames the points in the part of the picture that is left of the margin.
Camera camera_beside(std::span<const Vec3> points, const RenderOptions& render, int margin) {
  const int width = render.width - margin;
  Camera camera = framed_camera(points, render.camera, width, render.height);
  const float share = static_cast<float>(width) / static_cast<float>(render.width);
  camera.clip_from_view.row(0) *= share;
  camera.clip_from_view.row(0) -= (1 - share) * camera.clip_from_view.row(3);
  return camera;
}

void check_styled_options(const StyledOptions& options) {
  check_options(options.render);
  if (!(options.occlusion >= 0 && options.occlusion <= 1)) {
    throw Error("occlusion is a number from 0 to 1, not " + std::to_string(options.occlusion));
  }
  if (options.right_margin < 0 || options.right_margin >= options.render.width) {
    throw Error("the margin of " + std::to_string(options.right_margin) +
                " pixels leaves no room for the picture");
  }
}

}  // namespace

std::vector<float> rescaled(std::span<const float> values, float lowest, float highest, float first,
                            float last) {
  std::vector<float> result(values.begin(), values.end());
  for (float& value : result) {
    if (std::isnan(value)) continue;
    const float place =
        highest > lowest ? (value - lowest) / (highest - lowest) : (value < lowest ? 0.0f : 1.0f);
    value = first + std::clamp(place, 0.0f, 1.0f) * (last - first);
  }
  return result;
}

std::vector<Vec3> framed_points(std::span<const StyledSurface> surfaces) {
  std::vector<Vec3> points;
  for (const StyledSurface& styled : surfaces) {
    const Vec3 offset = (styled.mesh.origin - surfaces.front().mesh.origin).cast<float>();
    for (const Vec3& point : points_of_triangles(styled.mesh)) points.push_back(point + offset);
  }
  return points;
}

Camera styled_camera(std::span<const StyledSurface> surfaces, const StyledOptions& options) {
  check_styled_options(options);
  if (!options.framed.empty()) {
    return camera_beside(options.framed, options.render, options.right_margin);
  }
  return camera_beside(framed_points(surfaces), options.render, options.right_margin);
}

namespace {

/// What all passes over a picture share.
struct Drawing {
  const Camera& camera;
  const StyledOptions& options;
  const Progress& progress;
  Eigen::Vector2f depths;              ///< distances of the nearest and the farthest point
  std::optional<GroundShadow> shadow;  ///< if there is one to be seen
  GlTexture shadow_texture;
  GlTexture color_map;
  bool has_surroundings = false;  ///< the picture has several parts that darken each other

  PictureQuality quality() const { return options.render.quality; }
  /// The camera as it shows a surface.
  Camera camera_of(const DrawnSurface& drawn) const {
    Camera own = camera;
    if (!drawn.sliced) own.slice.reset();
    return own;
  }
  UpAxis up() const { return options.render.camera.up; }

  /// Between passes of pictures that take a while. Some drivers put passes off until somebody waits
  /// for them.
  void pause() const {
    if (quality() != PictureQuality::final) return;
    glFinish();
    progress.report("drawing", 0);
  }
};

/// The part of the picture that is drawn.
struct Part {
  Eigen::Vector4f transform;
  Eigen::Vector2i size;    ///< of its light
  Eigen::Vector2i corner;  ///< of its light in the picture's
};

/// Lets a target of the first pass show nothing.
void clear_samples(Target& target, const Eigen::Vector2i& size) {
  constexpr std::array<GLuint, 4> kNothing{0, 0, 0, 0};
  constexpr float kFarthest = 1;
  fit_target(target, {GL_R32UI}, true, size.x(), size.y());
  glClearNamedFramebufferuiv(target.framebuffer, GL_COLOR, 0, kNothing.data());
  glClearNamedFramebufferfv(target.framebuffer, GL_DEPTH, 0, &kFarthest);
}

/// Draws what is nearest into this part of it from now on.
void bind_samples(const Target& target, const Eigen::Vector2i& size) {
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target.framebuffer);
  glViewport(0, 0, size.x(), size.y());
  glEnable(GL_DEPTH_TEST);
}

}  // namespace

struct StyledRenderer::State {
  StyledPrograms programs;
  TiledPicture picture;
  Target visible, once;  ///< what samples show, and what pixels do
  ShownPart shown;       ///< by `visible`
  GlBuffer lists;        ///< of pixels' triangles, as listed_triangles.glsl has them
  std::size_t list_words = 0;
  Target surroundings;  ///< what samples of all the picture show, coarser
  ShownPart shown_surroundings;
  SampleGroups groups;
  GlVertexArray no_attributes = no_vertex_attributes();
  std::vector<DrawnSurface> surfaces;
  std::vector<Vec3> points;  // of all surfaces, as the camera frames them
  float diagonal = 0;

  void measure();
  Drawing drawing(const Camera& camera, const StyledOptions& options,
                  const Progress& progress) const;
  ShownPart part_to_show(const Drawing& drawing, const Part& part,
                         const Eigen::Vector2i& largest) const;
  void draw_visible(const Drawing& drawing, const Part& part, const Eigen::Vector2i& largest);
  void draw_parts(const DrawnSurface& drawn, const Drawing& drawing, const Part& part, int samples,
                  StyledPrograms::Parts parts);
  void list_triangles(const DrawnSurface& drawn, const Drawing& drawing, const Part& part);
  void draw_parts_once(const DrawnSurface& drawn, const Drawing& drawing, const Part& part,
                       const Eigen::Vector2i& largest);
  void draw_surfaces(const Drawing& drawing, const Part& part, const Target& light);
  void draw_surface(const DrawnSurface& drawn, const Drawing& drawing, const Part& part,
                    const Target& light);
  void draw_ground(const Drawing& drawing, const Part& part, const Target& light);
  void draw_surroundings(const Drawing& drawing);
  void set_picture(const ShaderProgram& program, const Drawing& drawing, const Part& part) const;
};

/// What the first pass is to show; what surfaces discard hangs on more than that.
ShownPart StyledRenderer::State::part_to_show(const Drawing& drawing, const Part& part,
                                              const Eigen::Vector2i& largest) const {
  ShownPart result{
      {}, part.transform, largest, part.size, drawing.quality() == PictureQuality::interactive};
  for (const DrawnSurface& drawn : surfaces) {
    if (drawn.style.discards()) return {};
    result.surfaces.push_back({drawn.surface.geometry(), drawing.camera_of(drawn)});
  }
  return result;
}

/// The first pass: which triangle of which surface each sample shows.
void StyledRenderer::State::draw_visible(const Drawing& drawing, const Part& part,
                                         const Eigen::Vector2i& largest) {
  ShownPart to_show = part_to_show(drawing, part, largest);
  if (!to_show.surfaces.empty() && to_show == shown) return;
  shown = {};
  clear_samples(visible, kVisibleSamples * largest);
  const bool draft = drawing.quality() == PictureQuality::interactive;
  for (const DrawnSurface& drawn : surfaces) {
    bind_samples(visible, kVisibleSamples * part.size);
    if (drawn.style.discards() && draft) {
      draw_parts_once(drawn, drawing, part, largest);
    } else if (drawn.style.discards()) {
      draw_parts(drawn, drawing, part, kVisibleSamples, StyledPrograms::Parts::drawn);
    } else {
      programs.whole().set("first_number", drawn.first_number);
      const Camera camera = drawing.camera_of(drawn);
      if (draft) leave_out_hidden_side(drawn.surface, camera);
      drawn.surface.draw(programs.whole(), camera, part.transform);
      glDisable(GL_CULL_FACE);
    }
    glDisable(GL_DEPTH_TEST);
    drawing.pause();
  }
  shown = std::move(to_show);
}

/// The first pass over a surface that is discarded in parts, with so many samples along a pixel's
/// side.
void StyledRenderer::State::draw_parts(const DrawnSurface& drawn, const Drawing& drawing,
                                       const Part& part, int samples, StyledPrograms::Parts parts) {
  const std::size_t regions = drawn.style.regions();
  const ShaderProgram& program = regions > 0
                                     ? programs.beside_tiles(drawn.style.features(), parts)
                                     : programs.between_strokes(drawn.style.features(), parts);
  program.set("first_number", drawn.first_number);
  program.set("color_map", static_cast<int>(kColorMapUnit));
  drawn.surface.bind(program, drawing.camera, part.transform);
  drawn.style.bind(program, samples * shading_side(drawing.options.render));
  program.set("target_size", Eigen::Vector2f((samples * part.size).cast<float>()));
  set_light(program, drawing.camera, drawing.options.render);
  for (std::size_t region = 0; region < std::max<std::size_t>(regions, 1); ++region) {
    if (regions > 0) drawn.style.bind_region(program, region);
    if (parts == StyledPrograms::Parts::drawn) {
      drawn.surface.draw(program, drawing.camera_of(drawn), part.transform);
      continue;
    }
    program.set("pixels_in_row", part.size.x());
    glUseProgram(program.name());
    glBindVertexArray(no_attributes);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
}

/// Puts the surface's triangles into the lists of the pixels whose middle they cover.
void StyledRenderer::State::list_triangles(const DrawnSurface& drawn, const Drawing& drawing,
                                           const Part& part) {
  const auto pixels =
      static_cast<std::size_t>(part.size.x()) * static_cast<std::size_t>(part.size.y());
  const std::size_t words = 1 + pixels * (1 + 3 * kListedInPixel);
  if (words != list_words) {
    lists = GlBuffer();  // gives its memory back first
    lists = make_buffer(words * sizeof(GLuint), nullptr, "lists of triangles", 0);
    list_words = words;
  }
  const auto begins = static_cast<GLuint>(1 + pixels);
  const auto fill = [&](GLuint value, std::size_t count) {
    glClearNamedBufferSubData(lists, GL_R32UI, 0, static_cast<GLsizeiptr>(count * sizeof(GLuint)),
                              GL_RED_INTEGER, GL_UNSIGNED_INT, &value);
  };
  fill(0, begins);
  fill(begins, 1);
  const ShaderProgram& program = programs.list();
  program.set("pixels_in_row", part.size.x());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kListsBinding, lists);
  glDisable(GL_DEPTH_TEST);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  drawn.surface.draw(program, drawing.camera_of(drawn), part.transform);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glEnable(GL_DEPTH_TEST);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

/// The same of a draft: whether it is discarded, which takes longest, is found out once a pixel,
/// and after all triangles are there: software shades four by four pixels for each of them.
void StyledRenderer::State::draw_parts_once(const DrawnSurface& drawn, const Drawing& drawing,
                                            const Part& part, const Eigen::Vector2i& largest) {
  clear_samples(once, largest);
  bind_samples(once, part.size);
  // Where pixels are many, few triangles are smaller than they are.
  const bool lists_pixels = part.size.x() <= kMostListed / part.size.y();
  if (lists_pixels) list_triangles(drawn, drawing, part);
  draw_parts(drawn, drawing, part, 1,
             lists_pixels ? StyledPrograms::Parts::listed : StyledPrograms::Parts::drawn);
  bind_samples(visible, kVisibleSamples * part.size);
  const ShaderProgram& program = programs.spread();
  program.set("pixels", 0);
  program.set("pixel_depths", 1);
  program.set("samples", kVisibleSamples);
  glBindTextureUnit(0, once.textures[0]);
  glBindTextureUnit(1, once.textures[1]);
  glUseProgram(program.name());
  glBindVertexArray(no_attributes);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

/// What a program of the second pass has to know of the picture.
void StyledRenderer::State::set_picture(const ShaderProgram& program, const Drawing& drawing,
                                        const Part& part) const {
  const StyledOptions& options = drawing.options;
  program.set("target_size", Eigen::Vector2f(part.size.cast<float>()));
  set_light(program, drawing.camera, drawing.options.render);
  bind_visible(program, visible);
  program.set("color_map", static_cast<int>(kColorMapUnit));
  program.set("has_threshold", options.scale.threshold.has_value());
  program.set("threshold", options.scale.threshold.value_or(0.0f));
  program.set("beyond_color", linear_light(options.scale.beyond));
  program.set("depth_range", drawing.depths);
  program.set("haze_color", linear_light(options.render.background_center));
  program.set("occlusion", options.occlusion);
  program.set("occlusion_radius", kOcclusionReach * diagonal);
  program.set("target_corner", Eigen::Vector2f(part.corner.cast<float>()));
  program.set("has_surroundings", drawing.has_surroundings);
  program.set("depths_of_picture", static_cast<int>(kSurroundingsUnit));
  program.set("part_of_target",
              Eigen::Vector2f(Eigen::Vector2f((kVisibleSamples * part.size).cast<float>())
                                  .cwiseQuotient(Eigen::Vector2f(visible.width, visible.height))));
}

/// Adds the surface's light where it is seen.
void StyledRenderer::State::draw_surface(const DrawnSurface& drawn, const Drawing& drawing,
                                         const Part& part, const Target& light) {
  const StyledOptions& options = drawing.options;
  const bool texture = drawn.style.regions() > 0, occlusion = options.occlusion > 0;
  const DepthCue cue = drawn.tinted ? options.depth_cue : DepthCue::none;
  const std::string features = drawn.style.features() +
                               "const int kDepthCue = " + std::to_string(static_cast<int>(cue)) +
                               ";\n";
  const ShaderProgram& program =
      texture ? programs.texture(features, occlusion) : programs.strokes(features, occlusion);
  groups.find(drawn.surface, visible, drawing.camera, part.transform, light, part.size,
              drawn.first_number);
  set_picture(program, drawing, part);
  drawn.surface.bind(program, drawing.camera, part.transform);
  drawn.style.bind(program, shading_side(options.render));
  program.set("first_number", drawn.first_number);
  program.set("triangle_count", static_cast<int>(drawn.surface.triangle_count()));
  if (!options.render.shading) program.set("shading", false);
  const int count = SampleGroups::count(drawn.surface, options.render.quality);
  for (std::size_t region = 0; region < std::max<std::size_t>(drawn.style.regions(), 1); ++region) {
    if (texture) drawn.style.bind_region(program, region);
    groups.shade(program, light, count, SampleGroups::First::on_top);
  }
}

/// What all of the picture shows, for the occlusion of parts that end where it goes on.
void StyledRenderer::State::draw_surroundings(const Drawing& drawing) {
  constexpr int kLongestSide = 1024;
  const RenderOptions& render = drawing.options.render;
  const int longest = std::max(render.width, render.height);
  const auto side = [&](int pixels) {
    return std::max(1, static_cast<int>(std::int64_t{pixels} * kLongestSide / longest));
  };
  const Eigen::Vector2i size(side(render.width), side(render.height));
  const Part all{tile_transform({0, 0, render.width, render.height}, render), size, {0, 0}};
  const auto swap_targets = [this] {
    std::swap(visible, surroundings);
    std::swap(shown, shown_surroundings);
  };
  swap_targets();
  draw_visible(drawing, all, size);
  swap_targets();
}

/// The second pass: the light of each surface where it is seen, on top of nothing.
void StyledRenderer::State::draw_surfaces(const Drawing& drawing, const Part& part,
                                          const Target& light) {
  constexpr std::array<float, 4> kNoLight{0, 0, 0, 0};
  glClearNamedFramebufferfv(light.framebuffer, GL_COLOR, 0, kNoLight.data());
  glViewport(0, 0, part.size.x(), part.size.y());
  for (const DrawnSurface& drawn : surfaces) {
    if (drawn.surface.triangle_count() == 0) continue;
    draw_surface(drawn, drawing, part, light);
    drawing.pause();
  }
  if (drawing.shadow) draw_ground(drawing, part, light);
}

void StyledRenderer::State::draw_ground(const Drawing& drawing, const Part& part,
                                        const Target& light) {
  const Eigen::Matrix3f axes = ground_axes(drawing.up());
  const GroundShadow& shadow = *drawing.shadow;
  const Vec3 origin = axes.transpose() * drawing.camera.origin;
  const ShaderProgram& program = programs.ground();
  program.set("target_size", Eigen::Vector2f(part.size.cast<float>()));
  program.set("clip_from_view", drawing.camera.clip_from_view);
  program.set("view_from_world", drawing.camera.view_from_world);
  program.set("tile", part.transform);
  bind_visible(program, visible);
  program.set("shadow", static_cast<int>(kShadowUnit));
  program.set("ground", Vec3((shadow.height - origin.z()) * axes.col(2)));
  program.set("across", Vec3(axes.col(0)));
  program.set("away", Vec3(axes.col(1)));
  program.set("upwards", Vec3(axes.col(2)));
  Eigen::Vector4f place;
  place << shadow.lower - origin.head<2>(), shadow.size.cwiseInverse();
  program.set("shadow_place", place);
  glBindTextureUnit(kShadowUnit, drawing.shadow_texture);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, light.framebuffer);
  glUseProgram(program.name());
  glBindVertexArray(no_attributes);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDisable(GL_BLEND);
}

StyledRenderer::StyledRenderer() : state_(std::make_unique<State>()) {}

StyledRenderer::~StyledRenderer() = default;
StyledRenderer::StyledRenderer(StyledRenderer&&) noexcept = default;
StyledRenderer& StyledRenderer::operator=(StyledRenderer&&) noexcept = default;

namespace {

/// What the surface is without its style.
SurfaceDrawing drawing_of(const StyledSurface& styled, const Mesh& mesh) {
  SurfaceDrawing drawing{.mesh = mesh, .normals = styled.normals};
  if (!styled.strokes.empty()) {
    drawing.waves = styled.strokes.front().waves;
    drawing.z = styled.strokes.front().z;
  }
  if (styled.texture) {
    drawing.texture_waves = styled.texture->waves;
    drawing.texture_tile = &styled.texture->tiles.front().tile;
  }
  return drawing;
}

DrawnSurface drawn_surface(const StyledSurface& styled, const Eigen::Vector3d& origin) {
  DrawnSurface drawn{
      moved_to(styled.mesh, origin), {}, GlStyle(styled), styled.tinted, styled.sliced};
  drawn.surface.upload(drawing_of(styled, drawn.mesh));
  return drawn;
}

/// Whether buffers can stay, with other numbers in them.
bool has_buffers_of(const DrawnSurface& drawn, const StyledSurface& styled) {
  return drawn.mesh.triangles == styled.mesh.triangles &&
         drawn.mesh.vertex_count() == styled.mesh.vertex_count() &&
         drawn.surface.has_normals() == !styled.normals.empty() &&
         drawn.surface.has_waves() == !styled.strokes.empty() &&
         drawn.surface.has_texture() == styled.texture.has_value();
}

void check_triangle_count(std::size_t count) {
  if (count <= std::numeric_limits<int>::max()) return;
  throw Error("the surfaces have more triangles than a picture can number");
}

}  // namespace

/// Numbers the triangles of all surfaces.
void StyledRenderer::State::measure() {
  int number = 0;
  points.clear();
  for (DrawnSurface& drawn : surfaces) {
    drawn.first_number = number;
    number += static_cast<int>(drawn.mesh.triangle_count());
    const std::vector<Vec3> more = points_of_triangles(drawn.mesh);
    points.insert(points.end(), more.begin(), more.end());
  }
  Eigen::AlignedBox3f box;
  for (const Vec3& point : points) box.extend(point);
  diagonal = points.empty() ? 0 : box.diagonal().norm();
}

void StyledRenderer::upload(std::span<const StyledSurface> surfaces) {
  if (surfaces.empty()) throw Error("cannot draw a picture of no surface; add one");
  std::vector<DrawnSurface> drawn;
  std::size_t triangles = 0;
  for (const StyledSurface& styled : surfaces) {
    check_triangle_count(triangles += styled.mesh.triangle_count());
    drawn.push_back(drawn_surface(styled, surfaces.front().mesh.origin));
  }
  state_->surfaces = std::move(drawn);
  state_->measure();
}

void StyledRenderer::update(std::size_t number, const StyledSurface& surface) {
  State& s = *state_;
  if (number >= s.surfaces.size()) {
    throw Error("there is no surface " + std::to_string(number) + " to update; upload it");
  }
  DrawnSurface& drawn = s.surfaces[number];
  const Eigen::Vector3d origin = s.surfaces.front().mesh.origin;
  if (has_buffers_of(drawn, surface)) {
    GlStyle style(surface, &drawn.style);
    Mesh mesh = moved_to(surface.mesh, origin);
    const SurfaceDrawing drawing = drawing_of(surface, mesh);
    const bool stays = mesh.positions == drawn.mesh.positions;
    drawn.surface.update({.positions = stays ? std::span<const Vec3>() : mesh.positions,
                          .normals = drawing.normals,
                          .waves = drawing.waves,
                          .z = drawing.z,
                          .texture_waves = drawing.texture_waves});
    drawn.mesh = std::move(mesh);
    drawn.style = std::move(style);
    drawn.tinted = surface.tinted;
    drawn.sliced = surface.sliced;
    if (stays) return;
  } else {
    std::size_t triangles = surface.mesh.triangle_count();
    for (const DrawnSurface& other : s.surfaces) triangles += other.mesh.triangle_count();
    check_triangle_count(triangles - drawn.mesh.triangle_count());
    drawn = drawn_surface(surface, origin);
  }
  s.measure();
}

Drawing StyledRenderer::State::drawing(const Camera& camera, const StyledOptions& options,
                                       const Progress& progress) const {
  Drawing drawing{camera, options, progress, depth_range(points, camera), {}, {}, {}};
  drawing.color_map = color_map_texture(options.scale.map);
  if (!options.ground_shadow) return drawing;
  Mesh all;
  for (const DrawnSurface& drawn : surfaces) {
    const bool cut = camera.slice && drawn.sliced;
    append(cut ? left_by(*camera.slice, drawn.mesh) : drawn.mesh, all);
  }
  GroundShadow shadow = ground_shadow(all.positions, all.triangles, ground_axes(drawing.up()));
  if (shadow.missing.empty()) return drawing;
  drawing.shadow_texture = shadow_texture(shadow);
  drawing.shadow = std::move(shadow);
  return drawing;
}

Image StyledRenderer::draw(const StyledOptions& options, const Progress& progress) const {
  check_styled_options(options);
  State& s = *state_;
  const RenderOptions& render = options.render;
  const auto framed = options.framed.empty() ? std::span<const Vec3>(s.points) : options.framed;
  const Camera camera = camera_beside(framed, render, options.right_margin);
  Drawing drawing = s.drawing(camera, options, progress);
  drawing.has_surroundings = options.occlusion > 0 && !is_one_tile(render);
  if (drawing.has_surroundings) s.draw_surroundings(drawing);
  const auto draw_light = [&](const Target& target, const Tile& tile) {
    const int side = shading_side(render);
    const Part part{tile_transform(tile, render), side * Eigen::Vector2i(tile.width, tile.height),
                    side * Eigen::Vector2i(tile.x, tile.y)};
    s.draw_visible(drawing, part, {target.width, target.height});
    glBindTextureUnit(kColorMapUnit, drawing.color_map);
    if (drawing.has_surroundings) glBindTextureUnit(kSurroundingsUnit, s.surroundings.textures[1]);
    s.draw_surfaces(drawing, part, target);
  };
  return s.picture.draw(render, draw_light, progress);
}

Image render_styled(std::span<const StyledSurface> surfaces, const StyledOptions& options,
                    const Progress& progress) {
  check_styled_options(options);
  const HeadlessContext context;
  StyledRenderer renderer;
  renderer.upload(surfaces);
  Image image = renderer.draw(options, progress);
  context.check_errors("drawing the picture");
  return image;
}

}  // namespace brindle
