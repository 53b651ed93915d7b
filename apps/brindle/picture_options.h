/// What the picture options hold, for builds with OpenGL.
#pragma once

#include <optional>
#include <span>

#include "brindle/quality.h"
#include "brindle/renderer.h"
#include "picture.h"

namespace brindle::tool {

enum class View { stripes, branches, angle_error };

struct PictureOptions {
  View view = View::stripes;
  std::optional<UpAxis> up;  // the user's choice
  RenderOptions render;
};

/// What the view shows on top of the stripes.
Overlay overlay_of(View view, const Mesh& mesh, const WaveSet& waves,
                   std::span<const CornerPhases> corners);

/// How the renderer draws what the user asked for.
RenderOptions render_options(const PictureOptions& options);

}  // namespace brindle::tool
