#include "pictures/ornaments.h"

#include <algorithm>

#include "brindle/geometry/append_mesh.h"
#include "brindle/geometry/normals.h"
#include "brindle/line_drawing.h"
#include "pictures/picture_options.h"

namespace brindle::tool {
namespace {

constexpr Color kSecondColor{0.78f, 0.26f, 0.17f};
// The outline runs along edges, beside the smooth outline that the depths have.
constexpr float kOutlineTolerance = 0.01f;
constexpr Color kOutlineColor{0.25f, 0.25f, 0.27f};

Color color_of(bool second, const RenderOptions& render) {
  return second ? kSecondColor : render.stripe_color;
}

void add(const Mesh& part, std::span<const Vec3> normals, const TriangleColor& color,
         OrnamentedSurface& all) {
  append(part, all.mesh);
  all.normals.insert(all.normals.end(), normals.begin(), normals.end());
  all.colors.resize(all.mesh.triangles.size(), color);
}

}  // namespace

SurfaceDrawing OrnamentedSurface::drawing() const {
  return {.mesh = mesh, .normals = normals, .triangle_colors = colors};
}

OrnamentedSurface ornamented(const Surface& surface, std::span<const Ornament> ornaments,
                             const RenderOptions& render) {
  OrnamentedSurface all;
  add(surface.mesh, surface.normals, {}, all);
  for (const Ornament& ornament : ornaments) {
    add(ornament.mesh, vertex_normals(ornament.mesh), {color_of(ornament.second, render), 1}, all);
  }
  return all;
}

void write_ornaments(const std::filesystem::path& path, const Surface& surface,
                     std::span<const Ornament> ornaments, const PictureOptions& options) {
  const RenderOptions render = render_options(options);
  const OrnamentedSurface all = ornamented(surface, ornaments, render);
  write_png(path, render_picture(all.drawing(), render));
}

void write_line_drawing(const std::filesystem::path& path, const Surface& surface,
                        std::span<const PenLines> pens, const PictureOptions& options) {
  const RenderOptions render = render_options(options);
  const Visibility visibility(surface.mesh, render.camera, render.width, render.height);
  std::vector<Pen> drawn;
  for (const PenLines& pen : pens) {
    drawn.push_back({pen.name, color_of(pen.second, render), 1.0f, visibility.strokes(pen.lines)});
  }
  const Polylines bounds =
      outline(surface.mesh, surface.normals, render.camera, render.width, render.height);
  drawn.push_back({"outline", kOutlineColor, 1.4f, visibility.strokes(bounds, kOutlineTolerance)});
  write_svg(path, render.width, render.height, drawn);
}

}  // namespace brindle::tool
