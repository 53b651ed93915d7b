#include "brindle/line_drawing.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/feature_lines.h"
#include "brindle/normals.h"
#include "brindle/shapes.h"
#include "brindle/surface.h"
#include "progress_reports.h"
#include "test_folder.h"

namespace brindle {
namespace {

constexpr CameraView kFromFront{.azimuth_deg = 0, .elevation_deg = 0};  // from +z

void add_line(Polylines& lines, std::initializer_list<Vec3> points) {
  for (const Vec3& p : points) {
    lines.points.push_back(p);
    lines.normals.emplace_back(0.0f, 0.0f, 1.0f);
  }
  lines.offsets.push_back(static_cast<Index>(lines.points.size()));
  lines.closed.push_back(0);
}

/// A square of side 2 around the z axis, facing it.
void add_square(Mesh& mesh, float half, float z) {
  const auto first = static_cast<Index>(mesh.positions.size());
  for (const auto& [x, y] : {std::pair{-half, -half}, {half, -half}, {half, half}, {-half, half}}) {
    mesh.positions.emplace_back(x, y, z);
  }
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
}

float length_of(const std::vector<Stroke>& strokes) {
  float length = 0;
  for (const Stroke& stroke : strokes) {
    for (std::size_t i = 1; i < stroke.size(); ++i) length += (stroke[i] - stroke[i - 1]).norm();
  }
  return length;
}

TEST(LineDrawing, WhatIsBehindIsHidden) {
  Mesh mesh;
  add_square(mesh, 1, -1);
  add_square(mesh, 0.4f, 1);
  Polylines lines;
  add_line(lines, {{-1, 0, -1}, {1, 0, -1}});      // on the back square: hidden in the middle
  add_line(lines, {{-0.4f, 0, 1}, {0.4f, 0, 1}});  // on the front square
  const Visibility visibility(mesh, kFromFront, 400, 300);
  const std::vector<Stroke> strokes = visibility.strokes(lines);
  ASSERT_EQ(strokes.size(), 3u);
  for (const Stroke& stroke : strokes) EXPECT_EQ(stroke.size(), 2u) << "straight";
  EXPECT_NEAR(strokes[0].back().x() + strokes[1].front().x(), 400, 2) << "symmetric";
  EXPECT_NEAR(strokes[2].front().x(), strokes[0].back().x(), 1.5) << "where the front one begins";
}

TEST(LineDrawing, OfALineOnTheFarSideIsNothing) {
  const Mesh sphere = make_shape("sphere,resolution=16");
  Polylines front, back;
  for (int i = 0; i < 20; ++i) {
    const float x = -0.8f + 0.08f * static_cast<float>(i);
    const float z = std::sqrt(1 - x * x);
    front.points.emplace_back(x, 0.0f, z);
    back.points.emplace_back(x, 0.0f, -z);
  }
  for (Polylines* lines : {&front, &back}) {
    lines->normals.assign(20, Vec3(0, 0, 1));
    lines->offsets.push_back(20);
    lines->closed.push_back(0);
  }
  const Visibility visibility(sphere, kFromFront, 300, 300);
  EXPECT_EQ(visibility.strokes(front).size(), 1u);
  EXPECT_TRUE(visibility.strokes(back).empty());
}

TEST(LineDrawing, TheOutlineOfASphereIsACircle) {
  const Mesh sphere = make_shape("sphere,resolution=24");
  const Polylines bounds = outline(sphere, vertex_normals(sphere), kFromFront, 300, 300);
  const Visibility visibility(sphere, kFromFront, 300, 300);
  const std::vector<Stroke> strokes = visibility.strokes(bounds, 0.02f);
  const float radius = 150 * 0.95f;
  EXPECT_NEAR(length_of(strokes), 2 * 3.14159f * radius, 0.1f * 2 * 3.14159f * radius);
  for (const Stroke& stroke : strokes) {
    for (const auto& p : stroke) {
      EXPECT_NEAR((p - Eigen::Vector2f(150, 150)).norm(), radius, 0.04f * radius);
    }
  }
}

TEST(LineDrawing, TheOutlineOfAnOpenSurfaceHasItsBoundary) {
  Mesh mesh;
  add_square(mesh, 1, 0);
  const Polylines bounds = outline(mesh, vertex_normals(mesh), kFromFront, 200, 200);
  ASSERT_EQ(bounds.count(), 1u) << "joined into one line";
  EXPECT_EQ(bounds.closed[0], 1);
  EXPECT_EQ(bounds.points.size(), 4u);
}

double length_of_all(const Polylines& lines) {
  double sum = 0;
  for (std::size_t line = 0; line < lines.count(); ++line) sum += length_of(lines, line);
  return sum;
}

/// A prism with a regular polygon as its base, whose triangles go from one base to the other.
Mesh prism(int sides, float height) {
  Mesh mesh;
  for (const float z : {0.0f, height}) {
    for (int i = 0; i < sides; ++i) {
      const double angle = 2 * std::numbers::pi * i / sides;
      mesh.positions.emplace_back(std::cos(angle), std::sin(angle), z);
    }
  }
  mesh.positions.emplace_back(0, 0, 0);
  mesh.positions.emplace_back(0, 0, height);
  const auto add = [&](int a, int b, int c) {
    mesh.triangles.push_back({static_cast<Index>(a), static_cast<Index>(b), static_cast<Index>(c)});
  };
  for (int i = 0; i < sides; ++i) {
    const int j = (i + 1) % sides;
    add(i, j, sides + j);
    add(i, sides + j, sides + i);
    add(2 * sides, j, i);
    add(2 * sides + 1, sides + i, sides + j);
  }
  return mesh;
}

CameraView view_along(float azimuth, float elevation) {
  CameraView view = kFromFront;
  view.azimuth_deg = azimuth;
  view.elevation_deg = elevation;
  return view;
}

TEST(LineDrawing, TheOutlineOfABoxRunsAlongItsEdges) {
  Mesh box = prism(4, std::sqrt(2.0f));
  const Polylines bounds = outline(box, vertex_normals(box), view_along(20, 30), 200, 200);
  ASSERT_EQ(bounds.count(), 1u);
  EXPECT_EQ(bounds.closed[0], 1);
  EXPECT_EQ(bounds.points.size(), 6u) << "a hexagon";
  EXPECT_NEAR(length_of_all(bounds), 6 * std::sqrt(2.0), 1e-5);
}

TEST(LineDrawing, TheOutlineOfACylinderIsSmoothBesideItsRims) {
  constexpr int kSides = 48;
  const Mesh mesh = prism(kSides, 3);
  const Polylines bounds = outline(mesh, vertex_normals(mesh), view_along(20, 30), 200, 200);
  ASSERT_EQ(bounds.count(), 1u);
  EXPECT_EQ(bounds.closed[0], 1);
  // Half of each rim, and two lines along the side: with corners, these would run aside.
  const double side = 2 * std::sin(std::numbers::pi / kSides);
  EXPECT_NEAR(length_of_all(bounds), 2 * 3 + kSides * side, 0.15);
}

TEST(LineDrawing, OutlinesDoNotDependOnHowTrianglesAreWound) {
  for (Mesh mesh : {prism(4, 1), prism(48, 3), make_shape("torus,resolution=30")}) {
    const std::vector<Vec3> normals = vertex_normals(mesh);
    const Polylines bounds = outline(mesh, normals, view_along(20, 30), 200, 200);
    for (std::size_t t = 0; t < mesh.triangle_count(); t += 3) {
      std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
    }
    const Polylines turned = outline(mesh, normals, view_along(20, 30), 200, 200);
    EXPECT_NEAR(length_of_all(turned), length_of_all(bounds), 1e-4);
    EXPECT_EQ(turned.points.size(), bounds.points.size());
  }
}

TEST(LineDrawing, WhatIsOutsideThePictureIsCutOff) {
  Mesh mesh;
  add_square(mesh, 1, 0);
  Polylines lines;
  add_line(lines, {{-1, 0, 0}, {1, 0, 0}});
  CameraView close = kFromFront;
  close.zoom = 4;
  const std::vector<Stroke> strokes = Visibility(mesh, close, 200, 200).strokes(lines);
  ASSERT_EQ(strokes.size(), 1u);
  EXPECT_NEAR(length_of(strokes), 200, 1.5);
}

TEST(LineDrawing, RefusesImpossibleSizes) {
  Mesh mesh;
  add_square(mesh, 1, 0);
  EXPECT_THROW(Visibility(mesh, kFromFront, 0, 100), Error);
  EXPECT_THROW(Visibility(mesh, kFromFront, 100, 10000), Error);
}

struct LineDrawingFile : TestFolder {};

TEST_F(LineDrawingFile, SvgHasAGroupPerPen) {
  const std::filesystem::path path = folder / "pens.svg";
  const std::vector<Pen> pens = {{"u", Color{1, 0, 0}, 1.5f, {{{0, 0}, {10, 20.126f}}}},
                                 {"outline", Color{}, 1, {}}};
  write_svg(path, 40, 30, pens);
  std::ifstream in(path);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  for (const char* part : {"width=\"40\" height=\"30\"",
                           "<g id=\"u\" fill=\"none\" stroke=\"#ff0000\"", "stroke-width=\"1.50\"",
                           "<path d=\"M0.00 0.00L10.00 20.13\"/>", "<g id=\"outline\"", "</svg>"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " in " << text;
  }
}

TEST(LineDrawing, CanBeCancelledAtEveryReport) {
  const Surface torus = make_surface(make_shape("torus,resolution=130"));
  const CameraView view;
  const Polylines bounds = outline(torus.mesh, torus.normals, view, 400, 300);
  const auto path = std::filesystem::path(testing::TempDir()) / "cancelled.svg";
  const std::vector<std::function<void(const Progress&)>> jobs = {
      [&](const Progress& p) { Visibility(torus.mesh, view, 800, 600, p); },
      [&](const Progress& p) { outline(torus.mesh, torus.normals, view, 400, 300, p); },
      [&](const Progress& p) { crease_lines(torus.mesh, torus.normals, 1, p); },
      [&](const Progress& p) {
        static const Visibility seen(torus.mesh, view, 400, 300);
        static const std::vector<Pen> pens(8'000, Pen{"p", {}, 1, seen.strokes(bounds)});
        write_svg(path, 400, 300, pens, p);
      }};
  for (std::size_t number = 0; number < jobs.size(); ++number) {
    testing_support::Reports all;
    jobs[number](all.progress());
    EXPECT_GE(all.count(), 3) << number;
    std::filesystem::remove(path);
    for (const int report : testing_support::reports_to_cancel(all.count(), 6)) {
      testing_support::Reports reports(report);
      EXPECT_THROW(jobs[number](reports.progress()), Cancelled) << number << " at " << report;
      EXPECT_FALSE(std::filesystem::exists(path));
    }
  }
}

}  // namespace
}  // namespace brindle
