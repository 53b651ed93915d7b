#include "brindle/render/renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <type_traits>

#include "brindle/error.h"
#include "brindle/gl/gl_buffer.h"
#include "brindle/gl/headless_context.h"
#include "brindle/gl/shader_program.h"
#include "brindle/render/gl_texture_tile.h"
#include "brindle/render/tiled_picture.h"

namespace brindle {
namespace {

// What the shaders take for plain floats and integers.
static_assert(sizeof(Triangle) == 12 && sizeof(Vec3) == 12 && sizeof(Complex) == 8);

constexpr int kWantedSamples = 8;

/// Triangles drawn at once. Software renderers keep all that they have not yet drawn in memory.
constexpr std::size_t kBatch = 1 << 16;

enum Binding {
  kTriangles,
  kPositions,
  kNormals,
  kWaves,
  kPhases,
  kTriangleColors,
  kMarks,
  kTextureU,
  kTextureV,
  kBindings
};

std::vector<Eigen::Vector4f> packed_waves(const WaveSet& waves) {
  std::vector<Eigen::Vector4f> packed(waves.directions.size());
  for (std::size_t v = 0; v < packed.size(); ++v) {
    packed[v] << waves.directions[v], waves.frequencies[v];
  }
  return packed;
}

std::vector<std::uint32_t> packed_colors(std::span<const TriangleColor> colors) {
  const auto byte = [](float value) {
    return static_cast<std::uint32_t>(std::lround(255 * std::clamp(value, 0.0f, 1.0f)));
  };
  std::vector<std::uint32_t> packed;
  packed.reserve(colors.size());
  for (const TriangleColor& c : colors) {
    packed.push_back(byte(c.color.red) | byte(c.color.green) << 8 | byte(c.color.blue) << 16 |
                     byte(c.amount) << 24);
  }
  return packed;
}

std::vector<Vec3> packed_marks(std::span<const Mark> marks) {
  std::vector<Vec3> packed;
  packed.reserve(2 * marks.size());
  for (const Mark& mark : marks) {
    packed.insert(packed.end(), {mark.position, linear_light(mark.color)});
  }
  return packed;
}

/// Direction, frequency and z of every corner.
std::vector<float> packed_corners(const std::vector<CornerWaves>& triangles) {
  std::vector<float> packed;
  packed.reserve(18 * triangles.size());
  for (const CornerWaves& corners : triangles) {
    for (const auto& [wave, z] : corners) {
      packed.insert(packed.end(), wave.direction.begin(), wave.direction.end());
      packed.insert(packed.end(), {wave.frequency, z.real(), z.imag()});
    }
  }
  return packed;
}

void check_count(std::size_t count, std::size_t wanted, const char* what, const char* of) {
  if (count == 0 || count == wanted) return;
  throw Error("cannot draw this scene: it has " + std::to_string(count) + " " + what + " for " +
              std::to_string(wanted) + " " + of);
}

void check_waves(const WaveSet* waves, std::size_t vertices) {
  if (waves == nullptr) return;
  check_count(waves->directions.size(), vertices, "directions", "vertices");
  check_count(waves->frequencies.size(), vertices, "frequencies", "vertices");
}

void check_scene(const StripeScene& scene) {
  const std::size_t vertices = scene.mesh.vertex_count();
  check_count(scene.normals.size(), vertices, "normals", "vertices");
  check_count(scene.z.size(), vertices, "phases", "vertices");
  check_count(scene.triangle_colors.size(), scene.mesh.triangle_count(), "triangle colours",
              "triangles");
  check_waves(scene.waves, vertices);
  if (scene.texture_waves == nullptr) return;
  check_count(scene.texture_waves->u.size(), scene.mesh.triangle_count(), "waves U", "triangles");
  check_count(scene.texture_waves->v.size(), scene.mesh.triangle_count(), "waves V", "triangles");
}

void check_change(const SceneChange& change, std::size_t vertices, std::size_t triangles) {
  check_count(change.positions.size(), vertices, "positions", "vertices");
  check_count(change.normals.size(), vertices, "normals", "vertices");
  check_count(change.z.size(), vertices, "phases", "vertices");
  check_count(change.triangle_colors.size(), triangles, "triangle colours", "triangles");
  check_waves(change.waves, vertices);
}

/// Samples a pixel beside supersampling; 0 for one. Where triangles are about as small as pixels
/// each sample would be shaded by itself anyway, and software renderers take five times as long.
int samples_for(std::size_t triangle_count, const RenderOptions& options) {
  const double pixels = static_cast<double>(options.width) * options.height *
                        options.supersampling * options.supersampling;
  if (4 * static_cast<double>(triangle_count) > pixels) return 0;
  const int samples = std::min(kWantedSamples, gl_limit(GL_MAX_SAMPLES));
  return samples > 1 ? samples : 0;
}

}  // namespace

struct Renderer::State {
  ShaderProgram surface{{"surface_buffers.glsl", "surface.vert"},
                        {"surface_buffers.glsl", "fragment_phase.glsl", "surface_fragment.glsl",
                         "texture_fragment.glsl", "texture_tile.glsl", "stripe_coverage.glsl",
                         "light.glsl", "striped_surface.frag"}};
  ShaderProgram probe{{"surface_buffers.glsl", "surface.vert"},
                      {"surface_buffers.glsl", "fragment_phase.glsl", "surface_fragment.glsl",
                       "fragment_probe.frag"}};
  ShaderProgram mark{{"mark.vert"}, {"mark.frag"}};
  TiledPicture picture;
  GlVertexArray no_attributes = no_vertex_attributes();

