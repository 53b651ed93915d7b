#include "brindle/pattern/triangle_kernels.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/fragment_phase.h"
#include "brindle/quality.h"
#include "instruction_sets.h"
#include "phase_graphs.h"

namespace brindle {
namespace {

constexpr double kPi = std::numbers::pi;

/// Corner phases as corner_phases.h defines them, with the angles of the standard library.
CornerPhases expected_phases(std::array<CornerWave, 3> corners, PhaseShiftKind kind) {
  CornerPhases result;
  for (const CornerWave& corner : corners) {
    if (corner.wave.direction.isZero(0)) return result;
  }
  const auto signs = common_orientation(
      {corners[0].wave.direction, corners[1].wave.direction, corners[2].wave.direction});
  result.kind = TriangleKind::field_singularity;
  if (!signs) return result;
  float step[3];
  for (int m = 0; m < 3; ++m) {
    if ((*signs)[m] < 0) corners[m] = flipped(corners[m]);
    result.sign[m] = static_cast<std::int8_t>((*signs)[m]);
  }
  for (int m = 0; m < 3; ++m) {
    const CornerWave &j = corners[m], &i = corners[(m + 1) % 3];
    const float shift = phase_shift(kind, j.wave, i.wave).radians;
    const float rest = std::arg(i.z * std::conj(j.z)) - shift;
    constexpr float kPeriod = 6.28318530718f;
    step[m] = shift + rest - kPeriod * std::round(rest / kPeriod);
  }
  result.phase = {std::arg(corners[0].z), 0, 0};
  for (int m = 0; m < 2; ++m) result.phase[m + 1] = result.phase[m] + step[m];
  result.branch_index =
      static_cast<std::int8_t>(std::lround((step[0] + step[1] + step[2]) / (2 * kPi)));
  result.kind = result.branch_index == 0 ? TriangleKind::regular : TriangleKind::branch;
  return result;
}

testing_support::WavySurface coarse_surface(const std::string& shape) {
  return testing_support::wavy_surface(shape, testing_support::kAxis, 20);
}

struct NamedSurface {
  std::string name;
  testing_support::WavySurface surface;
};

/// Every built-in shape, with stripes along an axis.
const std::vector<NamedSurface>& all_surfaces() {
  static const std::vector<NamedSurface> surfaces = [] {
    std::vector<NamedSurface> made;
    for (const std::string& name : shape_names()) made.push_back({name, coarse_surface(name)});
    return made;
  }();
  return surfaces;
}

std::vector<Complex> random_phases(std::size_t count, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> angle(-4, 4);
  std::vector<Complex> z(count);
  for (Complex& value : z) value = std::polar(1.0f, angle(random));
  return z;
}

void expect_same_phases(const CornerPhases& a, const CornerPhases& b, float tolerance) {
  ASSERT_EQ(a.kind, b.kind);
  ASSERT_EQ(a.branch_index, b.branch_index);
  ASSERT_EQ(a.sign, b.sign);
  for (int m = 0; m < 3; ++m) {
    ASSERT_NEAR(a.phase[m], b.phase[m], tolerance * (1 + std::abs(b.phase[m])));
  }
}

TEST(TriangleKernels, AnglesAreThoseOfTheStandardLibrary) {
  std::mt19937 random(1);
  std::normal_distribution<float> component;
  for (int n = 0; n < 100000; ++n) {
    const Complex z(component(random), n % 3 == 0 ? 1e-4f * component(random) : component(random));
    ASSERT_NEAR(portable::phase_angle(z), std::arg(z), 3e-7f) << z;
    ASSERT_NEAR(portable::phase_angle(std::conj(z)), -portable::phase_angle(z), 0) << z;
  }
  for (const float re : {-1.0f, -0.0f, 0.0f, 1.0f}) {
    for (const float im : {-1.0f, -0.0f, 0.0f, 1.0f}) {
      EXPECT_EQ(portable::phase_angle({re, im}), std::atan2(im, re)) << re << ' ' << im;
    }
  }
}

TEST(TriangleKernels, CornerPhasesAreAsDefinedOnEveryShape) {
  std::uint32_t seed = 0;
  for (auto [shape, surface] : all_surfaces()) {
    testing_support::flip_half(surface.waves, ++seed);
    surface.waves.directions[seed].setZero();
    const auto z = random_phases(surface.mesh.vertex_count(), seed);
    for (const PhaseShiftKind kind :
         {PhaseShiftKind::aligned, PhaseShiftKind::trapezoid, PhaseShiftKind::common_source}) {
      const auto corners = corner_phases(surface.mesh.triangles, surface.waves, z, kind);
      for (std::size_t t = 0; t < corners.size(); t += 3) {
        const auto waves = corner_waves(surface.mesh.triangles[t], surface.waves, z);
        expect_same_phases(corners[t], expected_phases(waves, kind), 1e-6f);
        expect_same_phases(corners[t], corner_phases(waves, kind), 0);
        if (HasFatalFailure()) FAIL() << shape << ", triangle " << t;
      }
    }
  }
}

/// As the errors are defined, in double precision.
double expected_angle_deg(const Mesh& mesh, const WaveSet& waves, const Triangle& triangle,
                          const CornerPhases& corners) {
  using Vec3d = Eigen::Vector3d;
  const auto at = [&](int m) -> Vec3d { return mesh.positions[triangle[m]].cast<double>(); };
  const Vec3d normal = (at(1) - at(0)).cross(at(2) - at(0));
  if (normal.isZero(0)) return 0;
  Vec3d direction = Vec3d::Zero();
  for (int m = 0; m < 3; ++m) {
    direction += corners.sign[m] * waves.directions[triangle[m]].cast<double>();
  }
  const Vec3d slope = normal.cross(double{corners.phase[2] - corners.phase[0]} * (at(1) - at(0)) -
                                   double{corners.phase[1] - corners.phase[0]} * (at(2) - at(0)));
  direction -= direction.dot(normal) / normal.squaredNorm() * normal;
  // Of lines, which have no sign.
  return std::atan2(slope.cross(direction).norm(), std::abs(slope.dot(direction))) * 180 / kPi;
}

TEST(TriangleKernels, ErrorsAreAsDefinedOnEveryShape) {
  std::uint32_t seed = 0;
  for (const auto& [shape, surface] : all_surfaces()) {
    const auto z = random_phases(surface.mesh.vertex_count(), ++seed);
    const auto corners =
        corner_phases(surface.mesh.triangles, surface.waves, z, PhaseShiftKind::aligned);
    const auto errors = angle_errors_deg(surface.mesh, surface.waves, corners);
    for (std::size_t t = 0; t < corners.size(); ++t) {
      if (corners[t].kind != TriangleKind::regular) {
        EXPECT_EQ(errors[t], -1);
        continue;
      }
      ASSERT_NEAR(
          errors[t],
          expected_angle_deg(surface.mesh, surface.waves, surface.mesh.triangles[t], corners[t]),
          2e-3)
          << shape << ", triangle " << t;
    }
  }
}

TEST(TriangleKernels, ErrorsDoNotDependOnTheUnitOfLength) {
  for (const float scale : {1e-12f, 1e-7f, 1e6f, 1e12f}) {
    auto surface = coarse_surface("torus,resolution=20");
    const auto z = random_phases(surface.mesh.vertex_count(), 5);
    const auto quality = [&] {
      return measure_quality(
          surface.mesh, surface.waves,
          corner_phases(surface.mesh.triangles, surface.waves, z, PhaseShiftKind::aligned));
    };
    const PatternQuality before = quality();
    // The gradient itself needs squares of areas.
    const bool representable = scale > 1e-9f && scale < 1e9f;
    for (Vec3& position : surface.mesh.positions) position *= scale;
    surface.waves.positions = surface.mesh.positions;
    for (float& frequency : surface.waves.frequencies) frequency /= scale;
    const PatternQuality after = quality();
    EXPECT_EQ(after.branches, before.branches) << scale;
    if (!representable) continue;
    EXPECT_NEAR(after.angle_error_mean_deg, before.angle_error_mean_deg, 1e-3) << scale;
    EXPECT_NEAR(after.spacing_error_mean, before.spacing_error_mean, 1e-4) << scale;
  }
}

TEST(CornerPhases, OfWhatIsNoNumberAreNoWave) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const WaveSet waves{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},
                      std::vector<Vec3>(3, Vec3(1, 0, 0)),
                      std::vector<float>(3, 1.0f)};
  for (const Complex bad : {Complex(nan, 0), Complex(0, nan)}) {
    const CornerPhases corners = corner_phases(
        corner_waves({0, 1, 2}, waves, std::vector<Complex>{1, 1, bad}), PhaseShiftKind::aligned);
    EXPECT_EQ(corners.kind, TriangleKind::no_wave);
    EXPECT_EQ(corners.phase, (std::array<float, 3>{}));
  }
}

