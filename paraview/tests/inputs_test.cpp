// Inputs of filters: grids, blocks, polygons, arrays of any type.
#include <algorithm>
#include <cmath>

#include <brindle/mesh.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkUnstructuredGrid.h>

#include "filter_runs.h"

namespace brindle::paraview {
namespace {

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
  // One pattern over both blocks: points at one position have one phase.
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

/// Plane tensors with their larger eigenvector along (1, 1, 0), in the components of an order.
vtkSmartPointer<vtkDoubleArray> plane_tensors(const char* name, vtkIdType count,
                                              std::initializer_list<double> row) {
  const auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(row.size()));
  for (vtkIdType i = 0; i < count; ++i) array->InsertNextTuple(row.begin());
  return array;
}

TEST(BrindleStripes, TakesTensorsInTheOrderOfTheirComponents) {
  const auto data = polygons_of(make_shape("sphere,resolution=24"));
  for (vtkDataSetAttributes* rows : {static_cast<vtkDataSetAttributes*>(data->GetPointData()),
                                     static_cast<vtkDataSetAttributes*>(data->GetCellData())}) {
    const bool points = rows == data->GetPointData();
    const vtkIdType count = points ? data->GetNumberOfPoints() : data->GetNumberOfCells();
    rows->AddArray(plane_tensors("vtk", count, {2, 2, 0, 1, 0, 0}));
    rows->AddArray(plane_tensors("voigt", count, {2, 2, 0, 0, 0, 1}));
    rows->AddArray(plane_tensors("plane", count, {2, 2, 1}));
    rows->AddArray(plane_tensors("matrix", count, {2, 1, 1, 2}));
    vtkNew<vtkBrindleStripes> filter;
    filter->SetInputData(data);
    filter->SetField(kArray);
    const auto directions = [&](const char* name, int order) {
      choose(*filter, 0, name, points);
      filter->SetTensorOrder(order);
      filter->Update();
      return numbers(*filter->GetOutput(), "direction");
    };
    const std::vector<float> vtk = directions("vtk", 0);
    EXPECT_EQ(directions("voigt", 1), vtk);
    EXPECT_EQ(directions("plane", 2), vtk);
    EXPECT_EQ(directions("matrix", 2), vtk);
    EXPECT_NE(directions("voigt", 0), vtk);
    choose(*filter, 0, "plane", points);
    filter->SetTensorOrder(1);
    EXPECT_NE(only_error(*filter).find("'plane'"), std::string::npos);
  }
}

TEST(BrindleStripes, TakesTheDistanceBetweenStripes) {
  const auto data = polygons_of(make_shape("torus,resolution=24"));
  vtkNew<vtkBrindleStripes> by_spacing, by_frequency;
  by_spacing->SetFrequencySource(kSpacing);
  by_spacing->SetSpacing(0.125);
  by_frequency->SetFrequencySource(kFrequency);
  by_frequency->SetFrequency(8);
  for (vtkBrindleStripes* filter : {by_spacing.Get(), by_frequency.Get()}) {
    filter->SetInputData(data);
    filter->Update();
  }
  EXPECT_EQ(numbers(*by_spacing->GetOutput(), "sin_phase"),
            numbers(*by_frequency->GetOutput(), "sin_phase"));
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

// Numbers of any type give the same result.
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

// Left by programs that change points but not arrays.
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

// Quadrangles and larger polygons are triangulated as by the library; strips are split with
// consistent winding.
TEST(BrindleStripes, CutsPolygonsAsTheLibraryDoes) {
  const Mesh torus = make_shape("torus,resolution=12");
  auto data = polygons_of(torus);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {  // makes quadrangles non-planar
    double p[3];
    data->GetPoint(i, p);
    data->GetPoints()->SetPoint(i, p[0] + 0.03 * std::sin(7.0 * double(i)), p[1], p[2]);
  }
  std::vector<Vec3> positions;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
    double p[3];
    data->GetPoint(i, p);
    positions.emplace_back(float(p[0]), float(p[1]), float(p[2]));
  }
  // Pairs of triangles that share an edge, and the star around a vertex.
  std::vector<Triangle> expected;
  vtkNew<vtkCellArray> polygons, strips;
  for (std::size_t t = 0; t + 1 < torus.triangle_count(); t += 2) {
    const Triangle &a = torus.triangles[t], &b = torus.triangles[t + 1];
    const auto apex =
        std::ranges::find_if(b, [&](Index v) { return std::ranges::find(a, v) == a.end(); });
    std::size_t k = 0;
    while (k < 3 && std::ranges::find(b, a[k]) != b.end()) ++k;
    if (apex == b.end() || k == 3) continue;
    const std::vector<Index> quad = {a[k], a[(k + 1) % 3], *apex, a[(k + 2) % 3]};
    triangulate_polygon(positions, quad, expected);
    polygons->InsertNextCell({quad[0], quad[1], quad[2], quad[3]});
  }
  ASSERT_GT(expected.size(), 100u);
  strips->InsertNextCell({0, 1, 2, 3, 4});
  expected.insert(expected.end(), {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}});
  data->SetPolys(polygons);
  data->SetStrips(strips);
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("number");
  for (int i = 0; i < data->GetNumberOfCells(); ++i) numbers->InsertNextValue(i);
  data->GetCellData()->AddArray(numbers);
  vtkNew<vtkBrindleStripes> filter;
  filter->SetInputData(data);
  filter->SetField(kDirection);
  filter->SetCreaseAngle(180);
  filter->SetTextureCoordinates(false);
  filter->Update();
  vtkPolyData& output = *filter->GetOutput();
  ASSERT_EQ(output.GetNumberOfPolys(), static_cast<vtkIdType>(expected.size()));
  for (vtkIdType t = 0; t < output.GetNumberOfPolys(); ++t) {
    vtkIdType count = 0;
    const vtkIdType* points = nullptr;
    output.GetPolys()->GetCellAtId(t, count, points);
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_EQ(points[c], expected[static_cast<std::size_t>(t)][c]);
    const auto cell =
        static_cast<vtkIdType>(output.GetCellData()->GetArray("number")->GetComponent(t, 0));
    EXPECT_EQ(cell, std::min(t / 2, polygons->GetNumberOfCells()));
  }
}

}  // namespace
}  // namespace brindle::paraview
