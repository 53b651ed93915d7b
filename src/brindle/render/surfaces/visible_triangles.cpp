#include "brindle/render/surfaces/visible_triangles.h"

#include <algorithm>
#include <array>
#include <utility>

#include "brindle/gl/gl_buffer.h"
#include "brindle/render/surfaces/tiled_picture.h"

namespace brindle {
namespace {

constexpr GLuint kListsBinding = 4;
constexpr std::size_t kListedInPixel = 8;  // triangles per pixel, averaged over a draft
constexpr int kMostListed = 1 << 19;       // pixels with lists, which take 100 bytes each

constexpr const char* kAllIsSeen = "bool is_seen(uint number) { return true; }\n";

/// Clears a target of the first pass.
void clear_samples(Target& target, const Eigen::Vector2i& size) {
  constexpr std::array<GLuint, 4> kNothing{0, 0, 0, 0};
  constexpr float kFarthest = 1;
  fit_target(target, {GL_R32UI}, true, size.x(), size.y());
  glClearNamedFramebufferuiv(target.framebuffer, GL_COLOR, 0, kNothing.data());
  glClearNamedFramebufferfv(target.framebuffer, GL_DEPTH, 0, &kFarthest);
}

/// Binds this part of the target for nearest triangles.
void bind_samples(const Target& target, const Eigen::Vector2i& size) {
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target.framebuffer);
  glViewport(0, 0, size.x(), size.y());
  glEnable(GL_DEPTH_TEST);
}

/// Lets OpenGL cull the hidden side of the surface, if known, until GL_CULL_FACE is disabled.
void leave_out_hidden_side(const GlSurface& surface, const Camera& camera) {
  // A slice opens surfaces, so that both sides are visible.
  if (camera.slice) return;
  if (surface.hidden_side() == HiddenSide::none || surface.box().contains(eye_of(camera))) return;
  glEnable(GL_CULL_FACE);
  glCullFace(surface.hidden_side() == HiddenSide::back ? GL_BACK : GL_FRONT);
}

/// The content of the first pass; discarded parts depend on more than that.
ShownPart part_to_show(std::span<const DrawnSurface> surfaces, const Camera& camera,
                       const PicturePart& part, const Eigen::Vector2i& largest, bool draft) {
  ShownPart result{{}, part.transform, largest, part.size, draft};
  for (const DrawnSurface& drawn : surfaces) {
    if (drawn.discards()) return {};
    result.surfaces.push_back({drawn.surface.geometry(), drawn.seen_by(camera)});
  }
  return result;
}

}  // namespace

Camera DrawnSurface::seen_by(const Camera& camera) const {
  Camera own = camera;
  if (!sliced) own.slice.reset();
  return own;
}

bool ShownPart::Surface::operator==(const Surface& other) const {
  const Camera& a = camera;
  const Camera& b = other.camera;
  return geometry == other.geometry && a.origin == b.origin &&
         a.view_from_world == b.view_from_world && a.clip_from_view == b.clip_from_view &&
         a.slice.has_value() == b.slice.has_value() &&
         (!a.slice || a.slice->coeffs() == b.slice->coeffs());
}

void VisibleSamples::bind(const ShaderProgram& program) const {
  enum Unit { kTriangleUnit = 2, kDepthUnit = 3 };  // after those of GlTextureTile
  program.set("visible", static_cast<int>(kTriangleUnit));
  program.set("visible_depth", static_cast<int>(kDepthUnit));
  glBindTextureUnit(kTriangleUnit, target.textures[0]);
  glBindTextureUnit(kDepthUnit, target.textures[1]);
}

VisibleTriangles::VisibleTriangles()
    : whole_({"visible_triangles.vert"}, {{"is_seen", kAllIsSeen}, "visible_triangles.frag"}) {}

void VisibleTriangles::draw(VisibleSamples& samples, std::span<const DrawnSurface> surfaces,
                            const Camera& camera, const PicturePart& part,
                            const Eigen::Vector2i& largest, const RenderOptions& options,
                            const std::function<void()>& pause) {
  const bool draft = options.quality == PictureQuality::interactive;
  ShownPart to_show = part_to_show(surfaces, camera, part, largest, draft);
  if (!to_show.surfaces.empty() && to_show == samples.shown) return;
  samples.shown = {};
  clear_samples(samples.target, kSamples * largest);
  for (const DrawnSurface& drawn : surfaces) {
    bind_samples(samples.target, kSamples * part.size);
    const Camera own = drawn.seen_by(camera);
    if (!drawn.discards()) {
      draw_whole(drawn, own, part, draft);
    } else if (draft) {
      draw_parts_once(samples.target, drawn, own, part, largest, options);
    } else {
      draw_parts(drawn, own, part, options, kSamples, Triangles::all);
    }
    glDisable(GL_DEPTH_TEST);
    if (pause) pause();
  }
  samples.shown = std::move(to_show);
}

void VisibleTriangles::draw_whole(const DrawnSurface& drawn, const Camera& camera,
                                  const PicturePart& part, bool draft) {
  whole_.set("first_number", drawn.first_number);
  if (draft) leave_out_hidden_side(drawn.surface, camera);
  drawn.surface.draw(whole_, camera, part.transform);
  glDisable(GL_CULL_FACE);
}

