/// The camera as shader uniforms.
#pragma once

#include "brindle/camera.h"
#include "brindle/gl/shader_program.h"

namespace brindle {

/// Sets the uniforms `origin`, `view_from_world`, `clip_from_view`, `slice` and `tile`. `tile` is
/// the part of the picture that fills the target (`tile_transform`).
void set_camera(const ShaderProgram& program, const Camera& camera, const Eigen::Vector4f& tile);

/// RAII: enables the camera's slice for programs whose vertex shaders set `gl_ClipDistance[0]`.
class SlicedDrawing {
 public:
  explicit SlicedDrawing(const Camera& camera);
  ~SlicedDrawing();
  SlicedDrawing(const SlicedDrawing&) = delete;
  SlicedDrawing& operator=(const SlicedDrawing&) = delete;

 private:
  bool sliced_;
};

}  // namespace brindle
