/// The first pass of a picture: which triangle of which surface is seen where.
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
  bool tinted = true;                           ///< by the depth cue
  bool sliced = true;                           ///< by the camera's slice
  int first_number = 0;                         ///< of its triangles among those of all surfaces

  bool discards() const { return style && style->discards(); }
  /// The picture's camera as it shows this surface.
  Camera seen_by(const Camera& camera) const;
};

/// The part of a picture that is drawn at once.
struct PicturePart {
  Eigen::Vector4f transform;                         ///< `tile_transform`
  Eigen::Vector2i size;                              ///< of its light, in evaluations
  Eigen::Vector2i corner = Eigen::Vector2i::Zero();  ///< of its light in the picture's
};

/// What a first pass shows. One that would show the same need not be drawn again, as long as its
/// target holds it: while stripes or styles change, and nothing moves.
struct ShownPart {
  struct Surface {
    std::uint64_t geometry;
    Camera camera;
    bool operator==(const Surface& other) const;
  };

  std::vector<Surface> surfaces;  ///< none: nothing that could be shown again
  Eigen::Vector4f tile = Eigen::Vector4f::Zero();
  Eigen::Vector2i size = Eigen::Vector2i::Zero(), viewport = Eigen::Vector2i::Zero();
  bool leaves_out_hidden = false;

  bool operator==(const ShownPart&) const = default;
};

/// Numbers and depths of the triangles that are seen, in samples of which each pixel of the light
/// has two by two. Kept from picture to picture.
struct VisibleSamples {
  Target target;
  ShownPart shown;  ///< by `target`

  /// Lets a program that includes visible_samples.glsl read them.
  void bind(const ShaderProgram& program) const;
};

/// Draws first passes.
class VisibleTriangles {
 public:
  /// Samples along the side of a pixel, as visible_samples.glsl has it.
  static constexpr int kSamples = 2;

  /// Throws Error, naming shader file and line, if the driver does not take the shaders.
  VisibleTriangles();

  /// Draws the surfaces for a light of at most `largest` pixels, of which the part fills some.
  /// Interactive pictures leave out the hidden side of closed surfaces, on which half of the time
  /// is spent. Calls `pause` after each surface. Throws Error if the driver cannot draw into
  /// samples for as many pixels.
  void draw(VisibleSamples& samples, std::span<const DrawnSurface> surfaces, const Camera& camera,
            const PicturePart& part, const Eigen::Vector2i& largest, const RenderOptions& options,
            const std::function<void()>& pause = {});

 private:
  /// Triangles that are seen in parts: all of a surface, or those in the lists of pixels.
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
  std::optional<ShaderProgram> list_, spread_;  ///< made when they are needed
  std::map<std::string, ShaderProgram> parts_;  ///< by what they are and the style's features
  Target once_;                                 ///< what pixels of a draft show
  GlBuffer lists_;  ///< of pixels' triangles, as listed_triangles.glsl has them
  std::size_t list_words_ = 0;
  GlVertexArray no_attributes_ = no_vertex_attributes();
};

}  // namespace brindle
