#include "brindle/render/slice_refusal.h"

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/render/parsed_words.h"

namespace brindle {
namespace {

RenderOptions cut_at(const char* text) {
  RenderOptions options;
  options.camera.slice = parse_slice(text);
  EXPECT_TRUE(options.camera.slice) << text;
  return options;
}

Camera camera_cut_at(const Mesh& mesh, const char* text) {
  const RenderOptions options = cut_at(text);
  return framed_camera(points_of_triangles(mesh), options.camera, options.width, options.height);
}

/// A square in the plane z = 1, from 0,0 to 2,2.
Mesh square() {
  Mesh mesh;
  mesh.positions = {{0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

TEST(SliceRefusal, SaysWhereTheSurfaceIs) {
  EXPECT_EQ(
      slice_refusal(square(), camera_cut_at(square(), "x=-1"), "--slice"),
      "--slice leaves nothing of the surface, which has x from 0 to 2, y from 0 to 2, z from 1 "
      "to 1; put the plane elsewhere, or take the other side, such as -x=50%");
  Mesh far = square();
  far.origin = {1000, 0, 0};
  EXPECT_NE(slice_refusal(far, camera_cut_at(far, "x=-1")).find("x from 1000 to 1002"),
            std::string::npos);
}

// What touches the plane alone has no area; what lies within it is not taken away.
TEST(SliceRefusal, CountsAreas) {
  const Mesh mesh = square();
  for (const char* some : {"x=0.01", "-x=1.99", "z=1", "-z=1", "y=50%", "0,0,0,-1,-1,0"}) {
    EXPECT_EQ(slice_refusal(mesh, camera_cut_at(mesh, some)), "") << some;
    EXPECT_NO_THROW(check_slice(mesh, cut_at(some))) << some;
  }
  for (const char* none : {"x=0", "-x=2", "z=0.9", "-z=1.1", "y=0%", "0,0,0,1,1,0"}) {
    EXPECT_NE(slice_refusal(mesh, camera_cut_at(mesh, none)), "") << none;
    EXPECT_THROW(check_slice(mesh, cut_at(none)), Error) << none;
  }
}

TEST(SliceRefusal, NeedsASliceAndASurface) {
  EXPECT_EQ(slice_refusal(square(), framed_camera({}, {}, 8, 8)), "");
  EXPECT_NO_THROW(check_slice(square(), {}));
  EXPECT_NO_THROW(check_slice(Mesh{}, cut_at("x=0")));
}

TEST(SliceRefusal, CountsPointsWithoutTriangles) {
  Mesh points = square();
  points.triangles.clear();
  EXPECT_NO_THROW(check_slice(points, cut_at("x=0")));
  EXPECT_THROW(check_slice(points, cut_at("x=-0.01")), Error);
}

TEST(SliceRefusal, AsksEverySurface) {
  const Mesh mesh = square();
  Mesh beside = square();
  beside.origin = {0, 0, -3};
  const Camera camera = camera_cut_at(mesh, "z=0");
  const std::vector<StyledSurface> both = {{.mesh = mesh}, {.mesh = beside}};
  EXPECT_NE(slice_refusal(std::span(both).first(1), camera), "");
  EXPECT_EQ(slice_refusal(both, camera), "");
  const std::vector<StyledSurface> whole = {{.mesh = mesh}, {.mesh = mesh, .sliced = false}};
  EXPECT_EQ(slice_refusal(whole, camera), "");
  EXPECT_NE(slice_refusal(both, camera_cut_at(mesh, "z=-2.5")).find("z from -2 to 1"),
            std::string::npos);
}

}  // namespace
}  // namespace brindle
