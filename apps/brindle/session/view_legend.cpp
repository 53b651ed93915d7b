#include "session/view_legend.h"

#include "brindle/base/text.h"
#include "pictures/ornaments.h"
#include "pictures/picture.h"

namespace brindle::tool {
namespace {

constexpr int kScaleSteps = 32;

/// As in the library's overlay.
Color color_of(TriangleKind kind) {
  Mesh mesh;
  mesh.positions.resize(3);
  mesh.triangles = {{0, 1, 2}};
  CornerPhases corners;
  corners.kind = kind;
  return branch_overlay(mesh, {&corners, 1}).marks.front().color;
}

ViewLegend branch_legend() {
  ViewLegend legend;
  legend.entries = {{color_of(TriangleKind::branch), "a stripe begins or ends"},
                    {color_of(TriangleKind::field_singularity), "singularity of the field"}};
  return legend;
}

ViewLegend error_legend() {
  ViewLegend legend{"angle between stripes and field", {}, {}, "0", ""};
  for (int i = 0; i < kScaleSteps; ++i) {
    legend.scale.push_back(error_color((static_cast<float>(i) + 0.5f) / kScaleSteps));
  }
  legend.highest = formatted("%g degrees or more", static_cast<double>(kLargestAngleErrorDeg));
  return legend;
}

ViewLegend curves_legend(const ShownCurves& curves, const PictureOptions& picture) {
  ViewLegend legend;
  if (curves.families.size() < 2) return legend;
  for (const CurveFamily& family : curves.families) {
    legend.entries.push_back(
        {ornament_color(family.name == "v", picture.render), "curves of " + family.name});
  }
  return legend;
}

}  // namespace

ViewLegend view_legend(const LiveState& state) {
  const PictureOptions& picture = state.parsed->arguments().picture;
  if (state.curves) return curves_legend(*state.curves, picture);
  if (ornaments_of(state) != nullptr) return {};
  switch (picture.view) {
    case View::stripes:
      return {};
    case View::branches:
      return branch_legend();
    case View::angle_error:
      return error_legend();
  }
  return {};
}

}  // namespace brindle::tool
