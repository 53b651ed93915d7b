#include "brindle/splats.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "brindle/base/elementary.h"
#include "brindle/base/parallel.h"
#include "brindle/error.h"
#include "brindle/gl/gl_buffer.h"
#include "brindle/gl/shader_program.h"
#include "brindle/render/surfaces/gl_target.h"
#include "brindle/render/surfaces/tiled_picture.h"

namespace brindle {
namespace {

/// Points per draw call. Software renderers keep undrawn ones in memory.
constexpr std::size_t kSplatBatch = 1 << 15;

/// Disc radius over the mean neighbour distance: larger discs stick out at creases, smaller ones
/// leave holes between uneven points.
constexpr float kOverlap = 0.8f;

/// The layout of splat.vert.
struct PackedSplat {
  Eigen::Vector4f position_radius;
  Eigen::Vector4f normal_turns;         ///< the phase over 2 pi
  Eigen::Vector4f direction_frequency;  ///< zero: no wave
};

void check_drawing(const SplatDrawing& drawing) {
  const std::size_t points = drawing.positions.size();
  const auto check = [&](std::size_t count, const char* what) {
    if (count != points) {
      throw Error("cannot draw these points: there are " + std::to_string(count) + " " + what +
                  " for " + std::to_string(points) + " points");
    }
  };
  check(drawing.normals.size(), "normals");
  check(drawing.radii.size(), "radii");
  if (drawing.waves == nullptr) return;
  check(drawing.waves->directions.size(), "directions");
  check(drawing.waves->frequencies.size(), "frequencies");
  check(drawing.z.size(), "phases");
}

std::vector<PackedSplat> packed_splats(const SplatDrawing& drawing) {
  std::vector<PackedSplat> packed;
  for (std::size_t i = 0; i < drawing.positions.size(); ++i) {
    if (drawing.normals[i].isZero(0) || !(drawing.radii[i] > 0)) continue;
    PackedSplat& splat = packed.emplace_back();
    splat.position_radius << drawing.positions[i], drawing.radii[i];
    splat.normal_turns << drawing.normals[i], 0;
    splat.direction_frequency.setZero();
    if (drawing.waves == nullptr) continue;
    splat.normal_turns.w() = elementary::arg(drawing.z[i]) / (2 * std::numbers::pi_v<float>);
    splat.direction_frequency << drawing.waves->directions[i], drawing.waves->frequencies[i];
  }
  return packed;
}

}  // namespace

std::vector<float> splat_radii(std::span<const Vec3> positions, const Adjacency& neighborhood) {
  std::vector<float> radii(positions.size());
  parallel_for(radii.size(), [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<Index>(begin); i < end; ++i) {
      const auto neighbors = neighborhood.of(i);
      float sum = 0;
      for (const Index j : neighbors) sum += (positions[j] - positions[i]).norm();
      radii[i] = neighbors.empty() ? 0 : kOverlap * sum / static_cast<float>(neighbors.size());
    }
  });
  return radii;
}

struct SplatRenderer::State {
  ShaderProgram splat{{"splat.vert"}, {"splat.frag"}};
  ShaderProgram surface{
      {"full_screen.vert"},
      {"stripe_coverage.glsl", "light.glsl", "picture_light.glsl", "splat_surface.frag"}};
  TiledPicture picture;
  GlVertexArray no_attributes = no_vertex_attributes();

  std::vector<Vec3> points;  ///< framed by cameras
  GlBuffer splats;
  std::size_t splat_count = 0;
  Target sums;  ///< of the discs at each pixel

  void draw_splats(bool behind) const;
  void draw_tile(const Target& target, const Camera& camera, const Tile& tile,
                 const RenderOptions& options) const;
  void draw_surface(const Target& target, const Camera& camera, const Tile& tile,
                    const RenderOptions& options) const;
};

