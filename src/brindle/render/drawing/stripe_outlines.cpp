#include "brindle/stripe_outlines.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "brindle/base/parallel.h"
#include "brindle/error.h"
#include "brindle/render/drawing/pen_order.h"
#include "brindle/render/drawing/region_tracer.h"
#include "brindle/render/drawing/seen_surfaces.h"
#include "brindle/render/style_checks.h"

namespace brindle {
namespace {

// With the hundredths that files keep: a twentieth of a pixel in all.
constexpr double kTraceTolerance = 0.015;
constexpr double kFitTolerance = 0.03;

void check_drawn_texture(const RegionTexture& texture, const Mesh& mesh) {
  if (texture.waves->triangle_count() != mesh.triangle_count()) {
    throw Error("the texture of a drawing's surface has waves of " +
                std::to_string(texture.waves->triangle_count()) + " triangles, not of its " +
                std::to_string(mesh.triangle_count()));
  }
  for (const RegionTile& tile : texture.tiles) {
    if (std::holds_alternative<BuiltInTile>(tile.tile)) continue;
    throw Error(
        "a drawing has outlines of motifs, and a tile is a picture of pixels; take a "
        "built-in tile, or write .png");
  }
}

void check_surfaces(std::span<const StyledSurface> surfaces) {
  if (surfaces.empty()) throw Error("cannot draw outlines of no surface; add one");
  for (const StyledSurface& surface : surfaces) {
    check_style(surface);
    if (surface.texture) check_drawn_texture(*surface.texture, surface.mesh);
  }
  if (first_codes(surfaces).back() > std::numeric_limits<std::uint16_t>::max()) {
    throw Error("a drawing has at most 65,534 surfaces, strokes and tiles");
  }
}

double area_of(const OutlineLoop& loop) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Eigen::Vector2d& a = loop[i];
    const Eigen::Vector2d& b = loop[i + 1 < loop.size() ? i + 1 : 0];
    sum += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * std::abs(sum);
}

Pen pen_of(std::string name, const Color& color, const std::vector<OutlineLoop>& loops,
           double least_area) {
  Pen pen{std::move(name), color, 1, {}, true, true};
  for (const OutlineLoop& loop : loops) {
    if (area_of(loop) < least_area) continue;
    Stroke path = smooth_closed_path(loop, kFitTolerance);
    if (!path.empty()) pen.strokes.push_back(std::move(path));
  }
  return pen;
}

/// A pen, and the codes that it fills.
struct PenRegion {
  std::string name;
  Color color;
  CodeRange codes;
};

/// The pens of surface `number`: its own, then those of its marks.
void add_pens(const StyledSurface& surface, std::size_t number, std::size_t first_code,
              std::vector<PenRegion>& pens) {
  const std::string suffix = number == 0 ? "" : "_" + std::to_string(number);
  const auto codes = [&](std::size_t first, std::size_t last) {
    return CodeRange{static_cast<std::uint16_t>(first_code + first),
                     static_cast<std::uint16_t>(first_code + last)};
  };
  if (surface.between == BetweenStrokes::surface) {
    pens.push_back({"surface" + suffix, surface.color, codes(0, mark_count(surface))});
  }
  for (std::size_t mark = 1; mark <= mark_count(surface); ++mark) {
    if (surface.texture) {
      const std::string name = "tiles" + (mark == 1 ? "" : std::to_string(mark)) + suffix;
      pens.push_back({name, surface.texture->tiles[mark - 1].color, codes(mark, mark)});
    } else {
      pens.push_back({"stripes" + suffix, surface.strokes[0].color, codes(mark, mark)});
    }
  }
}

}  // namespace

std::vector<Pen> stripe_outlines(std::span<const StyledSurface> surfaces, const Camera& camera,
                                 const PictureLight& light, int width, int height, float least_area,
                                 const Progress& heard) {
  check_drawing_size(width, height);
  check_surfaces(surfaces);
  if (!(least_area >= 0)) throw Error("the least area of an outline is a number from 0 on");
  JobStages stages(heard, {{"outlines", 1}});
  const Progress progress = stages.begin("outlines");
  constexpr double kSorted = 0.05, kTraced = 0.9;
  const CodeAt code_at =
      seen_codes(surfaces, camera, light, width, height, progress.part(0, kSorted));
  const std::vector<std::size_t> codes = first_codes(surfaces);
  std::vector<PenRegion> regions;
  for (std::size_t i = surfaces.size(); i-- > 0;) add_pens(surfaces[i], i, codes[i], regions);
  std::vector<CodeRange> ranges;
  for (const PenRegion& region : regions) ranges.push_back(region.codes);
  const auto outlines = region_outlines(width, height, code_at, ranges, kTraceTolerance,
                                        progress.part(kSorted, kTraced));
  std::vector<Pen> pens;
  reported_for(
      regions.size(), progress.part(kTraced, 1),
      [&](std::size_t i) {
        pens.push_back(pen_of(regions[i].name, regions[i].color, outlines[i],
                              static_cast<double>(least_area)));
      },
      1);
  stages.finish();
  return pens;
}

}  // namespace brindle
