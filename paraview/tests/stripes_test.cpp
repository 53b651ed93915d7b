// Results of `Brindle Stripes`.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <brindle/creases.h>
#include <brindle/frequency_field.h>
#include <brindle/measured_field.h>
#include <brindle/smooth_field.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkStringArray.h>

#include "filter_runs.h"
#include "vtkBrindleCurves.h"

namespace brindle::paraview {
namespace {

TEST(BrindleStripes, HasTheLibrarysPatternBitForBit) {
  for (const float slack : {0.0f, 0.25f}) {
    const auto data = swirling("torus,resolution=40");
    const Surface surface = make_surface(make_shape("torus,resolution=40"));
    const StripePattern pattern = expected(*data, surface, 12, slack);
    vtkNew<vtkBrindleStripes> filter;
    filter->SetInputData(data);
    filter->SetField(kArray);
    choose(*filter, 0, "v");
    filter->SetStripes(12);
    filter->SetSlack(slack);
    for (const bool coordinates : {false, true}) {
      filter->SetTextureCoordinates(coordinates);
      filter->Update();
      expect_phases(*filter->GetOutput(), pattern.solution.z);
    }
    const std::vector<float> frequencies = numbers(*filter->GetOutput(), "frequency");
    EXPECT_TRUE(std::equal(pattern.waves.frequencies.begin(), pattern.waves.frequencies.end(),
                           frequencies.begin()));
    EXPECT_EQ(filter->GetOutput()->GetPointData()->HasArray("frequency_wanted"), slack > 0);
    EXPECT_EQ(filter->GetOutput()->GetFieldData()->GetArray("branches")->GetComponent(0, 0),
              static_cast<double>(pattern.quality.branches));
    EXPECT_EQ(filter->GetSolversMade(), 1) << "a new form of the output is no new pattern";
  }
}

TEST(BrindleStripes, EachSideOfACreaseHasItsOwnWave) {
  Mesh mesh = make_shape("box,resolution=20,fillet=0.001");
  const auto data = polygons_of(mesh);
  data->GetPointData()->AddArray(vectors_by("place", data->GetNumberOfPoints(), [&](vtkIdType i) {
    return mesh.positions[static_cast<std::size_t>(i)];
  }));
  const std::size_t own = mesh.vertex_count();
  Creases creases = split_at_creases(mesh);
  ASSERT_FALSE(creases.empty());
  const Surface surface = make_surface(std::move(mesh), std::move(creases));
  const Vec3 direction(1, 2, 3);
  const FrequencyField frequencies = constant_frequency_field(
      frequency_of_stripes(12, bounding_box(surface.mesh).diagonal()), surface.mesh.vertex_count());
  const StripePattern pattern =
      stripe_pattern(surface, projected_direction_field(direction, surface.normals), frequencies);

  vtkNew<vtkBrindleStripes> filter;
  filter->SetInputData(data);
  filter->SetField(kDirection);
  filter->SetDirection(1, 2, 3);
  filter->SetStripes(12);
  filter->SetTextureCoordinates(false);
  filter->Update();
  expect_phases(*filter->GetOutput(), pattern.solution.z);
  const std::vector<float> places = numbers(*filter->GetOutput(), "place");
  ASSERT_EQ(places.size(), 3 * surface.mesh.vertex_count());
  for (std::size_t v = 0; v < surface.mesh.vertex_count(); ++v) {
    EXPECT_EQ(Vec3(&places[3 * v]), surface.mesh.positions[v]) << "at point " << v;
  }
  filter->SetCreaseAngle(180);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), static_cast<vtkIdType>(own));
  Errors errors(*filter);
  filter->SetCreaseAngle(-1);
  filter->Update();
  filter->SetStripes(13);
  filter->Update();
  EXPECT_EQ(errors.messages.size(), 2u);
}

/// Two squares that meet at a fold.
Mesh tent(float slope) {
  Mesh mesh = make_shape("plane,resolution=16");
  for (Vec3& p : mesh.positions) p.z() = -slope * std::abs(p.x());
  return mesh;
}