/// `behind` draws only depths, each disc moved away from the eye by its radius. Discs in front of
/// these depths are blended, others hidden.
void SplatRenderer::State::draw_splats(bool behind) const {
  splat.set("behind", behind);
  glUseProgram(splat.name());
  glBindVertexArray(no_attributes);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, splats);
  for (std::size_t first = 0; first < splat_count; first += kSplatBatch) {
    glDrawArrays(GL_TRIANGLES, static_cast<GLint>(6 * first),
                 static_cast<GLsizei>(6 * std::min(kSplatBatch, splat_count - first)));
    if (first + kSplatBatch < splat_count) glFinish();
  }
}

void SplatRenderer::State::draw_tile(const Target& target, const Camera& camera, const Tile& tile,
                                     const RenderOptions& options) const {
  constexpr std::array<float, 4> kNothing{0, 0, 0, 0};
  constexpr float kFarthest = 1;
  for (const GLint attachment : {0, 1}) {
    glClearNamedFramebufferfv(sums.framebuffer, GL_COLOR, attachment, kNothing.data());
  }
  glClearNamedFramebufferfv(sums.framebuffer, GL_DEPTH, 0, &kFarthest);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, sums.framebuffer);
  set_camera(splat, camera, tile_transform(tile, options));
  std::optional<SlicedDrawing> sliced(std::in_place, camera);
  glEnable(GL_DEPTH_TEST);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  draw_splats(true);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  draw_splats(false);
  sliced.reset();
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
  glDisable(GL_DEPTH_TEST);
  draw_surface(target, camera, tile, options);
}

void SplatRenderer::State::draw_surface(const Target& target, const Camera& camera,
                                        const Tile& tile, const RenderOptions& options) const {
  surface.set("phase_sums", 0);
  surface.set("normal_sums", 1);
  surface.set("tile", tile_transform(tile, options));
  surface.set("target_size", Eigen::Vector2f(tile.width * shading_side(options),
                                             tile.height * shading_side(options)));
  surface.set("view_scale",
              Eigen::Vector2f(camera.clip_from_view(0, 0), camera.clip_from_view(1, 1)));
  surface.set("orthographic", camera.orthographic());
  set_light(surface, camera, options);
  set_looks(surface, options);
  glBindTextureUnit(0, sums.textures[0]);
  glBindTextureUnit(1, sums.textures[1]);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target.framebuffer);
  fill_viewport(surface, no_attributes);
}

SplatRenderer::SplatRenderer() : state_(std::make_unique<State>()) {}

SplatRenderer::~SplatRenderer() = default;
SplatRenderer::SplatRenderer(SplatRenderer&&) noexcept = default;
SplatRenderer& SplatRenderer::operator=(SplatRenderer&&) noexcept = default;

void SplatRenderer::upload(const SplatDrawing& drawing) {
  check_drawing(drawing);
  const std::vector<PackedSplat> packed = packed_splats(drawing);
  state_->points.clear();
  for (const PackedSplat& splat : packed) {
    state_->points.push_back(splat.position_radius.head<3>());
  }
  state_->splats = buffer_of(packed, "points");
  state_->splat_count = packed.size();
  check_gl("copying the points to OpenGL");
}

Image SplatRenderer::draw(const RenderOptions& options, const Progress& progress) const {
  check_options(options);
  const Camera camera =
      framed_camera(state_->points, options.camera, options.width, options.height);
  const auto draw_light = [&](const Target& target, const Tile& tile) {
    fit_target(state_->sums, {GL_RGBA32F, GL_RGBA32F}, true, target.width, target.height);
    state_->draw_tile(target, camera, tile, options);
  };
  return state_->picture.draw(options, draw_light, progress);
}

Image render_splats(const SplatDrawing& drawing, const RenderOptions& options,
                    const Progress& progress) {
  check_options(options);
  return drawn_alone<SplatRenderer>(drawing, options, "drawing the points", progress);
}

}  // namespace brindle