  std::vector<Vec3> points;  ///< what a camera has to frame
  std::size_t vertex_count = 0;
  std::size_t triangle_count = 0;
  std::array<GlBuffer, kBindings> buffers;
  GLuint foreign_phases = 0;  ///< instead of those in `buffers`, unless 0
  GlTextureTile texture_tile;
  GLsizei mark_count = 0;

  bool has_phases() const { return foreign_phases != 0 || buffers[kPhases] != 0; }
  void draw_surface(const ShaderProgram& program, const Camera& camera,
                    const Eigen::Vector4f& tile) const;
  void draw_marks(const Camera& camera, const Eigen::Vector4f& tile,
                  const RenderOptions& options) const;
  void draw_light(const Camera& camera, const Tile& tile, const RenderOptions& options) const;
};

void Renderer::State::draw_surface(const ShaderProgram& program, const Camera& camera,
                                   const Eigen::Vector4f& tile) const {
  program.set("origin", camera.origin);
  program.set("view_from_world", camera.view_from_world);
  program.set("clip_from_view", camera.clip_from_view);
  program.set("tile", tile);
  program.set("smooth_normals", buffers[kNormals] != 0);
  program.set("has_waves", buffers[kWaves] != 0 && has_phases());
  program.set("has_texture", buffers[kTextureU] != 0);
  program.set("has_triangle_colors", buffers[kTriangleColors] != 0);
  for (GLuint binding = 0; binding < buffers.size(); ++binding) {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffers[binding]);
  }
  if (foreign_phases != 0) glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kPhases, foreign_phases);
  glUseProgram(program.name());
  glBindVertexArray(no_attributes);
  for (std::size_t first = 0; first < triangle_count; first += kBatch) {
    glDrawArrays(GL_TRIANGLES, static_cast<GLint>(3 * first),
                 static_cast<GLsizei>(3 * std::min(kBatch, triangle_count - first)));
    if (first + kBatch < triangle_count) glFinish();
  }
}

