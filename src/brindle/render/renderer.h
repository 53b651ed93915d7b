/// Pictures of stripes on a surface, by OpenGL.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "brindle/geometry/mesh.h"
#include "brindle/pattern/texture_waves.h"
#include "brindle/render/camera.h"
#include "brindle/render/color.h"
#include "brindle/render/image.h"
#include "brindle/render/overlay.h"
#include "brindle/render/texture_tile.h"
#include "brindle/waves/phase_graph.h"

namespace brindle {

/// What is drawn. Everything but the mesh may be left empty: no normals gives flat facets, no waves
/// a plain surface. Triangles with a corner that has no wave are drawn as plain surface too.
struct SurfaceDrawing {
  const Mesh& mesh;
  std::span<const Vec3> normals = {};  ///< one unit normal per vertex
  const WaveSet* waves = nullptr;      ///< one wave per vertex; positions are the mesh's
  std::span<const Complex> z = {};     ///< one phase exp(i Phi) per vertex
  std::span<const TriangleColor> triangle_colors = {};  ///< one per triangle
  std::span<const Mark> marks = {};
  const TextureWaves* texture_waves =
      nullptr;                                ///< with `texture_tile`: a texture instead of stripes
  const TextureTile* texture_tile = nullptr;  ///< figures are drawn in the colour of stripes
};

/// What has changed in a drawing that was uploaded before. Spans left empty and no waves leave what
/// was there; marks are replaced in any case.
struct DrawingChange {
  std::span<const Vec3> positions = {};  ///< one per vertex
  std::span<const Vec3> normals = {};    ///< one per vertex
  const WaveSet* waves = nullptr;
  std::span<const Complex> z = {};
  std::span<const TriangleColor> triangle_colors = {};
  std::span<const Mark> marks = {};
};

struct RenderOptions {
  int width = 1200;   ///< pixels
  int height = 900;   ///< pixels
  CameraView camera;  ///< the mesh is framed from this side
  Color base_color{0.957f, 0.937f, 0.898f};
  Color stripe_color{0.110f, 0.196f, 0.353f};
  float stripe_width = 0.5f;  ///< share of the period, 0 to 1
  Color background_center{0.980f, 0.980f, 0.976f};
  Color background_edge{0.855f, 0.867f, 0.882f};
  bool transparent = false;  ///< no background: its alpha is 0
  bool shading = true;       ///< false: plain colours without light
  float mark_radius = 6;     ///< pixels
  int supersampling = 2;     ///< 1 to 4: samples along each side of a pixel, beside multisampling
  int tile_side =
      2048;  ///< samples along a side of the parts that a picture is drawn in, at least 64
};

/// The colours that let overlays stand out: a light grey surface with faint stripes.
RenderOptions with_faint_stripes(RenderOptions options);

/// Draws in the OpenGL 4.5 context that is current when it is made; that context must be
/// current whenever it is used or destroyed.
class Renderer {
 public:
  /// Throws Error, naming shader file and line, if the driver does not take the shaders.
  Renderer();
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// Copies the drawing to OpenGL, in place of the last one.
  /// Throws Error if sizes do not match or the drawing is larger than the driver's buffers.
  void upload(const SurfaceDrawing& drawing);

  /// Copies what has changed since the last upload. The camera goes on framing the mesh as it was
  /// uploaded, so that moving vertices do not move it. Throws as `upload` does.
  void update(const DrawingChange& change);

  /// Reads phases from an OpenGL buffer of somebody else's, 2 floats a vertex, such as
  /// `GpuAnimator::phases`, until the next `upload`, or `update` with phases: what is there when a
  /// picture is drawn is drawn, without a copy. Throws Error if the buffer is not that large.
  void use_phases(unsigned buffer);

  /// Draws the uploaded drawing. Pictures larger than the driver's framebuffers are drawn in tiles.
  /// Throws Error if an option is out of its range or the picture is beyond the limits of image.h.
  Image draw(const RenderOptions& options) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Draws one picture in a headless context of its own. Throws what HeadlessContext and Renderer do.
Image render_picture(const SurfaceDrawing& drawing, const RenderOptions& options = {});

}  // namespace brindle
