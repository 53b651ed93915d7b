/// The second pass of a picture: shading of visible surfaces.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/gl/shader_program.h"
#include "brindle/mesh.h"
#include "brindle/render/surfaces/visible_triangles.h"
#include "brindle/styled_picture.h"

namespace brindle {

/// Shared by all passes of a picture.
struct PictureScene {
  Camera camera;
  const StyledOptions& options;
  Eigen::Vector2f depths{0, 1};                  ///< for depth cues: nearest and farthest point
  float diagonal = 0;                            ///< of all surfaces
  GlTexture color_map = {};                      ///< where styles follow values
  const VisibleSamples* surroundings = nullptr;  ///< of the whole picture, if it is drawn in parts
};

/// Evaluates pattern and light once per pixel, and once more for each further surface in it. Reused
/// from picture to picture.
class Shading {
 public:
  /// The light of a part replaces the target's or is added to it.
  enum class Light { replaced, added };

  /// Draws the light of a surface into the lower left of `light`, where `seen` has its triangles.
  void draw(const DrawnSurface& drawn, const VisibleSamples& seen, const PictureScene& scene,
            const PicturePart& part, const Target& light, Light first);

 private:
  const ShaderProgram& program_for(const DrawnSurface& drawn, const StyledOptions& options);
  void group_samples(const DrawnSurface& drawn, const VisibleSamples& seen,
                     const PictureScene& scene, const PicturePart& part, const Target& light);
  void set_scene(const ShaderProgram& program, const DrawnSurface& drawn,
                 const VisibleSamples& seen, const PictureScene& scene,
                 const PicturePart& part) const;
  void shade_groups(const ShaderProgram& program, const Target& light, int count, Light first);

  ShaderProgram group_{{"full_screen.vert"}, {"visible_samples.glsl", "group_samples.frag"}};
  std::map<std::string, ShaderProgram> programs_;  ///< by pattern and features
  Target groups_;         ///< groups of samples that are shaded together; depths: their number
  Eigen::Vector4i part_;  ///< of the target, around the surface: lower left corner and size
  GlVertexArray no_attributes_ = no_vertex_attributes();
};

// Soft shadows of surfaces on the ground.

/// Blocked shares of light, `side` x `side`, row by row along the first axis.
struct GroundShadow {
  static constexpr int kSide = 192;
  std::vector<float> missing;
  Eigen::Vector2f lower, size;  ///< of the square, along the two ground axes
  float height = 0;             ///< of the ground, along the third axis
};

/// The columns of `axes` are two axes along the ground and the one off it. The light is vertical.
/// `points` are the corners of `triangles`.
GroundShadow ground_shadow(std::span<const Vec3> points, std::span<const Triangle> triangles,
                           const Eigen::Matrix3f& axes);

/// The part of a mesh on the negative side of the plane; triangles are clipped there.
Mesh left_by(const Eigen::Hyperplane<float, 3>& slice, const Mesh& mesh);

}  // namespace brindle
