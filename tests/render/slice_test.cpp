#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/feature_lines.h"
#include "brindle/line_drawing.h"
#include "brindle/render/parsed_words.h"
#include "brindle/render/surfaces/shading.h"
#include "brindle/shapes.h"
#include "brindle/splats.h"
#include "brindle/stripe_outlines.h"
#include "brindle/styled_picture.h"
#include "brindle/surface.h"
#include "render/test_drawings.h"

namespace brindle {
namespace {

using namespace test;

RenderOptions sliced_by(const char* text, RenderOptions options = plain_options()) {
  options.camera.slice = parse_slice(text);
  EXPECT_TRUE(options.camera.slice) << text;
  return options;
}

Image draw_styled(const StyledSurface& surface, const RenderOptions& render) {
  const HeadlessContext& context = Studio::shared().context;
  static StyledRenderer renderer;
  renderer.upload({&surface, 1});
  StyledOptions options;
  options.render = render;
  Image image = renderer.draw(options);
  context.check_errors("drawing the test picture");
  return image;
}

/// The sum of all coverage in pixels.
double covered(const Image& image) {
  double sum = 0;
  for (const Pixel& pixel : image.pixels) sum += pixel.alpha / 255.0;
  return sum;
}

TEST(Slice, IsReadFromWords) {
  EXPECT_EQ(parse_slice("x=0.25"), (Slice{{0.25, 0, 0}, {1, 0, 0}, false}));
  EXPECT_EQ(parse_slice("-y=-2"), (Slice{{0, -2, 0}, {0, -1, 0}, false}));
  EXPECT_EQ(parse_slice("z=50%"), (Slice{{0, 0, 0.5}, {0, 0, 1}, true}));
  EXPECT_EQ(parse_slice("1,2,3,0,0,-4"), (Slice{{1, 2, 3}, {0, 0, -4}, false}));
  // Coordinates of files have more digits than a float.
  EXPECT_EQ(parse_slice("x=2600000.2"), (Slice{{2600000.2, 0, 0}, {1, 0, 0}, false}));
  EXPECT_EQ(parse_slice("2600000.2,0,0,1,0,0"), parse_slice("x=2600000.2"));
  for (const char* text : {"", "x", "x=", "=1", "x=1,2", "w=1", "xy=1", "--x=1", "x=%", "x=nan",
                           "1,2,3", "1,2,3,0,0,0", "1,2,3,0,0,1,2", "0.5", "50%", "x=1=2"}) {
    EXPECT_FALSE(parse_slice(text)) << text;
  }
}

TEST(Slice, LeavesTheCameraWhereItIs) {
  const std::vector<Vec3> points = {{-1, 0, 0}, {3, 2, 0}, {0, 1, 5}};
  CameraView view;
  const Camera whole = framed_camera(points, view, 200, 100);
  EXPECT_FALSE(whole.cuts_off({100, 0, 0}));
  view.slice = parse_slice("x=25%");
  const Camera shares = framed_camera(points, view, 200, 100);
  view.slice = parse_slice("x=0");
  const Camera units = framed_camera(points, view, 200, 100);
  for (const Camera& camera : {shares, units}) {
    EXPECT_EQ(camera.view_from_world, whole.view_from_world);
    EXPECT_EQ(camera.clip_from_view, whole.clip_from_view);
    EXPECT_TRUE(camera.cuts_off({0.001f, -7, 3}));
    EXPECT_FALSE(camera.cuts_off({-0.001f, 7, 3}));
  }
}

TEST(Slice, NeedsAPointAndANormal) {
  const StripedSurface plate = plane_wave(square(1), Vec3::UnitX(), 2);
  for (const Slice& slice : {Slice{{0, 0, 0}, {0, 0, 0}}, Slice{{NAN, 0, 0}, {0, 0, 1}},
                             Slice{{0, 0, 0}, {0, INFINITY, 1}}}) {
    RenderOptions options = plain_options();
    options.camera.slice = slice;
    EXPECT_THROW(Studio::shared().draw(plate.drawing(), options), Error);
  }
}

/// A plate's right half is away, and its left half is what it was, but for so many pixels.
void expect_left_half(const Image& whole, const Image& half, int rounded = 0) {
  const int middle = whole.width / 2;
  int same = 0;
  for (int y = 0; y < whole.height; ++y) {
    for (int x = 0; x < middle - 1; ++x) same += half.at(x, y) == whole.at(x, y);
    for (int x = middle + 1; x < whole.width; ++x) ASSERT_EQ(half.at(x, y).alpha, 0) << x;
  }
  EXPECT_GE(same, (middle - 1) * whole.height - rounded);
  EXPECT_NEAR(covered(half) / covered(whole), 0.5, 0.01);
}

TEST(Slice, TakesAwayOneSideAndLeavesTheOtherAsItIs) {
  const StripedSurface plate = plane_wave(square(5), Vec3(0.6f, 0.8f, 0), 12);
  const RenderOptions half = sliced_by("x=50%");
  Studio& studio = Studio::shared();
  expect_left_half(studio.draw(plate.drawing(), plain_options()),
                   studio.draw(plate.drawing(), half));
  StyledSurface styled{.mesh = plate.mesh, .strokes = {{.waves = &plate.waves, .z = plate.z}}};
  for (const BetweenStrokes between : {BetweenStrokes::surface, BetweenStrokes::discarded}) {
    styled.between = between;
    for (const PictureQuality quality : {PictureQuality::interactive, PictureQuality::final}) {
      RenderOptions whole = plain_options(), cut = half;
      whole.quality = cut.quality = quality;
      const Image image = draw_styled(styled, whole);
      ASSERT_GT(covered(image), 1000);
      const Image rest = draw_styled(styled, cut);
      for (int x = 82; x < 160; ++x) ASSERT_EQ(rest.at(x, 60).alpha, 0);
      for (int x = 0; x < 78; ++x) ASSERT_EQ(rest.at(x, 60), image.at(x, 60)) << x;
    }
  }
}

TEST(Slice, TakesAwayTheOtherSideWithASign) {
  const StripedSurface plate = plane_wave(square(5), Vec3::UnitX(), 12);
  Studio& studio = Studio::shared();
  const double whole = covered(studio.draw(plate.drawing(), plain_options()));
  for (const char* axis : {"x", "y"}) {
    const std::string place = std::string(axis) + "=0.3";
    const double one = covered(studio.draw(plate.drawing(), sliced_by(place.c_str())));
    const double other = covered(studio.draw(plate.drawing(), sliced_by(("-" + place).c_str())));
    EXPECT_NEAR(one / whole, 0.3, 0.01);
    EXPECT_NEAR(one + other, whole, 0.01 * whole);
  }
  EXPECT_EQ(covered(studio.draw(plate.drawing(), sliced_by("x=-1"))), 0);
  EXPECT_EQ(studio.draw(plate.drawing(), sliced_by("z=1")).pixels,
            studio.draw(plate.drawing(), plain_options()).pixels);
}

TEST(Slice, SparesSurfacesThatAreToStayWhole) {
  const StripedSurface plate = plane_wave(square(5), Vec3::UnitX(), 12);
  StyledSurface styled{.mesh = plate.mesh, .strokes = {{.waves = &plate.waves, .z = plate.z}}};
  styled.strokes[0].color = {1, 1, 1};
  styled.color = {0, 0, 0};
  const Image whole = draw_styled(styled, plain_options());
  EXPECT_NEAR(covered(draw_styled(styled, sliced_by("x=50%"))) / covered(whole), 0.5, 0.01);
  styled.sliced = false;
  EXPECT_EQ(draw_styled(styled, sliced_by("x=50%")).pixels, whole.pixels);
  styled.between = BetweenStrokes::discarded;
  const double strokes = covered(draw_styled(styled, plain_options()));
  EXPECT_NEAR(covered(draw_styled(styled, sliced_by("x=50%"))), strokes, 1e-9);
  // Drawings agree.
  const auto stripes_of = [&](bool sliced) {
    styled.sliced = sliced;
    CameraView view = plain_options().camera;
    view.slice = parse_slice("x=50%");
    const Camera camera = framed_camera(plate.mesh.positions, view, 160, 120);
    std::size_t stripes = 0;
    for (const Pen& pen : stripe_outlines({&styled, 1}, camera, {}, 160, 120)) {
      stripes += pen.name == "stripes" ? pen.strokes.size() : 0;
    }
    return stripes;
  };
  EXPECT_EQ(stripes_of(false), 12u);
  EXPECT_EQ(stripes_of(true), 6u);
}

TEST(Slice, CutsDiscsOfPoints) {
  const StripedSurface plate = plane_wave(square(12), Vec3::UnitX(), 6);
  const std::vector<Vec3> normals(plate.mesh.vertex_count(), Vec3::UnitZ());
  const std::vector<float> radii(plate.mesh.vertex_count(), 0.1f);
  const SplatDrawing drawing{plate.mesh.positions, normals, radii, &plate.waves, plate.z};
  const Image whole = render_splats(drawing, plain_options());
  // Discs that are cut are rounded in another way, by every driver in its own.
  expect_left_half(whole, render_splats(drawing, sliced_by("x=50%")), 40);
}

/// A ball without its front half: its inner side is seen all over, with stripes on it, in drafts as
/// in final pictures.
TEST(Slice, OpensClosedSurfaces) {
  const Surface ball = make_surface(make_shape("sphere,resolution=20"));
  StripedSurface striped = plane_wave(ball.mesh, Vec3::UnitX(), 5);
  for (std::size_t v = 0; v < striped.waves.directions.size(); ++v) {
    const Vec3& n = ball.normals[v];
    striped.waves.directions[v] = (Vec3::UnitX() - n.x() * n).normalized();
  }
  for (const PictureQuality quality : {PictureQuality::interactive, PictureQuality::final}) {
    RenderOptions whole = plain_options(), open = sliced_by("z=0");
    whole.camera.projection = open.camera.projection = Projection::orthographic;
    whole.quality = open.quality = quality;
    Studio& studio = Studio::shared();
    const Image outside = studio.draw(striped.drawing(), whole);
    const Image inside = studio.draw(striped.drawing(), open);
    EXPECT_NEAR(covered(inside) / covered(outside), 1, 0.01);
    const Light light = light_in_the_middle(inside);
    EXPECT_LT(light.lowest, 0.05);
    EXPECT_GT(light.highest, 0.95);
  }
}

TEST(Slice, TakesMarksAlong) {
  const StripedSurface plate = plane_wave(square(2), Vec3::UnitX(), 1);
  const std::vector<Mark> marks = {{{0.2f, 0.5f, 0}, {0, 1, 0}}, {{0.8f, 0.5f, 0}, {0, 1, 0}}};
  SurfaceDrawing drawing = plate.drawing();
  drawing.marks = marks;
  const auto green = [&](const RenderOptions& options) {
    int count = 0;
    for (const Pixel& p : Studio::shared().draw(drawing, options).pixels) {
      count += p.green > 200 && p.red < 50;
    }
    return count;
  };
  const int both = green(plain_options());
  EXPECT_GT(both, 30);
  EXPECT_EQ(2 * green(sliced_by("x=50%")), both);
  EXPECT_EQ(green(sliced_by("x=10%")), 0);
}

double area_of(const Mesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3& a = mesh.positions[t[0]];
    sum += 0.5 *
           static_cast<double>((mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a).norm());
  }
  return sum;
}

TEST(Slice, LeavesItsShareOfTriangles) {
  const Mesh plate = square(3);
  for (const float share : {0.0f, 0.1f, 0.5f, 0.77f, 1.0f}) {
    const Eigen::Hyperplane<float, 3> plane(Vec3::UnitX(), Vec3(share, 0, 0));
    EXPECT_NEAR(area_of(left_by(plane, plate)), share, 1e-5);
  }
  const Mesh ball = make_shape("sphere,resolution=9");
  const Eigen::Hyperplane<float, 3> one(Vec3(1, 2, 3).normalized(), Vec3(0.1f, 0, 0.2f));
  const Eigen::Hyperplane<float, 3> other(-one.normal(), -one.offset());
  EXPECT_NEAR(area_of(left_by(one, ball)) + area_of(left_by(other, ball)), area_of(ball), 1e-4);
}

TEST(Slice, HasAnEdgeAroundItsOpening) {
  const Surface ball = make_surface(make_shape("sphere,resolution=20"));
  const Eigen::Hyperplane<float, 3> plane(Vec3(1, 2, 2) / 3, Vec3(0.2f, 0.4f, 0.4f));
  const Polylines edge = slice_lines(ball.mesh, ball.normals, plane);
  ASSERT_EQ(edge.count(), 1u);
  EXPECT_EQ(edge.closed[0], 1);
  EXPECT_NEAR(length_of(edge, 0), 2 * std::numbers::pi * std::sqrt(1 - 0.36), 0.02);
  for (const Vec3& p : edge.points) {
    EXPECT_LT(plane.signedDistance(p), 0);
    EXPECT_GT(plane.signedDistance(p), -1e-3f);
  }
}

/// A line across a plate behind another plate, of which the left half is taken away.
TEST(Slice, UncoversLinesOfDrawings) {
  Mesh mesh = square(1);
  for (Vec3& p : mesh.positions) p.z() = -1;
  Mesh front = square(1);
  append(front, mesh);
  Polylines line;
  line.points = {{0.1f, 0.5f, -1}, {0.9f, 0.5f, -1}};
  line.normals.assign(2, Vec3::UnitZ());
  line.offsets = {0, 2};
  line.closed = {0};
  CameraView view{.azimuth_deg = 0, .elevation_deg = 0};
  view.projection = Projection::orthographic;
  const auto length = [&](const char* slice, bool hidden) {
    view.slice = parse_slice(slice);
    float sum = 0;
    for (const Stroke& stroke : Visibility(mesh, view, 200, 200).strokes(line, 1e-4f, hidden)) {
      sum += (stroke.back() - stroke.front()).norm();
    }
    return sum / (200 * 0.95f);  // a unit fills the picture but for its margin
  };
  EXPECT_EQ(length("z=1", false), 0);
  EXPECT_NEAR(length("z=1", true), 0.8, 0.02);
  EXPECT_NEAR(length("z=-0.5", false), 0.8, 0.02) << "the front plate is away";
  EXPECT_EQ(length("z=-0.5", true), 0);
  EXPECT_EQ(length("z=-2", false), 0) << "all is";
  EXPECT_EQ(length("z=-2", true), 0);
  // The plane leaves the line where x is below 0.5, and of the front plate what is below 0.5 + z
  // + 1.
  EXPECT_NEAR(length("0.5,0,-1,1,0,0", true), 0.4, 0.02) << "both are cut at the same place";
  EXPECT_NEAR(length("0.5,0,-1,1,0,0.4", false), 0.4, 0.02) << "the front plate ends at 0.1";
}

}  // namespace
}  // namespace brindle
