// What comes to ranks.
#include <vtkMultiBlockDataSet.h>
#include <vtkRTAnalyticSource.h>
#include <vtkUnstructuredGrid.h>

#include "rank_patterns.h"

namespace brindle::paraview {
namespace {

// A layer of what other ranks have changes nothing, and stays what it was.
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
        EXPECT_EQ(figure(output, name), figure(*plain->GetOutput(), name)) << name;
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

/// A beam of hexahedra, cut across for the ranks, with numbers of its points in the whole.
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

// The surface of a grid is that of the whole, and not the walls between ranks.
TEST(RankGrids, HaveTheSurfaceOfTheWhole) {
  const double faces = 2.0 * (8 * 8 + 2 * 8 * 24);
  const auto check = [&](vtkDataObject* data) {
    vtkNew<vtkBrindleStripes> filter;
    filter->SetInputData(data);
    filter->SetField(kDirection);
    filter->SetDirection(1, 0.3, 0.2);
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

// So is that of images in pieces, as sources give them.
TEST(RankGrids, OfImagesHaveNoWalls) {
  vtkNew<vtkRTAnalyticSource> source;
  source->SetWholeExtent(-8, 8, -4, 4, -4, 4);
  vtkNew<vtkBrindleStripes> filter;
  filter->SetInputConnection(source->GetOutputPort());
  filter->SetField(kDirection);
  filter->SetDirection(1, 0.3, 0.2);
  filter->SetTextureCoordinates(false);
  filter->UpdatePiece(rank(), rank_count(), 0);
  const double faces = 2.0 * (8 * 8 + 2 * 8 * 16);
  EXPECT_EQ(sum(own_cells(*filter->GetOutput())), 2 * faces);
}

TEST(RankBlocks, AreOneSurface) {
  const Pieces pieces(kShape, cuts()[1]);
  vtkNew<vtkMultiBlockDataSet> blocks;
  // A rank's triangles in two blocks, of which one may be empty.
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

// Ghosts of some blocks, between ranks and between blocks of one rank, and none of others.
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
