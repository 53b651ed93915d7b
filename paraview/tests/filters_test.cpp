#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include <Eigen/Geometry>
#include <brindle/array_field.h>
#include <brindle/samples.h>
#include <brindle/smooth_field.h>
#include <brindle/stripe_pattern.h>
#include <vtkAppendPolyData.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>

#include "vtkBrindleCurves.h"
#include "vtkBrindleSamples.h"
#include "vtkBrindleStripes.h"
#include "vtk_surfaces.h"

namespace brindle::paraview {
namespace {

enum { kSmooth, kCurvature, kDirection, kArray };
enum { kStripes, kFrequency, kFrequencyArray, kByArray };

vtkSmartPointer<vtkPolyData> swirling(const char* shape, float angle = 0) {
  auto data = polygons_of(make_shape(shape));
  add_swirl(*data, angle);
  return data;
}

/// The library's own pattern of the vectors.
StripePattern expected(vtkPolyData& data, const Surface& surface, float stripes, float slack) {
  DirectionField directions = tangent_directions(
      [&] {
        std::vector<Vec3> vectors;
        const std::vector<float> v = numbers(data, "v");
        for (std::size_t i = 0; i < v.size(); i += 3)
          vectors.emplace_back(v[i], v[i + 1], v[i + 2]);
        return vectors;
      }(),
      surface.normals);
  StripeOptions options;
  options.slack = slack;
  const float diagonal = bounding_box(surface.mesh).diagonal();
  return stripe_pattern(surface, std::move(directions), frequency_of_stripes(stripes, diagonal),
                        options);
}

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

// One stripe is one unit of U, its middle at 1/2, whichever way its wave runs.
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
    // At barycentres of split triangles U is the mean, and the phase what the surface shows.
    if (output.GetPointData()->GetArray("branch")->GetComponent(p, 0) > 0) continue;
    ASSERT_NEAR(std::sin(phase), sines[static_cast<std::size_t>(p)], 2e-4);
    ++compared;
  }
  EXPECT_GT(compared, used.size() / 2);
}

double area(vtkPolyData& data) {
  double sum = 0;
  for (vtkIdType t = 0; t < data.GetNumberOfPolys(); ++t) {
    vtkIdType count = 0;
    const vtkIdType* points = nullptr;
    data.GetPolys()->GetCellAtId(t, count, points);
    Eigen::Vector3d p[3];
    for (int k = 0; k < 3; ++k) data.GetPoint(points[k], p[k].data());
    sum += (p[1] - p[0]).cross(p[2] - p[0]).norm() / 2;
  }
  return sum;
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
  // A copied point has its original's rows: the label and the word say the same.
  for (vtkIdType i = 0; i < output.GetNumberOfPoints(); ++i) {
    const int label =
        static_cast<int>(output.GetPointData()->GetArray("label")->GetComponent(i, 0));
    ASSERT_EQ(output.GetPointData()->GetAbstractArray("word")->GetVariantValue(i).ToString(),
              std::to_string(label / 7));
  }
}

// Points that stand at one place with arrays of their own: a texture's seam, a crease's normals.
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

TEST(BrindleStripes, TakesGridsAsTheirSurface) {
  const auto data = swirling("torus,resolution=24");
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(data->GetPoints());
  grid->SetCells(VTK_TRIANGLE, data->GetPolys());
  grid->GetPointData()->ShallowCopy(data->GetPointData());
  vtkNew<vtkBrindleStripes> of_grid, of_polygons;
  of_grid->SetInputData(grid);
  of_polygons->SetInputData(data);
  for (vtkBrindleStripes* filter : {of_grid.Get(), of_polygons.Get()}) {
    filter->SetField(kArray);
    choose(*filter, 0, "v");
    filter->Update();
  }
  EXPECT_NEAR(
      of_grid->GetOutput()->GetFieldData()->GetArray("angle_error_mean_deg")->GetComponent(0, 0),
      of_polygons->GetOutput()
          ->GetFieldData()
          ->GetArray("angle_error_mean_deg")
          ->GetComponent(0, 0),
      0.1);
  EXPECT_NEAR(area(*of_grid->GetOutput()), area(*data), 1e-6);
}

