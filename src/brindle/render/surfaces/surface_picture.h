/// Pictures of surfaces, one or several: what Renderer and StyledRenderer have in common.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "brindle/render/surfaces/ground_shadow.h"
#include "brindle/render/surfaces/shading.h"
#include "brindle/render/surfaces/tiled_picture.h"
#include "brindle/render/surfaces/visible_triangles.h"

namespace brindle {

/// Keeps surfaces, programs and targets from picture to picture. Needs a current context, as
/// ShaderProgram does.
class SurfacePicture {
 public:
  /// Draws on top of the light of a part's surfaces.
  using DrawMarks = std::function<void(const PicturePart& part, const VisibleSamples& seen)>;

  std::vector<DrawnSurface> surfaces;

  /// Draws the surfaces, and the shadow on the ground if there is one. Throws Cancelled if
  /// `progress` asks for it, between one pass and the next.
  Image draw(PictureScene& scene, const std::optional<GroundShadow>& shadow,
             const DrawMarks& draw_marks, const Progress& progress);

 private:
  void draw_surroundings(PictureScene& scene);
  void draw_ground(const PictureScene& scene, const GroundShadow& shadow, GLuint texture,
                   const PicturePart& part, const Target& light);

  TiledPicture tiles_;
  VisibleTriangles visible_;
  Shading shading_;
  VisibleSamples seen_, surroundings_;   ///< of a part; of all of a picture, coarser
  std::optional<ShaderProgram> ground_;  ///< made when it is needed
  GlVertexArray no_attributes_ = no_vertex_attributes();
};

/// Two axes along the ground and the one off it.
Eigen::Matrix3f ground_axes(UpAxis up);

}  // namespace brindle
