#include "brindle/render/gl_surface.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "brindle/error.h"
#include "brindle/gl/gl_buffer.h"

namespace brindle {
namespace {

// What the shaders take for plain floats and integers.
static_assert(sizeof(Triangle) == 12 && sizeof(Vec3) == 12 && sizeof(Complex) == 8);

/// Triangles drawn at once. Software renderers keep all that they have not yet drawn in memory.
constexpr std::size_t kTriangleBatch = 1 << 16;

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
  throw Error("cannot draw this drawing: it has " + std::to_string(count) + " " + what + " for " +
              std::to_string(wanted) + " " + of);
}

void check_waves(const WaveSet* waves, std::size_t vertices) {
  if (waves == nullptr) return;
  check_count(waves->directions.size(), vertices, "directions", "vertices");
  check_count(waves->frequencies.size(), vertices, "frequencies", "vertices");
}

void check_drawing(const SurfaceDrawing& drawing) {
  const std::size_t vertices = drawing.mesh.vertex_count();
  check_count(drawing.normals.size(), vertices, "normals", "vertices");
  check_count(drawing.z.size(), vertices, "phases", "vertices");
  check_count(drawing.triangle_colors.size(), drawing.mesh.triangle_count(), "triangle colours",
              "triangles");
  check_waves(drawing.waves, vertices);
  if (drawing.texture_waves == nullptr) return;
  check_count(drawing.texture_waves->u.size(), drawing.mesh.triangle_count(), "waves U",
              "triangles");
  check_count(drawing.texture_waves->v.size(), drawing.mesh.triangle_count(), "waves V",
              "triangles");
}

void check_change(const DrawingChange& change, std::size_t vertices, std::size_t triangles) {
  check_count(change.positions.size(), vertices, "positions", "vertices");
  check_count(change.normals.size(), vertices, "normals", "vertices");
  check_count(change.z.size(), vertices, "phases", "vertices");
  check_count(change.triangle_colors.size(), triangles, "triangle colours", "triangles");
  check_waves(change.waves, vertices);
}

}  // namespace

void GlSurface::upload(const SurfaceDrawing& drawing) {
  check_drawing(drawing);
  points_ = points_of_triangles(drawing.mesh);
  vertex_count_ = drawing.mesh.vertex_count();
  triangle_count_ = drawing.mesh.triangle_count();
  buffers_ = {};
  foreign_phases_ = 0;
  buffers_[kTriangles] = buffer_of(drawing.mesh.triangles, "triangles");
  buffers_[kPositions] = buffer_of(drawing.mesh.positions, "positions");
  buffers_[kNormals] = buffer_of(drawing.normals, "normals");
  if (drawing.waves != nullptr) buffers_[kWaves] = buffer_of(packed_waves(*drawing.waves), "waves");
  buffers_[kPhases] = buffer_of(drawing.z, "phases");
  buffers_[kTriangleColors] = buffer_of(packed_colors(drawing.triangle_colors), "triangle colours");
  if (drawing.texture_waves != nullptr && drawing.texture_tile != nullptr) {
    buffers_[kTextureU] = buffer_of(packed_corners(drawing.texture_waves->u), "waves U");
    buffers_[kTextureV] = buffer_of(packed_corners(drawing.texture_waves->v), "waves V");
    texture_tile_ = GlTextureTile(*drawing.texture_tile);
  }
  check_gl("copying the mesh to OpenGL");
}

void GlSurface::update(const DrawingChange& change) {
  check_change(change, vertex_count_, triangle_count_);
  if (!change.positions.empty()) buffers_[kPositions] = buffer_of(change.positions, "positions");
  if (!change.normals.empty()) buffers_[kNormals] = buffer_of(change.normals, "normals");
  if (change.waves != nullptr) buffers_[kWaves] = buffer_of(packed_waves(*change.waves), "waves");
  if (!change.z.empty()) {
    buffers_[kPhases] = buffer_of(change.z, "phases");
    foreign_phases_ = 0;
  }
  if (!change.triangle_colors.empty()) {
    buffers_[kTriangleColors] =
        buffer_of(packed_colors(change.triangle_colors), "triangle colours");
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
  program.set("origin", camera.origin);
  program.set("view_from_world", camera.view_from_world);
  program.set("clip_from_view", camera.clip_from_view);
  program.set("tile", tile);
  program.set("smooth_normals", buffers_[kNormals] != 0);
  program.set("has_waves", has_waves());
  program.set("has_texture", buffers_[kTextureU] != 0);
  program.set("has_triangle_colors", buffers_[kTriangleColors] != 0);
  texture_tile_.bind(program);
  for (GLuint binding = 0; binding < buffers_.size(); ++binding) {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffers_[binding]);
  }
  if (foreign_phases_ != 0) glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kPhases, foreign_phases_);
  glUseProgram(program.name());
  glBindVertexArray(no_attributes_);
  for (std::size_t first = 0; first < triangle_count_; first += kTriangleBatch) {
    glDrawArrays(GL_TRIANGLES, static_cast<GLint>(3 * first),
                 static_cast<GLsizei>(3 * std::min(kTriangleBatch, triangle_count_ - first)));
    if (first + kTriangleBatch < triangle_count_) glFinish();
  }
}

}  // namespace brindle
