/// Camera motion with the mouse.
#pragma once

#include "brindle/camera.h"
#include "session/session_document.h"

namespace brindle::tool {

/// Turns by a mouse motion relative to the picture's height: about the up axis and at most to the
/// poles, or freely for views with a rotation.
CameraView turned(const CameraView& view, const Eigen::Vector2f& motion);

/// Moves the light with the mouse, relative to the picture's height, at most to the poles.
LightDirection moved_light(const LightDirection& light, const Eigen::Vector2f& motion);

/// The same with this zoom.
CameraView zoomed_to(const CameraView& view, float zoom);

/// Zooms in by wheel clicks, within the limits of views.
CameraView zoomed(const CameraView& view, float clicks);

/// Moves the content by pixels to the right and down. `camera` is that of `view` for a picture of
/// this size; `center` is in its middle.
CameraView moved(const CameraView& view, const Camera& camera, const Vec3& center, PictureSize size,
                 const Eigen::Vector2f& pixels);

/// The point in the middle of the picture at the depth of `near`.
Vec3 middle_of(const Camera& camera, const Vec3& near);

/// The point under a pixel of a picture of this size at the depth of `near`.
Vec3 place_under(const Camera& camera, PictureSize size, const Eigen::Vector2d& pixel,
                 const Vec3& near);

/// The view as a free rotation.
CameraView freed(const CameraView& view);

/// The view without a rotation, in the same direction.
CameraView upright(const CameraView& view);

/// Switches between orthographic and perspective.
CameraView with_other_projection(const CameraView& view);

/// A side view: azimuth and elevation in degrees, upright.
CameraView from_side(const CameraView& view, float azimuth_deg, float elevation_deg);

}  // namespace brindle::tool
