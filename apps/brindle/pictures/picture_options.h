/// The fields of picture options, for builds with OpenGL.
#pragma once

#include <optional>
#include <span>

#include "brindle/line_drawing.h"
#include "brindle/quality.h"
#include "brindle/renderer.h"
#include "brindle/splats.h"
#include "pictures/picture.h"

namespace brindle::tool {

enum class View { stripes, branches, angle_error };

struct PictureOptions {
  View view = View::stripes;
  std::optional<UpAxis> up;  // the user's choice
  std::optional<Projection> projection;
  std::optional<Slice> slice;      // in the coordinates of the mesh's file
  RenderOptions render;            // pixels unless `paper`
  std::optional<PaperSize> paper;  // --size in millimetres
  std::optional<float> scale;      // millimetres on paper for each unit of length
  double dpi = 0;                  // pixels per inch of .png; 0: not given

  /// Calls `add("--option", field)` for options of stripes.
  template <class Add>
  void visit_stripes(const Add& add) {
    add("--view", view);
    add("--stripe-width", render.stripe_width);
  }
};

/// The end of the colour scale of angle errors.
inline constexpr float kLargestAngleErrorDeg = 30;

/// The overlay of the view.
Overlay overlay_of(View view, const Mesh& mesh, const WaveSet& waves,
                   std::span<const CornerPhases> corners);

/// The picture's content, by reference.
SurfaceDrawing drawing_of(const Surface& surface, const StripeResult& result,
                          const Overlay& overlay);
SplatDrawing splat_drawing_of(const Surface& surface, const StripePattern& pattern,
                              std::span<const float> radii);

/// The renderer's options, for surfaces relative to `origin` (`Mesh::origin` of the first one).
RenderOptions render_options(const PictureOptions& options, const Eigen::Vector3d& origin);

}  // namespace brindle::tool
