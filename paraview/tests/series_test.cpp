#include <cmath>
#include <complex>

#include <brindle/direction_field.h>
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

void expect_phases(vtkDataSet& output, std::span<const Complex> z) {
  const std::vector<float> phases = numbers(output, "phase");
  ASSERT_GE(phases.size(), z.size());
  for (std::size_t i = 0; i < z.size(); ++i) ASSERT_EQ(phases[i], std::arg(z[i]));
}

class Series : public testing::Test {
 protected:
  Series() : surface(make_surface(make_shape(kShape))) {
    filter->SetField(3);
    choose(*filter, 0, "v");
  }

  Surface surface;
  vtkNew<vtkBrindleStripes> filter;
};

TEST_F(Series, FramesFollowAndNothingIsBuiltAgain) {
  // Steps change the data of one producer, as ParaView's readers do.
  auto producer = polygons_of(surface.mesh);
  filter->SetInputData(producer);
  StripeAnimator animator(surface);
  for (int step = 0; step < 4; ++step) {
    const float angle = 0.1f * static_cast<float>(step);
    add_swirl(*producer, angle);
    producer->Modified();
    set_time(*producer, step);
    filter->Update();
    const WaveSet waves = waves_at(surface, angle);
    expect_phases(*filter->GetOutput(),
                  animator.frame({waves.positions, waves.directions, waves.frequencies}).z);
    EXPECT_EQ(filter->GetSurfacesMade(), 1);
    EXPECT_EQ(filter->GetSolversMade(), 1);
    EXPECT_EQ(filter->GetPatternsFollowed(), step);
  }
}

TEST_F(Series, GoingBackStartsAfresh) {
  auto producer = polygons_of(surface.mesh);
  filter->SetInputData(producer);
  for (const int step : {0, 1, 2, 1}) {
    add_swirl(*producer, 0.1f * static_cast<float>(step));
    producer->Modified();
    set_time(*producer, step);
    filter->Update();
  }
  expect_phases(*filter->GetOutput(), stripe_pattern(surface, waves_at(surface, 0.1f)).solution.z);
  EXPECT_EQ(filter->GetSurfacesMade(), 1);
  EXPECT_EQ(filter->GetPatternsFollowed(), 2);
}

TEST_F(Series, PropertiesAndInputsWithoutTimeStartAfresh) {
  auto producer = polygons_of(surface.mesh);
  filter->SetInputData(producer);
  add_swirl(*producer, 0);
  set_time(*producer, 0);
  filter->Update();
  filter->SetRotate(10);
  filter->Update();
  filter->SetRotate(0);
  add_swirl(*producer, 0.2f);
  set_time(*producer, 1);
  producer->Modified();
  filter->Update();
  expect_phases(*filter->GetOutput(), stripe_pattern(surface, waves_at(surface, 0.2f)).solution.z);
  producer->GetInformation()->Remove(vtkDataObject::DATA_TIME_STEP());
  add_swirl(*producer, 0.3f);
  producer->Modified();
  filter->Update();
  expect_phases(*filter->GetOutput(), stripe_pattern(surface, waves_at(surface, 0.3f)).solution.z);
  EXPECT_EQ(filter->GetPatternsFollowed(), 0);
}

TEST_F(Series, WithoutAnchorEveryStepStandsAlone) {
  filter->SetTimeAnchor(0);
  auto producer = polygons_of(surface.mesh);
  filter->SetInputData(producer);
  for (const int step : {0, 1, 2}) {
    add_swirl(*producer, 0.1f * static_cast<float>(step));
    set_time(*producer, step);
    producer->Modified();
    filter->Update();
  }
  expect_phases(*filter->GetOutput(), stripe_pattern(surface, waves_at(surface, 0.2f)).solution.z);
}

TEST_F(Series, MeshesThatAreReadAgainAreTheSameAndMovedOnesKeepTheSolver) {
  vtkNew<vtkPolyData> producer;
  filter->SetInputData(producer);
  const auto step = [&](double time, float stretch) {
    Mesh mesh = surface.mesh;
    for (Vec3& p : mesh.positions) p.z() *= stretch;
    auto data = polygons_of(mesh);
    add_swirl(*data, 0.1f * static_cast<float>(time));
    producer->ShallowCopy(data);
    set_time(*producer, time);
    filter->Update();
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
  auto data = polygons_of(other);
  add_swirl(*data, 0);
  producer->ShallowCopy(data);
  set_time(*producer, 3);
  filter->Update();
  EXPECT_EQ(filter->GetSolversMade(), 2) << "other cells are another surface";
  EXPECT_EQ(filter->GetPatternsFollowed(), 2);
}

TEST_F(Series, StepsThatFailAreForgotten) {
  auto producer = polygons_of(surface.mesh);
  filter->SetInputData(producer);
  add_swirl(*producer, 0);
  set_time(*producer, 0);
  filter->Update();
  Errors errors(*filter);
  producer->GetPointData()->RemoveArray("v");
  set_time(*producer, 1);
  producer->Modified();
  filter->Update();
  EXPECT_EQ(errors.messages.size(), 1u);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  add_swirl(*producer, 0.1f);
  set_time(*producer, 2);
  producer->Modified();
  filter->Update();
  EXPECT_EQ(errors.messages.size(), 1u);
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 0);
}

// Both patterns of samples follow: points move a little where the field does.
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
