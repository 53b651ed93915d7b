#include "brindle/render/drawing/simplified_stroke.h"

#include "brindle/polylines.h"

namespace brindle {

Stroke simplified_stroke(const Stroke& stroke, bool closed, float tolerance) {
  Polylines line;
  for (const auto& p : stroke) {
    line.points.emplace_back(p.x(), p.y(), 0.0f);
    line.normals.emplace_back(0.0f, 0.0f, 1.0f);
  }
  line.offsets.push_back(static_cast<Index>(stroke.size()));
  line.closed.push_back(closed);
  Stroke result;
  for (const Vec3& p : simplified(line, tolerance).points) result.emplace_back(p.x(), p.y());
  return result;
}

}  // namespace brindle
