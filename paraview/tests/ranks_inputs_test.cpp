// What comes to ranks, and curves and samples of it.
#include <brindle/samples.h>
#include <vtkGhostCellsGenerator.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkRTAnalyticSource.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include "rank_patterns.h"
#include "vtkBrindleCurves.h"
#include "vtkBrindleSamples.h"

namespace brindle::paraview {
namespace {

constexpr const char* kShape = "torus,resolution=40";

/// The same data with a layer of ghosts, as ParaView's Ghost Cells makes it.
template <class Data>
vtkSmartPointer<Data> with_ghosts(Data* data) {
  vtkNew<vtkGhostCellsGenerator> generator;
  generator->SetInputData(data);
  generator->SetBuildIfRequired(false);
  generator->SetNumberOfGhostLayers(1);
  generator->Update();
  return Data::SafeDownCast(generator->GetOutputDataObject(0));
}

long ghost_count(vtkDataSet& data) {
  vtkUnsignedCharArray* flags = data.GetCellGhostArray();
  long count = 0;
  for (vtkIdType i = 0; flags != nullptr && i < flags->GetNumberOfTuples(); ++i) {
    count += (flags->GetValue(i) & vtkDataSetAttributes::DUPLICATECELL) != 0;
  }
  return count;
}

// A layer of what other ranks have changes nothing, and stays what it was.
TEST(RankGhosts, AreSeenAndNotCounted) {
  for (const std::size_t which : {0u, 1u}) {
    const Cut& cut = cuts()[which];
    SCOPED_TRACE(cut.name);
    const Pieces pieces(kShape, cut);
    vtkNew<vtkBrindleStripes> plain, ghosts;
    const auto data = pieces.polygons(true);
    lay_swirl(*plain, data);
    const auto more = with_ghosts(data.Get());
    const long given = ghost_count(*more);
    EXPECT_EQ(sum(double(given)) > 0, rank_count() > 1);
    lay_swirl(*ghosts, more);
    vtkPolyData& output = *ghosts->GetOutput();
    expect_one_pattern(pieces.whole, output);
    const Gathered a(pieces.whole.vertex_count(), *plain->GetOutput(), "phase");
    const Gathered b(pieces.whole.vertex_count(), output, "phase");
    EXPECT_EQ(a.values, b.values);
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

/// This rank's pattern of the whole, from all ranks' stripes.
StripePattern stripes_of(const Pieces& pieces, vtkPolyData* data, double turn) {
  vtkNew<vtkBrindleStripes> stripes;
  stripes->SetRotate(turn);
  lay_swirl(*stripes, data);
  return whole_pattern(pieces.whole, *stripes->GetOutput());
}

// Lines of one pattern: together as long as those of the whole, ghosts or not.
TEST(RankCurves, AreThoseOfOnePattern) {
  const Pieces pieces(kShape, cuts()[0]);
  const Surface surface = make_surface(pieces.whole);
  for (const bool ghosts : {false, true}) {
    SCOPED_TRACE(ghosts ? "ghosts" : "no ghosts");
    auto data = pieces.polygons(true);
    if (ghosts) data = with_ghosts(data.Get());
    const StripePattern pattern = stripes_of(pieces, data, 0);
    const StripeCurves whole = stripe_curves(surface, pattern);
    double wanted = 0;
    for (std::size_t line = 0; line < whole.lines.count(); ++line) {
      wanted += length_of(whole.lines, line);
    }
    vtkNew<vtkBrindleCurves> filter;
    filter->SetInputData(data);
    filter->SetField(kArray);
    choose(*filter, 0, "v");
    filter->Update();
    double length = 0;
    vtkDataArray* lengths = filter->GetOutput()->GetCellData()->GetArray("length");
    for (vtkIdType i = 0; lengths != nullptr && i < lengths->GetNumberOfTuples(); ++i) {
      length += lengths->GetComponent(i, 0);
    }
    EXPECT_NEAR(sum(length) / wanted, 1, 1e-4);
  }
}

TEST(RankSamples, AreThoseOfOnePattern) {
  const Pieces pieces(kShape, cuts()[0]);
  const Surface surface = make_surface(pieces.whole);
  for (const bool ghosts : {false, true}) {
    SCOPED_TRACE(ghosts ? "ghosts" : "no ghosts");
    auto data = pieces.polygons(true);
    if (ghosts) data = with_ghosts(data.Get());
    const StripePattern u = stripes_of(pieces, data, 0), v = stripes_of(pieces, data, 90);
    const auto wanted = static_cast<double>(stripe_samples(surface, u, v).size());
    vtkNew<vtkBrindleSamples> filter;
    filter->SetInputData(data);
    filter->SetField(kArray);
    choose(*filter, 0, "v");
    filter->Update();
    EXPECT_NEAR(sum(double(filter->GetOutput()->GetNumberOfPoints())) / wanted, 1, 0.01);
  }
}

}  // namespace
}  // namespace brindle::paraview
