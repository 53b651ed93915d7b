/// The second pass of a picture: the light of what is seen.
#pragma once

#include <array>
#include <optional>

#include "brindle/gl/shader_program.h"
#include "brindle/render/gl_surface.h"
#include "brindle/render/gl_target.h"
#include "brindle/render/sample_groups.h"
#include "brindle/render/visible_triangles.h"
#include "brindle/renderer.h"

namespace brindle {

/// Evaluates the surface's pattern and light once for each pixel, and once more for each further
/// surface that is seen in it.
class Shading {
 public:
  /// Draws into the lower left of `light`, `size` pixels; what shows no surface is left
  /// transparent.
  void draw(const GlSurface& surface, const VisibleTriangles& visible, const Camera& camera,
            const Eigen::Vector4f& tile, const Target& light, const Eigen::Vector2i& size,
            const RenderOptions& options);

 private:
  /// Software renderers execute both sides of a branch, so every pattern has a program of its own.
  enum Pattern { kNone, kStripes, kTexture, kWholeTiles, kPatterns };

  const ShaderProgram& program_for(const GlSurface& surface);

  std::array<std::optional<ShaderProgram>, kPatterns> programs_;  ///< made when they are needed
  SampleGroups groups_;
};

}  // namespace brindle
