#include "brindle/wave_metrics.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "brindle/direction_field.h"
#include "brindle/error.h"
#include "brindle/frequency_field.h"
#include "brindle/shapes.h"
#include "brindle/waves/wave_check.h"

namespace brindle {
namespace {

WaveSet waves_along_x(const Surface& surface, float frequency) {
  return {surface.mesh.positions, projected_direction_field(Vec3(1, 0, 0), surface.normals),
          constant_frequency_field(frequency, surface.mesh.vertex_count())};
}

void check(const Surface& surface, const WaveSet& waves) {
  check_fineness(*surface.neighborhood, waves.positions, waves.directions, waves.frequencies);
}

template <class Run>
std::string message_of(const Run& run) {
  try {
    run();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(WaveMetrics, CountsEdgesAPeriod) {
  // Edges of a grid run along x by their length, by 0, or by that of the diagonal's shadow: inside,
  // four of six neighbours are an edge away along x.
  const Surface plane = make_surface(make_shape("plane,resolution=20"));
  const double edge = (plane.mesh.positions[1] - plane.mesh.positions[0]).norm();
  const WaveMetrics metrics = measure_waves(plane, waves_along_x(plane, 3));
  EXPECT_NEAR(metrics.edges_per_period_median, 1 / (3 * edge * 4 / 6), 1e-4);
  EXPECT_NEAR(metrics.stripes, 3 * bounding_box(plane.mesh).diagonal(), 1e-4);
  EXPECT_EQ(metrics.used, plane.mesh.vertex_count());
  EXPECT_EQ(metrics.without_wave, 0u);
}

TEST(WaveMetrics, WarningsTellOfMissingWaves) {
  const Surface plane = make_surface(make_shape("plane,resolution=20"));
  WaveSet waves = waves_along_x(plane, 1);
  for (std::size_t v = 0; v < 10; ++v) waves.directions[v].setZero();
  const WaveMetrics metrics = measure_waves(plane, waves);
  const std::vector<std::string> found = wave_warnings(metrics);
  ASSERT_EQ(found.size(), 1u);
  const std::string count = std::to_string(plane.mesh.vertex_count());
  EXPECT_TRUE(has(found[0], "10 of " + count + " vertices have no wave: the field is zero"))
      << found[0];
}

TEST(WaveMetrics, NoWaveAtAllIsRefused) {
  const Surface plane = make_surface(make_shape("plane,resolution=5"));
  WaveSet waves = waves_along_x(plane, 1);
  for (Vec3& d : waves.directions) d.setZero();
  EXPECT_TRUE(has(message_of([&] { check_metrics(measure_waves(plane, waves)); }),
                  "no vertex has a wave: the field is zero"));
  EXPECT_TRUE(
      has(message_of([&] { check_metrics(measure_waves(plane, waves), {}, "; 3 are far"); }),
          "no vertex has a wave; 3 are far; the field is zero, not finite or normal to the "
          "surface at all others"));
}

TEST(Fineness, WavesWhosePhasesAreRoundingErrorsAreRefusedByName) {
  const Surface plane = make_surface(make_shape("plane,resolution=20"));
  for (const float fine : {1e7f, 1e30f, 3e38f}) {
    const WaveSet waves = waves_along_x(plane, fine);
    const std::string message = message_of([&] { check(plane, waves); });
    EXPECT_TRUE(has(message, "nothing can be told of such stripes")) << message;
    EXPECT_TRUE(has(message, "whose frequency is")) << message;
    EXPECT_TRUE(has(message, "take fewer stripes")) << message;
    EXPECT_NE(message_of([&] { check_metrics(measure_waves(plane, waves)); }), "");
  }
  for (const float taken : {1e-30f, 1.0f, 1e4f}) {
    EXPECT_NO_THROW(check(plane, waves_along_x(plane, taken)));
  }
  // One alone may be a thousand times too fine, but not a million times.
  WaveSet waves = waves_along_x(plane, 1);
  waves.frequencies[123] = 1e6f;
  EXPECT_NO_THROW(check(plane, waves));
  waves.frequencies[123] = 1e30f;
  const std::string message = message_of([&] { check(plane, waves); });
  EXPECT_TRUE(has(message, "at vertex 123, whose frequency is 1e+30")) << message;
}

TEST(Fineness, DoesNotDependOnUnitsOrPlace) {
  for (const float scale : {1e-6f, 1.0f, 1e6f}) {
    Mesh mesh = make_shape("plane,resolution=20");
    for (Vec3& p : mesh.positions) p = scale * (p + Vec3(50, 0, 0));
    const Surface plane = make_surface(std::move(mesh));
    EXPECT_NO_THROW(check(plane, waves_along_x(plane, 1e3f / scale))) << scale;
    EXPECT_THROW(check(plane, waves_along_x(plane, 1e7f / scale)), Error) << scale;
  }
}

}  // namespace
}  // namespace brindle
