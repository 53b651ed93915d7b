// Results of `Brindle Curves` and `Brindle Samples`.
#include <numbers>

#include <brindle/samples.h>

#include "filter_runs.h"
#include "vtkBrindleCurves.h"
#include "vtkBrindleSamples.h"

namespace brindle::paraview {
namespace {

TEST(BrindleCurves, AreTheLibrarysCurves) {
  const auto data = swirling("torus,resolution=40");
  // An array of positions, to compare with the points of curves.
  data->GetPointData()->AddArray(vectors_by("place", data->GetNumberOfPoints(), [&](vtkIdType i) {
    double p[3];
    data->GetPoint(i, p);
    return Vec3(float(p[0]), float(p[1]), float(p[2]));
  }));
  const Surface surface = make_surface(make_shape("torus,resolution=40"));
  const StripePattern pattern = expected(*data, surface, 12, 0);
  for (const CurveOptions& options :
       {CurveOptions{}, CurveOptions{.join = true}, CurveOptions{.trim = 0.0f},
        CurveOptions{.fair = 0.25f}, CurveOptions{.join = true, .fair = 0.25f}}) {
    const StripeCurves curves = stripe_curves(surface, pattern, options);
    vtkNew<vtkBrindleCurves> filter;
    filter->SetInputData(data);
    filter->SetField(kArray);
    choose(*filter, 0, "v");
    filter->SetStripes(12);
    filter->SetJoin(options.join);
    if (options.trim) filter->SetTrim(static_cast<double>(*options.trim));
    filter->SetFair(static_cast<double>(options.fair));
    filter->Update();
    vtkPolyData& output = *filter->GetOutput();
    ASSERT_EQ(output.GetNumberOfLines(), static_cast<vtkIdType>(curves.lines.count()));
    ASSERT_EQ(output.GetNumberOfPoints(), static_cast<vtkIdType>(curves.lines.points.size()));
    const std::vector<float> places = numbers(output, "place");
    for (vtkIdType i = 0; i < output.GetNumberOfPoints(); ++i) {
      for (int c = 0; c < 3; ++c) {
        ASSERT_EQ(float(output.GetPoint(i)[c]),
                  curves.lines.points[static_cast<std::size_t>(i)][c]);
        ASSERT_NEAR(places[static_cast<std::size_t>(3 * i + c)], output.GetPoint(i)[c], 1e-5);
      }
    }
    for (std::size_t line = 0; line < curves.lines.count(); ++line) {
      const auto cell = static_cast<vtkIdType>(line);
      EXPECT_EQ(output.GetCellData()->GetArray("closed")->GetComponent(cell, 0),
                curves.lines.closed[line]);
      EXPECT_EQ(static_cast<std::size_t>(output.GetCellSize(cell)),
                curves.lines.points_of(line).size() + curves.lines.closed[line]);
    }
  }
}

TEST(BrindleCurves, LeaveShortOnesOut) {
  vtkNew<vtkBrindleCurves> filter;
  filter->SetInputData(swirling("torus,resolution=40"));
  filter->SetField(kArray);
  choose(*filter, 0, "v");
  filter->SetMinimumLength(1);
  filter->Update();
  vtkDataArray& lengths = *filter->GetOutput()->GetCellData()->GetArray("length");
  ASSERT_GT(lengths.GetNumberOfTuples(), 0);
  for (vtkIdType i = 0; i < lengths.GetNumberOfTuples(); ++i) {
    EXPECT_GE(lengths.GetComponent(i, 0), 1);
  }
  filter->SetMinimumLength(-1);
  EXPECT_NE(only_error(*filter).find("Minimum Length"), std::string::npos);
}

TEST(BrindleSamples, AreTheLibrarysSamples) {
  const auto data = swirling("torus,resolution=40");
  const Surface surface = make_surface(make_shape("torus,resolution=40"));
  const StripePattern u = expected(*data, surface, 12, 0);
  WaveSet crossing = u.waves;
  crossing.directions = rotated(u.waves.directions, surface.normals, std::numbers::pi_v<float> / 2);
  const StripePattern v = stripe_pattern(surface, crossing);
  const std::vector<Sample> samples = stripe_samples(surface, u, v);
  vtkNew<vtkBrindleSamples> filter;
  filter->SetInputData(data);
  filter->SetField(kArray);
  choose(*filter, 0, "v");
  filter->SetStripes(12);
  filter->Update();
  vtkPolyData& output = *filter->GetOutput();
  ASSERT_EQ(output.GetNumberOfPoints(), static_cast<vtkIdType>(samples.size()));
  EXPECT_EQ(output.GetNumberOfVerts(), output.GetNumberOfPoints());
  ASSERT_NE(output.GetPointData()->GetNormals(), nullptr);
  EXPECT_NE(output.GetPointData()->GetArray("v"), nullptr);
  const std::vector<float> spacings = numbers(output, "spacing_u");
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto point = static_cast<vtkIdType>(i);
    for (int c = 0; c < 3; ++c) {
      ASSERT_EQ(float(output.GetPoint(point)[c]), samples[i].position[c]);
      ASSERT_EQ(float(output.GetPointData()->GetNormals()->GetComponent(point, c)),
                samples[i].normal[c]);
    }
    ASSERT_EQ(spacings[i], samples[i].spacing_u);
  }

  filter->SetCrossingFactor(2);
  filter->Update();
  const auto denser = static_cast<double>(filter->GetOutput()->GetNumberOfPoints());
  EXPECT_NEAR(denser / static_cast<double>(samples.size()), 2, 0.3);
  filter->SetCrossingFactor(0);
  EXPECT_NE(only_error(*filter).find("Crossing Factor"), std::string::npos);
}

}  // namespace
}  // namespace brindle::paraview