TEST(BrindleStripes, TakesBlocksForOneSurface) {
  const Mesh whole = make_shape("torus,resolution=32");
  Mesh halves[2] = {whole, whole};
  for (int side : {0, 1}) {
    std::erase_if(halves[side].triangles, [&](const Triangle& t) {
      const float x =
          whole.positions[t[0]].x() + whole.positions[t[1]].x() + whole.positions[t[2]].x();
      return (x > 0) == (side == 0);
    });
  }
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned side : {0u, 1u}) {
    auto half = polygons_of(halves[side]);
    add_swirl(*half, 0);
    if (side == 1)
      half->GetPointData()->AddArray(
          vectors_by("one", half->GetNumberOfPoints(), [](vtkIdType) { return Vec3(1, 2, 3); }));
    blocks->SetBlock(side, half);
  }
  vtkNew<vtkBrindleStripes> filter;
  filter->SetInputData(blocks);
  filter->SetField(kArray);
  choose(*filter, 0, "v");
  filter->SetTextureCoordinates(false);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  ASSERT_NE(output, nullptr);
  const auto n = static_cast<std::size_t>(whole.vertex_count());
  const std::vector<float> phases = numbers(*output, "phase");
  ASSERT_EQ(phases.size(), 2 * n);
  const Surface surface = make_surface(whole);
  auto data = polygons_of(whole);
  add_swirl(*data, 0);
  // One pattern, as of the whole: both blocks' points at one place have one phase.
  for (std::size_t v = 0; v < n; ++v) {
    ASSERT_EQ(std::isnan(phases[v]), std::isnan(phases[v + n]));
    if (!std::isnan(phases[v])) {
      ASSERT_EQ(phases[v], phases[v + n]);
    }
  }
  const StripePattern pattern = expected(*data, surface, 40, 0);
  for (std::size_t v = 0; v < n; ++v) {
    if (std::isnan(phases[v])) continue;
    ASSERT_NEAR(std::abs(std::polar(1.0f, phases[v]) - pattern.solution.z[v]), 0, 1e-3);
  }
  EXPECT_EQ(output->GetPointData()->HasArray("one"), 0) << "not all blocks have it";

  Errors errors(*filter);
  choose(*filter, 0, "one");
  filter->Modified();
  filter->Update();
  ASSERT_EQ(errors.messages.size(), 1u);
  EXPECT_NE(errors.messages[0].find("'one'"), std::string::npos);
}

TEST(BrindleStripes, TakesFieldsOfCells) {
  const Mesh mesh = make_shape("sphere,resolution=24");
  const auto data = polygons_of(mesh);
  data->GetCellData()->AddArray(
      vectors_by("cells", data->GetNumberOfCells(), [](vtkIdType) { return Vec3(0, 0, 2); }));
  vtkNew<vtkBrindleStripes> by_cells, by_direction;
  by_cells->SetInputData(data);
  by_cells->SetField(kArray);
  choose(*by_cells, 0, "cells", false);
  by_direction->SetInputData(data);
  by_direction->SetField(kDirection);
  by_cells->Update();
  by_direction->Update();
  const std::vector<float> a = numbers(*by_cells->GetOutput(), "direction");
  const std::vector<float> b = numbers(*by_direction->GetOutput(), "direction");
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) ASSERT_NEAR(a[i], b[i], 1e-6f);
}

TEST(BrindleStripes, FollowsFrequenciesOfAnArray) {
  const auto data = swirling("sphere,resolution=24");
  vtkNew<vtkFloatArray> wanted;
  wanted->SetName("f");
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
    wanted->InsertNextValue(3 + float(data->GetPoint(i)[2]));
  }
  data->GetPointData()->AddArray(wanted);
  vtkNew<vtkBrindleStripes> filter;
  filter->SetInputData(data);
  filter->SetFrequencySource(kFrequencyArray);
  choose(*filter, 1, "f");
  filter->SetTextureCoordinates(false);
  filter->Update();
  EXPECT_EQ(numbers(*filter->GetOutput(), "frequency"), numbers(*data, "f"));

  filter->SetFrequencySource(kByArray);
  filter->SetFrequencyRange(0.5, 2);
  filter->SetStripes(10);
  filter->Update();
  const std::vector<float> f = numbers(*filter->GetOutput(), "frequency");
  const auto [low, high] = std::minmax_element(f.begin(), f.end());
  EXPECT_NEAR(*high / *low, 4, 1e-4);
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

/// What a filter says, once, of an input or a setting that cannot be; its output is then empty.
std::string only_error(vtkBrindleFilter& filter) {
  Errors errors(filter);
  filter.Update();
  EXPECT_EQ(errors.messages.size(), 1u);
  EXPECT_EQ(filter.GetOutput()->GetNumberOfPoints(), 0);
  return errors.messages.empty() ? "" : errors.messages[0];
}

