/// What a camera's slice takes away is not drawn.
#pragma once

#include "brindle/camera.h"
#include "brindle/gl/shader_program.h"

namespace brindle {

/// The slice of positions less the camera's `origin`: x, y and z of its normal, and what is added;
/// above 0 is away. Without a slice nothing is.
Eigen::Vector4f slice_of(const Camera& camera);

/// As long as this lives, programs whose vertex shaders say so (`gl_ClipDistance[0]`) leave out
/// what the camera's slice takes away. Sets the uniform `slice` of one.
class SlicedDrawing {
 public:
  SlicedDrawing(const ShaderProgram& program, const Camera& camera);
  ~SlicedDrawing();
  SlicedDrawing(const SlicedDrawing&) = delete;
  SlicedDrawing& operator=(const SlicedDrawing&) = delete;

 private:
  bool sliced_;
};

}  // namespace brindle
