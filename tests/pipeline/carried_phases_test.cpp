#include "brindle/carried_phases.h"

#include <cmath>
#include <numbers>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/points.h"
#include "brindle/stripe_animator.h"
#include "brindle/stripe_pattern.h"
#include "phase_graphs.h"
#include "test_meshes.h"

namespace brindle {
namespace {

using testing_support::flip_half;
using testing_support::kAxis;
using testing_support::wavy_surface;
using testing_support::WavySurface;

std::vector<Complex> solved(const WavySurface& surface) { return solve_phases(surface.graph()).z; }

LastPattern last_of(const WavySurface& surface, std::span<const Complex> z) {
  return {surface.mesh, surface.waves, z};
}

double angle_between(const Complex& a, const Complex& b) {
  return std::abs(std::arg(a * std::conj(b)));
}

/// The phase of a plane wave along (0.8, 0.6, 0) of frequency 3, for a wave that runs along
/// `direction`.
Complex plane_phase(const Vec3& position, const Vec3& direction) {
  const float turns = 3 * Vec3(0.8f, 0.6f, 0).dot(position);
  const Complex z = std::polar(1.0f, 2 * std::numbers::pi_v<float> * turns);
  return direction.dot(Vec3(0.8f, 0.6f, 0)) < 0 ? -std::conj(z) : z;
}

WavySurface plane_with_wave(int resolution) {
  WavySurface plane = wavy_surface("plane,resolution=" + std::to_string(resolution), kAxis, 20);
  std::ranges::fill(plane.waves.directions, Vec3(0.8f, 0.6f, 0));
  std::ranges::fill(plane.waves.frequencies, 3.0f);
  return plane;
}

std::vector<Complex> plane_phases(const WavySurface& plane) {
  std::vector<Complex> z;
  for (std::size_t i = 0; i < plane.mesh.vertex_count(); ++i) {
    z.push_back(plane_phase(plane.waves.positions[i], plane.waves.directions[i]));
  }
  return z;
}

TEST(CarriedPhases, OntoTheSameMeshAreTheSame) {
  for (const auto& [name, mesh] : every_shape()) {
    SCOPED_TRACE(name);
    const WavySurface surface = wavy_surface(mesh, kAxis, 20);
    const std::vector<Complex> z = solved(surface);
    const std::vector<Complex> carried =
        carried_phases(last_of(surface, z), surface.mesh, surface.waves);
    // Vertices that stand at one place cannot be told apart.
    const std::vector<Index> first = first_at_each_place(surface.mesh.positions);
    std::size_t compared = 0;
    for (std::size_t i = 0; i < z.size(); ++i) {
      if (surface.waves.directions[i].isZero(0) || first[i] != i) continue;
      EXPECT_LT(std::abs(carried[i] - z[i]), 1e-4) << i;
      ++compared;
    }
    EXPECT_GT(compared, z.size() / 2);
  }
}

TEST(CarriedPhases, TurnWithDirections) {
  WavySurface surface = wavy_surface("trefoil,resolution=60", kAxis, 20);
  const std::vector<Complex> z = solved(surface);
  const WavySurface before = surface;
  const auto flipped = flip_half(surface.waves, 5);
  const auto by_place = carried_phases(last_of(before, z), surface.mesh, surface.waves);
  const auto by_number = matched_phases(last_of(before, z), surface.waves);
  for (std::size_t i = 0; i < z.size(); ++i) {
    if (surface.waves.directions[i].isZero(0)) continue;
    const Complex expected = flipped[i] ? -std::conj(z[i]) : z[i];
    EXPECT_EQ(by_number[i], expected);
    EXPECT_LT(std::abs(by_place[i] - expected), 1e-4);
  }
}

TEST(CarriedPhases, LeadAPlaneWaveOntoAnyTriangulation) {
  const WavySurface coarse = plane_with_wave(9);
  WavySurface fine = plane_with_wave(40);
  flip_half(fine.waves, 2);
  const std::vector<Complex> z = plane_phases(coarse);
  const auto carried = carried_phases(last_of(coarse, z), fine.mesh, fine.waves);
  const auto expected = plane_phases(fine);
  for (std::size_t i = 0; i < carried.size(); ++i) {
    EXPECT_LT(angle_between(carried[i], expected[i]), 1e-3) << i;
  }
}

TEST(CarriedPhases, RunOnBeyondTheBorderForAPeriod) {
  const WavySurface plane = plane_with_wave(20);
  const BoundingBox box = bounding_box(plane.mesh);
  const auto at_distance = [&](float distance, double max_periods) {
    Mesh mesh{{Vec3(box.upper.x() + distance, box.center().y(), 0)}, {}};
    const WaveSet waves{mesh.positions, {Vec3(0.8f, 0.6f, 0)}, {3.0f}};
    const std::vector<Complex> z = plane_phases(plane);
    const Complex carried = carried_phases(last_of(plane, z), mesh, waves, max_periods)[0];
    if (carried != Complex(0)) {
      EXPECT_LT(angle_between(carried, plane_phase(mesh.positions[0], waves.directions[0])), 1e-3);
    }
    return carried != Complex(0);
  };
  EXPECT_TRUE(at_distance(0.3f, 1));
  EXPECT_FALSE(at_distance(0.36f, 1)) << "a period is a third";
  EXPECT_TRUE(at_distance(0.36f, 2));
}

TEST(CarriedPhases, HeedOrigins) {
  const WavySurface plane = plane_with_wave(20);
  const std::vector<Complex> z = plane_phases(plane);
  Mesh moved = plane.mesh;
  moved.origin = {1e6, 2, 3};
  WaveSet waves = plane.waves;
  for (std::size_t i = 0; i < waves.positions.size(); ++i) {
    waves.positions[i] = moved.positions[i] += Vec3(0.125f, 0, 0);
  }
  Mesh last = plane.mesh;
  last.origin = {1e6 + 0.125, 2, 3};
  const auto carried = carried_phases({last, plane.waves, z}, moved, waves);
  for (std::size_t i = 0; i < z.size(); ++i) EXPECT_LT(angle_between(carried[i], z[i]), 1e-3);
}

TEST(CarriedPhases, AreZeroWhereAWaveIsMissing) {
  WavySurface last = plane_with_wave(10);
  std::vector<Complex> z = plane_phases(last);
  WavySurface now = last;
  z[3] = 0;
  z[4] = std::nanf("");
  last.waves.directions[5] = Vec3::Zero();
  now.waves.directions[6] = Vec3::Zero();
  const auto by_place = carried_phases(last_of(last, z), now.mesh, now.waves);
  const auto by_number = matched_phases(last_of(last, z), now.waves);
  for (std::size_t i = 0; i < z.size(); ++i) {
    const bool known = i < 3 || i > 6;
    EXPECT_EQ(by_number[i] != Complex(0), known) << i;
    if (!known) continue;
    EXPECT_LT(std::abs(by_place[i] - z[i]), 1e-4) << "beside what is missing";
  }
  EXPECT_EQ(by_place[6], Complex(0));
  const WavySurface far = plane_with_wave(10);
  std::ranges::fill(z, Complex(0));
  for (const Complex& phase : carried_phases(last_of(last, z), far.mesh, far.waves)) {
    EXPECT_EQ(phase, Complex(0));
  }
}

TEST(CarriedPhases, FollowCounterparts) {
  const WavySurface last = plane_with_wave(10);
  const std::vector<Complex> z = plane_phases(last);
  const WaveSet waves{last.waves.positions, std::vector<Vec3>(z.size(), Vec3(0.8f, 0.6f, 0)),
                      last.waves.frequencies};
  std::vector<Index> counterparts(z.size());
  for (Index i = 0; i < counterparts.size(); ++i) {
    counterparts[i] = static_cast<Index>(z.size()) - 1 - i;
  }
  counterparts[7] = kNoCounterpart;
  const auto carried = matched_phases(last_of(last, z), waves, counterparts);
  for (std::size_t i = 0; i < z.size(); ++i) {
    EXPECT_EQ(carried[i], i == 7 ? Complex(0) : z[z.size() - 1 - i]);
  }
  counterparts[0] = static_cast<Index>(z.size());
  EXPECT_THROW(matched_phases(last_of(last, z), waves, counterparts), Error);
  counterparts.pop_back();
  EXPECT_THROW(matched_phases(last_of(last, z), waves, counterparts), Error);
}

TEST(CarriedPhases, RefuseSizesThatDoNotMatch) {
  const WavySurface last = plane_with_wave(6), other = plane_with_wave(7);
  const std::vector<Complex> z = plane_phases(last);
  EXPECT_THROW(matched_phases(last_of(last, z), other.waves), Error);
  EXPECT_THROW(carried_phases(last_of(last, z), other.mesh, last.waves), Error);
  EXPECT_THROW(
      carried_phases({last.mesh, last.waves, std::span(z).first(3)}, last.mesh, last.waves), Error);
  EXPECT_THROW(phase_step(last.waves, z, std::span(z).first(3)), Error);
}

TEST(CarriedPhases, OfPointsRunFromTheNearest) {
  const WavySurface plane = plane_with_wave(30);
  Mesh points = plane.mesh;
  points.triangles.clear();
  const std::vector<Complex> z = plane_phases(plane);
  WavySurface other = plane_with_wave(17);
  const auto carried = carried_phases({points, plane.waves, z}, other.mesh, other.waves);
  const auto expected = plane_phases(other);
  for (std::size_t i = 0; i < carried.size(); ++i) {
    EXPECT_LT(angle_between(carried[i], expected[i]), 1e-3);
  }
}

TEST(PhaseStep, IsTheMeanOfKnownOnes) {
  const WaveSet waves{std::vector<Vec3>(4, Vec3::Zero()),
                      {Vec3::UnitX(), Vec3::UnitX(), Vec3::UnitX(), Vec3::Zero()},
                      std::vector<float>(4, 1.0f)};
  const std::vector<Complex> z = {std::polar(1.0f, 0.2f), std::polar(1.0f, 3.0f), 1, 1};
  const std::vector<Complex> last = {1, std::polar(1.0f, -3.0f), 0, 0};
  const PhaseStep step = phase_step(waves, z, last);
  EXPECT_NEAR(step.mean, (0.2 + (2 * std::numbers::pi - 6)) / 2, 1e-6);
  EXPECT_EQ(step.unmatched, 1u);
}

// A sphere with other vertices and triangles at every step.

/// Waves on a round sphere at a step: spirals around an axis that turns. They close nowhere, so
/// that stripes must branch.
WavySurface spiral_waves(Mesh mesh, int step) {
  for (Vec3& position : mesh.positions) position.normalize();
  const float angle = 0.01f * static_cast<float>(step);
  const Vec3 axis(std::cos(angle), std::sin(angle), 0.3f);
  WavySurface sphere = wavy_surface(std::move(mesh), axis, 18);
  sphere.waves.directions = rotated(sphere.waves.directions, sphere.normals, 0.6f);
  return sphere;
}

WavySurface sphere_at(int step) {
  Mesh mesh = make_shape("sphere,resolution=" + std::to_string(26 + 2 * (step % 4)));
  std::mt19937 random(static_cast<unsigned>(step));
  std::normal_distribution<float> any;
  const Eigen::Quaternionf turn =
      Eigen::Quaternionf(any(random), any(random), any(random), any(random)).normalized();
  for (Vec3& position : mesh.positions) position = turn * position;
  return spiral_waves(std::move(mesh), step);
}

/// Points in common, with the waves that they have at a step.
WavySurface probes_at(int step) { return spiral_waves(make_shape("sphere,resolution=20"), step); }

struct Means {
  double step = 0, energy = 0;
};

/// Twenty steps, each following the one before with weight lambda.
Means play(float lambda) {
  constexpr int kSteps = 20;
  Means means;
  WavySurface last;
  std::vector<Complex> last_z, last_probed;
  for (int step = 0; step < kSteps; ++step) {
    WavySurface now = sphere_at(step);
    AnimatorOptions options;
    options.lambda = lambda;
    StripeAnimator animator(now.neighborhood, options);
    if (step > 0) {
      const auto carried = carried_phases(last_of(last, last_z), now.mesh, now.waves);
      animator.set_last_phases(carried);
    }
    const auto frame =
        animator.frame({now.waves.positions, now.waves.directions, now.waves.frequencies});
    last_z.assign(frame.z.begin(), frame.z.end());
    means.energy += energy(now.graph(), last_z) / kSteps;
    last = std::move(now);
    const WavySurface probes = probes_at(step);
    const auto probed = carried_phases(last_of(last, last_z), probes.mesh, probes.waves);
    if (step > 0) means.step += phase_step(probes.waves, probed, last_probed).mean / (kSteps - 1);
    last_probed = probed;
  }
  return means;
}

TEST(CarriedPhases, KeepStripesTogetherWhereTrianglesChange) {
  const Means anchored = play(0.025f), scratch = play(0);
  EXPECT_LT(anchored.step, 0.25 * scratch.step);
  EXPECT_LT(anchored.energy, 1.1 * scratch.energy);
}

TEST(CarriedPhases, ByNumberAndByPlaceEndInOnePattern) {
  const WavySurface first = wavy_surface("trefoil,resolution=60", kAxis, 24);
  const std::vector<Complex> z = solved(first);
  WavySurface next = first;
  next.waves.directions = rotated(first.waves.directions, first.normals, 0.03f);
  const auto follow = [&](const std::vector<Complex>& last_z) {
    StripeAnimator animator(next.neighborhood);
    animator.set_last_phases(last_z);
    const auto frame =
        animator.frame({next.waves.positions, next.waves.directions, next.waves.frequencies});
    return std::vector<Complex>(frame.z.begin(), frame.z.end());
  };
  const auto by_number = follow(matched_phases(last_of(first, z), next.waves));
  const auto by_place = follow(carried_phases(last_of(first, z), next.mesh, next.waves));
  EXPECT_LT(phase_step(next.waves, by_number, by_place).mean, 1e-3);
}

TEST(StripePattern, StaysNearToItsLastPhases) {
  const Surface surface = make_surface(make_shape("trefoil,resolution=60"));
  const WavySurface wavy = wavy_surface("trefoil,resolution=60", kAxis, 24);
  StripeOptions options;
  const StripePattern first = stripe_pattern(surface, wavy.waves, options);
  WaveSet next = wavy.waves;
  next.directions = rotated(next.directions, surface.normals, 0.05f);
  const StripePattern scratch = stripe_pattern(surface, next, options);
  options.last_phases = matched_phases({surface.mesh, wavy.waves, first.solution.z}, next);
  const auto step = [&](const StripePattern& pattern) {
    return phase_step(next, pattern.solution.z, options.last_phases).mean;
  };
  const StripePattern anchored = stripe_pattern(surface, next, options);
  EXPECT_LT(step(anchored), 0.5 * step(scratch));
  EXPECT_LT(anchored.solution.energy, 1.25 * scratch.solution.energy);
  options.lambda = 1e4f;
  EXPECT_LT(step(stripe_pattern(surface, next, options)), 1e-3);
  options.lambda = 0;
  EXPECT_EQ(stripe_pattern(surface, next, options).solution.z, scratch.solution.z);
}

TEST(StripePattern, RefusesLastPhasesThatAreNone) {
  const Surface surface = make_surface(make_shape("torus,resolution=20"));
  const WavySurface wavy = wavy_surface("torus,resolution=20", kAxis, 10);
  StripeOptions options;
  options.last_phases.assign(surface.mesh.vertex_count() - 1, Complex(1));
  EXPECT_THROW(stripe_pattern(surface, wavy.waves, options), Error);
  options.last_phases.assign(surface.mesh.vertex_count(), Complex(2));
  EXPECT_THROW(stripe_pattern(surface, wavy.waves, options), Error);
  options.last_phases.assign(surface.mesh.vertex_count(), Complex(1));
  options.lambda = -1;
  EXPECT_THROW(stripe_pattern(surface, wavy.waves, options), Error);
  options.lambda = 0.1f;
  options.solver.solver = Solver::relaxation;
  EXPECT_THROW(stripe_pattern(surface, wavy.waves, options), Error);
}

}  // namespace
}  // namespace brindle
