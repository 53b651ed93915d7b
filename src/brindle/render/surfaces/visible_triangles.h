/// The first pass of a picture: the visible triangle at each sample.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brindle/gl/shader_program.h"
#include "brindle/render/surfaces/gl_style.h"
#include "brindle/render/surfaces/gl_surface.h"
#include "brindle/render/surfaces/gl_target.h"
#include "brindle/renderer.h"

namespace brindle {

/// A surface of a picture.
struct DrawnSurface {
  GlSurface surface;
  std::optional<GlStyle> style = std::nullopt;  ///< none: the colours of the picture's options
  bool tinted = true;                           ///< whether the depth cue applies
  bool sliced = true;                           ///< whether the camera's slice applies
  int first_number = 0;  ///< index of its first triangle among those of all surfaces

  bool discards() const { return style && style->discards(); }
  /// The picture's camera for this surface.
  Camera seen_by(const Camera& camera) const;
};

/// The part of a picture that is drawn at once.
struct PicturePart {
  Eigen::Vector4f transform;                         ///< `tile_transform`
  Eigen::Vector2i size;                              ///< of its light, in evaluations
  Eigen::Vector2i corner = Eigen::Vector2i::Zero();  ///< of its light in that of the picture
};

/// The content of a first pass. An equal one need not be drawn again while its target holds it, as
/// when only stripes or styles change.
struct ShownPart {
  struct Surface {
    std::uint64_t geometry;
    Camera camera;
    bool operator==(const Surface& other) const;
  };

  std::vector<Surface> surfaces;  ///< empty: not reusable
  Eigen::Vector4f tile = Eigen::Vector4f::Zero();
  Eigen::Vector2i size = Eigen::Vector2i::Zero(), viewport = Eigen::Vector2i::Zero();
  bool leaves_out_hidden = false;

  bool operator==(const ShownPart&) const = default;
};

/// Numbers and depths of visible triangles, in two by two samples per pixel of the light. Reused
/// from picture to picture.
struct VisibleSamples {
  Target target;
  ShownPart shown;  ///< in `target`

  /// Binds them for programs that include visible_samples.glsl.
  void bind(const ShaderProgram& program) const;
};

/// Draws first passes.
class VisibleTriangles {
 public:
  /// Samples along the side of a pixel, as in visible_samples.glsl.
  static constexpr int kSamples = 2;

  /// Throws Error with shader file and line if the driver rejects the shaders.
  VisibleTriangles();

  /// Draws the surfaces for a light of at most `largest` pixels, of which the part fills some.
  /// Interactive pictures leave out the hidden side of closed surfaces, which takes half of the
  /// time. Calls `pause` after each surface. Throws Error if the driver has no samples for so many
  /// pixels.
  void draw(VisibleSamples& samples, std::span<const DrawnSurface> surfaces, const Camera& camera,
            const PicturePart& part, const Eigen::Vector2i& largest, const RenderOptions& options,
            const std::function<void()>& pause = {});

 private:
  /// Triangles of partly discarded surfaces: all, or those in the pixel lists.
  enum class Triangles { all, listed };

  void draw_whole(const DrawnSurface& drawn, const Camera& camera, const PicturePart& part,
                  bool draft);
  void draw_parts(const DrawnSurface& drawn, const Camera& camera, const PicturePart& part,
                  const RenderOptions& options, int samples, Triangles triangles);
  void draw_parts_once(Target& samples, const DrawnSurface& drawn, const Camera& camera,
                       const PicturePart& part, const Eigen::Vector2i& largest,
                       const RenderOptions& options);
  void list_triangles(const DrawnSurface& drawn, const Camera& camera, const PicturePart& part);
  const ShaderProgram& parts_program(const GlStyle& style, Triangles triangles);

  ShaderProgram whole_;
  std::optional<ShaderProgram> list_, spread_;  ///< created on demand
  std::map<std::string, ShaderProgram> parts_;  ///< by kind and features of the style
  Target once_;                                 ///< visible samples of a draft's pixels
  GlBuffer lists_;  ///< triangles of pixels, as in listed_triangles.glsl
  std::size_t list_words_ = 0;
  GlVertexArray no_attributes_ = no_vertex_attributes();
};

}  // namespace brindle
