#include "brindle/render/surfaces/gl_camera.h"

#include <epoxy/gl.h>

namespace brindle {
namespace {

/// The slice for positions relative to the camera's `origin`: normal and offset; positive points
/// are cut away. Zero without a slice.
Eigen::Vector4f slice_of(const Camera& camera) {
  if (!camera.slice) return {0, 0, 0, -1};
  Eigen::Vector4f slice;
  slice << camera.slice->normal(), camera.slice->signedDistance(camera.origin);
  return slice;
}

}  // namespace

void set_camera(const ShaderProgram& program, const Camera& camera, const Eigen::Vector4f& tile) {
  program.set("origin", camera.origin);
  program.set("view_from_world", camera.view_from_world);
  program.set("clip_from_view", camera.clip_from_view);
  program.set("slice", slice_of(camera));
  program.set("tile", tile);
}

SlicedDrawing::SlicedDrawing(const Camera& camera) : sliced_(camera.slice.has_value()) {
  if (sliced_) glEnable(GL_CLIP_DISTANCE0);
}

SlicedDrawing::~SlicedDrawing() {
  if (sliced_) glDisable(GL_CLIP_DISTANCE0);
}

}  // namespace brindle
