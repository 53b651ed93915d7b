// What comes to ranks, and what becomes of it when time goes on or something is wrong.
#include <limits>

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

/// Sums over all ranks.
double sum(double value) {
  double total = 0;
  for (const double other : ranks().all(value)) total += other;
  return total;
}

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
vtkSmartPointer<vtkUnstructuredGrid> beam(bool whole) {
  constexpr int kLong = 24, kSide = 8;
  const int size = whole ? 1 : rank_count(), mine = whole ? 0 : rank();
  const int first = kLong * mine / size, last = kLong * (mine + 1) / size;
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

// With ghosts the surface of a grid is that of the whole; without, walls between ranks are there.
TEST(RankGrids, HaveTheSurfaceOfTheWholeWithGhosts) {
  const double faces = 2.0 * (8 * 8 + 2 * 8 * 24), walls = 2.0 * 8 * 8 * (rank_count() - 1);
  for (const bool ghosts : {false, true}) {
    SCOPED_TRACE(ghosts ? "ghosts" : "no ghosts");
    vtkSmartPointer<vtkUnstructuredGrid> grid = beam(false);
    if (ghosts) grid = with_ghosts(grid.Get());
    vtkNew<vtkBrindleStripes> filter;
    filter->SetInputData(grid);
    filter->SetField(kDirection);
    filter->SetDirection(1, 0.3, 0.2);
    filter->SetTextureCoordinates(false);
    Errors errors(*filter);
    filter->Update();
    ASSERT_TRUE(errors.messages.empty()) << errors.messages[0];
    vtkPolyData& output = *filter->GetOutput();
    EXPECT_EQ(sum(own_cells(output)), 2 * (faces + (ghosts ? 0 : walls)));
    const Gathered phases(25 * 9 * 9, output, "phase");
    EXPECT_EQ(phases.different, 0u);
    EXPECT_EQ(phases.shared > 0, rank_count() > 1);
  }
}

// Sources that can make ghosts are asked for them.
TEST(RankGrids, OfSourcesComeWithGhosts) {
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

class RankSeries : public testing::Test {
 protected:
  RankSeries() : pieces(kShape, cuts()[0]), data(pieces.polygons()) {}

  void show(double time, float angle) {
    set_time(*data, time);
    lay_swirl(*filter, data, angle);
  }
  void expect(std::span<const Complex> z) { expect_phases(*filter->GetOutput(), z); }

  Pieces pieces;
  vtkSmartPointer<vtkPolyData> data;
  vtkNew<vtkBrindleStripes> filter;
};

TEST_F(RankSeries, FramesFollowAndNothingIsBuiltAgain) {
  Twin twin(pieces, numbers_by_place(pieces));
  for (int step = 0; step < 4; ++step) {
    show(step, 0.1f * static_cast<float>(step));
    expect(twin.frame(0.1f * static_cast<float>(step)));
    EXPECT_EQ(filter->GetSurfacesMade(), 1);
    EXPECT_EQ(filter->GetSolversMade(), 1);
    EXPECT_EQ(filter->GetPatternsFollowed(), step);
    expect_one_pattern(pieces.whole, *filter->GetOutput());
  }
}

TEST_F(RankSeries, GoingBackStartsAfresh) {
  for (const int step : {0, 1, 2, 1}) show(step, 0.1f * static_cast<float>(step));
  expect(Twin(pieces, numbers_by_place(pieces)).frame(0.1f));
  EXPECT_EQ(filter->GetPatternsFollowed(), 2);
}

// Whatever only one rank has seen, all do: a mesh read again, moved points, a time nobody else has.
TEST_F(RankSeries, WhatIsNewToOneRankIsNewToAll) {
  show(0, 0);
  if (rank() == 0) data->ShallowCopy(pieces.polygons());
  show(1, 0.1f);
  EXPECT_EQ(filter->GetSurfacesMade(), 1) << "read again with the same numbers";
  EXPECT_EQ(filter->GetPatternsFollowed(), 1);
  // All copies of a vertex move, wherever they are; on ranks without it nothing does.
  const auto found = std::ranges::find(pieces.ids, 100u);
  if (found != pieces.ids.end()) {
    Pieces moved = pieces;
    moved.own.positions[static_cast<std::size_t>(found - pieces.ids.begin())] *= 1.001f;
    data->ShallowCopy(moved.polygons());
  }
  show(2, 0.2f);
  EXPECT_EQ(filter->GetSurfacesMade(), 2);
  EXPECT_EQ(filter->GetSolversMade(), 1);
  EXPECT_EQ(filter->GetPatternsFollowed(), 2);
  expect_one_pattern(pieces.whole, *filter->GetOutput());
}

// Two ranks' points part: cells are as they were, but the surface is another one.
TEST_F(RankSeries, SurfacesThatTearAreOthers) {
  show(0, 0);
  Pieces torn = pieces;
  for (Vec3& p : torn.own.positions) p.z() += 3 * static_cast<float>(rank());
  data->ShallowCopy(torn.polygons());
  show(1, 0.1f);
  EXPECT_EQ(filter->GetSolversMade(), rank_count() > 1 ? 2 : 1);
}

/// What a filter says, once, on every rank; its output is then empty.
std::string only_error(vtkBrindleFilter& filter) {
  Errors errors(filter);
  filter.Modified();
  filter.Update();
  EXPECT_EQ(errors.messages.size(), 1u);
  EXPECT_EQ(filter.GetOutput()->GetNumberOfPoints(), 0);
  return errors.messages.empty() ? "" : errors.messages[0];
}

void has(const std::string& message, const char* part) {
  EXPECT_NE(message.find(part), std::string::npos) << message;
}

TEST(RankErrors, OfOneRankAreEverybodys) {
  const Pieces pieces(kShape, cuts()[0]);
  const int last = rank_count() - 1;
  const auto good = pieces.polygons();
  add_swirl(*good, 0);
  const auto changed = [&](const std::function<void(vtkPolyData&)>& change) {
    vtkNew<vtkPolyData> data;
    data->DeepCopy(good);
    if (rank() == last) change(*data);
    return vtkSmartPointer<vtkPolyData>(data.Get());
  };
  vtkNew<vtkBrindleStripes> filter;
  filter->SetField(kArray);
  filter->SetTextureCoordinates(false);
  choose(*filter, 0, "v");
  const auto message = [&](const std::function<void(vtkPolyData&)>& change) {
    filter->SetInputData(changed(change));
    return only_error(*filter);
  };
  const auto runs = [&] {
    filter->SetInputData(good);
    Errors errors(*filter);
    filter->Update();
    EXPECT_TRUE(errors.messages.empty());
    expect_one_pattern(pieces.whole, *filter->GetOutput());
  };
  has(message([](vtkPolyData& d) { d.GetPointData()->RemoveArray("v"); }), "'v'");
  has(message([](vtkPolyData& d) {
        d.GetPoints()->SetPoint(5, 0, std::numeric_limits<double>::quiet_NaN(), 0);
      }),
      "vertex 5");
  runs();
  has(message([](vtkPolyData& d) { d.GetPolys()->InsertNextCell({0, 1, 1000000}); }), "1000000");
  if (rank_count() > 1) {
    const std::string wide = message([](vtkPolyData& d) {
      vtkNew<vtkFloatArray> array;
      array->SetName("v");
      array->SetNumberOfComponents(9);
      array->SetNumberOfTuples(d.GetNumberOfPoints());
      array->Fill(1);
      d.GetPointData()->AddArray(array);
    });
    has(wide, "on another");
    has(message([](vtkPolyData& d) { d.GetPointData()->RemoveArray("v"); }),
        ("rank " + std::to_string(last)).c_str());
  }
  runs();
}

TEST(RankErrors, RefuseWhatRanksCannotDoTogether) {
  const Pieces pieces(kShape, cuts()[0]);
  vtkNew<vtkBrindleStripes> stripes;
  stripes->SetInputData(pieces.polygons());
  stripes->SetSlack(0.25);
  vtkNew<vtkBrindleCurves> join, longer;
  join->SetInputData(pieces.polygons());
  join->SetJoin(true);
  longer->SetInputData(pieces.polygons());
  longer->SetMinimumLength(0.5);
  if (rank_count() > 1) {
    has(only_error(*stripes), "slack");
    has(only_error(*join), "Join");
    has(only_error(*longer), "Minimum Length");
    return;
  }
  for (vtkBrindleFilter* filter :
       {static_cast<vtkBrindleFilter*>(stripes), static_cast<vtkBrindleFilter*>(join),
        static_cast<vtkBrindleFilter*>(longer)}) {
    filter->Update();
    EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 0);
  }
}

TEST(RankErrors, NothingIsNoErrorAndPointsAloneAre) {
  vtkNew<vtkBrindleStripes> filter;
  filter->SetInputData(vtkSmartPointer<vtkPolyData>::New());
  Errors errors(*filter);
  filter->Update();
  EXPECT_TRUE(errors.messages.empty());
  auto points = polygons_of(make_shape("sphere,resolution=12"));
  points->SetPolys(vtkSmartPointer<vtkCellArray>::New());
  filter->SetInputData(rank() == 0 ? points : vtkSmartPointer<vtkPolyData>::New());
  has(only_error(*filter), "polygons");
}

// Points without cells on one rank are no reason to refuse what another has.
TEST(RankErrors, PointsBesideASurfaceAreNone) {
  const Pieces pieces(kShape, cuts()[5]);
  const auto data = pieces.polygons();
  if (rank() == 0 && rank_count() > 1) data->ShallowCopy(polygons_of(pieces.whole));
  if (rank() == 0 && rank_count() > 1) data->SetPolys(vtkSmartPointer<vtkCellArray>::New());
  vtkNew<vtkBrindleStripes> filter;
  filter->SetInputData(data);
  filter->SetField(kDirection);
  Errors errors(*filter);
  filter->Update();
  EXPECT_TRUE(errors.messages.empty());
  EXPECT_EQ(sum(double(filter->GetOutput()->GetNumberOfPolys())) > 0, true);
}

TEST(RankErrors, OneRankThatIsStoppedStopsAll) {
  const Pieces pieces(kShape, cuts()[0]);
  vtkNew<vtkBrindleStripes> filter;
  filter->SetInputData(pieces.polygons());
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback([](vtkObject* caller, unsigned long, void*, void* progress) {
    if (rank() == 0 && *static_cast<double*>(progress) >= 0.1) {
      static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
    }
  });
  const unsigned long watch = filter->AddObserver(vtkCommand::ProgressEvent, command);
  Errors errors(*filter);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_TRUE(errors.messages.empty()) << "asking to stop is no error";
  filter->RemoveObserver(watch);
  filter->Modified();
  filter->Update();
  EXPECT_GT(sum(double(filter->GetOutput()->GetNumberOfPoints())), 0);
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