/// The program of a surface that is discarded between its strokes or around its tiles.
const ShaderProgram& VisibleTriangles::parts_program(const GlStyle& style, Triangles triangles) {
  const bool listed = triangles == Triangles::listed;
  const std::string features = style.features();
  ShaderSources sources = {{"features", features},
                           "surface_buffers.glsl",
                           "surface_point.glsl",
                           "fragment_phase.glsl",
                           "style_buffers.glsl"};
  const ShaderSources pattern =
      style.regions() > 0
          ? ShaderSources{"texture_tile.glsl", "broken_tiles.glsl", "region_texture.glsl"}
          : ShaderSources{"stripe_middle.glsl", "light.glsl", "picture_light.glsl", "strokes.glsl"};
  const ShaderSources end = listed
                                ? ShaderSources{"listed_triangles.glsl", "listed_visibility.frag"}
                                : ShaderSources{"visible_triangles.frag"};
  sources.insert(sources.end(), pattern.begin(), pattern.end());
  sources.insert(sources.end(), end.begin(), end.end());
  const std::string kind = std::string(listed ? "listed " : "") +
                           (style.regions() > 0 ? "beside tiles\n" : "between strokes\n");
  return parts_
      .try_emplace(kind + features,
                   ShaderSources{listed ? "full_screen.vert" : "visible_triangles.vert"}, sources)
      .first->second;
}

/// Draws a partly discarded surface with so many samples along a pixel's side.
void VisibleTriangles::draw_parts(const DrawnSurface& drawn, const Camera& camera,
                                  const PicturePart& part, const RenderOptions& options,
                                  int samples, Triangles triangles) {
  const std::size_t regions = drawn.style->regions();
  const ShaderProgram& program = parts_program(*drawn.style, triangles);
  program.set("first_number", drawn.first_number);
  drawn.surface.bind(program, camera, part.transform);
  drawn.style->bind(program, samples * shading_side(options));
  program.set("target_size", Eigen::Vector2f((samples * part.size).cast<float>()));
  set_light(program, camera, options);
  for (std::size_t region = 0; region < std::max<std::size_t>(regions, 1); ++region) {
    if (regions > 0) drawn.style->bind_region(program, region);
    if (triangles == Triangles::all) {
      drawn.surface.draw(program, camera, part.transform);
    } else {
      program.set("pixels_in_row", part.size.x());
      fill_viewport(program, no_attributes_);
    }
  }
}

/// Adds the surface's triangles to the lists of pixels whose middle they cover.
void VisibleTriangles::list_triangles(const DrawnSurface& drawn, const Camera& camera,
                                      const PicturePart& part) {
  const auto pixels =
      static_cast<std::size_t>(part.size.x()) * static_cast<std::size_t>(part.size.y());
  const std::size_t words = 1 + pixels * (1 + 3 * kListedInPixel);
  if (words != list_words_) {
    lists_ = GlBuffer();  // frees its memory first
    lists_ = make_buffer(words * sizeof(GLuint), nullptr, "lists of triangles", 0);
    list_words_ = words;
  }
  const auto begins = static_cast<GLuint>(1 + pixels);
  const auto fill = [&](GLuint value, std::size_t count) {
    glClearNamedBufferSubData(lists_, GL_R32UI, 0, static_cast<GLsizeiptr>(count * sizeof(GLuint)),
                              GL_RED_INTEGER, GL_UNSIGNED_INT, &value);
  };
  fill(0, begins);
  fill(begins, 1);
  if (!list_) {
    list_.emplace(ShaderSources{"visible_triangles.vert"},
                  ShaderSources{"listed_triangles.glsl", "list_triangles.frag"});
  }
  list_->set("pixels_in_row", part.size.x());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kListsBinding, lists_);
  glDisable(GL_DEPTH_TEST);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  drawn.surface.draw(*list_, camera, part.transform);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glEnable(GL_DEPTH_TEST);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

/// As `draw_parts`, for drafts. Discarding takes longest, so it runs once per pixel and after all
/// triangles are known: software renderers shade blocks of four by four pixels per triangle.
void VisibleTriangles::draw_parts_once(Target& samples, const DrawnSurface& drawn,
                                       const Camera& camera, const PicturePart& part,
                                       const Eigen::Vector2i& largest,
                                       const RenderOptions& options) {
  clear_samples(once_, largest);
  bind_samples(once_, part.size);
  // With many pixels, few triangles are smaller than one.
  const bool lists_pixels = part.size.x() <= kMostListed / part.size.y();
  if (lists_pixels) list_triangles(drawn, camera, part);
  draw_parts(drawn, camera, part, options, 1, lists_pixels ? Triangles::listed : Triangles::all);
  bind_samples(samples, kSamples * part.size);
  if (!spread_)
    spread_.emplace(ShaderSources{"full_screen.vert"}, ShaderSources{"spread_samples.frag"});
  spread_->set("pixels", 0);
  spread_->set("pixel_depths", 1);
  spread_->set("samples", kSamples);
  glBindTextureUnit(0, once_.textures[0]);
  glBindTextureUnit(1, once_.textures[1]);
  fill_viewport(*spread_, no_attributes_);
}

}  // namespace brindle
