/// Rejects slices that cut everything away, so that no picture is empty without an error.
#pragma once

#include <span>
#include <string>

#include "brindle/camera.h"
#include "brindle/renderer.h"
#include "brindle/styled_picture.h"

namespace brindle {

/// The reason why a picture with this camera shows nothing of the mesh (of its points if it has no
/// triangles): the slice cuts all of it away. Empty if anything remains. `name`: the user's name
/// for the plane.
std::string slice_refusal(const Mesh& mesh, const Camera& camera,
                          const std::string& name = "slice");

/// The same for styled surfaces, some of which ignore slices. The camera is relative to the origin
/// of the first one.
std::string slice_refusal(std::span<const StyledSurface> surfaces, const Camera& camera,
                          const std::string& name = "slice");

/// Throws Error if the text is not empty.
void check_slice(const std::string& refusal);

/// The same for a picture of one mesh.
void check_slice(const Mesh& mesh, const RenderOptions& render, const std::string& name = "slice");

}  // namespace brindle
