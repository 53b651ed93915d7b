// Smooth fields that go on from those before, on surfaces that move.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <optional>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/base/parallel.h"
#include "brindle/carried_phases.h"
#include "brindle/error.h"
#include "brindle/frequency_field.h"
#include "brindle/shapes.h"
#include "brindle/shapes/isosurface.h"
#include "brindle/smooth_field.h"
#include "brindle/solver.h"
#include "brindle/stripe_animator.h"
#include "brindle/waves/direction_graph.h"

namespace brindle {
namespace {

constexpr int kFrames = 21;

using Motion = std::function<Mesh(int step)>;

double field_energy(const Surface& surface, const DirectionField& field, int symmetry) {
  const PhaseGraph graph = build_direction_graph(surface.neighborhood, surface.normals, symmetry);
  std::vector<Complex> u;
  for (std::size_t i = 0; i < field.size(); ++i) {
    u.push_back(representation(field[i], surface.normals[i], symmetry));
  }
  return energy(graph, u);
}

/// With noise of its own at every step, so that fields found anew turn freely.
Mesh noisy(Mesh mesh, int step, float noise = 5e-4f) {
  std::mt19937 random(static_cast<unsigned>(7 * step + 1));
  std::normal_distribution<float> any;
  const float scale = noise * bounding_box(mesh).diagonal();
  for (Vec3& position : mesh.positions) {
    position += scale * Vec3(any(random), any(random), any(random));
  }
  return mesh;
}

Motion motion_of(const std::string& shape, const std::function<Vec3(const Vec3&, float)>& moved) {
  const Mesh rest = make_shape(shape);
  return [rest, moved](int step) {
    Mesh mesh = rest;
    for (Vec3& position : mesh.positions) {
      position = moved(position, static_cast<float>(step) / (kFrames - 1));
    }
    return noisy(std::move(mesh), step);
  };
}

/// A wave of 0.4 % of its size runs through it.
Motion beating(const std::string& shape) {
  return motion_of(shape, [](const Vec3& p, float time) {
    return Vec3(p * (1 + 0.004f * std::sin(6.2832f * time + 2 * p.x())));
  });
}

struct Played {
  double turn = 0, turn_anew = 0;              ///< degrees a step
  double phase_step = 0, phase_step_anew = 0;  ///< radians
  double energy = 0, energy_anew = 0;          ///< of the field
};

/// Plays steps that have the same triangles twice: fields that follow under stripes that do, and
/// both from scratch.
Played play(const Motion& motion, const SmoothFieldOptions& options = {}) {
  Played sums;
  AnimatorOptions alone;
  alone.lambda = 0;
  std::optional<StripeAnimator> following, scratch;
  Surface before;
  DirectionField last, last_anew;
  FrequencyField frequencies;
  for (int step = 0; step < kFrames; ++step) {
    const Surface surface = make_surface(motion(step));
    const DirectionField anew = smooth_direction_field(surface, options);
    DirectionField field = anew;
    if (step == 0) {
      following.emplace(surface);
      scratch.emplace(surface, alone);
      const float frequency = frequency_of_stripes(40, bounding_box(surface.mesh).diagonal());
      frequencies = constant_frequency_field(frequency, anew.size());
    } else {
      SmoothFieldOptions follows = options;
      const auto carried = [&](const DirectionField& directions) {
        return matched_directions({before.mesh, before.normals, directions}, surface);
      };
      follows.last.directions = carried(last);
      field = smooth_direction_field(surface, follows);
      sums.turn += field_step(field, follows.last.directions, options.symmetry).mean_deg;
      sums.turn_anew += field_step(anew, carried(last_anew), options.symmetry).mean_deg;
    }
    const auto& positions = surface.mesh.positions;
    const double moved = following->frame({positions, field, frequencies}).phase_step;
    const double moved_anew = scratch->frame({positions, anew, frequencies}).phase_step;
    if (step > 0) {
      sums.phase_step += moved;
      sums.phase_step_anew += moved_anew;
      sums.energy += field_energy(surface, field, options.symmetry);
      sums.energy_anew += field_energy(surface, anew, options.symmetry);
    }
    before = surface;
    last = field;
    last_anew = anew;
  }
  sums.turn /= kFrames - 1;
  sums.turn_anew /= kFrames - 1;
  return sums;
}

struct Beating : testing::TestWithParam<const char*> {};

TEST_P(Beating, FieldsThatFollowKeepStripesTogether) {
  const Played played = play(beating(GetParam()));
  // Fields found anew turn freely, on the knot only as far as the least curl leaves them.
  EXPECT_GT(played.turn_anew, 10);
  EXPECT_LT(played.turn, std::min(5.0, 0.2 * played.turn_anew));
  EXPECT_LE(played.phase_step, 0.25 * played.phase_step_anew);
  EXPECT_LE(played.energy, 1.05 * played.energy_anew);
}

TEST_P(Beating, CurvatureFieldsFollow) {
  SmoothFieldOptions options;
  options.curvature_anchor = 0.1f;
  const Played played = play(beating(GetParam()), options);
  EXPECT_LT(played.turn, 0.9 * played.turn_anew);
  // Curvature of the knot is so clear that its field, found anew, does not turn freely.
  const bool turns_freely = played.phase_step_anew > kFrames - 1;
  EXPECT_LE(played.phase_step, (turns_freely ? 0.25 : 0.6) * played.phase_step_anew);
  // Noise of curvature that is not followed leaves some smoothness, too.
  EXPECT_LE(played.energy, 1.2 * played.energy_anew);
}

INSTANTIATE_TEST_SUITE_P(Shapes, Beating,
                         testing::Values("trefoil,resolution=40", "vessels,resolution=40",
                                         "molecule,resolution=30", "sphere,resolution=24"),
                         [](const auto& test) {
                           return std::string(test.param, std::strchr(test.param, ','));
                         });

TEST(FollowedField, CrossesFollow) {
  SmoothFieldOptions options;
  options.symmetry = 4;
  const Played played = play(beating("sphere,resolution=24"), options);
  EXPECT_LT(played.turn, 0.25 * played.turn_anew);
  EXPECT_LE(played.energy, 1.1 * played.energy_anew);
}

/// What shapes that change much come to in a whole series.
struct GreatMotion {
  const char* name;
  const char* shape;
  std::function<Vec3(const Vec3&, float)> moved;
  /// Against fields found anew, which are free to choose another minimum.
  double most_energy = 1.08;
};

void PrintTo(const GreatMotion& motion, std::ostream* out) { *out << motion.name; }

Vec3 turned_place(const Vec3& p, float time) {
  return Eigen::AngleAxisf(6.2832f * time, Vec3(1, 2, 3).normalized()) * p;
}

/// A cylinder becomes half a ring.
Vec3 bent(const Vec3& p, float time) {
  const float curvature = 1.57f * time + 1e-4f, angle = p.z() * curvature;
  const float radius = 1 / curvature - p.x();
  return {1 / curvature - radius * std::cos(angle), p.y(), radius * std::sin(angle)};
}

Vec3 with_horns(const Vec3& p, float time) {
  float height = 0;
  for (const Vec3& tip : {Vec3(1, 0, 0), Vec3(-0.3f, 0.9f, 0.3f), Vec3(-0.5f, -0.5f, 0.7f)}) {
    height += std::exp(-12 * (p.normalized() - tip.normalized()).squaredNorm());
  }
  return p * (1 + 2 * time * height);
}

Vec3 flattened(const Vec3& p, float time) {
  return {p.x() * (1 + 2 * time), p.y(), p.z() * (1 - 0.9f * time)};
}

/// A bump runs round the sphere.
Vec3 with_bump(const Vec3& p, float time) {
  const Vec3 middle(std::cos(6.2832f * time), std::sin(6.2832f * time), 0);
  return p * (1 + 0.6f * std::exp(-6 * (p.normalized() - middle).squaredNorm()));
}

struct MovingFar : testing::TestWithParam<GreatMotion> {};

TEST_P(MovingFar, FieldsStayAsSmoothAsThoseFoundAnew) {
  const Played played = play(motion_of(GetParam().shape, GetParam().moved));
  EXPECT_LT(played.turn, 0.25 * played.turn_anew);
  EXPECT_LT(played.phase_step, 0.6 * played.phase_step_anew);
  EXPECT_LE(played.energy, GetParam().most_energy * played.energy_anew);
}

INSTANTIATE_TEST_SUITE_P(
    Motions, MovingFar,
    testing::Values(GreatMotion{"turning", "molecule,resolution=30", turned_place},
                    GreatMotion{"bending", "cylinder,resolution=40", bent},
                    GreatMotion{"growing", "sphere,resolution=24", with_horns, 1.2},
                    GreatMotion{"flattening", "sphere,resolution=24", flattened},
                    GreatMotion{"bump", "sphere,resolution=24", with_bump}),
    [](const auto& test) { return std::string(test.param.name); });

/// Two spheres that melt into one surface, with other triangles at every step.
Surface melting(int step) {
  const double apart = 0.75 - 0.02 * step;
  const auto blend = [apart](const Eigen::Vector3d& p) {
    const Eigen::Vector3d middle(apart, 0, 0);
    const double a = (p - middle).norm() - 0.5, b = (p + middle).norm() - 0.5;
    const double h = std::max(0.3 - std::abs(a - b), 0.0) / 0.3;
    return std::min(a, b) - h * h * 0.3 / 4;
  };
  return make_surface(
      isosurface(blend, BoundingBox{Vec3(-1.5f, -0.8f, -0.8f), Vec3(1.5f, 0.8f, 0.8f)}, 0.06f));
}

TEST(FollowedField, GoesOnWhereTheTopologyAndTheTrianglesChange) {
  Surface before = melting(0);
  DirectionField last = smooth_direction_field(before);
  double turn = 0, energy = 0, energy_anew = 0;
  for (int step = 1; step < kFrames; ++step) {
    const Surface surface = melting(step);
    SmoothFieldOptions options;
    options.last.directions =
        carried_directions({before.mesh, before.normals, last}, surface, 2, 0.2);
    const DirectionField field = smooth_direction_field(surface, options);
    turn += field_step(field, options.last.directions).mean_deg;
    energy += field_energy(surface, field, 2);
    energy_anew += field_energy(surface, smooth_direction_field(surface), 2);
    before = surface;
    last = field;
  }
  EXPECT_LT(turn / (kFrames - 1), 6);
  EXPECT_LE(energy, 1.1 * energy_anew);
}

// One step.

struct Step : testing::Test {
  Surface before = make_surface(make_shape("trefoil,resolution=40"));
  DirectionField last = smooth_direction_field(before);
  Surface after = make_surface(beating("trefoil,resolution=40")(3));
  SmoothFieldOptions options;

