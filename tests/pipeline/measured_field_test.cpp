#include "brindle/measured_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/frequency_field.h"
#include "brindle/points.h"
#include "brindle/shapes.h"
#include "brindle/smooth_field.h"
#include "brindle/threads.h"
#include "progress_reports.h"
#include "test_numbers.h"

namespace brindle {
namespace {

using testing_support::kDegree;

/// A number from -1 to 1 that hangs on `i` and `seed` alone.
float noise(std::size_t i, unsigned seed) {
  const double sine = std::sin(static_cast<double>(i) * 12.9898 + seed * 78.233) * 43758.5453;
  return static_cast<float>(2 * (sine - std::floor(sine)) - 1);
}

/// A surface, a field that is true, and the frequency of its stripes.
struct Truth {
  explicit Truth(const char* shape, float stripes = 30)
      : surface(make_surface(make_shape(shape))), field(smooth_direction_field(surface)) {
    frequencies = constant_frequency_field(
        frequency_of_stripes(stripes, bounding_box(surface.mesh).diagonal()), field.size());
  }
  Surface surface;
  DirectionField field;
  FrequencyField frequencies;
};

/// Turned by noise whose standard deviation is `degrees`, and with every tenth sign the other way.
DirectionField noisy(const Truth& truth, float degrees, unsigned seed = 1) {
  DirectionField result = truth.field;
  for (std::size_t i = 0; i < result.size(); ++i) {
    // The sum of three even numbers from -1 to 1 has a variance of 1.
    const float angle =
        degrees * kDegree * (noise(i, seed) + noise(i, seed + 7) + noise(i, seed + 19));
    result[i] = std::cos(angle) * truth.field[i] +
                std::sin(angle) * truth.surface.normals[i].cross(truth.field[i]);
    if (i % 10 == 3) result[i] = -result[i];
  }
  return result;
}

/// Degrees between lines, on average over vertices that have both.
double mean_angle(const DirectionField& a, const DirectionField& b) {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].isZero(0) || b[i].isZero(0)) continue;
    sum += static_cast<double>(std::acos(std::min(1.0f, std::abs(a[i].dot(b[i]))))) /
           static_cast<double>(kDegree);
    ++count;
  }
  return sum / count;
}

SmoothedField seen(const Truth& truth, const DirectionField& data,
                   const FieldSmoothingOptions& options = {}) {
  return FieldSmoothing(truth.surface, options).frame({data, {}}, truth.frequencies);
}

TEST(FieldSmoothing, IsNearerToTheTruthThanTheDataByAFactor) {
  for (const char* shape : {"torus,resolution=120", "trefoil,resolution=80"}) {
    const Truth truth(shape);
    for (const float degrees : {10.0f, 20.0f, 40.0f}) {
      const DirectionField data = noisy(truth, degrees);
      const double before = mean_angle(data, truth.field);
      const double after = mean_angle(seen(truth, data).directions, truth.field);
      EXPECT_LT(after, before / 2) << shape << ' ' << degrees;
    }
  }
}

TEST(FieldSmoothing, LeavesCleanFieldsAsTheyAre) {
  for (const char* shape : {"torus,resolution=120", "trefoil,resolution=80"}) {
    const Truth truth(shape);
    const SmoothedField field = seen(truth, truth.field);
    EXPECT_LT(mean_angle(field.directions, truth.field), 1) << shape;
    for (const Vec3& d : field.directions) EXPECT_NEAR(d.norm(), 1, 1e-5);
  }
}

TEST(FieldSmoothing, SaysHowMuchDataAgree) {
  const Truth truth("torus,resolution=80");
  const auto mean = [&](float degrees) {
    const SmoothedField field = seen(truth, noisy(truth, degrees));
    double sum = 0;
    for (const float a : field.coherence) {
      EXPECT_GE(a, 0);
      EXPECT_LE(a, 1);
      sum += static_cast<double>(a);
    }
    return sum / static_cast<double>(field.coherence.size());
  };
  EXPECT_GT(mean(0), 0.98);  // the field itself turns within a period
  // Angles of lines count twice: the mean of exp(2 i theta) is exp(-2 sigma^2).
  EXPECT_NEAR(mean(20), std::exp(-2 * 0.349 * 0.349), 0.02);
}

