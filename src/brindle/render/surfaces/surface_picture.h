/// Pictures of surfaces: the common part of Renderer and StyledRenderer.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "brindle/render/surfaces/shading.h"
#include "brindle/render/surfaces/tiled_picture.h"
#include "brindle/render/surfaces/visible_triangles.h"

namespace brindle {

/// Reuses surfaces, programs and targets from picture to picture. Needs a current context, as
/// ShaderProgram does.
class SurfacePicture {
 public:
  /// Draws marks over the light of a part's surfaces.
  using DrawMarks = std::function<void(const PicturePart& part, const VisibleSamples& seen)>;

  std::vector<DrawnSurface> surfaces;

  /// Draws the surfaces and the optional ground shadow. Throws Cancelled between passes.
  Image draw(PictureScene& scene, const std::optional<GroundShadow>& shadow,
             const DrawMarks& draw_marks, const Progress& progress);

 private:
  void draw_surroundings(PictureScene& scene);
  void draw_ground(const PictureScene& scene, const GroundShadow& shadow, GLuint texture,
                   const PicturePart& part, const Target& light);

  TiledPicture tiles_;
  VisibleTriangles visible_;
  Shading shading_;
  VisibleSamples seen_, surroundings_;   ///< of a part; of the whole picture, coarser
  std::optional<ShaderProgram> ground_;  ///< created on demand
  GlVertexArray no_attributes_ = no_vertex_attributes();
};

/// Two axes along the ground and one off it.
Eigen::Matrix3f ground_axes(UpAxis up);

}  // namespace brindle
