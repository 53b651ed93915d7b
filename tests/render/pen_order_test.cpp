#include "brindle/render/drawing/pen_order.h"

#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/shapes.h"
#include "brindle/smooth_field.h"
#include "brindle/stripe_pattern.h"

namespace brindle {
namespace {

/// The length of ways between strokes, from the upper left corner on.
double travel(const std::vector<Stroke>& strokes) {
  double length = 0;
  Eigen::Vector2f pen = Eigen::Vector2f::Zero();
  for (const Stroke& stroke : strokes) {
    length += static_cast<double>((stroke.front() - pen).norm());
    pen = stroke.back();
  }
  return length;
}

/// The nearest end next, found among all.
double greedy_travel(std::vector<Stroke> left) {
  std::vector<Stroke> order;
  Eigen::Vector2f pen = Eigen::Vector2f::Zero();
  while (!left.empty()) {
    const auto distance = [&](const Stroke& stroke) {
      return std::min((stroke.front() - pen).norm(), (stroke.back() - pen).norm());
    };
    const auto next = std::ranges::min_element(left, {}, distance);
    if ((next->back() - pen).norm() < (next->front() - pen).norm()) std::ranges::reverse(*next);
    pen = next->back();
    order.push_back(*next);
    left.erase(next);
  }
  return travel(order);
}

/// Coordinates of strokes that all begin at the end that comes first by its coordinates, sorted.
std::vector<std::vector<float>> as_set(const std::vector<Stroke>& strokes) {
  std::vector<std::vector<float>> set;
  for (const Stroke& stroke : strokes) {
    std::vector<float> forwards, backwards;
    for (std::size_t i = 0; i < stroke.size(); ++i) {
      const Eigen::Vector2f &p = stroke[i], &q = stroke[stroke.size() - 1 - i];
      forwards.insert(forwards.end(), {p.x(), p.y()});
      backwards.insert(backwards.end(), {q.x(), q.y()});
    }
    set.push_back(std::min(forwards, backwards));
  }
  std::ranges::sort(set);
  return set;
}

void expect_ordered(const std::vector<Stroke>& strokes) {
  std::vector<Pen> pens = {{"pen", {}, 1, strokes}};
  order_strokes(pens);
  EXPECT_EQ(as_set(pens[0].strokes), as_set(strokes));
  EXPECT_LE(travel(pens[0].strokes), 1.15 * greedy_travel(strokes));
  EXPECT_LT(3 * travel(pens[0].strokes), travel(strokes)) << "they were in order before";
}

TEST(PenOrder, GoesOnAtTheNearestEndOfScatteredStrokes) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> place(0, 1000), size(-5, 5);
  std::vector<Stroke> strokes;
  for (int i = 0; i < 600; ++i) {
    const Eigen::Vector2f from(place(random), place(random));
    const Eigen::Vector2f middle = from + Eigen::Vector2f(size(random), size(random));
    strokes.push_back({from, middle, middle + Eigen::Vector2f(size(random), size(random))});
  }
  for (int i = 0; i < 20; ++i) strokes.push_back(strokes.front());  // ends at one place
  strokes.push_back({strokes.back().front()});                      // a dot
  expect_ordered(strokes);
}

TEST(PenOrder, GoesOnAtTheNearestEndInDrawings) {
  const Surface surface = make_surface(make_shape("vessels,resolution=40"));
  const StripePattern pattern = stripe_pattern(surface, smooth_direction_field(surface),
                                               60 / bounding_box(surface.mesh).diagonal());
  const StripeCurves curves = stripe_curves(surface, pattern);
  const std::vector<PenLines> lines = {{"u", {}, curves.lines}};
  const CameraView view;
  const std::vector<Pen> pens = line_drawing(surface.mesh, surface.normals, lines, view, 800, 600);
  ASSERT_EQ(pens.size(), 2u);
  for (const Pen& pen : pens) EXPECT_LE(travel(pen.strokes), 1.15 * greedy_travel(pen.strokes));
  const std::vector<Stroke> seen = Visibility(surface.mesh, view, 800, 600).strokes(curves.lines);
  EXPECT_EQ(as_set(pens[0].strokes), as_set(seen));
  EXPECT_GT(travel(seen), 2 * travel(pens[0].strokes));
}

TEST(PenOrder, LeavesFilledAreasAndNothingAlone) {
  const std::vector<Stroke> areas = {{{9, 9}, {9, 8}, {8, 8}}, {{1, 1}, {1, 2}, {2, 2}}};
  std::vector<Pen> pens = {{"none", {}, 1, {}}, {"area", {}, 1, areas, true}};
  order_strokes(pens);
  EXPECT_TRUE(pens[0].strokes.empty());
  EXPECT_EQ(pens[1].strokes, areas);
}

}  // namespace
}  // namespace brindle