TEST(FieldSmoothing, FillsHolesAsFarAsItIsTold) {
  const Truth truth("torus,resolution=80");
  DirectionField data = truth.field;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::size_t holes = 0;
  for (std::size_t i = 0; i < data.size(); ++i) {
    if (truth.surface.mesh.positions[i].x() < 0) continue;
    data[i] = i % 2 == 0 ? Vec3::Zero() : Vec3(nan, 0, 0);
    ++holes;
  }
  const float far = 1e6f;
  FieldSmoothing all(truth.surface, {.fill = far}), none(truth.surface, {.fill = 0}),
      some(truth.surface, {.fill = 3});
  const SmoothedField filled = all.frame({data, {}}, truth.frequencies);
  EXPECT_LT(mean_angle(filled.directions, truth.field), 12);  // half of the torus is guessed
  EXPECT_EQ(all.metrics().filled, holes);
  EXPECT_EQ(all.metrics().unfilled, 0u);
  EXPECT_EQ(all.metrics().data, data.size() - holes);

  const SmoothedField empty = none.frame({data, {}}, truth.frequencies);
  EXPECT_EQ(none.metrics().filled, 0u);
  EXPECT_EQ(none.metrics().unfilled, holes);
  some.frame({data, {}}, truth.frequencies);
  EXPECT_GT(some.metrics().filled, 0u);
  EXPECT_GT(some.metrics().unfilled, 0u);
  for (std::size_t i = 0; i < data.size(); ++i) {
    if (!empty.directions[i].isZero(0)) continue;
    EXPECT_GE(truth.surface.mesh.positions[i].x(), 0);
    EXPECT_EQ(empty.coherence[i], 0);
  }
}

/// What counts nothing says nothing, and the unit of the weights does not matter.
TEST(FieldSmoothing, CountsDataByTheirConfidence) {
  const Truth truth("torus,resolution=80");
  DirectionField data = truth.field;
  std::vector<float> confidence(data.size(), 0.001f);
  for (std::size_t i = 0; i < data.size(); i += 3) {
    data[i] = truth.surface.normals[i].cross(truth.field[i]);  // wrong by 90 degrees
    confidence[i] = 0;
  }
  FieldSmoothing smoothing(truth.surface);
  const SmoothedField weighted = smoothing.frame({data, confidence}, truth.frequencies);
  EXPECT_LT(mean_angle(weighted.directions, truth.field), 1);
  for (float& c : confidence) c *= 4096;
  EXPECT_EQ(smoothing.frame({data, confidence}, truth.frequencies).directions, weighted.directions);
}

TEST(FieldSmoothing, IsTheSameOnAFinerMesh) {
  Mesh mesh = make_shape("torus,resolution=60");
  const auto along_x = [](const Surface& surface) {
    DirectionField field;
    for (std::size_t i = 0; i < surface.normals.size(); ++i) {
      const float x = 9 * surface.mesh.positions[i].x(), y = 7 * surface.mesh.positions[i].y();
      const Vec3 wavy(1, 0.8f * std::sin(x), 0.8f * std::cos(y));
      field.push_back(tangent_direction(wavy, surface.normals[i]));
    }
    return field;
  };
  const Surface coarse = make_surface(mesh), fine = make_surface(subdivide(mesh));
  const auto field_on = [&](const Surface& surface) {
    const FrequencyField f(surface.normals.size(), 6.0f);
    return FieldSmoothing(surface).frame({along_x(surface), {}}, f);
  };
  SmoothedField a = field_on(coarse), b = field_on(fine);
  b.directions.resize(a.directions.size());  // the first vertices are those of the coarse mesh
  const double turned = mean_angle(along_x(coarse), a.directions);
  EXPECT_GT(turned, 3);
  EXPECT_LT(mean_angle(a.directions, b.directions), 0.1 * turned);
}

/// Lines of a mesh on the same mesh, subdivided: at midpoints those between the ends of edges.
DirectionField on_subdivided(const DirectionField& coarse, const Surface& fine) {
  DirectionField field = coarse;
  field.resize(fine.normals.size(), Vec3::Zero());
  for (Index i = static_cast<Index>(coarse.size()); i < field.size(); ++i) {
    Vec3 sum = Vec3::Zero();
    for (const Index j : fine.neighborhood->of(i)) {
      if (j < coarse.size()) sum += coarse[j].dot(sum) < 0 ? Vec3(-coarse[j]) : coarse[j];
    }
    field[i] = tangent_direction(sum, fine.normals[i]);
  }
  return field;
}

