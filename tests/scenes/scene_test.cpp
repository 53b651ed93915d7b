#include "scenes/scene.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "brindle/base/parallel.h"
#include "brindle/direction_field.h"
#include "brindle/error.h"
#include "brindle/shapes.h"

namespace brindle {
namespace {

constexpr SceneKind kKinds[] = {SceneKind::zoom, SceneKind::vortices, SceneKind::rotate,
                                SceneKind::wobble, SceneKind::brush};

Surface shape(const std::string& spec) { return make_surface(make_shape(spec)); }

SceneOptions options_of(SceneKind kind, float frequency = 5) {
  return {.kind = kind, .frequency = frequency};
}

struct EveryScene : testing::TestWithParam<SceneKind> {};

TEST_P(EveryScene, HasAName) { EXPECT_EQ(parse_scene_kind(name_of(GetParam())), GetParam()); }

TEST_P(EveryScene, GivesUnitTangentDirectionsAndFiniteWavesOnAnySurface) {
  for (const char* spec : {"torus,resolution=32", "mobius,resolution=8", "sheets,resolution=6",
                           "plane,resolution=9", "pieces,count=3"}) {
    const Surface surface = shape(spec);
    Scene scene(surface, options_of(GetParam()));
    for (const int number : {0, 1, 30, 121}) {
      const SceneFrame& frame = scene.frame(number);
      ASSERT_EQ(frame.waves.directions.size(), surface.mesh.vertex_count());
      std::size_t without = 0;
      for (std::size_t v = 0; v < frame.normals.size(); ++v) {
        const Vec3& d = frame.waves.directions[v];
        without += d.isZero(0);
        EXPECT_TRUE(frame.waves.positions[v].allFinite());
        EXPECT_GT(frame.waves.frequencies[v], 0);
        EXPECT_TRUE(d.isZero(0) || std::abs(d.norm() - 1) < 1e-5f) << spec;
        EXPECT_LT(std::abs(d.dot(frame.normals[v])), 1e-4f) << spec;
      }
      EXPECT_LT(without, frame.normals.size() / 10) << spec << ' ' << number;
    }
  }
}

TEST_P(EveryScene, ChangesLittleFromFrameToFrame) {
  const Surface surface = shape("torus,resolution=48");
  const float diagonal = bounding_box(surface.mesh).diagonal();
  Scene scene(surface, options_of(GetParam()));
  SceneFrame last = scene.frame(0);
  double change = 0;
  for (int number = 1; number < 40; ++number) {
    const SceneFrame& frame = scene.frame(number);
    double turn = 0;
    for (std::size_t v = 0; v < frame.normals.size(); ++v) {
      turn += (frame.waves.directions[v] - last.waves.directions[v]).norm();
      EXPECT_LT((frame.waves.positions[v] - last.waves.positions[v]).norm(), 0.005f * diagonal);
      EXPECT_NEAR(frame.waves.frequencies[v] / last.waves.frequencies[v], 1, 0.011);
      change += std::abs(frame.waves.frequencies[v] - last.waves.frequencies[v]) +
                (frame.waves.positions[v] - last.waves.positions[v]).norm();
    }
    // On average; near a zero of a field directions may turn as fast as they like.
    EXPECT_LT(turn / static_cast<double>(frame.normals.size()), 0.08) << number;
    change += turn;
    last = frame;
  }
  EXPECT_GT(change, 1);
}

TEST_P(EveryScene, DependsOnTheFramesNumberAlone) {
  const Surface surface = shape("torus,resolution=24");
  Scene scene(surface, options_of(GetParam()));
  const SceneFrame tenth = scene.frame(10);
  scene.frame(3);
  EXPECT_EQ(scene.frame(10).waves.directions, tenth.waves.directions);
  EXPECT_EQ(scene.frame(10).waves.positions, tenth.waves.positions);
  EXPECT_EQ(scene.frame(10).waves.frequencies, tenth.waves.frequencies);
}

TEST_P(EveryScene, DoesNotDependOnScaleOrPlace) {
  const Surface surface = shape("torus,resolution=32");
  // A smooth field without anchors turns as a whole at any rounding error; scaling has none here.
  const Vec3 offset = GetParam() == SceneKind::brush ? Vec3(Vec3::Zero()) : Vec3(16, -32, 64);
  Mesh moved = surface.mesh;
  for (Vec3& p : moved.positions) p = 8 * p + offset;
  Scene here(surface, options_of(GetParam()));
  Scene there(make_surface(std::move(moved)), options_of(GetParam(), 5.0f / 8));
  const SceneFrame& a = here.frame(25);
  const SceneFrame& b = there.frame(25);
  double turn = 0;
  for (std::size_t v = 0; v < a.normals.size(); ++v) {
    turn += 1 - a.waves.directions[v].dot(b.waves.directions[v]);
    EXPECT_LT((8 * a.waves.positions[v] + offset - b.waves.positions[v]).norm(), 1e-3);
  }
  EXPECT_LT(turn / static_cast<double>(a.normals.size()), 1e-2);
}

TEST_P(EveryScene, IsTheSameForEveryNumberOfThreads) {
  const Surface surface = shape("torus,resolution=64");
  const auto directions = [&](int threads) {
    const ThreadLimit limit(threads);
    return Scene(surface, options_of(GetParam())).frame(5).waves.directions;
  };
  EXPECT_EQ(directions(1), directions(2));
}

TEST_P(EveryScene, TakesASurfaceWithoutTriangles) {
  Scene scene(make_surface({{Vec3(1, 2, 3), Vec3(4, 5, 6)}, {}}), options_of(GetParam()));
  for (const Vec3& d : scene.frame(2).waves.directions) EXPECT_TRUE(d.allFinite());
}

INSTANTIATE_TEST_SUITE_P(Scene, EveryScene, testing::ValuesIn(kKinds),
                         [](const auto& kind) { return std::string(name_of(kind.param)); });

TEST(Scene, BeginsWithTheGlobalVectorsField) {
  const Surface surface = shape("torus,resolution=24");
  const Vec3 direction(1, 2, 0.5f);
  for (const SceneKind kind : {SceneKind::zoom, SceneKind::rotate, SceneKind::wobble}) {
    Scene scene(surface, {.kind = kind, .direction = direction, .frequency = 3});
    const SceneFrame& first = scene.frame(0);
    EXPECT_EQ(first.waves.positions, surface.mesh.positions);
    EXPECT_EQ(first.waves.frequencies.front(), 3);
    const DirectionField expected = projected_direction_field(direction, surface.normals);
    for (std::size_t v = 0; v < expected.size(); ++v) {
      EXPECT_LT((first.waves.directions[v] - expected[v]).norm(), 1e-3);
    }
  }
}

TEST(Scene, ZoomGrowsByOnePercentAFrame) {
  Scene scene(shape("torus,resolution=24"), options_of(SceneKind::zoom));
  EXPECT_NEAR(scene.frame(70).waves.frequencies[0], 5 * std::pow(1.01, 70), 1e-4);
}

TEST(Scene, FieldsWhirlAroundTheCores) {
  const Surface surface = shape("sphere,resolution=24");
  Scene scene(surface, options_of(SceneKind::vortices));
  for (const int number : {0, 77}) {
    const SceneFrame& frame = scene.frame(number);
    ASSERT_EQ(frame.points.size(), 2u);
    for (std::size_t v = 0; v < frame.normals.size(); ++v) {
      const Vec3& p = frame.mesh.positions[v];
      for (const Vec3& core : frame.points) {
        const float distance = (p - core).norm();
        if (distance < 0.02f || distance > 0.3f) continue;
        EXPECT_LT(std::abs(frame.waves.directions[v].dot((p - core) / distance)), 0.3f);
      }
    }
  }
}

TEST(Scene, WobbleStaysNearTheSurface) {
  const Surface surface = shape("torus,resolution=24");
  const float diagonal = bounding_box(surface.mesh).diagonal();
  Scene scene(surface, options_of(SceneKind::wobble));
  float largest = 0;
  for (int number = 0; number < 200; number += 7) {
    const SceneFrame& frame = scene.frame(number);
    for (std::size_t v = 0; v < frame.normals.size(); ++v) {
      largest = std::max(largest, (frame.mesh.positions[v] - surface.mesh.positions[v]).norm());
    }
  }
  EXPECT_LT(largest, 0.011f * diagonal);
  EXPECT_GT(largest, 0.008f * diagonal);
}

TEST(Scene, BrushRestsWhenTheStrokeIsFinished) {
  Scene scene(shape("torus,resolution=24"), options_of(SceneKind::brush));
  const DirectionField finished = scene.frame(121).waves.directions;
  EXPECT_EQ(scene.frame(130).waves.directions, finished);
  EXPECT_NE(scene.frame(60).waves.directions, finished);
}

TEST(Scene, RefusesOptionsOutOfRange) {
  const Surface surface = shape("torus,resolution=24");
  EXPECT_THROW(Scene(surface, {.frequency = 0}), Error);
  EXPECT_THROW(Scene(surface, {.frequency = INFINITY}), Error);
  EXPECT_THROW(Scene(surface, {.direction = Vec3::Zero(), .frequency = 1}), Error);
  EXPECT_THROW(Scene(surface, {.frequency = 1}).frame(-1), Error);
  EXPECT_FALSE(parse_scene_kind("dream"));
}

}  // namespace
}  // namespace brindle