TEST(BrindleStripes, CreasesStayWhereTheyAreWhileASurfaceMoves) {
  vtkNew<vtkBrindleStripes> filter;
  filter->SetField(kDirection);
  filter->SetDirection(1, 2, 3);
  filter->SetTextureCoordinates(false);
  filter->SetInputData(polygons_of(tent(1)));
  filter->Update();
  const vtkIdType count = filter->GetOutput()->GetNumberOfPoints();
  EXPECT_GT(count, static_cast<vtkIdType>(tent(1).vertex_count()));
  filter->SetInputData(polygons_of(tent(0.1f)));
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), count);
}

/// A swirl with noise, and a hole in it.
vtkSmartPointer<vtkPolyData> noisy_swirl() {
  auto data = swirling("torus,resolution=60");
  vtkDataArray& vectors = *data->GetPointData()->GetArray("v");
  for (vtkIdType i = 0; i < vectors.GetNumberOfTuples(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const double noise = std::sin(static_cast<double>(1000 + 3 * i + k) * 12.9898) * 43758.5453;
      const double kept = i % 7 == 0 ? std::nan("") : vectors.GetComponent(i, k);
      vectors.SetComponent(i, k, kept + 1.2 * (noise - std::floor(noise) - 0.5));
    }
  }
  return data;
}

TEST(BrindleStripes, SeesMeasuredFieldsAtTheScaleOfTheirStripes) {
  const auto data = noisy_swirl();
  const Surface surface = make_surface(make_shape("torus,resolution=60"));
  MeasuredField measured;
  const std::vector<float> v = numbers(*data, "v");
  for (std::size_t i = 0; i < v.size(); i += 3)
    measured.directions.push_back(
        tangent_direction(Vec3(v[i], v[i + 1], v[i + 2]), surface.normals[i / 3]));
  const FrequencyField frequencies = constant_frequency_field(
      frequency_of_stripes(12, bounding_box(surface.mesh).diagonal()), v.size() / 3);
  const SmoothedField field =
      FieldSmoothing(surface, {.periods = 1.5f, .singularities = 0}).frame(measured, frequencies);
  const StripePattern pattern = stripe_pattern(surface, field.directions, frequencies);

  vtkNew<vtkBrindleStripes> filter;
  filter->SetInputData(data);
  filter->SetField(kArray);
  choose(*filter, 0, "v");
  filter->SetStripes(12);
  Errors warnings(*filter, vtkCommand::WarningEvent);
  filter->Update();
  EXPECT_TRUE(std::ranges::any_of(warnings.messages, [](const std::string& message) {
    return message.find("Field Smoothing 1") != std::string::npos;
  })) << "noise is warned of";
  const double as_given = metric(*filter->GetOutput(), "branches");
  filter->SetFieldSmoothing(1.5);
  filter->SetFieldSingularities(0);
  filter->SetTextureCoordinates(false);
  filter->Update();
  expect_phases(*filter->GetOutput(), pattern.solution.z);
  EXPECT_EQ(metric(*filter->GetOutput(), "branches"),
            static_cast<double>(pattern.quality.branches));
  EXPECT_GT(as_given, 2 * static_cast<double>(pattern.quality.branches) + 10);
  filter->SetFieldSmoothing(101);
  EXPECT_NE(only_error(*filter).find("0 to 100"), std::string::npos);
}