TEST(CornerPhases, AnIndexBeyondAByteStaysABranch) {
  // Directions that turn by 90 degrees over one edge at a frequency of thousands.
  const WaveSet waves{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},
                      {Vec3(1, 0, 0), Vec3(0.6f, 0.8f, 0), Vec3(1, 0, 0)},
                      std::vector<float>(3, 5000.0f)};
  const CornerPhases corners = corner_phases(
      corner_waves({0, 1, 2}, waves, std::vector<Complex>(3, 1)), PhaseShiftKind::aligned);
  EXPECT_EQ(corners.kind, TriangleKind::branch);
  EXPECT_EQ(std::abs(corners.branch_index), 127);
}

TEST(TriangleKernels, PhaseDistancesAreThoseOfTheStandardLibrary) {
  const auto a = random_phases(kTriangleLanes, 3), b = random_phases(kTriangleLanes, 4);
  alignas(64) std::array<float, kTriangleLanes> distances, portable_distances;
  triangle_kernels::phase_distances(a.data(), b.data(), distances.data());
  portable::phase_distances(a.data(), b.data(), portable_distances.data());
  EXPECT_EQ(distances, portable_distances);
  for (std::size_t i = 0; i < kTriangleLanes; ++i) {
    EXPECT_NEAR(distances[i], std::abs(std::arg(a[i] * std::conj(b[i]))), 4e-7f);
  }
}

