#include "pictures/ornaments.h"

#include <algorithm>

#include "brindle/line_drawing.h"
#include "brindle/mesh.h"
#include "brindle/normals.h"
#include "brindle/render/slice_refusal.h"
#include "pictures/drawing_file.h"
#include "pictures/picture.h"

namespace brindle::tool {
namespace {

void add(const Mesh& part, std::span<const Vec3> normals, const TriangleColor& color,
         OrnamentedSurface& all) {
  append(part, all.mesh);
  all.normals.insert(all.normals.end(), normals.begin(), normals.end());
  all.colors.resize(all.mesh.triangles.size(), color);
}

}  // namespace

Color ornament_color(bool second, const RenderOptions& render) {
  constexpr Color kSecondColor{0.78f, 0.26f, 0.17f};
  return second ? kSecondColor : render.stripe_color;
}

SurfaceDrawing OrnamentedSurface::drawing() const {
  return {.mesh = mesh, .normals = normals, .triangle_colors = colors};
}

OrnamentedSurface ornamented(const Surface& surface, std::span<const Ornament> ornaments,
                             const RenderOptions& render) {
  OrnamentedSurface all;
  add(surface.mesh, surface.normals, {}, all);
  for (const Ornament& ornament : ornaments) {
    add(ornament.mesh, vertex_normals(ornament.mesh), {ornament_color(ornament.second, render), 1},
        all);
  }
  return all;
}

void write_ornaments(const std::filesystem::path& path, const Surface& surface,
                     std::span<const Ornament> ornaments, const PictureOptions& options,
                     const Progress& progress) {
  const RenderOptions render = render_options(options, surface.mesh.origin);
  const OrnamentedSurface all = ornamented(surface, ornaments, render);
  check_slice(all.mesh, render, "--slice");
  const Image image = render_picture(all.drawing(), render, progress.part(0, kDrawn));
  write_png(path, image, progress.part(kDrawn, 1), options.dpi);
}

void write_line_drawing(const std::filesystem::path& path, const Surface& surface,
                        std::span<const FamilyLines> families, const PictureOptions& options,
                        const Progress& progress) {
  const RenderOptions render = render_options(options, surface.mesh.origin);
  check_slice(surface.mesh, render, "--slice");
  std::vector<PenLines> lines;
  for (const FamilyLines& family : families) {
    lines.push_back({family.name, ornament_color(family.second, render), family.lines});
  }
  const int width = render.width, height = render.height;
  const std::vector<Pen> pens = line_drawing(surface.mesh, surface.normals, lines, render.camera,
                                             width, height, progress.part(0, 0.8));
  write_drawing(path, width, height, pens, options.paper, progress.part(0.8, 1));
}

}  // namespace brindle::tool
