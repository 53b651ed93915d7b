#include "brindle/render/sliced_drawing.h"

#include <epoxy/gl.h>

namespace brindle {

Eigen::Vector4f slice_of(const Camera& camera) {
  if (!camera.slice) return {0, 0, 0, -1};
  Eigen::Vector4f slice;
  slice << camera.slice->normal(), camera.slice->signedDistance(camera.origin);
  return slice;
}

SlicedDrawing::SlicedDrawing(const ShaderProgram& program, const Camera& camera)
    : sliced_(camera.slice.has_value()) {
  program.set("slice", slice_of(camera));
  if (sliced_) glEnable(GL_CLIP_DISTANCE0);
}

SlicedDrawing::~SlicedDrawing() {
  if (sliced_) glDisable(GL_CLIP_DISTANCE0);
}

}  // namespace brindle