void Renderer::State::draw_marks(const Camera& camera, const Eigen::Vector4f& tile,
                                 const RenderOptions& options) const {
  if (mark_count == 0) return;
  mark.set("origin", camera.origin);
  mark.set("view_from_world", camera.view_from_world);
  mark.set("clip_from_view", camera.clip_from_view);
  mark.set("tile", tile);
  mark.set("mark_size",
           Eigen::Vector2f(2 * options.mark_radius / static_cast<float>(options.width),
                           2 * options.mark_radius / static_cast<float>(options.height)));
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDepthMask(GL_FALSE);
  glUseProgram(mark.name());
  glDrawArrays(GL_TRIANGLES, 0, 6 * mark_count);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

void Renderer::State::draw_light(const Camera& camera, const Tile& tile,
                                 const RenderOptions& options) const {
  glEnable(GL_DEPTH_TEST);
  surface.set("target_size", Eigen::Vector2f(tile.width * options.supersampling,
                                             tile.height * options.supersampling));
  set_looks(surface, options);
  texture_tile.bind(surface);
  surface.set("up", up_seen_by(camera, options.camera.up));
  const Eigen::Vector4f transform = tile_transform(tile, options);
  draw_surface(surface, camera, transform);
  draw_marks(camera, transform, options);
  glDisable(GL_DEPTH_TEST);
}

RenderOptions with_faint_stripes(RenderOptions options) {
  options.base_color = {0.900f, 0.900f, 0.895f};
  options.stripe_color = {0.735f, 0.745f, 0.760f};
  return options;
}

Renderer::Renderer() : state_(std::make_unique<State>()) {}

Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

void Renderer::upload(const StripeScene& scene) {
  check_scene(scene);
  state_->points = points_of_triangles(scene.mesh);
  state_->vertex_count = scene.mesh.vertex_count();
  state_->triangle_count = scene.mesh.triangle_count();
  auto& buffers = state_->buffers;
  buffers = {};
  state_->foreign_phases = 0;
  buffers[kTriangles] = buffer_of(scene.mesh.triangles, "triangles");
  buffers[kPositions] = buffer_of(scene.mesh.positions, "positions");
  buffers[kNormals] = buffer_of(scene.normals, "normals");
  if (scene.waves != nullptr) buffers[kWaves] = buffer_of(packed_waves(*scene.waves), "waves");
  buffers[kPhases] = buffer_of(scene.z, "phases");
  buffers[kTriangleColors] = buffer_of(packed_colors(scene.triangle_colors), "triangle colours");
  buffers[kMarks] = buffer_of(packed_marks(scene.marks), "marks");
  state_->mark_count = static_cast<GLsizei>(scene.marks.size());
  if (scene.texture_waves != nullptr && scene.texture_tile != nullptr) {
    buffers[kTextureU] = buffer_of(packed_corners(scene.texture_waves->u), "waves U");
    buffers[kTextureV] = buffer_of(packed_corners(scene.texture_waves->v), "waves V");
    state_->texture_tile = GlTextureTile(*scene.texture_tile);
  }
  check_gl("copying the mesh to OpenGL");
}

void Renderer::update(const SceneChange& change) {
  check_change(change, state_->vertex_count, state_->triangle_count);
  auto& buffers = state_->buffers;
  if (!change.positions.empty()) buffers[kPositions] = buffer_of(change.positions, "positions");
  if (!change.normals.empty()) buffers[kNormals] = buffer_of(change.normals, "normals");
  if (change.waves != nullptr) buffers[kWaves] = buffer_of(packed_waves(*change.waves), "waves");
  if (!change.z.empty()) {
    buffers[kPhases] = buffer_of(change.z, "phases");
    state_->foreign_phases = 0;
  }
  if (!change.triangle_colors.empty()) {
    buffers[kTriangleColors] = buffer_of(packed_colors(change.triangle_colors), "triangle colours");
  }
  buffers[kMarks] = buffer_of(packed_marks(change.marks), "marks");
  state_->mark_count = static_cast<GLsizei>(change.marks.size());
  check_gl("copying a change of the scene to OpenGL");
}

void Renderer::use_phases(unsigned buffer) {
  GLint64 size = 0;
  glGetNamedBufferParameteri64v(buffer, GL_BUFFER_SIZE, &size);
  check_gl("looking at the buffer of phases");
  if (static_cast<std::size_t>(size) != state_->vertex_count * sizeof(Complex)) {
    throw Error("cannot draw this scene: a buffer of " + std::to_string(size) +
                " bytes is not one of phases for " + std::to_string(state_->vertex_count) +
                " vertices");
  }
  state_->foreign_phases = buffer;
}

Image Renderer::draw(const RenderOptions& options) const {
  check_options(options);
  const Camera camera =
      framed_camera(state_->points, options.camera, options.width, options.height);
  const int samples = samples_for(state_->triangle_count, options);
  return state_->picture.draw(options, samples, [&](const Target& /*target*/, const Tile& tile) {
    state_->draw_light(camera, tile, options);
  });
}

FragmentImage Renderer::draw_fragments(const RenderOptions& options) const {
  check_options(options);
  const int width = options.width;
  const int height = options.height;
  if (std::max(width, height) >
      std::min(gl_limit(GL_MAX_TEXTURE_SIZE), gl_limit(GL_MAX_VIEWPORT_DIMS))) {
    throw Error("a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                " pixels is beyond this driver's framebuffers; take a smaller one");
  }
  const Target target = target_of({GL_RG32F, GL_RGBA32F, GL_R32UI}, true, width, height);
  constexpr std::array<float, 4> kNothing{0, 0, 0, 0};
  constexpr std::array<GLuint, 4> kNoTriangles{FragmentImage::kNoTriangle, 0, 0, 0};
  constexpr float kFarthest = 1;
  glClearNamedFramebufferfv(target.framebuffer, GL_COLOR, 0, kNothing.data());
  glClearNamedFramebufferfv(target.framebuffer, GL_COLOR, 1, kNothing.data());
  glClearNamedFramebufferuiv(target.framebuffer, GL_COLOR, 2, kNoTriangles.data());
  glClearNamedFramebufferfv(target.framebuffer, GL_DEPTH, 0, &kFarthest);
  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
  glViewport(0, 0, width, height);
  glEnable(GL_DEPTH_TEST);
  if (state_->buffers[kWaves] == 0 || !state_->has_phases()) {
    throw Error("the scene has no waves whose phases could be drawn");
  }
  state_->draw_surface(state_->probe, framed_camera(state_->points, options.camera, width, height),
                       {1, 1, 0, 0});
  glDisable(GL_DEPTH_TEST);
  FragmentImage image{width, height, {}, {}, {}};
  const std::size_t count = static_cast<std::size_t>(width) * height;
  image.z.resize(count);
  image.barycentric.resize(count);
  image.triangle.resize(count);
  glNamedFramebufferReadBuffer(target.framebuffer, GL_COLOR_ATTACHMENT0);
  glReadPixels(0, 0, width, height, GL_RG, GL_FLOAT, image.z.data());
  glNamedFramebufferReadBuffer(target.framebuffer, GL_COLOR_ATTACHMENT1);
  glReadPixels(0, 0, width, height, GL_RGB, GL_FLOAT, image.barycentric.data());
  glNamedFramebufferReadBuffer(target.framebuffer, GL_COLOR_ATTACHMENT2);
  glReadPixels(0, 0, width, height, GL_RED_INTEGER, GL_UNSIGNED_INT, image.triangle.data());
  check_gl("drawing the fragments");
  flip_rows(image.z, width, height);
  flip_rows(image.barycentric, width, height);
  flip_rows(image.triangle, width, height);
  return image;
}

Image render_picture(const StripeScene& scene, const RenderOptions& options) {
  check_options(options);
  const HeadlessContext context;
  Renderer renderer;
  renderer.upload(scene);
  Image image = renderer.draw(options);
  context.check_errors("drawing the picture");
  return image;
}

}  // namespace brindle
