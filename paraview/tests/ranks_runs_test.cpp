// Ranks over time, and errors.
#include <algorithm>
#include <functional>
#include <limits>
#include <numbers>

#include "rank_patterns.h"
#include "vtkBrindleCurves.h"

namespace brindle::paraview {
namespace {

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

// A change on one rank is a change on all: a mesh read again, moved points, a new time.
TEST_F(RankSeries, WhatIsNewToOneRankIsNewToAll) {
  show(0, 0);
  if (rank() == 0) data->ShallowCopy(pieces.polygons());
  show(1, 0.1f);
  EXPECT_EQ(filter->GetSurfacesMade(), 1) << "read again with the same numbers";
  EXPECT_EQ(filter->GetPatternsFollowed(), 1);
  // Moves all copies of a vertex, on the ranks that have it.
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

/// The mean change of phases between two outputs, in radians.
double phase_step(const Pieces& pieces, vtkPolyData& before, vtkPolyData& after) {
  const std::size_t count = pieces.whole.vertex_count();
  const Gathered a(count, before, "phase"), b(count, after, "phase");
  const Gathered da(count, before, "direction"), db(count, after, "direction");
  double steps = 0;
  for (std::size_t v = 0; v < count; ++v) {
    const Complex turn = std::polar(1.0f, a.values[v][0]);
    const bool same = Vec3(da.values[v].data()).dot(Vec3(db.values[v].data())) > 0;
    const Complex now = std::polar(1.0f, b.values[v][0]);
    const Complex other = std::polar(1.0f, std::numbers::pi_v<float> - b.values[v][0]);
    steps += double(std::abs(std::arg((same ? now : other) * std::conj(turn))));
  }
  return steps / static_cast<double>(count);
}

// Cells are redistributed at every time, as by a filter: stripes continue.
TEST(RankSeriesDealtAnew, FollowsIdsOrPlacesOrSaysSo) {
  for (const bool moved : {false, true}) {
    for (const bool ids : {false, true}) {
      SCOPED_TRACE(std::string(moved ? "moved" : "in place") + (ids ? ", ids" : ", no ids"));
      const Pieces first(kShape, cuts()[0]);
      Mesh mesh = first.whole;
      if (moved) {
        for (Vec3& p : mesh.positions) p *= 1.001f;
      }
      std::ranges::reverse(mesh.triangles);
      const Pieces second(mesh, cuts()[2]);
      vtkNew<vtkBrindleStripes> filter;
      filter->SetStripes(kCoarse);
      Errors warnings(*filter, vtkCommand::WarningEvent);
      const auto data = first.polygons(ids);
      set_time(*data, 0);
      lay_swirl(*filter, data);
      vtkNew<vtkPolyData> shown;
      shown->DeepCopy(filter->GetOutput());
      data->ShallowCopy(second.polygons(ids));
      set_time(*data, 1);
      lay_swirl(*filter, data, 0.02f);
      expect_one_pattern(mesh, *filter->GetOutput());
      const bool follows = ids || !moved;
      EXPECT_EQ(filter->GetPatternsFollowed(), follows ? 1 : 0);
      EXPECT_EQ(sum(double(warnings.messages.size())), follows ? 0 : 1);
      const double step = phase_step(first, *shown, *filter->GetOutput());
      if (follows) {
        EXPECT_LT(step, 0.5);
      } else {
        EXPECT_GT(step, 0.5);
      }
    }
  }
}

/// The library's waves of a swirl over the whole.
WaveSet waves_of_swirl(const Surface& surface, float stripes) {
  std::vector<Vec3> vectors;
  for (const Vec3& p : surface.mesh.positions) vectors.push_back(swirl(p, 0));
  const float frequency = frequency_of_stripes(stripes, bounding_box(surface.mesh).diagonal());
  return {surface.mesh.positions, tangent_directions(vectors, surface.normals),
          constant_frequency_field(frequency, surface.mesh.vertex_count())};
}

// The first rank prints one process's warnings for the whole, once; all ranks have its metrics.
TEST(RankWarnings, AreThoseOfOneProcessSaidOnce) {
  const char* kTorus = "torus,resolution=40";
  for (const Cut& cut : cuts()) {
    const Pieces pieces(kTorus, cut);
    for (const float stripes : {8.0f, 3000.0f}) {
      SCOPED_TRACE(std::string(cut.name) + ", " + std::to_string(stripes));
      const Surface surface = make_surface(pieces.whole);
      const WaveSet waves = waves_of_swirl(surface, stripes);
      const WaveMetrics metrics = measure_waves(surface, waves);
      // Ranks have their own solution and branches; the beginning of the warning is common.
      const std::string warning = "stripes begin or end in";
      vtkNew<vtkBrindleStripes> filter;
      Errors warnings(*filter, vtkCommand::WarningEvent);
      filter->SetStripes(stripes);
      lay_swirl(*filter, pieces.polygons());
      const bool speaks = rank() == 0 && stripes > 100;
      ASSERT_EQ(warnings.messages.size(), speaks ? 1u : 0u);
      if (speaks) {
        EXPECT_TRUE(says_the_same(warnings.messages[0], warning)) << warnings.messages[0];
      }
      for (const auto& [name, number] :
           {std::pair("edges_per_period_min", metrics.edges_per_period_min),
            std::pair("edges_per_period_median", metrics.edges_per_period_median)}) {
        EXPECT_NEAR(metric(*filter->GetOutput(), name), number, 1e-5 * number) << name;
      }
    }
  }
}

/// The spacing tolerance equals the library's: phases, chosen and requested frequencies, metrics.
void expect_relaxed(vtkPolyData& output, Twin& twin, const StripePattern& pattern) {
  const PatternQuality quality = twin.measure().quality;
  if (output.GetNumberOfPoints() == 0) return;
  expect_phases(output, pattern.solution.z);
  EXPECT_EQ(numbers(output, "frequency"), pattern.waves.frequencies);
  EXPECT_EQ(numbers(output, "frequency_wanted"), pattern.frequencies_wanted);
  EXPECT_NE(pattern.waves.frequencies, pattern.frequencies_wanted);
  EXPECT_EQ(metric(output, "branches"), static_cast<double>(quality.branches));
  EXPECT_EQ(metric(output, "angle_error_mean_deg"), quality.angle_error_mean_deg);
  EXPECT_EQ(metric(output, "spacing_error_mean"), quality.spacing_error_mean);
}

TEST(RankSlack, IsTheLibrarysBitForBit) {
  for (const Cut& cut : cuts()) {
    SCOPED_TRACE(cut.name);
    const Pieces pieces(kShape, cut);
    const auto data = pieces.polygons();
    vtkNew<vtkBrindleStripes> filter;
    filter->SetSlack(0.25);
    Twin twin(pieces, numbers_by_place(pieces), 0.25f);
    for (int step = 0; step < 2; ++step) {
      const float angle = 0.1f * static_cast<float>(step);
      set_time(*data, step);
      lay_swirl(*filter, data, angle);
      expect_relaxed(*filter->GetOutput(), twin, twin.pattern(angle));
      expect_one_pattern(pieces.whole, *filter->GetOutput());
      const Gathered wanted(pieces.whole.vertex_count(), *filter->GetOutput(), "frequency_wanted");
      EXPECT_EQ(wanted.different, 0u);
      EXPECT_EQ(filter->GetPatternsFollowed(), step);
    }
  }
}

// The purpose of slack.
TEST(RankSlack, LeavesFewerBranches) {
  const Pieces pieces(kShape, cuts()[0]);
  vtkNew<vtkBrindleStripes> stiff, relaxed;
  relaxed->SetSlack(0.5);
  lay_swirl(*stiff, pieces.polygons());
  lay_swirl(*relaxed, pieces.polygons());
  EXPECT_EQ(stiff->GetOutput()->GetPointData()->GetArray("frequency_wanted"), nullptr);
  if (pieces.ids.empty()) return;
  EXPECT_LT(metric(*relaxed->GetOutput(), "branches"), metric(*stiff->GetOutput(), "branches"));
}

// Points shared by two ranks separate: the same cells, but another surface.
TEST_F(RankSeries, SurfacesThatTearAreOthers) {
  show(0, 0);
  Pieces torn = pieces;
  for (Vec3& p : torn.own.positions) p.z() += 3 * static_cast<float>(rank());
  data->ShallowCopy(torn.polygons());
  show(1, 0.1f);
  EXPECT_EQ(filter->GetSolversMade(), rank_count() > 1 ? 2 : 1);
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

// A warning about all vertices, with their number, is printed once.
TEST(RankErrors, WithoutAnyWaveOneRankWarns) {
  const Pieces pieces("plane,resolution=20", cuts()[0]);
  vtkNew<vtkBrindleStripes> filter;
  const auto data = pieces.polygons();
  data->GetPointData()->AddArray(
      vectors_by("v", data->GetNumberOfPoints(), [](vtkIdType) { return Vec3(0, 0, 1); }));
  filter->SetInputData(data);
  filter->SetField(kArray);
  choose(*filter, 0, "v");
  for (const bool one_has_waves : {false, true}) {
    if (one_has_waves && rank() == rank_count() - 1) {
      vtkDataArray& v = *data->GetPointData()->GetArray("v");
      for (vtkIdType i = 0; i < v.GetNumberOfTuples(); ++i) v.SetTuple3(i, 1, 0, 0);
      v.Modified();
      data->Modified();
    }
    if (one_has_waves) filter->SetStripes(6);
    Errors warnings(*filter, vtkCommand::WarningEvent), errors(*filter);
    filter->Update();
    EXPECT_TRUE(errors.messages.empty());
    EXPECT_EQ(sum(double(warnings.messages.size())), one_has_waves && rank_count() == 1 ? 0 : 1);
    if (warnings.messages.empty()) continue;
    EXPECT_EQ(rank(), 0);
    has(warnings.messages[0], one_has_waves ? "vertices have no wave" : "no point has a wave");
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

// Points without cells on one rank do not reject another's surface.
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

}  // namespace
}  // namespace brindle::paraview