#ifdef BRINDLE_HAS_HIGHWAY

/// What random numbers seldom hit: missing waves, right angles, phases exactly at the ends of a
/// period, shifts of exactly half a period, and what is no number.
CornerLanes adversarial_corners(std::mt19937& random) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  const auto one_of = [&](std::initializer_list<float> values) {
    return values.begin()[random() % values.size()];
  };
  const bool harmless = random() % 2;
  CornerLanes corners;
  for (std::size_t lane = 0; lane < kTriangleLanes; ++lane) {
    for (std::size_t m = 0; m < 3; ++m) {
      const auto number = [&] {
        return harmless ? one_of({0, -0.0f, 1, -1, 2})
                        : one_of({0, -0.0f, 1, -1, 0.6f, -0.8f, 1e-30f, 1e30f, nan, infinity});
      };
      corners.set(lane, m, {number(), number(), number()}, {number(), number(), number()},
                  harmless ? one_of({0.25f, 0.5f, 1}) : one_of({0.5f, 3, 1e20f, 0, -1, nan}));
      corners.set_phase(lane, m, {number(), number()});
    }
  }
  return corners;
}

template <class Lanes>
void expect_same_bits(const Lanes& a, const Lanes& b) {
  constexpr std::size_t kCount = sizeof(Lanes) / sizeof(float);
  std::array<float, kCount> x, y;
  std::memcpy(x.data(), &a, sizeof(Lanes));
  std::memcpy(y.data(), &b, sizeof(Lanes));
  for (std::size_t i = 0; i < kCount; ++i) {
    if (std::isnan(x[i]) && std::isnan(y[i])) continue;
    ASSERT_EQ(std::bit_cast<std::uint32_t>(x[i]), std::bit_cast<std::uint32_t>(y[i]))
        << i << ": " << x[i] << " and " << y[i];
  }
}

void expect_vectors_like_portable_code(const CornerLanes& corners) {
  for (const PhaseShiftKind kind : {PhaseShiftKind::aligned, PhaseShiftKind::trapezoid}) {
    LiftedLanes a, b;
    portable::lift_corners(corners, kind, nullptr, a);
    simd::lift_corners(corners, kind, nullptr, b);
    expect_same_bits(a, b);
    ErrorLanes errors_a, errors_b;
    portable::measure_errors(corners, a, errors_a);
    simd::measure_errors(corners, b, errors_b);
    expect_same_bits(errors_a, errors_b);
    // V is U with its corners the other way round.
    LiftedLanes v = a;
    DensityLanes density;
    for (std::size_t lane = 0; lane < kTriangleLanes; ++lane) {
      for (std::size_t m = 0; m < 3; ++m) {
        v.phase[m][lane] = a.phase[2 - m][lane];
        density.u[m][lane] = corners.frequency[m][lane];
        density.v[m][lane] = corners.frequency[2 - m][lane];
      }
    }
    DistortionLanes distortions_a, distortions_b;
    portable::measure_distortions(corners, a, v, density, distortions_a);
    simd::measure_distortions(corners, a, v, density, distortions_b);
    expect_same_bits(distortions_a, distortions_b);
  }
}

void expect_vectors_like_portable_code_on_every_shape() {
  std::uint32_t seed = 0;
  for (auto [shape, surface] : all_surfaces()) {
    testing_support::flip_half(surface.waves, ++seed);
    const auto z = random_phases(surface.mesh.vertex_count(), seed);
    for (std::size_t t = 0; t + kTriangleLanes <= surface.mesh.triangle_count();
         t += kTriangleLanes) {
      CornerLanes corners;
      for (std::size_t lane = 0; lane < kTriangleLanes; ++lane) {
        for (std::size_t m = 0; m < 3; ++m) {
          const Wave wave = surface.waves.wave(surface.mesh.triangles[t + lane][m]);
          corners.set(lane, m, wave.position, wave.direction, wave.frequency);
          corners.set_phase(lane, m, z[surface.mesh.triangles[t + lane][m]]);
        }
      }
      expect_vectors_like_portable_code(corners);
      if (testing::Test::HasFatalFailure()) FAIL() << shape << ", triangles from " << t;
    }
  }
}

TEST(TriangleKernels, VectorsGiveTheBitsOfPortableCodeOnEveryShape) {
  testing_support::on_every_instruction_set(
      [] { expect_vectors_like_portable_code_on_every_shape(); });
}

TEST(TriangleKernels, VectorsGiveTheBitsOfPortableCodeForWhatRandomNumbersSeldomHit) {
  testing_support::on_every_instruction_set([] {
    std::mt19937 random(7);
    for (int n = 0; n < 2000; ++n) {
      expect_vectors_like_portable_code(adversarial_corners(random));
      if (testing::Test::HasFatalFailure()) FAIL() << n;
    }
  });
}

#endif

}  // namespace
}  // namespace brindle
