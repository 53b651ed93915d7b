/// The surface of a drawing in OpenGL's buffers, drawn by any program that reads them.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "brindle/camera.h"
#include "brindle/gl/gl_name.h"
#include "brindle/gl/shader_program.h"
#include "brindle/render/gl_texture_tile.h"
#include "brindle/renderer.h"

namespace brindle {

/// Programs begin with the shaders surface_buffers.glsl and surface.vert. Needs a current context,
/// as ShaderProgram does.
class GlSurface {
 public:
  /// As those of Renderer.
  void upload(const SurfaceDrawing& drawing);
  void update(const DrawingChange& change);
  void use_phases(unsigned buffer);

  /// Sets the program's uniforms of camera and surface and draws all triangles. `tile` is the part
  /// of the picture that fills the target (`tile_transform`).
  void draw(const ShaderProgram& program, const Camera& camera, const Eigen::Vector4f& tile) const;

  bool has_waves() const;
  std::size_t triangle_count() const { return triangle_count_; }
  /// What a camera has to frame.
  std::span<const Vec3> points() const { return points_; }

  /// Where a drawing's marks are bound, which are not drawn here.
  static constexpr unsigned kMarksBinding = 6;

 private:
  enum Binding {
    kTriangles,
    kPositions,
    kNormals,
    kWaves,
    kPhases,
    kTriangleColors,
    kMarksUnused,
    kTextureU,
    kTextureV,
    kBindings
  };

  std::vector<Vec3> points_;
  std::size_t vertex_count_ = 0;
  std::size_t triangle_count_ = 0;
  std::array<GlBuffer, kBindings> buffers_;
  unsigned foreign_phases_ = 0;  ///< instead of those in `buffers_`, unless 0
  GlTextureTile texture_tile_;
  GlVertexArray no_attributes_ = no_vertex_attributes();
};

}  // namespace brindle
