/// Whether the plane that cuts a picture's surfaces open leaves anything to be seen. All that draws
/// asks here, so that no picture is empty without a word.
#pragma once

#include <span>
#include <string>

#include "brindle/camera.h"
#include "brindle/renderer.h"
#include "brindle/styled_picture.h"

namespace brindle {

/// Why a picture with this camera shows nothing of the mesh, or of its points if it has no
/// triangles: its slice takes all of it away. Empty where anything is left, and without a slice.
/// `name` is what users call the plane.
std::string slice_refusal(const Mesh& mesh, const Camera& camera,
                          const std::string& name = "slice");

/// The same of surfaces in styles, some of which slices may leave whole. The camera's coordinates
/// are relative to the first one's origin.
std::string slice_refusal(std::span<const StyledSurface> surfaces, const Camera& camera,
                          const std::string& name = "slice");

/// Throws Error if there is such a reason, so that no picture is written.
void check_slice(const std::string& refusal);

/// The same of a mesh that a picture shows alone.
void check_slice(const Mesh& mesh, const RenderOptions& render, const std::string& name = "slice");

}  // namespace brindle