/// The scale is in periods, not in edges, for noise as well: where edges are many to a period, the
/// field moves by less than 2 % of what noise is taken away.
TEST(FieldSmoothing, IsTheSameOfNoisyDataOnAFinerMesh) {
  for (const char* shape : {"torus,resolution=180", "trefoil"}) {
    const Truth truth(shape, 20);
    const DirectionField data = noisy(truth, 20);
    const Surface fine = make_surface(subdivide(make_shape(shape)));
    const FrequencyField frequencies(fine.normals.size(), truth.frequencies.front());
    const SmoothedField a = seen(truth, data);
    SmoothedField b = FieldSmoothing(fine).frame({on_subdivided(data, fine), {}}, frequencies);
    b.directions.resize(a.directions.size());
    const double turned = mean_angle(data, a.directions);
    EXPECT_GT(turned, 13) << shape;
    EXPECT_LT(mean_angle(a.directions, b.directions), 0.02 * turned) << shape;
  }
}

TEST(FieldSmoothing, DoesNotDependOnSignsOrThreads) {
  const Truth truth("torus,resolution=80");
  const DirectionField data = noisy(truth, 20);
  DirectionField flipped = data;
  for (std::size_t i = 0; i < flipped.size(); i += 2) flipped[i] = -flipped[i];
  const SmoothedField field = seen(truth, data);
  EXPECT_EQ(seen(truth, flipped).directions, field.directions);
  const ThreadLimit one(1);
  EXPECT_EQ(seen(truth, data).directions, field.directions);
}

/// Crosses are the same turned by 90 degrees; arrows are not the same turned round.
TEST(FieldSmoothing, KnowsArrowsAndCrosses) {
  const Truth truth("torus,resolution=80");
  DirectionField crosses = truth.field, arrows = truth.field;
  for (std::size_t i = 0; i < crosses.size(); i += 2) {
    crosses[i] = truth.surface.normals[i].cross(crosses[i]);
  }
  const SmoothedField turned = seen(truth, crosses, {.symmetry = 4});
  const SmoothedField whole = seen(truth, truth.field, {.symmetry = 4});
  for (std::size_t i = 0; i < crosses.size(); ++i) {
    const float cosine = std::abs(turned.directions[i].dot(whole.directions[i]));
    EXPECT_GT(std::max(cosine, std::sqrt(std::max(0.0f, 1 - cosine * cosine))), 0.999f);
    EXPECT_NEAR(turned.coherence[i], whole.coherence[i], 1e-3);
  }
  for (std::size_t i = 0; i < arrows.size(); i += 2) arrows[i] = -arrows[i];
  const SmoothedField facing = seen(truth, arrows, {.symmetry = 1});
  double mean = 0;
  for (const float a : facing.coherence) mean += static_cast<double>(a);
  EXPECT_LT(mean / static_cast<double>(facing.coherence.size()), 0.3);
}

TEST(FieldSmoothing, TakesDataOfTrianglesAndPoints) {
  const Truth truth("torus,resolution=80");
  MeasuredField of_triangles{{}, {}, true};
  for (const auto& [a, b, c] : truth.surface.mesh.triangles) {
    const Vec3& d = truth.field[a];
    of_triangles.directions.push_back(d +
                                      std::copysign(1.0f, d.dot(truth.field[b])) * truth.field[b]);
  }
  FieldSmoothing smoothing(truth.surface);
  EXPECT_LT(mean_angle(smoothing.frame(of_triangles, truth.frequencies).directions, truth.field),
            1.5);
  EXPECT_LT(smoothing.metrics().turned_median_deg, 2);

  PointCloud cloud;
  cloud.positions = truth.surface.mesh.positions;
  cloud.used.resize(cloud.positions.size());
  std::iota(cloud.used.begin(), cloud.used.end(), Index{0});
  const Surface points = make_point_surface(std::move(cloud));
  ASSERT_EQ(points.normals.size(), truth.field.size());
  const DirectionField data = noisy(truth, 20);
  const SmoothedField on_points = FieldSmoothing(points).frame({data, {}}, truth.frequencies);
  EXPECT_LT(mean_angle(on_points.directions, truth.field), mean_angle(data, truth.field) / 2);
}

