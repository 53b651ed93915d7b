#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <random>

#include <brindle/carried_phases.h>
#include <brindle/direction_field.h>
#include <brindle/measured_field.h>
#include <brindle/smooth_field.h>
#include <brindle/stripe_animator.h>
#include <brindle/stripe_pattern.h>

#include "vtkBrindleSamples.h"
#include "vtkBrindleStripes.h"
#include "vtk_surfaces.h"

namespace brindle::paraview {
namespace {

constexpr const char* kShape = "torus,resolution=40";

/// The waves of a step.
WaveSet waves_at(const Surface& surface, float angle) {
  std::vector<Vec3> vectors;
  for (const Vec3& p : surface.mesh.positions) vectors.push_back(swirl(p, angle));
  const float frequency = frequency_of_stripes(40, bounding_box(surface.mesh).diagonal());
  return {surface.mesh.positions, tangent_directions(vectors, surface.normals),
          constant_frequency_field(frequency, surface.mesh.vertex_count())};
}

class Series : public testing::Test {
 protected:
  Series() : surface(make_surface(make_shape(kShape))), data(polygons_of(surface.mesh)) {
    filter->SetInputData(data);
    filter->SetField(3);
    choose(*filter, 0, "v");
  }

  /// Shows the vectors of an angle at a time; below 0: without time.
  void show(double time, float angle) {
    add_swirl(*data, angle);
    data->Modified();
    if (time >= 0) {
      set_time(*data, time);
    } else {
      data->GetInformation()->Remove(vtkDataObject::DATA_TIME_STEP());
    }
    filter->Update();
  }

  /// Expects the result of an angle on its own.
  void expect_alone(float angle) {
    expect_phases(*filter->GetOutput(),
                  stripe_pattern(surface, waves_at(surface, angle)).solution.z);
  }

