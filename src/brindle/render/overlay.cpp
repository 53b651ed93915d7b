#include "brindle/renderer.h"

namespace brindle {
namespace {

constexpr Color kBranchColor{0.84f, 0.15f, 0.16f};
constexpr Color kSingularityColor{0.95f, 0.62f, 0.07f};

Vec3 centre_of(const Mesh& mesh, const Triangle& triangle) {
  const Vec3& first = mesh.positions[triangle[0]];
  return first +
         ((mesh.positions[triangle[1]] - first) + (mesh.positions[triangle[2]] - first)) / 3;
}

}  // namespace

Overlay branch_overlay(const Mesh& mesh, std::span<const CornerPhases> corners) {
  Overlay overlay;
  overlay.triangle_colors.resize(mesh.triangle_count());
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const TriangleKind kind = corners[t].kind;
    if (!is_branch(kind)) continue;
    const Color color = kind == TriangleKind::branch ? kBranchColor : kSingularityColor;
    overlay.triangle_colors[t] = {color, 0.85f};
    overlay.marks.push_back({centre_of(mesh, mesh.triangles[t]), color});
  }
  return overlay;
}

Overlay error_overlay(std::span<const float> values, float largest) {
  Overlay overlay;
  overlay.triangle_colors.reserve(values.size());
  for (const float value : values) {
    overlay.triangle_colors.push_back(value >= 0 ? TriangleColor{error_color(value / largest), 1}
                                                 : TriangleColor{});
  }
  return overlay;
}

}  // namespace brindle
