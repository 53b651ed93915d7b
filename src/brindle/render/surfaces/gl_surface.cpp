#include "brindle/render/surfaces/gl_surface.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "brindle/base/parallel.h"
#include "brindle/error.h"
#include "brindle/gl/gl_buffer.h"
#include "brindle/render/surfaces/gl_target.h"

namespace brindle {
namespace {

// The shaders' layout: plain floats and integers.
static_assert(sizeof(Triangle) == 12 && sizeof(Vec3) == 12 && sizeof(Complex) == 8);

/// Triangles per draw call. Software renderers draw one batch while they prepare the next, and keep
/// undrawn ones in memory.
constexpr std::size_t kTriangleBatch = 1 << 13;

/// Texture units after those of GlTextureTile and VisibleTriangles.
constexpr int kFirstUnit = 4;

/// Copies the items, reusing a buffer of the same size.
void renew_buffer(GlBuffer& buffer, std::span<const std::byte> items, const char* what) {
  GLint64 size = 0;
  if (buffer != 0) glGetNamedBufferParameteri64v(buffer, GL_BUFFER_SIZE, &size);
  if (static_cast<std::size_t>(size) != items.size()) {
    buffer = GlBuffer();  // frees its memory first
    buffer = make_buffer(items.size(), items.data(), what, GL_DYNAMIC_STORAGE_BIT);
  } else if (!items.empty()) {
    glNamedBufferSubData(buffer, 0, static_cast<GLsizeiptr>(items.size()), items.data());
  }
}

GlTexture buffer_texture() {
  GLuint name = 0;
  glCreateTextures(GL_TEXTURE_BUFFER, 1, &name);
  return GlTexture(name);
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

/// Direction, frequency and z of each corner.
std::vector<float> packed_corners(const std::vector<CornerWaves>& triangles) {
  std::vector<float> packed(18 * triangles.size());
  parallel_for(triangles.size(), [&](std::size_t begin, std::size_t end) {
    float* out = &packed[18 * begin];
    for (std::size_t t = begin; t < end; ++t) {
      for (const auto& [wave, z] : triangles[t]) {
        out = std::copy(wave.direction.begin(), wave.direction.end(), out);
        *out++ = wave.frequency;
        *out++ = z.real();
        *out++ = z.imag();
      }
    }
  });
  return packed;
}

/// Unique also across contexts on other threads.
std::uint64_t next_geometry() {
  static std::atomic<std::uint64_t> last = 0;
  return ++last;
}

Eigen::AlignedBox3f box_of(std::span<const Vec3> positions) {
  Eigen::AlignedBox3f box;
  for (const Vec3& position : positions) box.extend(position);
  return box;
}

void check_count(std::size_t count, std::size_t wanted, const char* what, const char* of) {
  if (count == 0 || count == wanted) return;
  throw Error("cannot draw this drawing: it has " + std::to_string(count) + " " + what + " for " +
              std::to_string(wanted) + " " + of);
}

void check_waves(const WaveSet* waves, std::size_t vertices) {
  if (waves == nullptr) return;
  check_count(waves->directions.size(), vertices, "directions", "vertices");
  check_count(waves->frequencies.size(), vertices, "frequencies", "vertices");
}

void check_change(const DrawingChange& change, std::size_t vertices, std::size_t triangles) {
  check_count(change.positions.size(), vertices, "positions", "vertices");
  check_count(change.normals.size(), vertices, "normals", "vertices");
  check_count(change.z.size(), vertices, "phases", "vertices");
  check_count(change.triangle_colors.size(), triangles, "triangle colours", "triangles");
  check_waves(change.waves, vertices);
  if (change.texture_waves == nullptr) return;
  check_count(change.texture_waves->u.size(), triangles, "waves U", "triangles");
  check_count(change.texture_waves->v.size(), triangles, "waves V", "triangles");
}

}  // namespace

std::vector<Eigen::Vector4f> packed_waves(const WaveSet& waves) {
  std::vector<Eigen::Vector4f> packed(waves.directions.size());
  for (std::size_t v = 0; v < packed.size(); ++v) {
    packed[v] << waves.directions[v], waves.frequencies[v];
  }
  return packed;
}

GlSurface::GlSurface() {
  for (GlTexture& texture : textures_) texture = buffer_texture();
}

template <class Items>
void GlSurface::renew(Part part, const Items& items, const char* what) {
  renew_buffer(buffers_[part], std::as_bytes(std::span(items)), what);
}

void GlSurface::upload(const SurfaceDrawing& drawing) {
  check_change({.normals = drawing.normals,
                .waves = drawing.waves,
                .z = drawing.z,
                .triangle_colors = drawing.triangle_colors,
                .texture_waves = drawing.texture_waves},
               drawing.mesh.vertex_count(), drawing.mesh.triangle_count());
  points_ = drawing.framed.empty()
                ? points_of_triangles(drawing.mesh)
                : std::vector<Vec3>(drawing.framed.begin(), drawing.framed.end());
  geometry_ = next_geometry();
  box_ = box_of(drawing.mesh.positions);
  hidden_side_ = brindle::hidden_side(drawing.mesh);
  vertex_count_ = drawing.mesh.vertex_count();
  triangle_count_ = drawing.mesh.triangle_count();
  foreign_phases_ = 0;
  renew(kTriangles, drawing.mesh.triangles, "triangles");
  renew(kPositions, drawing.mesh.positions, "positions");
  renew(kNormals, drawing.normals, "normals");
  renew(kWaves, drawing.waves ? packed_waves(*drawing.waves) : std::vector<Eigen::Vector4f>(),
        "waves");
  renew(kPhases, drawing.z, "phases");
  renew(kTriangleColors, packed_colors(drawing.triangle_colors), "triangle colours");
  const bool textured = drawing.texture_waves != nullptr && drawing.texture_tile != nullptr;
  renew(kTextureU, textured ? packed_corners(drawing.texture_waves->u) : std::vector<float>(),
        "waves U");
  renew(kTextureV, textured ? packed_corners(drawing.texture_waves->v) : std::vector<float>(),
        "waves V");
  if (textured) texture_tile_ = GlTextureTile(*drawing.texture_tile);
  broken_tiles_ = GlBrokenTiles(textured ? drawing.broken_tiles : nullptr, triangle_count_);
  check_gl("copying the mesh to OpenGL");
}

void GlSurface::update(const DrawingChange& change) {
  check_change(change, vertex_count_, triangle_count_);
  if (!change.positions.empty()) {
    geometry_ = next_geometry();
    box_ = box_of(change.positions);
    hidden_side_ = HiddenSide::none;
    renew(kPositions, change.positions, "positions");
  }
  if (!change.normals.empty()) renew(kNormals, change.normals, "normals");
  if (change.waves != nullptr) renew(kWaves, packed_waves(*change.waves), "waves");
  if (!change.z.empty()) {
    renew(kPhases, change.z, "phases");
    foreign_phases_ = 0;
  }
  if (!change.triangle_colors.empty()) {
    renew(kTriangleColors, packed_colors(change.triangle_colors), "triangle colours");
  }
  if (change.texture_waves != nullptr) {
    renew(kTextureU, packed_corners(change.texture_waves->u), "waves U");
    renew(kTextureV, packed_corners(change.texture_waves->v), "waves V");
    broken_tiles_ = GlBrokenTiles(change.broken_tiles, triangle_count_);
  }
  check_gl("copying a change of the drawing to OpenGL");
}

void GlSurface::use_phases(unsigned buffer) {
  GLint64 size = 0;
  glGetNamedBufferParameteri64v(buffer, GL_BUFFER_SIZE, &size);
  check_gl("looking at the buffer of phases");
  if (static_cast<std::size_t>(size) != vertex_count_ * sizeof(Complex)) {
    throw Error("cannot draw this: a buffer of " + std::to_string(size) +
                " bytes is not one of phases for " + std::to_string(vertex_count_) + " vertices");
  }
  foreign_phases_ = buffer;
}

bool GlSurface::has_waves() const {
  return buffers_[kWaves] != 0 && (foreign_phases_ != 0 || buffers_[kPhases] != 0);
}

void GlSurface::draw(const ShaderProgram& program, const Camera& camera,
                     const Eigen::Vector4f& tile) const {
  set_camera(program, camera, tile);
  const SlicedDrawing sliced(camera);
  glUseProgram(program.name());
  glVertexArrayElementBuffer(vertices_, buffers_[kTriangles]);
  glVertexArrayVertexBuffer(vertices_, 0, buffers_[kPositions], 0, sizeof(Vec3));
  glVertexArrayAttribFormat(vertices_, 0, 3, GL_FLOAT, GL_FALSE, 0);
  glEnableVertexArrayAttrib(vertices_, 0);
  glBindVertexArray(vertices_);
  for (std::size_t first = 0; first < triangle_count_; first += kTriangleBatch) {
    const std::size_t count = std::min(kTriangleBatch, triangle_count_ - first);
    program.set("first_triangle", static_cast<int>(first));
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * count), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(first * sizeof(Triangle)));
    glFlush();
  }
}

void GlSurface::bind(const ShaderProgram& program, const Camera& camera,
                     const Eigen::Vector4f& tile) const {
  constexpr std::array<const char*, kParts> kPartNames{
      "triangle_vertices", "positions", "normals",  "waves", "phases",
      "triangle_colors",   "texture_u", "texture_v"};
  constexpr std::array<GLenum, kParts> kFormats{GL_RGB32UI, GL_RGB32F, GL_RGB32F, GL_RGBA32F,
                                                GL_RG32F,   GL_R32UI,  GL_RG32F,  GL_RG32F};
  set_camera(program, camera, tile);
  program.set("smooth_normals", has_normals());
  texture_tile_.bind(program);
  broken_tiles_.bind(program);
  for (std::size_t part = 0; part < kParts; ++part) {
    const bool foreign = part == kPhases && foreign_phases_ != 0;
    glTextureBuffer(textures_[part], kFormats[part], foreign ? foreign_phases_ : buffers_[part]);
    program.set(kPartNames[part], kFirstUnit + static_cast<int>(part));
    glBindTextureUnit(kFirstUnit + static_cast<GLuint>(part), textures_[part]);
  }
}

}  // namespace brindle
