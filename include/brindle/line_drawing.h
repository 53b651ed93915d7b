/// Drawings of lines on a surface, hidden lines removed, for plotters and print.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brindle/camera.h"
#include "brindle/export.h"
#include "brindle/image.h"
#include "brindle/mesh.h"
#include "brindle/polylines.h"
#include "brindle/progress.h"

namespace brindle {
class Reporter;
}

namespace BRINDLE_EXPORT brindle {

/// A stroke of the pen: x to the right and y downwards, in pixels from the upper left corner.
using Stroke = std::vector<Eigen::Vector2f>;

/// The visible parts of a surface from one side, at every half pixel, found without OpenGL. Parts
/// that the slice of the view or the camera removes hide nothing, and lines there have no strokes,
/// not even hidden ones.
class Visibility {
 public:
  /// A picture of `width` x `height` pixels from `view`, in which the mesh is framed. Throws Error
  /// if a side is not in 1 .. 8192, and Cancelled if `progress` cancels.
  Visibility(const Mesh& mesh, const CameraView& view, int width, int height,
             const Progress& progress = {});
  /// As above with a given camera. `mesh` contains everything that can hide lines.
  Visibility(const Mesh& mesh, const Camera& camera, int width, int height,
             const Progress& progress = {});

  /// The visible parts of lines on the surface, in the order of the lines; with `hidden`, the
  /// hidden parts. Points that change a stroke by less than a twentieth of a pixel are left out.
  /// Lines behind the surface by less than `tolerance` times their distance count as on it.
  std::vector<Stroke> strokes(const Polylines& lines, float tolerance = 1e-4f, bool hidden = false,
                              const Progress& progress = {}) const;

 private:
  struct Seen {
    Eigen::Vector2f pixel;
    float distance;  ///< along the viewing direction
    float beyond;    ///< from the camera's slice; above 0: removed
  };
  Seen project(const Vec3& point) const;
  float nearness(std::span<const Seen> seen, std::span<const float> weights) const;
  float beyond(std::span<const Seen> seen, std::span<const float> weights) const;
  struct Cells;
  void draw(const Mesh& mesh, const Progress& progress);
  Cells cells_of(const std::array<Seen, 3>& corners) const;
  void draw_triangle(const std::array<Seen, 3>& corners, Reporter& reporter);
  bool visible(const Seen& seen, float tolerance) const;
  void add_strokes(std::span<const Seen> path, float tolerance, bool hidden,
                   std::vector<Stroke>& strokes) const;
  bool in_picture(const Seen& seen) const;

  Camera camera_;
  int width_;
  int height_;
  int columns_;  // of half pixels
  int rows_;
  std::vector<float> nearness_;  // 1 / distance of the nearest surface; 0 where there is none
};

/// Outlines of a surface: silhouettes, which are smooth because normals are linear within
/// triangles; edges that bend by more than 40 degrees; and borders. `normals` has one unit normal
/// per vertex. Throws Cancelled if `progress` cancels.
Polylines outline(const Mesh& mesh, std::span<const Vec3> normals, const CameraView& view,
                  int width, int height, const Progress& progress = {});

/// Strokes of one pen.
struct Pen {
  std::string name;  ///< letters, digits and underscores
  Color color;
  float width = 1;  ///< pixels
  std::vector<Stroke> strokes;
  bool filled = false;  ///< strokes are closed and bound an area; inner ones are its holes
  /// Strokes are smooth: a point, then two control points and the end of each cubic Bézier.
  bool curved = false;
};

/// Lines to draw with one pen.
struct PenLines {
  std::string name;  ///< letters, digits and underscores
  Color color;
  const Polylines& lines;
};

/// A pen for each of `drawn`, with the visible parts of its lines from `view`, and one named
/// "outline", wider and grey, with the surface's outline. Pens travel little between their strokes.
/// Throws what Visibility does, and Cancelled if `progress` cancels.
std::vector<Pen> line_drawing(const Mesh& mesh, std::span<const Vec3> normals,
                              std::span<const PenLines> drawn, const CameraView& view, int width,
                              int height, const Progress& progress = {});

/// Pixels of a drawing in an inch, as in browsers.
inline constexpr double kDrawingDpi = 96;
inline constexpr double kMillimetresPerInch = 25.4;

/// A page in millimetres.
struct PaperSize {
  double width = 0;
  double height = 0;
};

/// Writes one group per pen: a path per stroke, or one path for a filled pen; no background. With
/// `paper`, the page has exactly that size, else `width` x `height` pixels. Throws what write_file
/// does, and Cancelled if `progress` cancels.
void write_svg(const std::filesystem::path& path, int width, int height, std::span<const Pen> pens,
               const Progress& progress = {}, const std::optional<PaperSize>& paper = {});

}  // namespace brindle