TEST(BrindleStripes, CountsDataOfCellsAsTheyAreAndByTheirWeights) {
  const auto data = polygons_of(make_shape("torus,resolution=60"));
  const Surface surface = make_surface(make_shape("torus,resolution=60"));
  MeasuredField measured;
  measured.of_triangles = true;
  vtkNew<vtkDoubleArray> weights;
  weights->SetName("weight");
  const auto vectors = vectors_by("cells", data->GetNumberOfCells(), [&](vtkIdType t) {
    const auto& [a, b, c] = surface.mesh.triangles[static_cast<std::size_t>(t)];
    const std::vector<Vec3>& p = surface.mesh.positions;
    Vec3 vector = swirl((p[a] + p[b] + p[c]) / 3, 0);
    if (t % 2 == 0) vector = -vector;
    if (t % 5 == 0) vector = Vec3(1, 2, 3);  // weight zero
    weights->InsertNextValue(t % 5 == 0 ? 0 : 2);
    measured.directions.push_back(vector.cast<double>().stableNormalized().cast<float>());
    measured.confidence.push_back(t % 5 == 0 ? 0.0f : 2.0f);
    return vector;
  });
  data->GetCellData()->AddArray(vectors);
  data->GetCellData()->AddArray(weights);
  const FrequencyField frequencies = constant_frequency_field(
      frequency_of_stripes(12, bounding_box(surface.mesh).diagonal()), surface.normals.size());
  const SmoothedField field = FieldSmoothing(surface).frame(measured, frequencies);

  vtkNew<vtkBrindleStripes> filter;
  filter->SetInputData(data);
  filter->SetField(kArray);
  choose(*filter, 0, "cells", false);
  choose(*filter, 2, "weight", false);
  filter->SetStripes(12);
  filter->SetFieldSmoothing(1);
  filter->SetTextureCoordinates(false);
  filter->Update();
  expect_phases(*filter->GetOutput(),
                stripe_pattern(surface, field.directions, frequencies).solution.z);
  EXPECT_EQ(numbers(*filter->GetOutput(), "coherence"), field.coherence);
  choose(*filter, 2, "None");
  filter->Update();
  EXPECT_NE(numbers(*filter->GetOutput(), "coherence"), field.coherence);
  filter->SetTextureCoordinates(true);
  filter->Update();
  EXPECT_TRUE(filter->GetOutput()->GetPointData()->HasArray("coherence"));
  filter->SetFieldSmoothing(0);
  filter->Update();
  EXPECT_FALSE(filter->GetOutput()->GetPointData()->HasArray("coherence"));
}

TEST(BrindleStripes, SeesFrequenciesAtTheScaleOfTheirStripes) {
  const auto data = swirling("torus,resolution=60");
  const Surface surface = make_surface(make_shape("torus,resolution=60"));
  vtkNew<vtkDoubleArray> density;
  density->SetName("density");
  FrequencyField given;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
    const float noise = 0.4f * std::sin(static_cast<float>(7 * i));
    given.push_back(i % 9 == 0 ? std::nanf("") : 3 * std::exp(noise));
    density->InsertNextValue(static_cast<double>(given.back()));
  }
  data->GetPointData()->AddArray(density);
  vtkNew<vtkBrindleStripes> filter;
  filter->SetInputData(data);
  filter->SetField(kArray);
  choose(*filter, 0, "v");
  filter->SetFrequencySource(kFrequencyArray);
  choose(*filter, 1, "density");
  filter->SetTextureCoordinates(false);
  filter->SetFrequencySmoothing(1);
  filter->Update();
  EXPECT_EQ(numbers(*filter->GetOutput(), "frequency"),
            smoothed_frequencies(surface, given).frequencies);
  filter->SetFrequencySmoothing(-1);
  EXPECT_NE(only_error(*filter).find("Frequency Smoothing"), std::string::npos);
}

TEST(BrindleStripes, MakesFieldsAsTheLibraryDoes) {
  const Mesh mesh = make_shape("trefoil,resolution=24");
  const Surface surface = make_surface(mesh);
  const float frequency = frequency_of_stripes(40, bounding_box(mesh).diagonal());
  SmoothFieldOptions curvature;
  curvature.curvature_anchor = 0.1f;
  curvature.curvature_direction = CurvatureDirection::minimum;
  const std::vector<DirectionField> fields = {
      smooth_direction_field(surface), smooth_direction_field(surface, curvature),
      rotated(projected_direction_field({1, 2, 3}, surface.normals), surface.normals,
              std::numbers::pi_v<float> / 2)};
  vtkNew<vtkBrindleStripes> filter;
  filter->SetInputData(polygons_of(mesh));
  filter->SetCurvatureDirection(1);
  filter->SetDirection(1, 2, 3);
  for (const int field : {kSmooth, kCurvature, kDirection}) {
    filter->SetField(field);
    filter->SetAlong(field == kDirection);
    filter->Update();
    expect_phases(
        *filter->GetOutput(),
        stripe_pattern(surface, fields[static_cast<std::size_t>(field)], frequency).solution.z);
  }
}

