#include "scenes/brush_stroke.h"

#include <cmath>

#include <gtest/gtest.h>

#include "brindle/shapes.h"

namespace brindle {
namespace {

Surface torus() { return make_surface(make_shape("torus,resolution=48")); }

TEST(BrushStroke, RunsFromOneEndOfTheSurfaceToTheFarthest) {
  const Surface surface = torus();
  const BoundingBox box = bounding_box(surface.mesh);
  const BrushStroke stroke = make_brush_stroke(surface, 0.04f * box.diagonal(), 1);
  EXPECT_GT(stroke.length, 0.5f * (box.upper - box.lower).maxCoeff());
  EXPECT_EQ(stroke.path_arc.front(), 0);
  EXPECT_EQ(stroke.path_arc.back(), stroke.length);
  EXPECT_EQ(brush_tip(stroke, 0), stroke.path.front());
  EXPECT_EQ(brush_tip(stroke, 2 * stroke.length), stroke.path.back());
  EXPECT_LT((brush_tip(stroke, 0.5f * stroke.length) - stroke.path[stroke.path.size() / 2]).norm(),
            0.1f * stroke.length);
}

TEST(BrushStroke, AnchorsLieAcrossThePathAndNearIt) {
  const Surface surface = torus();
  const float radius = 0.04f * bounding_box(surface.mesh).diagonal();
  const BrushStroke stroke = make_brush_stroke(surface, radius, 3);
  ASSERT_GT(stroke.anchor.size(), stroke.path.size());
  for (std::size_t k = 0; k < stroke.anchor.size(); ++k) {
    const FieldAnchor& a = stroke.anchor[k];
    EXPECT_LE(a.weight, 3);
    EXPECT_GE(a.weight, 0);
    EXPECT_NEAR(a.direction.norm(), 1, 1e-5);
    const float arc = stroke.anchor_arc[k];
    const Vec3 along =
        brush_tip(stroke, arc + 0.5f * radius) - brush_tip(stroke, arc - 0.5f * radius);
    EXPECT_LT(std::abs(a.direction.dot(along.normalized())), 0.5f);
    EXPECT_LT((surface.mesh.positions[a.vertex] - brush_tip(stroke, arc)).norm(), 2 * radius);
  }
}

TEST(BrushStroke, AnchorsGrowWithTheArcAndNeverShrink) {
  const Surface surface = torus();
  const BrushStroke stroke =
      make_brush_stroke(surface, 0.04f * bounding_box(surface.mesh).diagonal(), 1);
  std::vector<FieldAnchor> anchors;
  anchors_up_to(stroke, 0, anchors);
  EXPECT_TRUE(anchors.empty());
  float last = 0;
  for (int step = 1; step <= 10; ++step) {
    anchors_up_to(stroke, 0.1f * static_cast<float>(step) * (stroke.length + stroke.radius),
                  anchors);
    float sum = 0;
    for (const FieldAnchor& a : anchors) sum += a.weight;
    EXPECT_GT(sum, last);
    last = sum;
  }
  EXPECT_EQ(anchors.size(), stroke.anchor.size());
}

TEST(BrushStroke, OfASurfaceWithoutTrianglesIsEmpty) {
  const BrushStroke stroke = make_brush_stroke(make_surface({{Vec3(1, 2, 3)}, {}}), 1, 1);
  EXPECT_TRUE(stroke.path.empty());
  EXPECT_TRUE(stroke.anchor.empty());
}

}  // namespace
}  // namespace brindle