  Surface surface;
  vtkSmartPointer<vtkPolyData> data;
  vtkNew<vtkBrindleStripes> filter;
};

TEST_F(Series, FramesFollowAndNothingIsBuiltAgain) {
  StripeAnimator animator(surface);
  for (int step = 0; step < 4; ++step) {
    const float angle = 0.1f * static_cast<float>(step);
    show(step, angle);
    const WaveSet waves = waves_at(surface, angle);
    expect_phases(*filter->GetOutput(),
                  animator.frame({waves.positions, waves.directions, waves.frequencies}).z);
    EXPECT_EQ(filter->GetSurfacesMade(), 1);
    EXPECT_EQ(filter->GetSolversMade(), 1);
    EXPECT_EQ(filter->GetPatternsFollowed(), step);
  }
}

TEST_F(Series, GoingBackStartsAfresh) {
  for (const int step : {0, 1, 2, 1}) show(step, 0.1f * static_cast<float>(step));
  expect_alone(0.1f);
  EXPECT_EQ(filter->GetSurfacesMade(), 1);
  EXPECT_EQ(filter->GetPatternsFollowed(), 2);
}

TEST_F(Series, PropertiesAndInputsWithoutTimeStartAfresh) {
  show(0, 0);
  filter->SetRotate(10);
  filter->Update();
  filter->SetRotate(0);
  show(1, 0.2f);
  expect_alone(0.2f);
  show(-1, 0.3f);
  expect_alone(0.3f);
  EXPECT_EQ(filter->GetPatternsFollowed(), 0);
}

/// With a memory, the last time's field has a weight, also if phases do not continue.
TEST_F(Series, FieldsRememberThoseOfTheTimeBefore) {
  filter->SetTimeAnchor(0);
  filter->SetFieldSmoothing(1);
  filter->SetTemporalSmoothing(2);
  filter->SetTextureCoordinates(false);
  const FrequencyField frequencies = waves_at(surface, 0).frequencies;
  const auto seen_after = [&](const DirectionField& last, float angle) {
    return FieldSmoothing(surface, {.memory = 2})
        .frame({waves_at(surface, angle).directions, {}}, frequencies, {last, {}})
        .directions;
  };
  const auto expect_field = [&](const DirectionField& field) {
    expect_phases(*filter->GetOutput(), stripe_pattern(surface, field, frequencies).solution.z);
  };
  DirectionField last, first;
  for (const int step : {0, 1, 2}) {
    const float angle = 0.3f * static_cast<float>(step);
    show(step, angle);
    if (step > 0) last = matched_directions({surface.mesh, surface.normals, last}, surface);
    last = seen_after(last, angle);
    if (step == 0) first = last;
    expect_field(last);
    show(step, angle);  // showing it again changes nothing
    expect_field(last);
  }
  show(0, 0);
  expect_field(first);
}

TEST_F(Series, WithoutAnchorEveryStepStandsAlone) {
  filter->SetTimeAnchor(0);
  for (const int step : {0, 1, 2}) show(step, 0.1f * static_cast<float>(step));
  expect_alone(0.2f);
}

/// A pulsating sphere with new noise at every step: smooth fields from scratch turn arbitrarily.
Mesh beating(int step) {
  Mesh mesh = make_shape("sphere,resolution=20");
  std::mt19937 random(static_cast<unsigned>(step));
  std::normal_distribution<float> any;
  for (Vec3& p : mesh.positions) {
    p *= 1 + 0.01f * std::sin(2 * p.x() + 0.3f * static_cast<float>(step));
    p += 1e-3f * Vec3(any(random), any(random), any(random));
  }
  return mesh;
}

/// The library's smooth field of a step that continues the earlier ones.
DirectionField followed_field(int last_step, int curvature) {
  DirectionField directions;
  std::optional<Surface> before;
  for (int step = 0; step <= last_step; ++step) {
    const Surface surface = make_surface(beating(step));
    SmoothFieldOptions options;
    if (curvature != 0) options.curvature_anchor = 0.1f;
    if (before) {
      options.last.directions =
          matched_directions({before->mesh, before->normals, directions}, surface);
    }
    directions = smooth_direction_field(surface, options);
    before = surface;
  }
  return directions;
}

/// At points that coincide with a vertex of `mesh`: texture coordinates copy some and add others.
void expect_directions(vtkDataSet& output, const Mesh& mesh, const DirectionField& expected,
                       double tolerance_deg) {
  vtkDataArray* found = output.GetPointData()->GetArray("direction");
  ASSERT_NE(found, nullptr);
  const auto key = [](const Vec3& p) { return std::array{p.x(), p.y(), p.z()}; };
  std::map<std::array<float, 3>, Vec3> by_place;
  for (vtkIdType i = 0; i < found->GetNumberOfTuples(); ++i) {
    Eigen::Vector3d p, d;
    output.GetPoint(i, p.data());
    found->GetTuple(i, d.data());
    by_place.emplace(key((p - mesh.origin).cast<float>()), d.cast<float>());
  }
  DirectionField directions;
  for (const Vec3& p : mesh.positions) {
    const auto there = by_place.find(key(p));
    ASSERT_NE(there, by_place.end());
    directions.push_back(there->second);
  }
  EXPECT_LE(field_step(directions, expected).mean_deg, tolerance_deg);
}

class MovingSeries : public testing::TestWithParam<int> {
 protected:
  MovingSeries() : data(polygons_of(beating(0))) {
    filter->SetInputData(data);
    filter->SetField(GetParam());
  }

  void show(double time, int step) {
    data->ShallowCopy(polygons_of(beating(step)));
    set_time(*data, time);
    data->Modified();
    filter->Update();
  }

