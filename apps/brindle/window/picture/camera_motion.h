/// How a view follows the mouse.
#pragma once

#include "brindle/camera.h"
#include "session/session_document.h"

namespace brindle::tool {

/// Turns by a motion of the mouse, in shares of the picture's height: round the axis that points
/// up and over the poles at most, or freely where the view has a rotation of its own.
CameraView turned(const CameraView& view, const Eigen::Vector2f& motion);

/// A light pulled by a motion of the mouse, in shares of the picture's height: to the right and up
/// with it, over the poles at most.
LightDirection moved_light(const LightDirection& light, const Eigen::Vector2f& motion);

/// The same with this zoom.
CameraView zoomed_to(const CameraView& view, float zoom);

/// Zoomed in by this many clicks of the wheel, within what views allow.
CameraView zoomed(const CameraView& view, float clicks);

/// Moves what is seen by pixels to the right and down. `camera` is that with which `view` shows a
/// picture of this size; `center` is in its middle.
CameraView moved(const CameraView& view, const Camera& camera, const Vec3& center, PictureSize size,
                 const Eigen::Vector2f& pixels);

/// The point in the middle of the picture that is as far from the viewer as `near`.
Vec3 middle_of(const Camera& camera, const Vec3& near);

/// The point under a pixel of a picture of this size that is as far from the viewer as `near`.
Vec3 place_under(const Camera& camera, PictureSize size, const Eigen::Vector2d& pixel,
                 const Vec3& near);

/// With a rotation of its own, which starts where the view is.
CameraView freed(const CameraView& view);

/// Upright again: without a rotation, looking the same way.
CameraView upright(const CameraView& view);

/// Orthographic instead of perspective, or the other way round.
CameraView with_other_projection(const CameraView& view);

/// From one side: azimuth and elevation in degrees, upright.
CameraView from_side(const CameraView& view, float azimuth_deg, float elevation_deg);

}  // namespace brindle::tool
