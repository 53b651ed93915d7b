/// A surface in OpenGL buffers, drawn by any program that reads them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/camera.h"
#include "brindle/gl/gl_name.h"
#include "brindle/gl/shader_program.h"
#include "brindle/render/surface_light.h"
#include "brindle/render/surfaces/gl_texture_tile.h"
#include "brindle/renderer.h"

namespace brindle {

/// Direction and frequency per vertex, in the shaders' layout.
std::vector<Eigen::Vector4f> packed_waves(const WaveSet& waves);

/// Needs a current context, as ShaderProgram does.
class GlSurface {
 public:
  GlSurface();

  /// As in Renderer.
  void upload(const SurfaceDrawing& drawing);
  void update(const DrawingChange& change);
  void use_phases(unsigned buffer);

  /// Draws all triangles with a program that begins with visible_triangles.vert, and sets its
  /// uniforms. `tile` is the part of the picture that fills the target (`tile_transform`).
  void draw(const ShaderProgram& program, const Camera& camera, const Eigen::Vector4f& tile) const;

  /// Binds the surface for programs that begin with surface_buffers.glsl and surface_point.glsl,
  /// and sets the uniforms of camera and surface.
  void bind(const ShaderProgram& program, const Camera& camera, const Eigen::Vector4f& tile) const;

  bool has_waves() const;
  bool has_texture() const { return buffers_[kTextureU] != 0; }
  /// Whether motifs of broken tiles are left out.
  bool has_broken_tiles() const { return broken_tiles_.has_any(); }
  bool has_triangle_colors() const { return buffers_[kTriangleColors] != 0; }
  bool has_normals() const { return buffers_[kNormals] != 0; }
  std::size_t triangle_count() const { return triangle_count_; }
  /// The points that cameras frame.
  std::span<const Vec3> points() const { return points_; }
  /// Around all vertices.
  const Eigen::AlignedBox3f& box() const { return box_; }
  /// Unique for each set of triangles and vertices, over all surfaces.
  std::uint64_t geometry() const { return geometry_; }
  /// Of the mesh as uploaded; none once vertices have moved.
  HiddenSide hidden_side() const { return hidden_side_; }

 private:
  enum Part {
    kTriangles,
    kPositions,
    kNormals,
    kWaves,
    kPhases,
    kTriangleColors,
    kTextureU,
    kTextureV,
    kParts
  };

  template <class Items>
  void renew(Part part, const Items& items, const char* what);

  std::vector<Vec3> points_;
  Eigen::AlignedBox3f box_;
  HiddenSide hidden_side_ = HiddenSide::none;
  std::uint64_t geometry_ = 0;
  std::size_t vertex_count_ = 0;
  std::size_t triangle_count_ = 0;
  std::array<GlBuffer, kParts> buffers_;
  std::array<GlTexture, kParts> textures_;  ///< buffer textures
  unsigned foreign_phases_ = 0;             ///< replaces the one in `buffers_` unless 0
  GlTextureTile texture_tile_;
  GlBrokenTiles broken_tiles_;
  GlVertexArray vertices_ = no_vertex_attributes();
};

}  // namespace brindle
