#include "brindle/points/point_normals.h"

#include <random>

#include <gtest/gtest.h>

#include "brindle/geometry/topology.h"
#include "brindle/normals.h"
#include "brindle/shapes.h"

namespace brindle {
namespace {

/// The neighbours that triangles give serve as well as any.
struct Points {
  Mesh mesh;
  Adjacency neighborhood;
  std::vector<Vec3> normals;

  explicit Points(const char* shape)
      : mesh(make_shape(shape)),
        neighborhood(vertex_neighborhood(mesh)),
        normals(fitted_normals(mesh.positions, neighborhood)) {}
};

TEST(PointNormals, FitPlanesExactly) {
  const Points plane("plane,resolution=10");
  for (const Vec3& normal : plane.normals) EXPECT_NEAR(std::abs(normal.z()), 1, 1e-6);
}

TEST(PointNormals, FarFromTheOriginTheyAreAsGood) {
  Points torus("torus,resolution=40");
  for (Vec3& p : torus.mesh.positions) p = 1e-3f * p + Vec3(5, 5, 5);
  const auto far = fitted_normals(torus.mesh.positions, torus.neighborhood);
  double worst = 1;
  for (std::size_t i = 0; i < far.size(); ++i) {
    worst = std::min<double>(worst, std::abs(far[i].dot(torus.normals[i])));
  }
  EXPECT_GT(worst, 0.99);
}

TEST(PointNormals, AreThoseOfTheSurfaceOnceOriented) {
  for (const char* shape : {"sphere,resolution=12", "torus,resolution=60", "trefoil,resolution=20",
                            "box,resolution=30", "pieces,resolution=8"}) {
    Points points(shape);
    orient_normals(points.mesh.positions, points.neighborhood, points.normals);
    const std::vector<Vec3> expected = vertex_normals(points.mesh);
    std::size_t against = 0;
    double sum = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const double cosine = expected[i].dot(points.normals[i]);
      against += cosine < 0;
      sum += cosine;
    }
    EXPECT_LE(against, expected.size() / 500) << shape;
    EXPECT_GT(sum / static_cast<double>(expected.size()), 0.98) << shape;
  }
}

TEST(PointNormals, OrientationDoesNotDependOnSigns) {
  Points torus("torus,resolution=40");
  std::vector<Vec3> flipped = torus.normals;
  std::mt19937 random(2);
  for (Vec3& normal : flipped) {
    if (random() % 2) normal = -normal;
  }
  orient_normals(torus.mesh.positions, torus.neighborhood, torus.normals);
  orient_normals(torus.mesh.positions, torus.neighborhood, flipped);
  EXPECT_EQ(flipped, torus.normals);
}

TEST(PointNormals, OfPointsOnALineAreZero) {
  std::vector<Vec3> line;
  Adjacency chain;
  for (Index i = 0; i < 6; ++i) {
    line.push_back(0.1f * static_cast<float>(i) * Vec3(1, 2, 3) + Vec3(7, 0, 0));
    if (i > 0) chain.neighbors.push_back(i - 1);
    if (i < 5) chain.neighbors.push_back(i + 1);
    chain.offsets.push_back(static_cast<Index>(chain.neighbors.size()));
  }
  for (const Vec3& normal : fitted_normals(line, chain)) EXPECT_EQ(normal, Vec3(Vec3::Zero()));
  const Adjacency alone{{0, 0}, {}};
  EXPECT_EQ(fitted_normals(std::vector<Vec3>{{1, 2, 3}}, alone)[0], Vec3(Vec3::Zero()));
}

}  // namespace
}  // namespace brindle
