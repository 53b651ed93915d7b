#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/base/parallel.h"
#include "brindle/carried_phases.h"
#include "brindle/error.h"
#include "brindle/shapes.h"

namespace brindle {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

Surface shape(const std::string& spec) { return make_surface(make_shape(spec)); }

/// A field that turns from vertex to vertex.
DirectionField some_field(const Surface& surface) {
  return projected_direction_field({0.3f, 0.5f, 0.8f}, surface.normals);
}

LastField last_of(const Surface& surface, const DirectionField& directions) {
  return {surface.mesh, surface.normals, directions};
}

Surface moved_by(const Surface& surface, const Eigen::Affine3f& motion) {
  Mesh mesh = surface.mesh;
  for (Vec3& position : mesh.positions) position = motion * position;
  return make_surface(std::move(mesh));
}

double largest_angle(const DirectionField& a, const DirectionField& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, field_step({&a[i], 1}, {&b[i], 1}, 1).mean_deg);
  }
  return largest;
}

TEST(CarriedField, WhatMovesAsAWholeTakesItsFieldAlong) {
  const Surface knot = shape("trefoil,resolution=40");
  const DirectionField field = some_field(knot);
  for (const float angle : {0.1f, 1.5f, 3.1f}) {
    const Eigen::Affine3f motion =
        Eigen::Translation3f(1, -2, 0.5f) * Eigen::AngleAxisf(angle, Vec3(1, 2, -3).normalized());
    const Surface now = moved_by(knot, motion);
    DirectionField expected;
    for (const Vec3& d : field) expected.push_back(motion.linear() * d);
    EXPECT_LT(largest_angle(matched_directions(last_of(knot, field), now), expected), 0.05);
  }
}

TEST(CarriedField, GoesAlongWithAMirroredSurface) {
  // As the order of corners stays, normals change sides.
  const Surface knot = shape("trefoil,resolution=40");
  const DirectionField field = some_field(knot);
  const Surface now = moved_by(knot, Eigen::Affine3f(Eigen::Scaling(-1.0f, 1.0f, 1.0f)));
  DirectionField expected;
  for (const Vec3& d : field) expected.emplace_back(-d.x(), d.y(), d.z());
  EXPECT_LT(largest_angle(matched_directions(last_of(knot, field), now), expected), 0.05);
}

TEST(CarriedField, BendsWithAPlaneThatIsRolledUp) {
  const Surface plane = shape("plane,resolution=40");
  const DirectionField field(plane.mesh.vertex_count(), Vec3(0.6f, 0.8f, 0));
  Mesh mesh = plane.mesh;
  for (Vec3& p : mesh.positions) p = Vec3(std::sin(p.x()), p.y(), std::cos(p.x()) - 1);
  const Surface roll = make_surface(std::move(mesh));
  const DirectionField carried = matched_directions(last_of(plane, field), roll);
  for (std::size_t i = 0; i < carried.size(); ++i) {
    const float x = plane.mesh.positions[i].x();
    const Vec3 expected(0.6f * std::cos(x), 0.8f, -0.6f * std::sin(x));
    EXPECT_GT(carried[i].dot(expected), 0.999f);
  }
}

TEST(CarriedField, CounterpartsNameTheVertices) {
  const Surface knot = shape("trefoil,resolution=40");
  const DirectionField field = some_field(knot);
  const std::size_t count = knot.mesh.vertex_count();
  std::vector<Index> from(count);
  for (Index i = 0; i < count; ++i) from[i] = (7 * i + 3) % static_cast<Index>(count);
  ASSERT_NE(count % 7, 0u);
  Mesh mesh;
  for (const Index v : from) mesh.positions.push_back(knot.mesh.positions[v]);
  std::vector<Index> to(count);
  for (Index i = 0; i < count; ++i) to[from[i]] = i;
  for (const Triangle& t : knot.mesh.triangles)
    mesh.triangles.push_back({to[t[0]], to[t[1]], to[t[2]]});
  const Surface renumbered = make_surface(std::move(mesh));
  from[5] = kNoCounterpart;
  const DirectionField carried = matched_directions(last_of(knot, field), renumbered, from);
  for (std::size_t i = 0; i < count; ++i) {
    if (i == 5) {
      EXPECT_TRUE(carried[i].isZero(0));
    } else {
      EXPECT_LT(field_step({&carried[i], 1}, {&field[from[i]], 1}, 1).mean_deg, 0.05);
    }
  }
}

TEST(CarriedField, IsWhereTheLastOneIsOnOtherTriangles) {
  const Surface coarse = shape("sphere,resolution=30"), fine = shape("sphere,resolution=47");
  const DirectionField carried = carried_directions(last_of(coarse, some_field(coarse)), fine, 2);
  const DirectionField expected = some_field(fine);
  double sum = 0;
  for (std::size_t i = 0; i < carried.size(); ++i) {
    EXPECT_NEAR(carried[i].norm(), 1, 1e-5);
    EXPECT_NEAR(carried[i].dot(fine.normals[i]), 0, 1e-5);
    sum += field_step({&carried[i], 1}, {&expected[i], 1}).mean_deg;
  }
  EXPECT_LT(sum / static_cast<double>(carried.size()), 0.5);
}

