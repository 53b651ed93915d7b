#include <cstdlib>
#include <utility>

#include <gtest/gtest.h>

#include "brindle/mesh.h"
#include "brindle/render/surface_light.h"
#include "brindle/shapes.h"
#include "render/test_drawings.h"

namespace brindle {
namespace {

using namespace test;

Mesh turned_inside_out(Mesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

Mesh both(const Mesh& one, Mesh other) {
  Mesh mesh = one;
  for (Vec3& p : other.positions) p += Vec3(10, 0, 0);
  append(other, mesh);
  return mesh;
}

TEST(OuterSide, ClosedSurfacesShowOneSide) {
  for (const char* shape : {"sphere,resolution=12", "torus,resolution=16", "trefoil", "box"}) {
    const Mesh mesh = make_shape(shape);
    EXPECT_EQ(hidden_side(mesh), HiddenSide::back) << shape;
    EXPECT_EQ(hidden_side(turned_inside_out(mesh)), HiddenSide::front) << shape;
    EXPECT_EQ(hidden_side(both(mesh, mesh)), HiddenSide::back) << shape;
    EXPECT_EQ(hidden_side(both(mesh, turned_inside_out(mesh))), HiddenSide::none) << shape;
  }
}

TEST(OuterSide, OthersDoNot) {
  EXPECT_EQ(hidden_side(Mesh{}), HiddenSide::none);
  EXPECT_EQ(hidden_side(square(3)), HiddenSide::none);
  Mesh torus = make_shape("torus,resolution=16");
  std::swap(torus.triangles[7][0], torus.triangles[7][1]);
  EXPECT_EQ(hidden_side(torus), HiddenSide::none);  // one is wound against its neighbours
  torus.triangles.erase(torus.triangles.begin() + 7);
  EXPECT_EQ(hidden_side(torus), HiddenSide::none);  // a hole
}

TEST(OuterSide, LeavingItOutChangesNothing) {
  const Mesh mesh = make_shape("trefoil");
  StripedSurface surface = plane_wave(mesh, Vec3::UnitX(), 5);
  RenderOptions options = plain_options(200, 150);
  options.quality = PictureQuality::interactive;
  const Image front = Studio::shared().draw(surface.drawing(), options);
  StripedSurface turned = surface;
  turned.mesh = turned_inside_out(mesh);
  const Image same = Studio::shared().draw(turned.drawing(), options);
  for (std::size_t p = 0; p < front.pixels.size(); ++p) {
    ASSERT_NEAR(same.pixels[p].red, front.pixels[p].red, 2);  // corners come in another order
    ASSERT_EQ(same.pixels[p].alpha, front.pixels[p].alpha);
  }
  // A triangle of its own, too small to be seen, lets both sides be drawn again.
  const auto count = static_cast<Index>(surface.mesh.vertex_count());
  const Vec3 place = mesh.positions[mesh.triangles[0][0]];
  for (int m = 0; m < 3; ++m) {
    surface.mesh.positions.push_back(place);
    surface.waves.directions.push_back(Vec3::UnitX());
    surface.waves.frequencies.push_back(5);
    surface.z.push_back(1);
  }
  surface.mesh.triangles.push_back({count, count + 1, count + 2});
  surface.waves.positions = surface.mesh.positions;
  ASSERT_EQ(hidden_side(surface.mesh), HiddenSide::none);
  const Image all = Studio::shared().draw(surface.drawing(), options);
  int other = 0;  // on outlines, where both sides lie at the same depth but for rounding
  for (std::size_t p = 0; p < front.pixels.size(); ++p) {
    ASSERT_EQ(all.pixels[p].alpha, front.pixels[p].alpha);
    other += std::abs(all.pixels[p].red - front.pixels[p].red) > 2;
  }
  EXPECT_LE(other, 30);
}

}  // namespace
}  // namespace brindle
