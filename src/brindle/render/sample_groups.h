/// Which samples of a pixel show one surface, so that they are shaded once and not each for itself.
#pragma once

#include "brindle/gl/shader_program.h"
#include "brindle/render/gl_surface.h"
#include "brindle/render/gl_target.h"
#include "brindle/renderer.h"

namespace brindle {

/// Kept from picture to picture.
class SampleGroups {
 public:
  /// How many groups of a pixel are shaded in a picture of this quality.
  static int count(const GlSurface& surface, PictureQuality quality);

  /// Looks at all samples of `visible` that show triangles of this surface, whose numbers begin at
  /// `first_number`, for a shading of `size` pixels in the lower left of `light`.
  void find(const GlSurface& surface, const Target& visible, const Camera& camera,
            const Eigen::Vector4f& tile, const Target& light, const Eigen::Vector2i& size,
            int first_number = 0);

  /// Draws a program that reads `groups`, `group` and `last_group` as shade.frag does into `light`,
  /// for `count` groups one after the other, each over the pixels that have so many. The light of
  /// the first one goes in place of what is there, or on top of it.
  enum class First { in_place, on_top };
  void shade(const ShaderProgram& program, const Target& light, int count,
             First first = First::in_place);

 private:
  ShaderProgram program_{{"full_screen.vert"}, {"visible_samples.glsl", "group_samples.frag"}};
  Target groups_;         ///< which samples of a pixel are shaded together; depths: how many groups
  Eigen::Vector4i part_;  ///< of the target, where the surface is seen: lower left corner and size
  GlVertexArray no_attributes_ = no_vertex_attributes();
};

}  // namespace brindle