TEST(CarriedField, DoesNotDependOnSignsAndCrossesOnTheirNames) {
  const Surface coarse = shape("sphere,resolution=20"), fine = shape("sphere,resolution=31");
  for (const int symmetry : {2, 4}) {
    const DirectionField field = some_field(coarse);
    DirectionField renamed = field;
    for (Index i = 0; i < renamed.size(); ++i) {
      const int turns = symmetry == 2 ? 2 * static_cast<int>(i % 2) : static_cast<int>(i % 4);
      renamed[i] =
          Eigen::AngleAxisf(static_cast<float>(turns) * kPi / 2, coarse.normals[i]) * field[i];
    }
    const DirectionField a = carried_directions(last_of(coarse, field), fine, symmetry);
    const DirectionField b = carried_directions(last_of(coarse, renamed), fine, symmetry);
    // Where directions nearly cancel, rounding decides.
    EXPECT_LT(field_step(a, b, symmetry).mean_deg, 0.05);
  }
}

TEST(CarriedField, IsNotKnownFarAway) {
  const Surface plane = shape("plane,resolution=20");
  const DirectionField field(plane.mesh.vertex_count(), Vec3::UnitX());
  Mesh mesh = plane.mesh;
  for (Vec3& p : mesh.positions) p.z() += p.x() > 0 ? 0.3f : 0.1f;
  const Surface torn = make_surface(std::move(mesh));
  const DirectionField carried = carried_directions(last_of(plane, field), torn, 2, 0.2);
  for (std::size_t i = 0; i < carried.size(); ++i) {
    const float height = torn.mesh.positions[i].z();
    EXPECT_EQ(carried[i].isZero(0), height > 0.2f) << height;
  }
}

TEST(CarriedField, OriginsCount) {
  const Surface plane = shape("plane,resolution=20");
  DirectionField field;
  for (const Vec3& p : plane.mesh.positions) {
    field.push_back(p.x() < 0.4f ? Vec3::UnitX() : Vec3::UnitY());
  }
  Surface shifted = plane;
  for (Vec3& p : shifted.mesh.positions) p.x() -= 10;
  shifted.mesh.origin.x() += 10;
  const auto here = carried_directions(last_of(plane, field), plane);
  EXPECT_LT(largest_angle(carried_directions(last_of(plane, field), shifted), here), 0.1);
}

TEST(CarriedField, IsTheSameForEveryNumberOfThreads) {
  const Surface last = shape("sphere,resolution=30"), now = shape("sphere,resolution=33");
  const DirectionField field = some_field(last);
  const Surface turned = moved_by(last, Eigen::Affine3f(Eigen::AngleAxisf(0.3f, Vec3::UnitX())));
  const ThreadLimit one(1);
  const auto carried = carried_directions(last_of(last, field), now);
  const auto matched = matched_directions(last_of(last, field), turned);
  const ThreadLimit two(2);
  EXPECT_EQ(carried_directions(last_of(last, field), now), carried);
  EXPECT_EQ(matched_directions(last_of(last, field), turned), matched);
}

TEST(CarriedField, RefusesWhatCannotBe) {
  const Surface plane = shape("plane,resolution=4"), other = shape("plane,resolution=5");
  const DirectionField field(plane.mesh.vertex_count(), Vec3::UnitX());
  const LastField last = last_of(plane, field);
  EXPECT_THROW(matched_directions(last, other), Error);
  EXPECT_THROW(matched_directions(last, plane, std::vector<Index>(3, 0)), Error);
  const std::vector<Index> beyond(plane.mesh.vertex_count(), 1000);
  EXPECT_THROW(matched_directions(last, plane, beyond), Error);
  EXPECT_THROW(carried_directions(last, other, 0), Error);
  for (const double bad : {0.0, -1.0, std::nan("")}) {
    EXPECT_THROW(carried_directions(last, other, 2, bad), Error);
  }
  const DirectionField few(3, Vec3::UnitX());
  EXPECT_THROW(carried_directions(last_of(plane, few), other), Error);
  EXPECT_THROW(field_step(field, few), Error);
}

TEST(FieldStep, IsTheAngleBetweenAlikeDirections) {
  const DirectionField x{Vec3::UnitX()};
  const auto at = [](float degrees) {
    const float radians = degrees * kPi / 180;
    return DirectionField{{std::cos(radians), std::sin(radians), 0}};
  };
  EXPECT_NEAR(field_step(x, at(100), 1).mean_deg, 100, 1e-4);
  EXPECT_NEAR(field_step(x, at(100), 2).mean_deg, 80, 1e-4);
  EXPECT_NEAR(field_step(x, at(100), 4).mean_deg, 10, 1e-4);
  EXPECT_NEAR(field_step(x, at(0.01f), 2).mean_deg, 0.01, 1e-6);
  const DirectionField none{Vec3::Zero()};
  EXPECT_EQ(field_step(x, none).unmatched, 1u);
  EXPECT_EQ(field_step(none, x).unmatched, 0u);
  EXPECT_EQ(field_step(none, x).mean_deg, 0);
}

TEST(MeanPeriod, IsOneOverTheMeanFrequencyOfWaves) {
  const WaveSet waves{std::vector<Vec3>(3, Vec3::Zero()),
                      {Vec3::UnitX(), Vec3::UnitY(), Vec3::Zero()},
                      {2, 6, 100}};
  EXPECT_DOUBLE_EQ(mean_period(waves), 0.25);
  EXPECT_TRUE(std::isinf(mean_period({})));
}

}  // namespace
}  // namespace brindle