TEST(FieldSmoothing, FollowsTheLastFieldAsFarAsItIsTold) {
  const Truth truth("torus,resolution=80");
  FieldSmoothing alone(truth.surface), following(truth.surface, {.memory = 3});
  const auto step_of = [&](FieldSmoothing& smoothing) {
    SmoothedField last = smoothing.frame({noisy(truth, 40, 1), {}}, truth.frequencies);
    const SmoothedField next = smoothing.frame({noisy(truth, 40, 2), {}}, truth.frequencies,
                                               {last.directions, last.coherence});
    return mean_angle(last.directions, next.directions);
  };
  EXPECT_LT(step_of(following), step_of(alone) / 2);
}

TEST(FieldSmoothing, MetricsTellWhatWasTurned) {
  const Truth truth("torus,resolution=80");
  FieldSmoothing smoothing(truth.surface, {.periods = 2});
  EXPECT_THROW(smoothing.metrics(), Error);
  const DirectionField data = noisy(truth, 20);
  const SmoothedField field = smoothing.frame({data, {}}, truth.frequencies);
  const FieldSmoothingMetrics metrics = smoothing.metrics();
  EXPECT_NEAR(metrics.turned_mean_deg, mean_angle(data, field.directions), 1.5);  // by area
  EXPECT_LT(metrics.turned_median_deg, metrics.turned_p95_deg);
  EXPECT_GT(metrics.turned_share_over_20deg, 0.1);
  EXPECT_GT(metrics.singularities_of_data, metrics.singularities);
}

TEST(FieldSmoothing, RefusesWhatItCannotTake) {
  const Truth truth("torus,resolution=20");
  const std::size_t count = truth.field.size();
  const auto with = [&](FieldSmoothingOptions options) { FieldSmoothing(truth.surface, options); };
  EXPECT_THROW(with({.periods = 0}), Error);
  EXPECT_THROW(with({.periods = std::numeric_limits<float>::infinity()}), Error);
  EXPECT_THROW(with({.periods = 101}), Error);
  EXPECT_THROW(with({.symmetry = 0}), Error);
  EXPECT_THROW(with({.fill = -1}), Error);
  EXPECT_THROW(with({.memory = -1}), Error);
  FieldSmoothing smoothing(truth.surface);
  const auto frame = [&](const MeasuredField& field) { smoothing.frame(field, truth.frequencies); };
  EXPECT_THROW(frame({DirectionField(count - 1), {}}), Error);
  EXPECT_THROW(frame({truth.field, std::vector<float>(count, -1.0f)}), Error);
  EXPECT_THROW(frame({truth.field, std::vector<float>(count - 1, 1.0f)}), Error);
  EXPECT_THROW(frame({DirectionField(count, Vec3::Zero()), {}}), Error);  // no datum
  EXPECT_THROW(smoothing.frame({truth.field, {}}, std::vector<float>(count, -1.0f)), Error);
  EXPECT_NO_THROW(frame({truth.field, {}}));
  const Progress stop([](const ProgressReport&) { return false; });
  EXPECT_THROW(smoothing.frame({truth.field, {}}, truth.frequencies, {}, stop), Cancelled);
}

TEST(FieldSmoothing, MarksWhatItFills) {
  const Truth truth("torus,resolution=60");
  DirectionField data = truth.field;
  for (std::size_t i = 0; i < data.size(); i += 7) data[i] = Vec3::Zero();
  FieldSmoothing smoothing(truth.surface);
  const SmoothedField field = smoothing.frame({data, {}}, truth.frequencies);
  std::size_t filled = 0;
  for (std::size_t i = 0; i < data.size(); ++i) {
    EXPECT_EQ(field.filled[i] != 0, data[i].isZero(0) && !field.directions[i].isZero(0)) << i;
    filled += field.filled[i];
  }
  EXPECT_EQ(filled, smoothing.metrics().filled);
  EXPECT_GT(filled, 0u);
}

TEST(FieldSmoothing, SaysHowMuchDataAgreeOnAverage) {
  const Truth truth("torus,resolution=100");
  const auto metrics = [&](float degrees) {
    DirectionField data = noisy(truth, degrees);
    for (std::size_t i = 0; i < data.size(); i += 7) data[i] = Vec3::Zero();
    FieldSmoothing smoothing(truth.surface);
    smoothing.frame({data, {}}, truth.frequencies);
    return smoothing.metrics();
  };
  EXPECT_GT(metrics(0).coherence_mean, 0.98);
  EXPECT_GT(metrics(0).coherence_filled_mean, 0.98);
  const double expected = std::exp(-2 * 0.349 * 0.349);  // as above
  EXPECT_NEAR(metrics(20).coherence_mean, expected, 0.03);
  EXPECT_NEAR(metrics(20).coherence_filled_mean, expected, 0.05);
}

