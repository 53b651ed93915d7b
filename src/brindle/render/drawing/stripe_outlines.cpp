#include "brindle/stripe_outlines.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "brindle/error.h"
#include "brindle/render/drawing/drawing_size.h"
#include "brindle/render/drawing/region_tracer.h"
#include "brindle/render/drawing/seen_surfaces.h"
#include "brindle/render/drawing/smooth_path.h"

namespace brindle {
namespace {

// Together with the hundredths that files keep, a twentieth of a pixel.
constexpr double kTraceTolerance = 0.015;
constexpr double kFitTolerance = 0.03;

void check_entries(std::span<const StyledSurface> surfaces) {
  constexpr std::size_t kMostSurfaces = std::numeric_limits<std::uint16_t>::max() / 2 - 1;
  if (surfaces.empty()) throw Error("cannot draw outlines of no surface; add one");
  if (surfaces.size() > kMostSurfaces) throw Error("a drawing has at most 32766 surfaces");
  for (const StyledSurface& surface : surfaces) {
    const std::size_t count = surface.mesh.vertex_count();
    const auto check = [&](std::size_t size, const char* what, bool optional) {
      if (size == count || (optional && size == 0)) return;
      throw Error("the " + std::to_string(count) + " vertices of a drawing's surface have " +
                  std::to_string(size) + " " + what + "; give one per vertex");
    };
    check(surface.normals.size(), "normals", true);
    for (const Strokes& strokes : surface.strokes) {
      if (strokes.waves == nullptr) throw Error("strokes have no waves; give one per vertex");
      check(strokes.z.size(), "phases", false);
      check(strokes.widths.size(), "widths", true);
      check(strokes.opacities.size(), "opacities", true);
      check(strokes.color_places.size(), "places in the colour map", true);
    }
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

}  // namespace

std::vector<Pen> stripe_outlines(std::span<const StyledSurface> surfaces, const Camera& camera,
                                 UpAxis up, int width, int height, float least_area,
                                 const Progress& heard) {
  check_drawing_size(width, height);
  check_entries(surfaces);
  if (!(least_area >= 0)) throw Error("the least area of an outline is a number from 0 on");
  JobStages stages(heard, {{"outlines", 1}});
  const Progress progress = stages.begin("outlines");
  constexpr double kSorted = 0.05, kSeen = 0.5;
  const SeenSurfaces seen(surfaces, camera, up, width, height, progress.part(0, kSorted));
  const RegionTracer::CodeAt code_at = [&](double x, double y) { return seen.code_at(x, y); };
  const RegionTracer tracer(width, height, code_at, progress.part(kSorted, kSeen));
  std::vector<Pen> pens;
  for (std::size_t i = surfaces.size(); i-- > 0;) {
    const StyledSurface& surface = surfaces[i];
    const auto count = static_cast<double>(surfaces.size());
    const double begin = kSeen + (1 - kSeen) * static_cast<double>(surfaces.size() - 1 - i) / count;
    const double middle = begin + 0.5 * (1 - kSeen) / count;
    const std::string number = i == 0 ? "" : "_" + std::to_string(i);
    const auto plain = static_cast<std::uint16_t>(2 * i + 1);
    const auto stroke = static_cast<std::uint16_t>(2 * i + 2);
    const auto trace = [&](std::uint16_t first, const Progress& part) {
      return tracer.outlines(first, stroke, kTraceTolerance, part);
    };
    if (surface.between == BetweenStrokes::surface) {
      pens.push_back(pen_of("surface" + number, surface.color,
                            trace(plain, progress.part(begin, middle)), least_area));
    }
    if (surface.strokes.empty()) continue;
    pens.push_back(pen_of("stripes" + number, surface.strokes[0].color,
                          trace(stroke, progress.part(middle, begin + (1 - kSeen) / count)),
                          least_area));
  }
  stages.finish();
  return pens;
}

}  // namespace brindle
