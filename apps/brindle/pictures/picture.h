/// Pictures of patterns.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "brindle/line_drawing.h"
#include "brindle/polylines.h"
#include "brindle/progress.h"
#include "brindle/quality.h"
#include "brindle/renderer.h"
#include "brindle/splats.h"
#include "brindle/surface.h"
#include "input/vertex_values.h"
#include "pictures/stripe_result.h"

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

/// The share of drawing in the time to draw and write a picture.
inline constexpr double kDrawn = 0.7;

void add_picture_options(CLI::App& app, PictureOptions& options);

/// The same without options of stripes: --view and --stripe-width.
void add_camera_options(CLI::App& app, PictureOptions& options);

/// --scale and --dpi, and --size in millimetres.
void add_paper_options(CLI::App& app, PictureOptions& options);

/// --size and --quality alone, for pixels.
void add_size_options(CLI::App& app, PictureOptions& options);

/// Lets the axis point up that `usual_up_axis` gives, unless the user says otherwise.
void stand_upright(PictureOptions& options, const std::string& mesh);

/// The viewpoint of pictures, without a slice, for patterns, which belong to the whole surface.
std::optional<Viewpoint> viewpoint_of(const PictureOptions& options);

/// The same with its slice, which shows inner sides.
Viewpoint seen_viewpoint_of(const PictureOptions& options);

/// Whether pictures show stripes without an overlay.
bool shows_stripes(const PictureOptions& options);

/// What reports say of pictures: their quality and the axis that points up.
nlohmann::ordered_json picture_json(const PictureOptions& options);

/// A single-coloured mesh on a surface: tubes along curves, discs at samples.
struct Ornament {
  Mesh mesh;
  bool second = false;  ///< in the colour of the second pattern
};

/// Throws Error without an OpenGL context or if the file cannot be written; throws Cancelled.
void write_ornaments(const std::filesystem::path& path, const Surface& surface,
                     std::span<const Ornament> ornaments, const PictureOptions& options,
                     const Progress& progress);

/// The lines of one pattern.
struct FamilyLines {
  std::string name;
  const Polylines& lines;
  bool second = false;  ///< in the colour of the second pattern
};

/// Draws visible lines and the surface's outline from the picture's camera as SVG. Throws Error if
/// the picture is too large or the file cannot be written; throws Cancelled.
void write_line_drawing(const std::filesystem::path& path, const Surface& surface,
                        std::span<const FamilyLines> families, const PictureOptions& options,
                        const Progress& progress);

/// Throws Error without an OpenGL context or if the file cannot be written; throws Cancelled.
void write_picture(const std::filesystem::path& path, const Surface& surface,
                   const StripeResult& result, const PictureOptions& options,
                   const Progress& progress);

/// The texture's tile as a PNG file, in the picture's colours.
std::string tile_png(const TextureTile& tile, const PictureOptions& options);

}  // namespace brindle::tool
