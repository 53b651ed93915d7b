// Inputs of ranks.
#include <unordered_map>

#include <vtkMultiBlockDataSet.h>
#include <vtkRTAnalyticSource.h>
#include <vtkUnstructuredGrid.h>

#include "rank_patterns.h"

namespace brindle::paraview {
namespace {

// A layer of ghosts does not change the result, and stays unchanged.
TEST(RankGhosts, AreSeenAndNotCounted) {
  for (const std::size_t which : {0u, 1u}) {
    for (const double slack : {0.0, 0.25}) {
      const Cut& cut = cuts()[which];
      SCOPED_TRACE(std::string(cut.name) + ", slack " + std::to_string(slack));
      const Pieces pieces(kShape, cut);
      vtkNew<vtkBrindleStripes> plain, ghosts;
      plain->SetSlack(slack);
      ghosts->SetSlack(slack);
      const auto data = pieces.polygons(true);
      lay_swirl(*plain, data);
      const auto more = with_ghosts(data.Get());
      const long given = ghost_count(*more);
      EXPECT_EQ(sum(double(given)) > 0, rank_count() > 1);
      lay_swirl(*ghosts, more);
      vtkPolyData& output = *ghosts->GetOutput();
      expect_one_pattern(pieces.whole, output);
      for (const char* name : {"phase", "frequency"}) {
        const Gathered a(pieces.whole.vertex_count(), *plain->GetOutput(), name);
        const Gathered b(pieces.whole.vertex_count(), output, name);
        EXPECT_EQ(a.values, b.values) << name;
      }
      for (const char* name : {"branches", "angle_error_mean_deg", "spacing_error_mean"}) {
        EXPECT_EQ(metric(output, name), metric(*plain->GetOutput(), name)) << name;
      }
      EXPECT_EQ(ghost_count(output), given) << "the output keeps ghosts";
      EXPECT_EQ(output.GetNumberOfCells(), more->GetNumberOfCells());
      ghosts->SetTextureCoordinates(true);
      ghosts->Update();
      EXPECT_GE(ghost_count(*ghosts->GetOutput()), given);
      EXPECT_NE(ghosts->GetOutput()->GetPointData()->GetTCoords(), nullptr);
    }
  }
}

/// A beam of hexahedra, cut across the ranks, with global point numbers.
vtkSmartPointer<vtkUnstructuredGrid> beam() {
  constexpr int kLong = 24, kSide = 8;
  const int first = kLong * rank() / rank_count(), last = kLong * (rank() + 1) / rank_count();
  vtkNew<vtkPoints> points;
  vtkNew<vtkIdTypeArray> numbers;
  numbers->SetName("whole");
  for (int x = first; x <= last; ++x) {
    for (int y = 0; y <= kSide; ++y) {
      for (int z = 0; z <= kSide; ++z) {
        points->InsertNextPoint(0.1 * x, 0.1 * y, 0.1 * z);
        numbers->InsertNextValue((x * (kSide + 1) + y) * (kSide + 1) + z);
      }
    }
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  grid->GetPointData()->AddArray(numbers);
  const auto at = [&](int x, int y, int z) {
    return static_cast<vtkIdType>(((x - first) * (kSide + 1) + y) * (kSide + 1) + z);
  };
  for (int x = first; x < last; ++x) {
    for (int y = 0; y < kSide; ++y) {
      for (int z = 0; z < kSide; ++z) {
        const vtkIdType corners[] = {
            at(x, y, z),     at(x + 1, y, z),     at(x + 1, y + 1, z),     at(x, y + 1, z),
            at(x, y, z + 1), at(x + 1, y, z + 1), at(x + 1, y + 1, z + 1), at(x, y + 1, z + 1)};
        grid->InsertNextCell(VTK_HEXAHEDRON, 8, corners);
      }
    }
  }
  return grid;
}

double own_cells(vtkPolyData& data) {
  return static_cast<double>(data.GetNumberOfCells() - ghost_count(data));
}

// Every side of the beam has a wave of its own, also where ranks meet: its stripes are exact.
TEST(RankGrids, HaveExactStripesOnFlatFaces) {
  for (const bool ghosts : {false, true}) {
    SCOPED_TRACE(ghosts ? "ghosts" : "no ghosts");
    vtkNew<vtkBrindleStripes> filter;
    vtkSmartPointer<vtkUnstructuredGrid> grid = beam();
    if (ghosts) grid = with_ghosts(grid.Get());
    filter->SetInputData(grid);
    filter->SetField(kDirection);
    filter->SetDirection(1, 0.3, 0.2);
    filter->SetStripes(20);
    Errors errors(*filter);
    Errors warnings(*filter, vtkCommand::WarningEvent);
    filter->Update();
    ASSERT_TRUE(errors.messages.empty()) << errors.messages[0];
    EXPECT_TRUE(warnings.messages.empty()) << warnings.messages[0];
    vtkPolyData& output = *filter->GetOutput();
    EXPECT_EQ(sum(own_cells(output)), 2 * 2.0 * (8 * 8 + 2 * 8 * 24));
    EXPECT_EQ(metric(output, "branches"), 0);
    EXPECT_LT(metric(output, "angle_error_mean_deg"), 0.01);
    filter->SetCreaseAngle(180);
    filter->Update();
    EXPECT_GT(metric(output, "angle_error_mean_deg"), 0.1);
  }
}

// The surface of a grid is that of the whole, without internal faces between ranks.
TEST(RankGrids, HaveTheSurfaceOfTheWhole) {
  const double faces = 2.0 * (8 * 8 + 2 * 8 * 24);
  const auto check = [&](vtkDataObject* data) {
    vtkNew<vtkBrindleStripes> filter;
    filter->SetInputData(data);
    filter->SetField(kDirection);
    filter->SetDirection(1, 0.3, 0.2);
    filter->SetCreaseAngle(180);
    filter->SetTextureCoordinates(false);
    Errors errors(*filter);
    filter->Update();
    ASSERT_TRUE(errors.messages.empty()) << errors.messages[0];
    vtkPolyData& output = *filter->GetOutput();
    EXPECT_EQ(sum(own_cells(output)), 2 * faces);
    const Gathered phases(25 * 9 * 9, output, "phase");
    EXPECT_EQ(phases.different, 0u);
    EXPECT_EQ(phases.shared > 0, rank_count() > 1);
  };
  for (const bool ghosts : {false, true}) {
    SCOPED_TRACE(ghosts ? "ghosts" : "no ghosts");
    vtkSmartPointer<vtkUnstructuredGrid> grid = beam();
    if (ghosts) grid = with_ghosts(grid.Get());
    check(grid);
    vtkNew<vtkMultiBlockDataSet> block;
    block->SetBlock(0, grid);
    check(block);
  }
}

// The same for distributed images, as from sources.
TEST(RankGrids, OfImagesHaveNoWalls) {
  vtkNew<vtkRTAnalyticSource> source;
  source->SetWholeExtent(-8, 8, -4, 4, -4, 4);
  vtkNew<vtkBrindleStripes> filter;
  filter->SetInputConnection(source->GetOutputPort());
  filter->SetField(kDirection);
  filter->SetDirection(1, 0.3, 0.2);
  filter->SetTextureCoordinates(false);
  Errors errors(*filter);
  filter->UpdatePiece(rank(), rank_count(), 0);
  ASSERT_TRUE(errors.messages.empty()) << errors.messages[0];
  const double faces = 2.0 * (8 * 8 + 2 * 8 * 16);
  EXPECT_EQ(sum(own_cells(*filter->GetOutput())), 2 * faces);
}

/// Slabs of the beam as pieces of a file, each with its own points, optionally with shuffled global
/// ids.
vtkSmartPointer<vtkUnstructuredGrid> beam_in_pieces(const std::vector<int>& pieces, bool ids) {
  constexpr int kPieces = 4, kLong = 24, kSide = 8, kRow = (kSide + 1) * (kSide + 1);
  vtkNew<vtkPoints> points;
  vtkNew<vtkIdTypeArray> numbers, global;
  numbers->SetName("whole");
  global->SetName("GlobalPointIds");
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  for (const int piece : pieces) {
    const int from = kLong * piece / kPieces, to = kLong * (piece + 1) / kPieces;
    const vtkIdType first = points->GetNumberOfPoints();
    for (int v = from * kRow; v < (to + 1) * kRow; ++v) {
      points->InsertNextPoint(0.1 * (v / kRow), 0.1 * (v / (kSide + 1) % (kSide + 1)),
                              0.1 * (v % (kSide + 1)));
      numbers->InsertNextValue(v);
      global->InsertNextValue(v * 577 % 7919);
    }
    const auto at = [&](int x, int y, int z) {
      return first + static_cast<vtkIdType>(((x - from) * (kSide + 1) + y) * (kSide + 1) + z);
    };
    for (int cell = from * kSide * kSide; cell < to * kSide * kSide; ++cell) {
      const int x = cell / (kSide * kSide), y = cell / kSide % kSide, z = cell % kSide;
      const vtkIdType corners[] = {
          at(x, y, z),     at(x + 1, y, z),     at(x + 1, y + 1, z),     at(x, y + 1, z),
          at(x, y, z + 1), at(x + 1, y, z + 1), at(x + 1, y + 1, z + 1), at(x, y + 1, z + 1)};
      grid->InsertNextCell(VTK_HEXAHEDRON, 8, corners);
    }
  }
  grid->GetPointData()->AddArray(numbers);
  if (ids) grid->GetPointData()->SetGlobalIds(global);
  return grid;
}

/// Stripes of a direction, without texture coordinates.
void lay_level(vtkBrindleStripes& filter, vtkDataObject* data) {
  filter.SetCreaseAngle(180);
  filter.SetInputDataObject(data);
  filter.SetField(kDirection);
  filter.SetDirection(1, 0.3, 0.2);
  filter.SetTextureCoordinates(false);
  Errors errors(filter);
  filter.Update();
  EXPECT_TRUE(errors.messages.empty()) << errors.messages[0];
}

/// The ranks together have the pattern of one process: surface, phases, metrics.
void expect_pattern_of_one(std::size_t vertices, vtkDataObject* own, vtkDataObject* all) {
  vtkNew<vtkBrindleStripes> one, many;
  alone([&] { lay_level(*one, all); });
  lay_level(*many, own);
  vtkPolyData& whole = *one->GetOutput();
  EXPECT_EQ(sum(own_cells(*many->GetOutput())), own_cells(whole));
  EXPECT_EQ(sum(many->GetOutput()->GetNumberOfPoints() > 0), rank_count() > 4 ? 4 : rank_count());
  const Gathered phases(vertices, *many->GetOutput(), "phase");
  EXPECT_EQ(phases.different, 0u);
  std::size_t wrong = 0;
  for (vtkIdType i = 0; i < whole.GetNumberOfPoints(); ++i) {
    const auto vertex =
        static_cast<std::size_t>(whole.GetPointData()->GetArray("whole")->GetComponent(i, 0));
    const auto phase =
        static_cast<float>(whole.GetPointData()->GetArray("phase")->GetComponent(i, 0));
    const float told = phases.values[vertex][0];  // none at internal faces
    wrong += told != phase && !(std::isnan(told) && std::isnan(phase));
  }
  EXPECT_EQ(wrong, 0u);
  for (const char* name : {"branches", "angle_error_mean_deg", "spacing_error_mean"}) {
    if (many->GetOutput()->GetNumberOfPoints() == 0) continue;
    EXPECT_NEAR(metric(*many->GetOutput(), name), metric(whole, name), 1e-6) << name;
  }
}

const std::vector<int> kAllPieces = {0, 1, 2, 3};

// Pieces of a file have no internal faces and one pattern, on any number of ranks.
TEST(RankPieces, OfAGridAreOneOnAnyNumberOfRanks) {
  for (const bool ids : {false, true}) {
    SCOPED_TRACE(ids ? "ids" : "no ids");
    const auto all = beam_in_pieces(kAllPieces, ids);
    vtkNew<vtkBrindleStripes> one;
    alone([&] { lay_level(*one, all); });
    EXPECT_EQ(own_cells(*one->GetOutput()), 4.0 * (8 * 8 + 2 * 8 * 24)) << "walls";
    expect_pattern_of_one(25 * 9 * 9, beam_in_pieces(dealt(4), ids), all);
  }
}

/// Slabs of a shape as pieces of a file, optionally overlapping.
vtkSmartPointer<vtkPolyData> shape_in_pieces(const Mesh& mesh, const std::vector<int>& pieces,
                                             bool ids, bool overlap) {
  const std::vector<int> slab = slabs(mesh, 4), fine = slabs(mesh, 16);
  Pieces own(mesh, {"", [](const Mesh& m) { return std::vector<int>(m.triangle_count(), -1); }});
  own.own = {};
  own.ids.clear();
  for (const int piece : pieces) {
    std::unordered_map<Index, Index> number;
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
      const bool added = overlap && fine[t] == 4 * piece + 4;
      if (slab[t] != piece && !added) continue;
      Triangle corners = mesh.triangles[t];
      for (Index& v : corners) {
        const auto next = static_cast<Index>(own.ids.size());
        const auto [place, is_new] = number.emplace(v, next);
        if (is_new) {
          own.ids.push_back(v);
          own.own.positions.push_back(mesh.positions[v]);
        }
        v = place->second;
      }
      own.own.triangles.push_back(corners);
    }
  }
  auto data = own.polygons();
  if (!ids) return data;
  vtkNew<vtkIdTypeArray> global;
  global->SetName("GlobalPointIds");
  for (const std::uint64_t id : own.ids) {
    global->InsertNextValue(static_cast<vtkIdType>(id * 577 % 100003));
  }
  data->GetPointData()->SetGlobalIds(global);
  return data;
}

TEST(RankPieces, OfASurfaceAreOneOnAnyNumberOfRanks) {
  const Mesh mesh = make_shape(kShape);
  for (const bool ids : {false, true}) {
    for (const bool overlap : {false, true}) {
      SCOPED_TRACE(std::string(ids ? "ids" : "no ids") + (overlap ? ", overlap" : ""));
      const auto all = shape_in_pieces(mesh, kAllPieces, ids, overlap);
      EXPECT_EQ(all->GetNumberOfPolys() > static_cast<vtkIdType>(mesh.triangle_count()), overlap);
      expect_pattern_of_one(mesh.vertex_count(), shape_in_pieces(mesh, dealt(4), ids, overlap),
                            all);
    }
  }
}

// One rank reports invalid global ids, once.
TEST(RankPieces, WithWrongIdsAreTaken) {
  const Pieces pieces(kShape, cuts()[0]);
  const auto data = pieces.polygons();
  vtkNew<vtkIdTypeArray> global;
  global->SetName("GlobalPointIds");
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) global->InsertNextValue(7);
  data->GetPointData()->SetGlobalIds(global);
  vtkNew<vtkBrindleStripes> filter;
  Errors warnings(*filter, vtkCommand::WarningEvent);
  filter->SetStripes(kCoarse);
  lay_swirl(*filter, data);
  expect_one_pattern(pieces.whole, *filter->GetOutput());
  EXPECT_EQ(sum(double(warnings.messages.size())), 1);
}

/// Quadrangles beside hexahedra, in one grid.
vtkSmartPointer<vtkUnstructuredGrid> shell_on_a_cube() {
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  for (int v = 0; v < 8; ++v) points->InsertNextPoint(v % 2, v / 2 % 2, v / 4);
  for (int v = 0; v < 4; ++v) points->InsertNextPoint(v % 2, v / 2 % 2, 2);
  grid->SetPoints(points);
  if (rank() == 0) {
    const vtkIdType cube[] = {0, 1, 3, 2, 4, 5, 7, 6};
    grid->InsertNextCell(VTK_HEXAHEDRON, 8, cube);
  }
  const vtkIdType shell[] = {8, 9, 11, 10};
  grid->InsertNextCell(VTK_QUAD, 4, shell);
  return grid;
}

// A shell that all ranks have is kept once; it is no internal face.
TEST(RankPieces, KeepShellsOnce) {
  vtkNew<vtkBrindleStripes> filter;
  lay_level(*filter, shell_on_a_cube());
  EXPECT_EQ(sum(own_cells(*filter->GetOutput())), 2 * 6 + 2);
  EXPECT_EQ(filter->GetOutput()->GetCellData()->GetArray("brindle_has_volume"), nullptr);
}

TEST(RankBlocks, AreOneSurface) {
  const Pieces pieces(kShape, cuts()[1]);
  vtkNew<vtkMultiBlockDataSet> blocks;
  // A rank's triangles in two blocks, one of which may be empty.
  for (unsigned b : {0u, 1u}) {
    Pieces half = pieces;
    std::erase_if(half.own.triangles, [&](const Triangle& t) { return t[0] % 2 != b; });
    auto data = half.polygons();
    add_swirl(*data, 0);
    blocks->SetBlock(b, data);
  }
  vtkNew<vtkBrindleStripes> filter;
  filter->SetInputData(blocks);
  filter->SetField(kArray);
  choose(*filter, 0, "v");
  filter->SetTextureCoordinates(false);
  filter->Update();
  ASSERT_NE(filter->GetOutput(), nullptr);
  expect_one_pattern(pieces.whole, *filter->GetOutput());
}

// Some blocks have ghosts, between ranks and between blocks of one rank; others have none.
TEST(RankBlocks, HaveGhostsOrNot) {
  const Pieces pieces(kShape, cuts()[0]);
  vtkNew<vtkMultiBlockDataSet> blocks;
  const auto block = [&](unsigned which) {
    Pieces part = pieces;
    const std::size_t half = part.own.triangles.size() / 2;
    const auto middle = part.own.triangles.begin() + static_cast<std::ptrdiff_t>(half);
    which == 0 ? part.own.triangles.erase(middle, part.own.triangles.end())
               : part.own.triangles.erase(part.own.triangles.begin(), middle);
    return part.polygons(true);
  };
  blocks->SetBlock(0, block(0));
  blocks->SetBlock(1, block(1));
  const auto some = with_ghosts(blocks.Get());
  const auto ghosts = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  ghosts->SetBlock(0, some->GetBlock(0));
  ghosts->SetBlock(1, block(1));
  for (vtkMultiBlockDataSet* data : {blocks.Get(), some.Get(), ghosts.Get()}) {
    vtkNew<vtkBrindleStripes> filter;
    filter->SetInputData(data);
    filter->SetField(kDirection);
    filter->SetTextureCoordinates(false);
    filter->Update();
    expect_one_pattern(pieces.whole, *filter->GetOutput());
  }
}

TEST(RankStripesFarFromZero, StandWhereTheyDid) {
  const Pieces pieces(kShape, cuts()[0]);
  const auto data = pieces.polygons();
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
    double p[3];
    data->GetPoint(i, p);
    data->GetPoints()->SetPoint(i, p[0] + 4e6, p[1] - 3e6, p[2]);
  }
  vtkNew<vtkBrindleStripes> filter;
  filter->SetInputData(data);
  filter->SetField(kDirection);
  filter->SetDirection(1, 2, 3);
  filter->SetTextureCoordinates(false);
  filter->Update();
  const Gathered phases(pieces.whole.vertex_count(), *filter->GetOutput(), "phase");
  EXPECT_EQ(phases.different, 0u);
  EXPECT_EQ(phases.shared > 0, rank_count() > 1);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
    ASSERT_NEAR(filter->GetOutput()->GetPoint(i)[0], data->GetPoint(i)[0], 1e-6);
  }
}

}  // namespace
}  // namespace brindle::paraview