// Of a scale too small, the noise remains; of one too large, true turns are lost.
TEST(FieldSmoothing, DataHeldOutPreferTheScaleThatIsBestInTruth) {
  for (const char* shape : {"trefoil,resolution=80", "torus,resolution=80"}) {
    Truth truth(shape, 20);
    for (std::size_t i = 0; i < truth.field.size(); ++i) {
      const Vec3 d = truth.field[i];
      const float angle = std::sin(3 * truth.surface.mesh.positions[i].x());
      truth.field[i] = std::cos(angle) * d + std::sin(angle) * truth.surface.normals[i].cross(d);
    }
    const DirectionField data = noisy(truth, 25);
    std::vector<double> held_out, true_angle;
    for (const float periods : {0.1f, 0.2f, 0.4f, 0.8f, 1.6f, 3.2f, 6.4f}) {
      FieldSmoothing smoothing(truth.surface, {.periods = periods, .hold_out = 0.1f});
      const SmoothedField field = smoothing.frame({data, {}}, truth.frequencies);
      true_angle.push_back(mean_angle(field.directions, truth.field));
      const FieldSmoothingMetrics metrics = smoothing.metrics();
      const double share = static_cast<double>(metrics.held_out) / static_cast<double>(data.size());
      EXPECT_NEAR(share, 0.1, 0.02);
      held_out.push_back(metrics.held_out_turned_mean_deg);
    }
    const auto least = [](const std::vector<double>& values) {
      return std::ranges::min_element(values) - values.begin();
    };
    EXPECT_NEAR(static_cast<double>(least(held_out)), static_cast<double>(least(true_angle)), 1)
        << shape << testing::PrintToString(held_out) << testing::PrintToString(true_angle);
    EXPECT_GT(held_out.front(), *std::ranges::min_element(held_out));
    EXPECT_GT(held_out.back(), *std::ranges::min_element(held_out));
  }
}

TEST(FieldSmoothing, HoldingOutDataLeavesTheField) {
  const Truth truth("torus,resolution=60");
  const DirectionField data = noisy(truth, 20);
  const SmoothedField plain = seen(truth, data), checked = seen(truth, data, {.hold_out = 0.3f});
  EXPECT_EQ(checked.directions, plain.directions);
  EXPECT_EQ(checked.coherence, plain.coherence);
  for (const float share : {-0.1f, 1.0f, std::numeric_limits<float>::quiet_NaN()}) {
    EXPECT_THROW(FieldSmoothing(truth.surface, {.hold_out = share}), Error) << share;
  }
  EXPECT_THROW(seen(truth, data, {.fill = 0, .hold_out = 0.1f}), Error);
}

/// What is seen of the next frame, and of metrics.
struct SmoothedData {
  DirectionField directions;
  std::vector<float> coherence;
  double turned;
  std::size_t singularities_of_data;
  bool operator==(const SmoothedData&) const = default;
};

SmoothedData see(FieldSmoothing& smoothing, const Truth& truth, const DirectionField& data) {
  const SmoothedField field = smoothing.frame({data, {}}, truth.frequencies);
  const FieldSmoothingMetrics metrics = smoothing.metrics();
  return {field.directions, field.coherence, metrics.turned_mean_deg,
          metrics.singularities_of_data};
}

