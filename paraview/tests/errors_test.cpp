// Errors and cancellation of filters.
#include <limits>
#include <random>

#include <brindle/pattern_warnings.h>

#include "filter_runs.h"
#include "vtkBrindleCurves.h"
#include "vtkBrindleSamples.h"

namespace brindle::paraview {
namespace {

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
  has(only_error(*filter), "Time Anchor");
  filter->SetTimeAnchor(0.025);
  filter->SetFrequencySource(kFrequencyArray);
  choose(*filter, 1, "number");
  has(only_error(*filter), "'number'");
  filter->SetFrequencySource(kSpacing);
  filter->SetSpacing(0);
  has(only_error(*filter), "spacing");
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
  out_of_range->GetPolys()->InsertNextCell({0, 1, 2, 3});  // VTK triangulates it
  EXPECT_NE(message(out_of_range).find("1000000"), std::string::npos);

  auto points = polygons_of(make_shape("sphere,resolution=12"));
  points->SetPolys(vtkSmartPointer<vtkCellArray>::New());
  EXPECT_NE(message(points).find("polygons"), std::string::npos);

  Mesh flat;
  flat.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  flat.triangles = {{0, 1, 2}};
  EXPECT_NE(message(polygons_of(flat)).find("area"), std::string::npos);
}

// One warning with the reason, and the surface unchanged.
TEST(BrindleStripes, WarnsWhereNothingHasAWave) {
  vtkNew<vtkBrindleStripes> filter;
  filter->SetInputData(polygons_of(make_shape("plane,resolution=12")));
  filter->SetField(kDirection);
  filter->SetStripes(4);
  Errors errors(*filter), warnings(*filter, vtkCommand::WarningEvent);
  for (const double across : {0.0, 1.0}) {  // exactly normal, and oblique
    warnings.messages.clear();
    filter->SetDirection(across, 0, 1);
    filter->Update();
    EXPECT_TRUE(errors.messages.empty());
    EXPECT_EQ(warnings.messages.size(), across == 0 ? 1u : 0u);
    EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 0);
  }
}

// The library's warnings and metrics for the same waves, in ParaView's terms, once per update.
TEST(BrindleFilters, WarnOfStripesThatAreTooFine) {
  const auto data = swirling("torus,resolution=40");
  const Surface surface = make_surface(make_shape("torus,resolution=40"));
  vtkNew<vtkBrindleStripes> stripes;
  vtkNew<vtkBrindleCurves> curves;
  for (vtkBrindleFilter* filter :
       {static_cast<vtkBrindleFilter*>(stripes), static_cast<vtkBrindleFilter*>(curves)}) {
    Errors warnings(*filter, vtkCommand::WarningEvent);
    filter->SetInputData(data);
    filter->SetField(kArray);
    choose(*filter, 0, "v");
    for (const float count : {8.0f, 3000.0f, 3001.0f, 9.0f}) {
      SCOPED_TRACE(count);
      const StripePattern pattern = expected(*data, surface, count, 0);
      const WaveMetrics metrics = measure_waves(surface, pattern.waves);
      warnings.messages.clear();
      filter->SetStripes(count);
      filter->Update();
      const std::vector<std::string> of_library = pattern_warnings(surface, pattern);
      ASSERT_EQ(of_library.size(), count > 100 ? 1u : 0u);
      ASSERT_EQ(warnings.messages.size(), of_library.size());
      if (count > 100) {
        EXPECT_TRUE(says_the_same(warnings.messages[0], of_library[0])) << warnings.messages[0];
      }
      EXPECT_EQ(metric(*filter->GetOutput(), "edges_per_period_median"),
                metrics.edges_per_period_median);
      EXPECT_EQ(metric(*filter->GetOutput(), "edges_per_period_min"), metrics.edges_per_period_min);
    }
  }
}

TEST(BrindleStripes, WarnsOfBranchesAndOfMissingWaves) {
  auto data = swirling("torus,resolution=40");
  vtkNew<vtkBrindleStripes> filter;
  Errors warnings(*filter, vtkCommand::WarningEvent);
  filter->SetInputData(data);
  filter->SetField(kArray);
  choose(*filter, 0, "v");
  filter->SetStripes(12);
  vtkDataArray& vectors = *data->GetPointData()->GetArray("v");
  for (vtkIdType i = 0; i < 100; ++i) vectors.SetTuple3(i, 0, 0, 0);
  filter->Update();
  ASSERT_EQ(warnings.messages.size(), 1u);
  const std::string count = std::to_string(data->GetNumberOfPoints());
  EXPECT_NE(warnings.messages[0].find("100 of " + count + " vertices have no wave"),
            std::string::npos)
      << warnings.messages[0];

  // Random directions: nearly every triangle has a branch.
  data = swirling("torus,resolution=40");
  std::mt19937 random(1);
  const auto any = [&] { return static_cast<float>(random() % 2001) / 1000 - 1; };
  data->GetPointData()->AddArray(
      vectors_by("chance", data->GetNumberOfPoints(), [&](vtkIdType) -> Vec3 {
        const float x = any(), y = any(), z = any();
        return {x, y, z};
      }));
  filter->SetInputData(data);
  choose(*filter, 0, "chance");
  warnings.messages.clear();
  filter->Update();
  ASSERT_EQ(warnings.messages.size(), 2u);
  EXPECT_NE(warnings.messages[0].find("stripes begin or end in"), std::string::npos)
      << warnings.messages[0];
  EXPECT_NE(warnings.messages[1].find("which suggests noise"), std::string::npos)
      << warnings.messages[1];
}

// Also for the crossing waves, without repeating common warnings.
TEST(BrindleSamples, WarnOfWavesAcross) {
  const auto data = swirling("torus,resolution=40");
  vtkDataArray& vectors = *data->GetPointData()->GetArray("v");
  for (vtkIdType i = 0; i < 100; ++i) vectors.SetTuple3(i, 0, 0, 0);
  vtkNew<vtkBrindleSamples> filter;
  Errors warnings(*filter, vtkCommand::WarningEvent);
  filter->SetInputData(data);
  filter->SetField(kArray);
  choose(*filter, 0, "v");
  filter->SetStripes(8);
  filter->SetCrossingFactor(400);
  filter->Update();
  ASSERT_EQ(warnings.messages.size(), 2u);
  EXPECT_NE(warnings.messages[0].find("have no wave"), std::string::npos) << warnings.messages[0];
  EXPECT_NE(warnings.messages[1].find("% of the area"), std::string::npos) << warnings.messages[1];
}

TEST(BrindleSamples, RefusesStripesOfWhichNothingCanBeTold) {
  vtkNew<vtkBrindleSamples> filter;
  filter->SetInputData(polygons_of(make_shape("sphere,resolution=12")));
  filter->SetCrossingFactor(1e6);
  const std::string error = only_error(*filter);
  EXPECT_NE(error.find("take fewer stripes"), std::string::npos) << error;
}

TEST(BrindleStripes, HasNothingToSayOfNothing) {
  vtkNew<vtkBrindleStripes> filter;
  filter->SetInputData(vtkSmartPointer<vtkPolyData>::New());
  Errors errors(*filter);
  filter->Update();
  EXPECT_TRUE(errors.messages.empty());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
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

}  // namespace
}  // namespace brindle::paraview