TEST(BrindleStripes, SaysWhatIsWrong) {
  const auto has = [](const std::string& message, const char* part) {
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  const auto data = swirling("sphere,resolution=12");
  vtkNew<vtkFloatArray> number;
  number->SetName("number");
  number->SetNumberOfTuples(data->GetNumberOfPoints());
  number->Fill(-1);
  data->GetPointData()->AddArray(number);
  vtkNew<vtkBrindleStripes> filter;
  filter->SetInputData(data);
  filter->SetField(kArray);
  has(only_error(*filter), "choose an array");
  choose(*filter, 0, "w");
  has(only_error(*filter), "'w'");
  choose(*filter, 0, "number");
  has(only_error(*filter), "'number'");
  choose(*filter, 0, "v");
  filter->SetStripes(0);
  has(only_error(*filter), "above zero");
  filter->SetStripes(std::numeric_limits<double>::quiet_NaN());
  has(only_error(*filter), "above zero");
  filter->SetStripes(20);
  filter->SetSlack(-1);
  has(only_error(*filter), "lack");
  filter->SetSlack(0);
  filter->SetTimeAnchor(-1);
  has(only_error(*filter), "lambda");
  filter->SetTimeAnchor(0.025);
  filter->SetFrequencySource(kFrequencyArray);
  choose(*filter, 1, "number");
  has(only_error(*filter), "'number'");
  filter->SetFrequencySource(kStripes);
  filter->SetField(kDirection);
  filter->SetDirection(0, 0, 0);
  has(only_error(*filter), "0,0,0");
  filter->SetField(kArray);
  Errors none(*filter);
  filter->Update();
  EXPECT_TRUE(none.messages.empty()) << none.messages[0];
  EXPECT_GT(filter->GetOutput()->GetNumberOfPolys(), 0);
}

TEST(BrindleStripes, RefusesSurfacesThatAreNone) {
  const auto message = [](vtkDataObject* data) {
    vtkNew<vtkBrindleStripes> filter;
    filter->SetInputData(data);
    return only_error(*filter);
  };
  auto nan = polygons_of(make_shape("sphere,resolution=12"));
  nan->GetPoints()->SetPoint(5, 0, std::numeric_limits<double>::quiet_NaN(), 0);
  EXPECT_NE(message(nan).find('5'), std::string::npos);

  auto out_of_range = polygons_of(make_shape("sphere,resolution=12"));
  out_of_range->GetPolys()->InsertNextCell({0, 1, 1000000});
  EXPECT_NE(message(out_of_range).find("1000000"), std::string::npos);
  out_of_range->GetPolys()->InsertNextCell({0, 1, 2, 3});  // which VTK cuts into triangles
  EXPECT_NE(message(out_of_range).find("1000000"), std::string::npos);

  auto points = polygons_of(make_shape("sphere,resolution=12"));
  points->SetPolys(vtkSmartPointer<vtkCellArray>::New());
  EXPECT_NE(message(points).find("polygons"), std::string::npos);

  Mesh flat;
  flat.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  flat.triangles = {{0, 1, 2}};
  EXPECT_NE(message(polygons_of(flat)).find("area"), std::string::npos);
}

// Whatever type numbers have, they are those numbers.
TEST(BrindleStripes, TakesFieldsOfAnyType) {
  const auto data = polygons_of(make_shape("sphere,resolution=16"));
  const vtkIdType rows = data->GetNumberOfPoints();
  std::vector<float> expected_directions;
  for (const int type :
       {VTK_DOUBLE, VTK_FLOAT, VTK_CHAR, VTK_SIGNED_CHAR, VTK_SHORT, VTK_INT, VTK_LONG,
        VTK_LONG_LONG, VTK_ID_TYPE, VTK_UNSIGNED_CHAR, VTK_UNSIGNED_SHORT, VTK_UNSIGNED_INT,
        VTK_UNSIGNED_LONG, VTK_UNSIGNED_LONG_LONG}) {
    const auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
    array->SetName("v");
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(rows);
    for (vtkIdType i = 0; i < rows; ++i) {
      array->SetTuple3(i, 1 + double(i % 3), double(i % 5), 2 + double(i % 7));
    }
    data->GetPointData()->AddArray(array);
    vtkNew<vtkBrindleStripes> filter;
    filter->SetInputData(data);
    filter->SetField(kArray);
    choose(*filter, 0, "v");
    filter->SetTextureCoordinates(false);
    filter->Update();
    const std::vector<float> directions = numbers(*filter->GetOutput(), "direction");
    if (expected_directions.empty()) expected_directions = directions;
    EXPECT_EQ(directions, expected_directions) << array->GetClassName();
  }
}

// As programs leave behind that change points and forget arrays.
TEST(BrindleStripes, LeavesShortArraysOut) {
  const auto data = swirling("sphere,resolution=12");
  data->GetPointData()->AddArray(vectors_by("short", 5, [](vtkIdType) { return Vec3(1, 0, 0); }));
  vtkNew<vtkIntArray> unnamed;
  unnamed->SetNumberOfComponents(2);
  unnamed->SetNumberOfTuples(data->GetNumberOfPoints());
  unnamed->Fill(3);
  data->GetPointData()->AddArray(unnamed);
  vtkNew<vtkBrindleStripes> filter;
  filter->SetInputData(data);
  filter->Update();
  EXPECT_GT(filter->GetOutput()->GetNumberOfPolys(), 0);
  EXPECT_EQ(filter->GetOutput()->GetPointData()->HasArray("short"), 0);
  filter->SetField(kArray);
  choose(*filter, 0, "short");
  EXPECT_NE(only_error(*filter).find("'short'"), std::string::npos);
}

TEST(BrindleStripes, HasNothingToSayOfNothing) {
  vtkNew<vtkBrindleStripes> filter;
  filter->SetInputData(vtkSmartPointer<vtkPolyData>::New());
  Errors errors(*filter);
  filter->Update();
  EXPECT_TRUE(errors.messages.empty());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(BrindleStripes, CutsPolygonsAndLeavesLinesOut) {
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> quads, lines;
  constexpr int kSide = 12;
  for (int y = 0; y <= kSide; ++y) {
    for (int x = 0; x <= kSide; ++x) points->InsertNextPoint(x, y, 0);
  }
  for (vtkIdType y = 0; y < kSide; ++y) {
    for (vtkIdType x = 0; x < kSide; ++x) {
      const vtkIdType p = y * (kSide + 1) + x;
      quads->InsertNextCell({p, p + 1, p + kSide + 2, p + kSide + 1});
    }
  }
  lines->InsertNextCell({0, 1});
  data->SetPoints(points);
  data->SetPolys(quads);
  data->SetLines(lines);
  vtkNew<vtkFloatArray> cells;
  cells->SetName("cell");
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i) cells->InsertNextValue(float(i));
  data->GetCellData()->AddArray(cells);
  vtkNew<vtkBrindleStripes> filter;
  filter->SetInputData(data);
  filter->SetField(kDirection);
  filter->SetDirection(1, 0, 0);
  filter->SetStripes(6);
  filter->Update();
  vtkPolyData& output = *filter->GetOutput();
  EXPECT_EQ(output.GetNumberOfCells(), 2 * kSide * kSide);
  EXPECT_EQ(output.GetCellData()->GetArray("cell")->GetComponent(0, 0), 1) << "0 is the line";
}

TEST(BrindleStripes, StopsWhenItIsAsked) {
  vtkNew<vtkBrindleStripes> filter;
  filter->SetInputData(swirling("torus,resolution=40"));
  double last = 0;
  bool ordered = true, stop = false;
  struct Watch {
    double& last;
    bool &ordered, &stop;
  } watch{last, ordered, stop};
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&watch);
  command->SetCallback([](vtkObject* caller, unsigned long, void* data, void* progress) {
    auto& seen = *static_cast<Watch*>(data);
    const double now = *static_cast<double*>(progress);
    seen.ordered = seen.ordered && now >= seen.last && now <= 1;
    seen.last = now;
    if (seen.stop && now > 0.3) static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
  });
  filter->AddObserver(vtkCommand::ProgressEvent, command);
  Errors errors(*filter);
  stop = true;
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_TRUE(errors.messages.empty()) << "asking to stop is no error";

  stop = false;
  last = 0;
  ordered = true;
  filter->SetStripes(41);
  filter->Update();
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_TRUE(ordered);
}

TEST(BrindleCurves, AreTheLibrarysCurves) {
  const auto data = swirling("torus,resolution=40");
  // An array that says where a point is: curves then carry where they are.
  data->GetPointData()->AddArray(vectors_by("place", data->GetNumberOfPoints(), [&](vtkIdType i) {
    double p[3];
    data->GetPoint(i, p);
    return Vec3(float(p[0]), float(p[1]), float(p[2]));
  }));
  const Surface surface = make_surface(make_shape("torus,resolution=40"));
  const StripePattern pattern = expected(*data, surface, 12, 0);
  for (const bool join : {false, true}) {
    CurveOptions options;
    options.join = join;
    const StripeCurves curves = stripe_curves(surface, pattern, options);
    vtkNew<vtkBrindleCurves> filter;
    filter->SetInputData(data);
    filter->SetField(kArray);
    choose(*filter, 0, "v");
    filter->SetStripes(12);
    filter->SetJoin(join);
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