TEST(FieldSmoothing, AFrameThatFailsLeavesNothingBehind) {
  const Truth truth("torus,resolution=24");
  for (const std::optional<std::size_t> singularities :
       {std::optional<std::size_t>(), std::optional<std::size_t>(0)}) {
    const FieldSmoothingOptions options{.periods = 0.3f, .singularities = singularities};
    const DirectionField first = noisy(truth, 10, 1), second = noisy(truth, 60, 2);
    FieldSmoothing undisturbed(truth.surface, options);
    const SmoothedData a = see(undisturbed, truth, first);
    const double turned = undisturbed.metrics().turned_mean_deg;
    const SmoothedData b = see(undisturbed, truth, noisy(truth, 10, 3));
    testing_support::Reports all;
    FieldSmoothing(truth.surface, options)
        .frame({second, {}}, truth.frequencies, {}, all.progress());
    for (const int k : testing_support::reports_to_cancel(all.count())) {
      SCOPED_TRACE(k);
      FieldSmoothing smoothing(truth.surface, options);
      testing_support::Reports of_first(k), of_later(k);
      EXPECT_THROW(smoothing.frame({second, {}}, truth.frequencies, {}, of_first.progress()),
                   Cancelled);
      EXPECT_THROW(smoothing.metrics(), Error);
      EXPECT_EQ(see(smoothing, truth, first), a);
      try {
        smoothing.frame({second, {}}, truth.frequencies, {}, of_later.progress());
        break;  // it goes on from the last field, and may make fewer reports
      } catch (const Cancelled&) {
      }
      const DirectionField nothing(truth.field.size(), Vec3::Zero());
      EXPECT_THROW(smoothing.frame({nothing, {}}, truth.frequencies), Error);
      EXPECT_EQ(smoothing.metrics().turned_mean_deg, turned);
      EXPECT_EQ(see(smoothing, truth, noisy(truth, 10, 3)), b);
    }
  }
}

TEST(FieldSmoothingSingularities, AreUndoneInPairsWhereTheyAreAlone) {
  const Truth truth("sphere,resolution=60");
  const MeasuredField measured{noisy(truth, 45), {}};
  FieldSmoothing all(truth.surface, {.periods = 0.3f});
  const SmoothedField before = all.frame(measured, truth.frequencies);
  const std::size_t many = all.metrics().singularities;
  ASSERT_GT(many, 24U);

  FieldSmoothing half(truth.surface, {.periods = 0.3f, .singularities = many / 2});
  const SmoothedField some = half.frame(measured, truth.frequencies);
  EXPECT_LE(half.metrics().singularities, many / 2);
  EXPECT_GT(half.metrics().singularities, 4U) << "no more than were asked for";
  std::size_t same = 0;
  for (std::size_t i = 0; i < some.directions.size(); ++i) {
    same += std::abs(some.directions[i].dot(before.directions[i])) > std::cos(2 * kDegree) ? 1 : 0;
  }
  EXPECT_GT(same, some.directions.size() / 2) << "elsewhere the field stays";

  // A field of lines on a sphere has four or more, of which no two undo each other.
  FieldSmoothing few(truth.surface, {.periods = 0.3f, .singularities = 0});
  few.frame(measured, truth.frequencies);
  EXPECT_EQ(few.metrics().singularities, 4U);
  EXPECT_EQ(few.metrics().singularities_too_many, 4U);
}

/// Data without a scale of their own: pair after pair is undone until rounding is all that holds.
TEST(FieldSmoothingSingularities, OfPureNoiseStayAField) {
  const Truth truth("sphere,resolution=60");
  FieldSmoothing few(truth.surface, {.periods = 3, .singularities = 0});
  const SmoothedField field = few.frame({noisy(truth, 300), {}}, truth.frequencies);
  for (const Vec3& direction : field.directions) ASSERT_NEAR(direction.norm(), 1, 1e-4f);
  const FieldSmoothingMetrics metrics = few.metrics();
  EXPECT_EQ(metrics.singularities, metrics.singularities_too_many);
  FieldSmoothing all(truth.surface, {.periods = 3});
  all.frame({noisy(truth, 300), {}}, truth.frequencies);
  EXPECT_LE(metrics.singularities, all.metrics().singularities);
}

TEST(FieldSmoothingSingularities, ChangeNothingWhereThereAreFewEnough) {
  const Truth truth("trefoil,resolution=30");
  const MeasuredField measured{noisy(truth, 10), {}};
  FieldSmoothing all(truth.surface, {.periods = 1});
  FieldSmoothing few(truth.surface, {.periods = 1, .singularities = 1000});
  EXPECT_EQ(all.frame(measured, truth.frequencies).directions,
            few.frame(measured, truth.frequencies).directions);
}

TEST(FieldSmoothingSingularities, NeedTriangles) {
  Truth truth("sphere,resolution=20");
  truth.surface.mesh.triangles.clear();
  EXPECT_THROW(FieldSmoothing(truth.surface, {.singularities = 3}), Error);
}

}  // namespace
}  // namespace brindle
