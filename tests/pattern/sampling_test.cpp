#include "brindle/pattern/sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "brindle/base/elementary.h"
#include "brindle/base/parallel.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/solver.h"
#include "phase_graphs.h"
#include "test_folder.h"

namespace brindle {
namespace {

using testing_support::flip_half;
using testing_support::wavy_surface;
using testing_support::WavySurface;

/// Two patterns on one surface.
struct Crossed {
  WavySurface surface;  // with the waves of U
  WaveSet v;
  std::vector<Complex> z_u, z_v;
  MeshEdges edges = mesh_edges(surface.mesh, *surface.neighborhood);

  WavePattern pattern(bool second) const {
    return {surface.mesh, edges, surface.normals, second ? v : surface.waves, second ? z_v : z_u};
  }
  std::vector<Sample> samples() const {
    const LiftedWaves u(pattern(false)), w(pattern(true));
    return wave_samples(u, w);
  }
};

WaveSet turned(const WavySurface& surface, float frequency_factor) {
  WaveSet v = surface.waves;
  v.directions = rotated(v.directions, surface.normals, std::numbers::pi_v<float> / 2);
  for (float& f : v.frequencies) f *= frequency_factor;
  return v;
}

std::vector<Complex> plane_phases(const WaveSet& waves, float phase) {
  std::vector<Complex> z;
  for (std::size_t i = 0; i < waves.positions.size(); ++i) {
    z.push_back(std::polar(
        1.0f, phase + kTwoPi * waves.frequencies[i] * waves.directions[i].dot(waves.positions[i])));
  }
  return z;
}

/// Plane waves with known peaks: a perfect grid.
Crossed grid(const Vec3& axis, float stripes, float factor_v, float phase = 0) {
  WavySurface surface = wavy_surface("plane,resolution=12", axis, stripes);
  WaveSet v = turned(surface, factor_v);
  auto z_u = plane_phases(surface.waves, phase), z_v = plane_phases(v, phase);
  return {std::move(surface), std::move(v), std::move(z_u), std::move(z_v)};
}

Crossed solved(WavySurface surface, float factor_v = 1) {
  WaveSet v = turned(surface, factor_v);
  auto z_u = solve_phases(surface.graph()).z;
  auto z_v = solve_phases(build_phase_graph(surface.neighborhood, v)).z;
  return {std::move(surface), std::move(v), std::move(z_u), std::move(z_v)};
}

/// The grid's points inside the rectangle, by counting.
std::size_t expected_grid_points(const Crossed& crossed, float phase) {
  const Vec3 d_u = crossed.surface.waves.directions[0], d_v = crossed.v.directions[0];
  const float f_u = crossed.surface.waves.frequencies[0], f_v = crossed.v.frequencies[0];
  const BoundingBox box = bounding_box(crossed.surface.mesh);
  std::size_t count = 0;
  for (int i = -400; i <= 400; ++i) {
    for (int j = -400; j <= 400; ++j) {
      const float shift = 0.25f - phase / kTwoPi;
      const Vec3 p =
          (static_cast<float>(i) + shift) / f_u * d_u + (static_cast<float>(j) + shift) / f_v * d_v;
      count += std::abs(p.x()) < box.upper.x() && std::abs(p.y()) < box.upper.y();
    }
  }
  return count;
}

TEST(WaveSamples, OfPlaneWavesAreAPerfectGrid) {
  for (const float stripes : {5.0f, 30.0f, 120.0f}) {
    const Crossed crossed = grid(Vec3(1, 0.5f, 0), stripes, 1.7f, 0.3f);
    const std::vector<Sample> samples = crossed.samples();
    EXPECT_EQ(samples.size(), expected_grid_points(crossed, 0.3f));
    const float f_u = crossed.surface.waves.frequencies[0], f_v = crossed.v.frequencies[0];
    for (const Sample& s : samples) {
      const float u = f_u * crossed.surface.waves.directions[0].dot(s.position) + 0.3f / kTwoPi;
      const float v = f_v * crossed.v.directions[0].dot(s.position) + 0.3f / kTwoPi;
      EXPECT_NEAR(u - 0.25f, std::round(u - 0.25f), 2e-3f);
      EXPECT_NEAR(v - 0.25f, std::round(v - 0.25f), 2e-3f);
      EXPECT_NEAR(s.spacing_u, 1 / f_u, 1e-5f);
      EXPECT_NEAR(s.spacing_v, 1 / f_v, 1e-5f);
      EXPECT_NEAR(std::abs(s.direction_u.dot(crossed.surface.waves.directions[0])), 1, 1e-5f);
      EXPECT_NEAR(s.direction_u.dot(s.direction_v), 0, 1e-5f);
      EXPECT_NEAR(std::abs(s.normal.z()), 1, 1e-5f);
    }
  }
}

TEST(WaveSamples, LieInTheirTriangles) {
  const Crossed crossed = solved(wavy_surface("torus,resolution=64", Vec3(0.2f, 0.3f, 1), 40));
  const std::vector<Sample> samples = crossed.samples();
  EXPECT_GT(samples.size(), 500u);
  for (const Sample& s : samples) {
    EXPECT_GE(s.barycentric.minCoeff(), 0);
    EXPECT_NEAR(s.barycentric.sum(), 1, 1e-5f);
    Vec3 p = Vec3::Zero();
    const Triangle& t = crossed.surface.mesh.triangles[s.triangle];
    for (int m = 0; m < 3; ++m) p += s.barycentric[m] * crossed.surface.mesh.positions[t[m]];
    EXPECT_LT((p - s.position).norm(), 1e-5f);
    EXPECT_NEAR(s.normal.norm(), 1, 1e-5f);
    EXPECT_NEAR(s.direction_u.dot(s.normal), 0, 1e-4f);
  }
}

/// 17 x 17 vertices at whole coordinates, every square cut into two triangles one way or the other.
WavySurface whole_numbers() {
  WavySurface surface;
  for (int i = 0; i < 17 * 17; ++i) {
    surface.mesh.positions.emplace_back(static_cast<float>(i % 17), static_cast<float>(i / 17),
                                        0.0f);
  }
  for (Index y = 0; y < 16; ++y) {
    for (Index x = 0; x < 16; ++x) {
      const Index a = 17 * y + x, b = a + 1, c = a + 18, d = a + 17;
      const bool other = (x + y / 2) % 2;
      surface.mesh.triangles.push_back(other ? Triangle{a, b, d} : Triangle{a, b, c});
      surface.mesh.triangles.push_back(other ? Triangle{b, c, d} : Triangle{a, c, d});
    }
  }
  surface.normals = vertex_normals(surface.mesh);
  surface.neighborhood = std::make_shared<const Adjacency>(vertex_neighborhood(surface.mesh));
  surface.waves = {surface.mesh.positions, std::vector<Vec3>(17 * 17, Vec3(1, 0, 0)),
                   std::vector<float>(17 * 17, 0.25f)};
  return surface;
}

TEST(WaveSamples, OnEdgesAndVerticesAreFoundOnce) {
  // The peaks of both waves run exactly through every fourth row and column of vertices.
  WavySurface surface = whole_numbers();
  WaveSet v = surface.waves;
  for (Vec3& d : v.directions) d = Vec3(0, 1, 0);
  const auto exact_phases = [&](int axis) {
    const std::array<Complex, 4> phases = {Complex(0, 1), Complex(-1, 0), Complex(0, -1),
                                           Complex(1, 0)};
    std::vector<Complex> z;
    for (const Vec3& p : surface.mesh.positions) {
      z.push_back(phases[static_cast<std::size_t>(p[axis]) % 4]);
    }
    return z;
  };
  auto z_u = exact_phases(0), z_v = exact_phases(1);
  const Crossed crossed{std::move(surface), std::move(v), std::move(z_u), std::move(z_v)};
  // A vertex on a peak counts as just beyond it: peaks at 4, 8, 12 and 16 are inside, those at 0
  // are not.
  const std::vector<Sample> samples = crossed.samples();
  EXPECT_EQ(samples.size(), 16u);
  std::set<std::pair<long, long>> places;
  for (const Sample& s : samples) {
    places.insert({std::lround(s.position.x()), std::lround(s.position.y())});
    EXPECT_NEAR(s.position.x(), std::round(s.position.x() / 4) * 4, 1e-3f);
    EXPECT_NEAR(s.position.y(), std::round(s.position.y() / 4) * 4, 1e-3f);
  }
  EXPECT_EQ(places.size(), 16u);
}

TEST(WaveSamples, SoManyThatNothingHoldsThemAreRefused) {
  for (const float factor : {1e4f, 1e9f}) {
    Crossed crossed = grid(Vec3(1, 0.5f, 0), 30, 1);
    for (float& frequency : crossed.surface.waves.frequencies) frequency *= factor;
    for (float& frequency : crossed.v.frequencies) frequency *= factor;
    EXPECT_THROW(crossed.samples(), Error) << factor;
  }
}

#ifdef BRINDLE_HAS_NANOFLANN
TEST(WaveSamples, CrossingsOfLinesAreEvenInNumberAlongClosedCurves) {
  // On a sphere two closed curves cross an even number of times; with branches and singularities
  // only a count over all is known: that neighbouring triangles neither lose nor repeat one shows
  // in samples that stay apart.
  const Crossed crossed =
      solved(wavy_surface("sphere,resolution=24", Vec3(0.1f, 1, 0.2f), 60), 0.5f);
  std::vector<Sample> samples = crossed.samples();
  const SampleSpacing spacing = measure_sample_spacing(samples);
  EXPECT_LT(spacing.double_share, 0.01);
  const std::size_t before = samples.size();
  const std::size_t dropped = drop_doubles(samples);
  EXPECT_EQ(samples.size() + dropped, before);
  EXPECT_LT(dropped, before / 50);
  EXPECT_EQ(measure_sample_spacing(samples).double_share, 0);
}
#endif

TEST(WaveSamples, DoNotCareWhichWayDirectionsPointNorForThreads) {
  Crossed crossed = solved(wavy_surface("torus,resolution=48", Vec3(0.2f, 0.3f, 1), 30));
  const std::vector<Sample> before = crossed.samples();
  const auto turned_u = flip_half(crossed.surface.waves, 9);
  const auto turned_v = flip_half(crossed.v, 10);
  for (std::size_t i = 0; i < turned_u.size(); ++i) {
    if (turned_u[i]) crossed.z_u[i] = -std::conj(crossed.z_u[i]);
    if (turned_v[i]) crossed.z_v[i] = -std::conj(crossed.z_v[i]);
  }
  const ThreadLimit one(1);
  const std::vector<Sample> after = crossed.samples();
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(before[i].position, after[i].position);
    EXPECT_EQ(before[i].triangle, after[i].triangle);
  }
}

TEST(WaveSamples, HigherFrequencyGivesDenserSamples) {
  Crossed crossed = grid(Vec3(1, 0, 0), 20, 1);
  for (std::size_t i = 0; i < crossed.z_u.size(); ++i) {
    const bool important = crossed.surface.mesh.positions[i].x() > 0;
    crossed.surface.waves.frequencies[i] *= important ? 2 : 1;
    crossed.v.frequencies[i] *= important ? 2 : 1;
  }
  crossed.z_u = solve_phases(crossed.surface.graph()).z;
  crossed.z_v = solve_phases(build_phase_graph(crossed.surface.neighborhood, crossed.v)).z;
  std::size_t left = 0, right = 0;
  for (const Sample& s : crossed.samples()) {
    left += s.position.x() < -0.1f;
    right += s.position.x() > 0.1f;
  }
  EXPECT_NEAR(static_cast<double>(right) / static_cast<double>(left), 4, 0.6);
}

TEST(WaveSamples, NoneInSingularitiesOfTheField) {
  for (const char* shape : {"sphere,resolution=12", "box,resolution=20"}) {
    const WavySurface surface = wavy_surface(shape, Vec3(0.31f, 0.9f, 0.27f), 60);
    const Crossed crossed = solved(surface);
    const std::vector<Sample> samples = crossed.samples();
    EXPECT_GT(samples.size(), 500u);
    std::ptrdiff_t singular = 0;
    for (const WaveSet* waves : {&crossed.surface.waves, &crossed.v}) {
      const auto is_singular = [&](const Triangle& t) {
        const DirectionField& d = waves->directions;
        return !common_orientation({d[t[0]], d[t[1]], d[t[2]]});
      };
      singular += std::ranges::count_if(surface.mesh.triangles, is_singular);
      EXPECT_TRUE(std::ranges::none_of(samples, [&](const Sample& sample) {
        return is_singular(surface.mesh.triangles[sample.triangle]);
      })) << shape;
    }
    EXPECT_GT(singular, 0) << shape;
  }
}

TEST(WaveSamples, NoneWhereAPatternHasNoWaves) {
  Crossed crossed = grid(Vec3(1, 0.5f, 0), 30, 1);
  for (Vec3& d : crossed.v.directions) d.setZero();
  EXPECT_TRUE(crossed.samples().empty());
}

#ifdef BRINDLE_HAS_NANOFLANN
TEST(SampleSpacing, OfAPerfectGridIsOne) {
  const SampleSpacing spacing = measure_sample_spacing(grid(Vec3(1, 0.5f, 0), 30, 1.5f).samples());
  EXPECT_GT(spacing.samples, 100u);
  EXPECT_NEAR(spacing.mean, 1, 1e-3);
  EXPECT_NEAR(spacing.deviation, 0, 1e-3);
  EXPECT_EQ(spacing.double_share, 0);
}

TEST(SampleSpacing, FindsDoubles) {
  std::vector<Sample> samples = grid(Vec3(1, 0.5f, 0), 30, 1).samples();
  const std::size_t before = samples.size();
  samples.push_back(samples[3]);
  EXPECT_NEAR(measure_sample_spacing(samples).double_share, 2.0 / static_cast<double>(before + 1),
              1e-9);
  EXPECT_EQ(drop_doubles(samples), 1u);
  EXPECT_EQ(samples.size(), before);
  EXPECT_EQ(drop_doubles(samples, 0), 0u);
}

TEST(SampleSpacing, OfRealModelsHasNoDoubles) {
  const std::string path = BRINDLE_SHARED_MODELS "/spot.obj";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
  WavySurface surface;
  surface.mesh = read_mesh(path).mesh;
  surface.normals = vertex_normals(surface.mesh);
  surface.neighborhood = std::make_shared<const Adjacency>(vertex_neighborhood(surface.mesh));
  for (const float stripes : {20.0f, 100.0f}) {
    surface.waves = {surface.mesh.positions,
                     projected_direction_field(Vec3(0, 1, 0.2f), surface.normals),
                     constant_frequency_field(
                         frequency_of_stripes(stripes, bounding_box(surface.mesh).diagonal()),
                         surface.mesh.vertex_count())};
    std::vector<Sample> samples = solved(surface).samples();
    const std::size_t count = samples.size();
    EXPECT_LT(drop_doubles(samples), count / 40);
    const SampleSpacing spacing = measure_sample_spacing(samples);
    EXPECT_EQ(spacing.double_share, 0);
    EXPECT_NEAR(spacing.mean, 0.93, 0.07);
  }
}
#endif

struct SampleIo : TestFolder {};

TEST_F(SampleIo, EveryFormatHasEverySample) {
  const std::vector<Sample> samples = grid(Vec3(1, 0.5f, 0), 10, 1).samples();
  write_samples(folder / "a.csv", samples);
  std::ifstream csv(folder / "a.csv");
  std::string line;
  std::size_t rows = 0;
  std::getline(csv, line);
  EXPECT_EQ(std::count(line.begin(), line.end(), ','), 17);
  while (std::getline(csv, line)) ++rows;
  EXPECT_EQ(rows, samples.size());

  write_samples(folder / "a.ply", samples);
  std::ifstream ply(folder / "a.ply", std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(ply), {}};
  EXPECT_EQ(text.size() - text.find("end_header\n") - 11, samples.size() * (17 * 4 + 4));

  write_samples(folder / "a.vtp", samples);
  std::ifstream vtp(folder / "a.vtp", std::ios::binary);
  std::string head(400, '\0');
  vtp.read(head.data(), 400);
  EXPECT_NE(head.find("NumberOfVerts=\"" + std::to_string(samples.size()) + "\""),
            std::string::npos);
  // Arrays are columns behind all others; one with a taken name is renamed.
  const std::vector<DataArray> arrays = {
      make_data_array("triangle", 1, std::vector<std::uint8_t>(samples.size(), 3))};
  write_samples(folder / "b.csv", samples, Eigen::Vector3d::Zero(), arrays);
  std::ifstream with_array(folder / "b.csv");
  std::getline(with_array, line);
  EXPECT_TRUE(line.ends_with(",triangle,triangle_")) << line;
  std::getline(with_array, line);
  EXPECT_TRUE(line.ends_with("," + std::to_string(samples[0].triangle) + ",3")) << line;
  EXPECT_THROW(
      write_samples(folder / "c.csv", std::span(samples).first(1), Eigen::Vector3d::Zero(), arrays),
      Error);

  // Of an origin, all formats hold doubles.
  const Eigen::Vector3d origin(500000, 5800000, 0);
  write_samples(folder / "far.ply", samples, origin);
  std::ifstream far(folder / "far.ply", std::ios::binary);
  const std::string doubles{std::istreambuf_iterator<char>(far), {}};
  EXPECT_EQ(doubles.size() - doubles.find("end_header\n") - 11,
            samples.size() * (3 * 8 + 14 * 4 + 4));
  write_samples(folder / "far.csv", samples, origin);
  std::ifstream far_csv(folder / "far.csv");
  double x = 0;
  std::getline(far_csv, line);
  far_csv >> x;
  EXPECT_DOUBLE_EQ(x, origin.x() + static_cast<double>(samples[0].position.x()));
  EXPECT_THROW(write_samples(folder / "a.obj", samples), Error);
  EXPECT_FALSE(std::filesystem::exists(folder / "a.obj"));
}

}  // namespace
}  // namespace brindle