// One stripe is one unit of U, with its middle at 1/2, for either sign of the wave.
TEST(BrindleStripes, TextureCoordinatesAreLinearPhases) {
  vtkNew<vtkBrindleStripes> filter;
  filter->SetInputData(swirling("trefoil,resolution=24"));
  filter->SetField(kArray);
  choose(*filter, 0, "v");
  filter->Update();
  vtkPolyData& output = *filter->GetOutput();
  vtkDataArray& uv = *output.GetPointData()->GetTCoords();
  const std::vector<float> sines = numbers(output, "sin_phase");
  std::set<vtkIdType> used;
  for (vtkIdType t = 0; t < output.GetNumberOfPolys(); ++t) {
    vtkIdType count = 0;
    const vtkIdType* points = nullptr;
    output.GetPolys()->GetCellAtId(t, count, points);
    ASSERT_EQ(count, 3);
    used.insert(points, points + 3);
  }
  std::size_t compared = 0;
  for (const vtkIdType p : used) {
    ASSERT_EQ(uv.GetComponent(p, 1), 0.5);
    if (std::isnan(sines[static_cast<std::size_t>(p)])) continue;
    const double phase = 2 * std::numbers::pi * (uv.GetComponent(p, 0) - 0.25);
    // At barycentres of split triangles U is the mean, and the phase follows U.
    if (output.GetPointData()->GetArray("branch")->GetComponent(p, 0) > 0) continue;
    ASSERT_NEAR(std::sin(phase), sines[static_cast<std::size_t>(p)], 2e-4);
    ++compared;
  }
  EXPECT_GT(compared, used.size() / 2);
}

TEST(BrindleStripes, KeepsTheInputsPointsArraysAndShape) {
  const auto data = swirling("trefoil,resolution=24");
  vtkNew<vtkIntArray> labels;
  vtkNew<vtkStringArray> words;
  labels->SetName("label");
  words->SetName("word");
  for (int i = 0; i < data->GetNumberOfPoints(); ++i) {
    labels->InsertNextValue(7 * i);
    words->InsertNextValue(std::to_string(i));
  }
  data->GetPointData()->AddArray(labels);
  data->GetPointData()->AddArray(words);
  vtkNew<vtkIntArray> cells;
  cells->SetName("cell");
  for (int i = 0; i < data->GetNumberOfCells(); ++i) cells->InsertNextValue(i);
  data->GetCellData()->AddArray(cells);

  vtkNew<vtkBrindleStripes> filter;
  filter->SetInputData(data);
  filter->Update();
  vtkPolyData& output = *filter->GetOutput();
  ASSERT_GT(output.GetNumberOfPoints(), data->GetNumberOfPoints()) << "seams copy points";
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
    Eigen::Vector3d p, q;
    data->GetPoint(i, p.data());
    output.GetPoint(i, q.data());
    ASSERT_EQ(p, q);
    ASSERT_EQ(output.GetPointData()->GetArray("label")->GetComponent(i, 0), 7.0 * double(i));
    ASSERT_EQ(output.GetPointData()->GetAbstractArray("word")->GetVariantValue(i).ToString(),
              std::to_string(i));
  }
  EXPECT_NEAR(area(output), area(*data), 1e-9 * area(*data));
  EXPECT_EQ(output.GetCellData()->GetArray("cell")->GetNumberOfTuples(), output.GetNumberOfCells());
  // A copied point has its original's rows, of numbers and of text.
  for (vtkIdType i = 0; i < output.GetNumberOfPoints(); ++i) {
    const int label =
        static_cast<int>(output.GetPointData()->GetArray("label")->GetComponent(i, 0));
    ASSERT_EQ(output.GetPointData()->GetAbstractArray("word")->GetVariantValue(i).ToString(),
              std::to_string(label / 7));
  }
}