  DirectionField carried() const {
    return matched_directions({before.mesh, before.normals, last}, after);
  }
  DirectionField followed(DirectionField from) {
    options.last.directions = std::move(from);
    return smooth_direction_field(after, options);
  }
};

TEST_F(Step, WhatMovesAsAWholeIsFollowedAsAWhole) {
  const DirectionField here = followed(carried());
  const Eigen::AngleAxisf turn(2, Vec3(1, -2, 0.5f).normalized());
  const auto turned_surface = [&](const Surface& surface) {
    Mesh mesh = surface.mesh;
    for (Vec3& position : mesh.positions) position = turn * position + Vec3(3, 1, -2);
    return make_surface(std::move(mesh));
  };
  before = turned_surface(before);
  after = turned_surface(after);
  for (Vec3& direction : last) direction = turn * direction;
  const DirectionField there = followed(carried());
  DirectionField expected;
  for (const Vec3& direction : here) expected.push_back(turn * direction);
  EXPECT_LT(field_step(there, expected, 1).mean_deg, 0.1);
}

TEST_F(Step, KeepsSignsAndDoesNotDependOnThem) {
  const DirectionField from = carried(), field = followed(from);
  DirectionField flipped = from;
  for (std::size_t i = 0; i < flipped.size(); i += 3) flipped[i] = -flipped[i];
  const DirectionField other = followed(flipped);
  EXPECT_LT(field_step(field, other, 2).mean_deg, 0.01);
  for (std::size_t i = 0; i < field.size(); ++i) {
    EXPECT_GE(field[i].dot(from[i]), -1e-4f);
    EXPECT_GE(other[i].dot(flipped[i]), -1e-4f);
  }
}

TEST_F(Step, CrossesKeepTheirNames) {
  options.symmetry = 4;
  last = smooth_direction_field(before, options);
  const DirectionField from = carried();
  const DirectionField field = followed(from);
  for (std::size_t i = 0; i < field.size(); ++i) EXPECT_GE(field[i].dot(from[i]), 0.7f);
}

TEST_F(Step, IsTheSameForEveryNumberOfThreads) {
  const ThreadLimit one(1);
  const DirectionField alone = followed(carried());
  const ThreadLimit two(2);
  EXPECT_EQ(followed(carried()), alone);
}

TEST_F(Step, WhatIsNotKnownIsFilledIn) {
  const DirectionField whole = followed(carried());
  DirectionField torn = carried();
  for (std::size_t i = 0; i < torn.size(); ++i) {
    if (after.mesh.positions[i].x() > 1) torn[i].setZero();
  }
  const DirectionField field = followed(torn);
  for (const Vec3& direction : field) EXPECT_NEAR(direction.norm(), 1, 1e-4);
  EXPECT_LE(field_energy(after, field, 2), 1.3 * field_energy(after, whole, 2));
  EXPECT_GT(field_step(field, torn).unmatched, 40u);
  EXPECT_LT(field_step(field, torn).mean_deg, 8);
}

TEST_F(Step, NothingKnownIsAFieldFoundAnew) {
  const DirectionField nothing(after.mesh.vertex_count(), Vec3::Zero());
  const DirectionField anew = smooth_direction_field(after);
  EXPECT_LE(field_energy(after, followed(nothing), 2), 1.02 * field_energy(after, anew, 2));
  const DirectionField from = carried();
  options.last.confidence.assign(from.size(), 0);
  EXPECT_LE(field_energy(after, followed(from), 2), 1.02 * field_energy(after, anew, 2));
}

TEST_F(Step, StrokesStillDraw) {
  const Index vertex = 100;
  const Vec3 across = after.normals[vertex].cross(followed(carried())[vertex]);
  options.anchors = {{vertex, across, 50}};
  EXPECT_GT(std::abs(followed(carried())[vertex].dot(across)), 0.9f);
}

TEST_F(Step, RefusesWhatCannotBe) {
  const DirectionField from = carried();
  EXPECT_THROW(followed(DirectionField(3, Vec3::UnitX())), Error);
  DirectionField bad = from;
  bad[7].x() = std::nanf("");
  EXPECT_THROW(followed(bad), Error);
  options.last.confidence = {1};
  EXPECT_THROW(followed(from), Error);
  options.last.confidence.assign(from.size(), -1);
  EXPECT_THROW(followed(from), Error);
  options.last.confidence.clear();
  options.last.weight = -1;
  EXPECT_THROW(followed(from), Error);
}

}  // namespace
}  // namespace brindle
