#include "brindle/render/drawing/pen_order.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include "brindle/paths/path_order.h"

namespace brindle {
namespace {

std::vector<Stroke> ordered(std::vector<Stroke> strokes, const Progress& progress) {
  Polylines ends;
  for (const Stroke& stroke : strokes) {
    for (const Eigen::Vector2f& end : {stroke.front(), stroke.back()}) {
      ends.add({end.x(), end.y(), 0}, Vec3::UnitZ());
    }
    ends.end_line(false);
  }
  std::vector<Index> all(strokes.size());
  std::iota(all.begin(), all.end(), Index{0});
  const Vec3 corner = Vec3::Zero();
  std::vector<PlacedLine> order = nearest_order(ends, all, corner, {}, progress.part(0, 0.2));
  shorten_travel(ends, order, corner, progress.part(0.2, 1));
  std::vector<Stroke> result;
  for (const PlacedLine& placed : order) {
    Stroke& stroke = result.emplace_back(std::move(strokes[placed.line]));
    if (placed.reversed) std::reverse(stroke.begin(), stroke.end());
  }
  return result;
}

}  // namespace

void order_strokes(std::span<Pen> pens, const Progress& progress) {
  const auto count = static_cast<double>(pens.size());
  for (std::size_t i = 0; i < pens.size(); ++i) {
    const auto done = static_cast<double>(i);
    if (pens[i].filled) continue;
    pens[i].strokes =
        ordered(std::move(pens[i].strokes), progress.part(done / count, (done + 1) / count));
  }
}

}  // namespace brindle