// Points at one position with their own arrays: a texture's seam, a crease's normals.
TEST(BrindleStripes, RunsAcrossSeamsAndKeepsBothSides) {
  const Mesh whole = make_shape("sphere,resolution=20");
  Mesh cut = whole;
  std::vector<Index> copy_of(whole.vertex_count(), ~Index{0});
  std::vector<float> side(whole.vertex_count(), 0);
  for (Triangle& t : cut.triangles) {
    const float x =
        whole.positions[t[0]].x() + whole.positions[t[1]].x() + whole.positions[t[2]].x();
    if (x < 0) continue;
    for (Index& v : t) {
      if (copy_of[v] == ~Index{0}) {
        copy_of[v] = static_cast<Index>(cut.positions.size());
        cut.positions.push_back(whole.positions[v]);
        side.push_back(1);
      }
      v = copy_of[v];
    }
  }
  const auto data = polygons_of(cut);
  vtkNew<vtkFloatArray> sides;
  sides->SetName("side");
  for (const float s : side) sides->InsertNextValue(s);
  data->GetPointData()->AddArray(sides);
  vtkNew<vtkBrindleStripes> filter;
  filter->SetInputData(data);
  filter->SetField(kDirection);
  filter->Update();
  vtkPolyData& output = *filter->GetOutput();

  const Surface surface = make_surface(whole);
  const StripePattern pattern =
      stripe_pattern(surface, projected_direction_field(Vec3::UnitZ(), surface.normals),
                     frequency_of_stripes(40, bounding_box(whole).diagonal()));
  const std::vector<float> phases = numbers(output, "phase");
  for (Index v = 0; v < whole.vertex_count(); ++v) {
    if (std::isnan(phases[v])) continue;
    ASSERT_NEAR(std::abs(std::polar(1.0f, phases[v]) - pattern.solution.z[v]), 0, 1e-3);
    if (copy_of[v] != ~Index{0}) {
      ASSERT_EQ(phases[copy_of[v]], phases[v]);
    }
  }
  for (vtkIdType t = 0; t < output.GetNumberOfPolys(); ++t) {
    vtkIdType count = 0;
    const vtkIdType* points = nullptr;
    output.GetPolys()->GetCellAtId(t, count, points);
    const std::vector<float> at = numbers(output, "side");
    ASSERT_EQ(at[static_cast<std::size_t>(points[0])], at[static_cast<std::size_t>(points[1])]);
    ASSERT_EQ(at[static_cast<std::size_t>(points[0])], at[static_cast<std::size_t>(points[2])]);
    if (t > 200) break;
  }
}

TEST(BrindleStripes, FarFromZeroPointsStayWhereTheyAre) {
  const auto data = polygons_of(make_shape("torus,resolution=24"));
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
    double p[3];
    data->GetPoint(i, p);
    data->GetPoints()->SetPoint(i, p[0] + 4e6, p[1] - 3e6, p[2]);
  }
  vtkNew<vtkBrindleStripes> stripes;
  vtkNew<vtkBrindleCurves> curves;
  for (vtkBrindleFilter* filter :
       {static_cast<vtkBrindleFilter*>(stripes), static_cast<vtkBrindleFilter*>(curves)}) {
    filter->SetInputData(data);
    filter->Update();
    double a[6], b[6];
    data->GetBounds(a);
    filter->GetOutput()->GetBounds(b);
    for (int i = 0; i < 6; ++i) EXPECT_NEAR(a[i], b[i], 0.05);
  }
  EXPECT_NEAR(area(*stripes->GetOutput()), area(*data), 1e-6);
}

}  // namespace
}  // namespace brindle::paraview