  vtkSmartPointer<vtkPolyData> data;
  vtkNew<vtkBrindleStripes> filter;
};

TEST_P(MovingSeries, FieldsFollowSurfacesThatMove) {
  for (int step = 0; step < 4; ++step) {
    show(step, step);
    expect_directions(*filter->GetOutput(), beating(step), followed_field(step, GetParam()), 0.05);
  }
  EXPECT_EQ(filter->GetPatternsFollowed(), 3);
}

TEST_P(MovingSeries, GoingBackAndStandingAloneFindFieldsAnew) {
  const auto alone = [&](int step) {
    const Surface surface = make_surface(beating(step));
    SmoothFieldOptions options;
    if (GetParam() != 0) options.curvature_anchor = 0.1f;
    return smooth_direction_field(surface, options);
  };
  for (const int step : {0, 1, 2, 1}) show(step, step);
  expect_directions(*filter->GetOutput(), beating(1), alone(1), 0.05);
  filter->SetTimeAnchor(0);
  for (const int step : {0, 1}) show(step, step);
  expect_directions(*filter->GetOutput(), beating(1), alone(1), 0.05);
}

TEST_P(MovingSeries, WhatIsShownAgainStays) {
  for (const int step : {0, 1}) show(step, step);
  const DirectionField followed = followed_field(1, GetParam());
  data->Modified();
  filter->Update();
  expect_directions(*filter->GetOutput(), beating(1), followed, 0.05);
  show(1, 1);
  expect_directions(*filter->GetOutput(), beating(1), followed, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Fields, MovingSeries, testing::Values(0, 1),
                         [](const auto& test) { return test.param == 0 ? "smooth" : "curvature"; });

// Changing only the output's form neither makes a new pattern nor interrupts the series.
TEST_F(Series, FormsOfTheOutputDoNotMatter) {
  StripeAnimator animator(surface);
  for (const int step : {0, 1, 2}) {
    const float angle = 0.1f * static_cast<float>(step);
    show(step, angle);
    filter->SetTextureCoordinates(step % 2 == 0);
    filter->Update();
    const WaveSet waves = waves_at(surface, angle);
    expect_phases(*filter->GetOutput(),
                  animator.frame({waves.positions, waves.directions, waves.frequencies}).z);
  }
  EXPECT_EQ(filter->GetPatternsFollowed(), 2);
}

TEST_F(Series, MeshesThatAreReadAgainAreTheSameAndMovedOnesKeepTheSolver) {
  const auto step = [&](double time, float stretch) {
    Mesh mesh = surface.mesh;
    for (Vec3& p : mesh.positions) p.z() *= stretch;
    data->ShallowCopy(polygons_of(mesh));
    show(time, 0.1f * static_cast<float>(time));
  };
  step(0, 1);
  step(1, 1);
  EXPECT_EQ(filter->GetSurfacesMade(), 1);
  step(2, 1.01f);
  EXPECT_EQ(filter->GetSurfacesMade(), 2) << "normals follow the points";
  EXPECT_EQ(filter->GetSolversMade(), 1);
  EXPECT_EQ(filter->GetPatternsFollowed(), 2);

  Mesh other = surface.mesh;
  other.triangles.pop_back();
  data->ShallowCopy(polygons_of(other));
  show(3, 0);
  EXPECT_EQ(filter->GetSolversMade(), 2) << "other cells are another surface";
  EXPECT_EQ(filter->GetPatternsFollowed(), 2);
}

TEST_F(Series, StepsThatFailAreForgotten) {
  show(0, 0);
  Errors errors(*filter);
  data->GetPointData()->RemoveArray("v");
  set_time(*data, 1);
  data->Modified();
  filter->Update();
  EXPECT_EQ(errors.messages.size(), 1u);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  show(2, 0.1f);
  EXPECT_EQ(errors.messages.size(), 1u);
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 0);
}

// Both patterns of samples continue: points move little if the field does.
TEST(SampleSeries, SamplesMoveLittle) {
  const Surface surface = make_surface(make_shape(kShape));
  const auto moved = [&](double anchor) {
    vtkNew<vtkBrindleSamples> filter;
    filter->SetField(3);
    choose(*filter, 0, "v");
    filter->SetTimeAnchor(anchor);
    auto producer = polygons_of(surface.mesh);
    filter->SetInputData(producer);
    std::vector<Eigen::Vector3d> last;
    double sum = 0;
    for (int step = 0; step < 4; ++step) {
      add_swirl(*producer, 0.01f * static_cast<float>(step));
      set_time(*producer, step);
      producer->Modified();
      filter->Update();
      std::vector<Eigen::Vector3d> now;
      for (vtkIdType i = 0; i < filter->GetOutput()->GetNumberOfPoints(); ++i) {
        now.emplace_back(filter->GetOutput()->GetPoint(i));
      }
      for (const auto& p : last) {
        double nearest = 1e9;
        for (const auto& q : now) nearest = std::min(nearest, (p - q).norm());
        sum += nearest / static_cast<double>(last.size());
      }
      last = now;
    }
    return sum;
  };
  EXPECT_LT(moved(0.025), 0.7 * moved(0));
}

}  // namespace
}  // namespace brindle::paraview
