#include "brindle/pipeline/texture_orientation.h"

#include <random>

#include <gtest/gtest.h>

#include "brindle/base/parallel.h"
#include "brindle/smooth_field.h"
#include "textures.h"

namespace brindle {
namespace {

using namespace testing_support;

/// Directions with every other sign turned.
DirectionField with_random_signs(DirectionField field) {
  std::mt19937 random(11);
  for (Vec3& direction : field) {
    if (random() % 2) direction = -direction;
  }
  return field;
}

/// Of U along the field and V across it.
TextureOrientation oriented(const Surface& surface, const DirectionField& field) {
  TextureOrientation orientation(surface.mesh.triangles);
  orientation.follow(field, rotated(field, surface.normals, 1.5707963f), false);
  return orientation;
}

TEST(TextureOrientation, FindsTheOrientationOfAFieldThatHasOne) {
  for (const char* shape :
       {"torus,resolution=100", "torus,resolution=500", "cylinder,resolution=80", "plane"}) {
    const Surface surface = make_surface(make_shape(shape));
    // No zero on these shapes.
    const Vec3 axis = shape[0] == 't' ? Vec3(0, 0, 1) : Vec3(0.2f, 0.1f, 0.9f);
    DirectionField field = projected_direction_field(axis, surface.normals);
    if (shape[0] == 't') {
      for (std::size_t i = 0; i < field.size(); ++i) {
        const Vec3& p = surface.mesh.positions[i];
        field[i] = tangent_direction(Vec3(-p.y(), p.x(), 0), surface.normals[i]);
      }
    } else if (shape[0] == 'p') {
      field = projected_direction_field(Vec3(3, 1, 0), surface.normals);
    }
    const TextureSeams seams = oriented(surface, with_random_signs(field)).seams();
    EXPECT_EQ(seams.turned, 0u) << shape;
    EXPECT_EQ(seams.mirrored, 0u) << shape;
    EXPECT_EQ(seams.unoriented_triangles, 0u) << shape;
  }
}

TEST(TextureOrientation, KeepsTheSignsThatMostOfAPieceHas) {
  for (const char* shape : {"plane,resolution=40", "plane,resolution=300"}) {
    const Surface surface = make_surface(make_shape(shape));
    DirectionField field = projected_direction_field(Vec3(1, 2, 0), surface.normals);
    std::mt19937 random(3);
    for (Vec3& direction : field) {
      if (random() % 4 == 0) direction = -direction;
    }
    const TextureOrientation orientation = oriented(surface, field);
    for (std::size_t t = 0; t < surface.mesh.triangle_count(); ++t) {
      for (Index m = 0; m < 3; ++m) {
        const bool turned = turns_u(orientation.signs()[t], m);
        ASSERT_EQ(turned, field[surface.mesh.triangles[t][m]].x() < 0) << shape;
      }
    }
  }
}

TEST(TextureOrientation, TheSeamOfAHalfSingularityTakesTheShortWayOut) {
  // The finest has so many triangles that they are oriented in blocks.
  for (const int resolution : {20, 60, 400}) {
    const Surface surface =
        make_surface(make_shape("plane,resolution=" + std::to_string(resolution)));
    const TextureSeams seams =
        oriented(surface, with_random_signs(singular_field(surface.mesh, 0.5f))).seams();
    EXPECT_EQ(seams.unoriented_triangles, 1u);
    // From the middle straight to the border.
    EXPECT_GE(seams.turned, static_cast<std::size_t>(resolution / 2 - 1));
    EXPECT_LE(seams.turned, static_cast<std::size_t>(resolution / 2 + 1));
    EXPECT_EQ(seams.mirrored, 0u);
  }
}

TEST(TextureOrientation, AWholeSingularityNeedsNoSeam) {
  const Surface surface = make_surface(make_shape("plane,resolution=50"));
  const TextureSeams seams =
      oriented(surface, with_random_signs(singular_field(surface.mesh, 1))).seams();
  EXPECT_EQ(seams.turned, 0u);
}

TEST(TextureOrientation, DoesNotDependOnThreads) {
  const Surface surface = make_surface(make_shape("sphere,resolution=30"));
  const DirectionField field = smooth_direction_field(surface);
  std::vector<std::vector<CornerSigns>> results;
  for (const int threads : {1, 2}) {
    const ThreadLimit limit(threads);
    const TextureOrientation orientation = oriented(surface, field);
    results.emplace_back(orientation.signs().begin(), orientation.signs().end());
  }
  EXPECT_EQ(results[0], results[1]);
}

}  // namespace
}  // namespace brindle
