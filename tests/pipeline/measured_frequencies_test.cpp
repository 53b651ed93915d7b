#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/measured_field.h"
#include "brindle/shapes.h"
#include "brindle/threads.h"

namespace brindle {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// From -1 to 1.
float noise(std::size_t i) {
  const double sine = std::sin(static_cast<double>(i) * 12.9898 + 78.233) * 43758.5453;
  return static_cast<float>(2 * (sine - std::floor(sine)) - 1);
}

/// Frequencies that change slowly, of a surface in units of length that are so long.
struct Slow {
  explicit Slow(const char* shape, float unit = 1) {
    Mesh mesh = make_shape(shape);
    for (Vec3& position : mesh.positions) position *= unit;
    surface = make_surface(std::move(mesh));
    const float mean = 30 / bounding_box(surface.mesh).diagonal();
    for (const Vec3& p : surface.mesh.positions) {
      truth.push_back(mean * std::exp(0.5f * std::sin(2 * p.x() / unit)));
    }
  }

  FrequencyField noisy(float share) const {
    FrequencyField data = truth;
    for (std::size_t i = 0; i < data.size(); ++i) data[i] *= std::exp(share * noise(i));
    return data;
  }

  /// The mean of |log f - log truth| where there is one.
  double error(const FrequencyField& frequencies) const {
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      if (!std::isfinite(frequencies[i])) continue;
      sum += static_cast<double>(std::abs(std::log(frequencies[i] / truth[i])));
      ++count;
    }
    return sum / count;
  }

  /// By which share half of the data are off at most.
  double median_change(const FrequencyField& data) const {
    std::vector<double> changes;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      changes.push_back(std::expm1(static_cast<double>(std::abs(std::log(data[i] / truth[i])))));
    }
    std::ranges::nth_element(changes,
                             changes.begin() + static_cast<std::ptrdiff_t>(truth.size() / 2));
    return changes[truth.size() / 2];
  }

  Surface surface;
  FrequencyField truth;
};

TEST(MeasuredFrequencies, AreNearerToTheTruthThanTheDataByAFactor) {
  for (const char* shape : {"torus,resolution=100", "trefoil,resolution=60"}) {
    const Slow slow(shape);
    for (const float share : {0.2f, 0.6f}) {
      const FrequencyField data = slow.noisy(share);
      const SmoothedFrequencies seen = smoothed_frequencies(slow.surface, data);
      EXPECT_LT(slow.error(seen.frequencies), slow.error(data) / 2) << shape << ' ' << share;
      // Where the mesh resolves no more than a period, some of the noise is left.
      EXPECT_LT(seen.changed_median, 1.15 * slow.median_change(data)) << shape;
      EXPECT_GT(seen.changed_median, 0.5 * slow.median_change(data)) << shape;
    }
  }
}

TEST(MeasuredFrequencies, StayWhereThereIsNoNoise) {
  const Slow slow("torus,resolution=100");
  EXPECT_LT(slow.error(smoothed_frequencies(slow.surface, slow.truth).frequencies), 0.02);
  const FrequencyField same(slow.truth.size(), 12.5f);
  for (const float f : smoothed_frequencies(slow.surface, same).frequencies) {
    EXPECT_NEAR(f, 12.5f, 12.5e-6f);
  }
}

TEST(MeasuredFrequencies, FillHolesAsFarAsTheyAreTold) {
  const Slow slow("torus,resolution=100");
  FrequencyField data = slow.noisy(0.1f);
  std::size_t holes = 0, far = 0;
  for (std::size_t i = 0; i < data.size(); ++i) {
    const bool is_half = slow.surface.mesh.positions[i].y() > 0;
    if (!is_half && i % 3 != 0) continue;
    data[i] = kNaN;
    ++holes;
  }
  const SmoothedFrequencies seen = smoothed_frequencies(slow.surface, data, {.fill = 1.5f});
  const SmoothedFrequencies none = smoothed_frequencies(slow.surface, data, {.fill = 0});
  for (std::size_t i = 0; i < data.size(); ++i) {
    EXPECT_EQ(std::isnan(none.frequencies[i]), std::isnan(data[i]));
    far += std::isnan(seen.frequencies[i]) ? 1 : 0;
  }
  EXPECT_EQ(none.filled, 0u);
  EXPECT_EQ(seen.filled + far, holes);
  EXPECT_GT(far, holes / 4);
  EXPECT_GT(seen.filled, holes / 4);
  EXPECT_LT(slow.error(seen.frequencies), 0.1);
}

TEST(MeasuredFrequencies, LeavePlacesWithoutAWave) {
  const Slow slow("trefoil,resolution=30");
  FrequencyField data = slow.truth;
  data[5] = data[77] = 0;
  const SmoothedFrequencies seen = smoothed_frequencies(slow.surface, data);
  EXPECT_EQ(seen.frequencies[5], 0);
  EXPECT_EQ(seen.frequencies[77], 0);
  EXPECT_EQ(seen.filled, 0u);
}

TEST(MeasuredFrequencies, DoNotDependOnUnitsOrThreads) {
  const Slow metres("trefoil,resolution=40"), millimetres("trefoil,resolution=40", 1000);
  const FrequencyField one = smoothed_frequencies(metres.surface, metres.noisy(0.4f)).frequencies;
  const FrequencyField other =
      smoothed_frequencies(millimetres.surface, millimetres.noisy(0.4f)).frequencies;
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_NEAR(one[i], 1000 * other[i], 1e-3f * one[i]);
  const ThreadLimit alone(1);
  EXPECT_EQ(smoothed_frequencies(metres.surface, metres.noisy(0.4f)).frequencies, one);
}

/// P is in periods, not in edges.
TEST(MeasuredFrequencies, AreTheSameOnAFinerMesh) {
  const auto change = [](const char* shape) {
    const Slow slow(shape);
    FrequencyField data = slow.truth;
    for (std::size_t i = 0; i < data.size(); ++i) {
      data[i] *= std::exp(0.3f * std::sin(20 * slow.surface.mesh.positions[i].y()));
    }
    return slow.error(smoothed_frequencies(slow.surface, data).frequencies) / slow.error(data);
  };
  EXPECT_NEAR(change("torus,resolution=120"), change("torus,resolution=240"), 0.02);
}

TEST(MeasuredFrequencies, RefuseWhatTheyCannotTake) {
  const Slow slow("torus,resolution=10");
  const auto refuses = [&](const FrequencyField& data,
                           const FrequencySmoothingOptions& options = {}) {
    EXPECT_THROW(smoothed_frequencies(slow.surface, data, options), Error);
  };
  refuses({1, 2, 3});
  refuses(FrequencyField(slow.truth.size(), -1.0f));
  refuses(FrequencyField(slow.truth.size(), kNaN));
  refuses(FrequencyField(slow.truth.size(), 0.0f));
  refuses(FrequencyField(slow.truth.size(), std::numeric_limits<float>::infinity()));
  refuses(slow.truth, {.periods = 0});
  refuses(slow.truth, {.periods = 101});
  refuses(slow.truth, {.fill = -1});
}

}  // namespace
}  // namespace brindle
