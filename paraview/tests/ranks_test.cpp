// Patterns over partitions: every test runs on all ranks.
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>

#include <vtkMultiProcessController.h>

#include "rank_patterns.h"

namespace brindle::paraview {
namespace {

constexpr const char* kTorus = "torus,resolution=40";

TEST(GlobalNumbers, AreThoseOfPlacesOrIds) {
  for (const Cut& cut : cuts()) {
    SCOPED_TRACE(cut.name);
    const Pieces pieces("sphere,resolution=24", cut);
    std::vector<std::int64_t> ids(pieces.ids.begin(), pieces.ids.end());
    const PointNumbers by_id = global_numbers(ranks(), {pieces.own.positions, ids}, 1);
    EXPECT_EQ(by_id.of_points, pieces.ids);
    EXPECT_TRUE(by_id.by_id);
    EXPECT_FALSE(by_id.ids_refused);

    // A unique number per global vertex.
    const auto data = pieces.polygons();
    vtkNew<vtkDoubleArray> numbers;
    numbers->SetName("number");
    for (const std::uint64_t n : numbers_by_place(pieces)) numbers->InsertNextValue(double(n));
    data->GetPointData()->AddArray(numbers);
    const Gathered gathered(pieces.whole.vertex_count(), *data, "number");
    EXPECT_EQ(gathered.different, 0u);
    std::vector<float> each = gathered.first();
    std::ranges::sort(each);
    EXPECT_EQ(std::ranges::adjacent_find(each), each.end());
  }
}

// Local ids, as left by some programs, are not global.
TEST(GlobalNumbers, DoNotTrustIdsThatAreNotOfTheWhole) {
  const Pieces pieces("sphere,resolution=24", cuts()[0]);
  const std::vector<std::uint64_t> by_place = numbers_by_place(pieces);
  std::vector<std::int64_t> own(pieces.ids.size());
  std::iota(own.begin(), own.end(), 0);
  const std::vector<std::int64_t> same(own.size(), 7), negative(own.size(), -1);
  for (const auto& ids : {own, same, negative}) {
    if (rank_count() == 1 && ids == own) continue;  // the whole
    const PointNumbers numbers = global_numbers(ranks(), {pieces.own.positions, ids}, 1);
    EXPECT_EQ(numbers.of_points, by_place);
    EXPECT_TRUE(numbers.ids_refused);
    EXPECT_FALSE(numbers.by_id);
  }
}

// Points at one position are one vertex, as in one process, whatever their ids.
TEST(GlobalNumbers, PlacesJoinWhatIdsPutApart) {
  const Pieces pieces("sphere,resolution=24", cuts()[1]);
  std::vector<std::int64_t> ids;
  for (const std::uint64_t id : pieces.ids) {
    ids.push_back(static_cast<std::int64_t>(id + pieces.whole.vertex_count() * unsigned(rank())));
  }
  const auto data = pieces.polygons();
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetName("number");
  for (const std::uint64_t n : global_numbers(ranks(), {pieces.own.positions, ids}, 1).of_points) {
    numbers->InsertNextValue(double(n));
  }
  data->GetPointData()->AddArray(numbers);
  const Gathered gathered(pieces.whole.vertex_count(), *data, "number");
  EXPECT_EQ(gathered.different, 0u);
  EXPECT_EQ(gathered.shared > 0, rank_count() > 1);
}

// Points that a program rounded differently are one vertex by their ids.
TEST(GlobalNumbers, IdsJoinWhatRoundingPutsApart) {
  Pieces pieces("sphere,resolution=24", cuts()[0]);
  for (Vec3& p : pieces.own.positions) p *= 1 + 1e-7f * static_cast<float>(rank());
  const auto data = pieces.polygons(true);
  vtkNew<vtkBrindleStripes> filter;
  filter->SetInputData(data);
  filter->SetField(kDirection);
  filter->SetTextureCoordinates(false);
  filter->Update();
  const Gathered phases(pieces.whole.vertex_count(), *filter->GetOutput(), "phase");
  EXPECT_EQ(phases.different, 0u);
}

TEST(RankStripes, AreTheLibrarysBitForBit) {
  for (const char* shape : {kTorus, "sphere,resolution=30"}) {
    for (const Cut& cut : cuts()) {
      for (const bool with_ids : {false, true}) {
        SCOPED_TRACE(std::string(shape) + ", " + cut.name);
        const Pieces pieces(shape, cut);
        vtkNew<vtkBrindleStripes> filter;
        lay_swirl(*filter, pieces.polygons(with_ids));
        Twin twin(pieces, with_ids ? pieces.ids : numbers_by_place(pieces));
        const std::span<const Complex> z = twin.frame(0);
        if (!pieces.ids.empty()) expect_phases(*filter->GetOutput(), z);
        expect_one_pattern(pieces.whole, *filter->GetOutput());
      }
    }
  }
}

TEST(RankStripes, OfOneRankAreThoseOfOneProcess) {
  const Pieces pieces(
      kTorus, {"all", [](const Mesh& mesh) { return std::vector<int>(mesh.triangle_count()); }});
  vtkNew<vtkBrindleStripes> filter;
  lay_swirl(*filter, pieces.polygons());
  if (rank_count() > 1 && rank() > 0) {
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
    return;
  }
  if (rank_count() > 1) return;
  const Surface surface = make_surface(pieces.own);
  std::vector<Vec3> vectors;
  for (const Vec3& p : pieces.own.positions) vectors.push_back(swirl(p, 0));
  const float frequency = frequency_of_stripes(40, bounding_box(surface.mesh).diagonal());
  expect_phases(
      *filter->GetOutput(),
      stripe_pattern(surface, tangent_directions(vectors, surface.normals), frequency).solution.z);
}

/// Arrays independent of borders: of points and cells, vectors, tensors and numbers.
void add_arrays(vtkPolyData& data) {
  const auto place = [&](vtkIdType i) {
    double p[3];
    data.GetPoint(i, p);
    return Vec3(float(p[0]), float(p[1]), float(p[2]));
  };
  vtkNew<vtkDoubleArray> tensors, numbers;
  tensors->SetName("tensor");
  tensors->SetNumberOfComponents(6);
  numbers->SetName("number");
  for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i) {
    const Vec3 p = place(i);
    const double row[] = {1.0 + p.x(), 2.0 - p.y(), 0.5 + p.z(), p.y(), p.z(), p.x()};
    tensors->InsertNextTuple(row);
    numbers->InsertNextValue(1 + p.squaredNorm());
  }
  data.GetPointData()->AddArray(tensors);
  data.GetPointData()->AddArray(numbers);
  vtkNew<vtkIdList> corners;
  data.GetCellData()->AddArray(vectors_by("cells", data.GetNumberOfCells(), [&](vtkIdType cell) {
    data.GetCellPoints(cell, corners);
    return swirl(
        (place(corners->GetId(0)) + place(corners->GetId(1)) + place(corners->GetId(2))) / 3, 0.4f);
  }));
}

struct Waves {
  const char* name;
  std::function<void(vtkBrindleStripes&)> set;
};

const std::vector<Waves>& all_waves() {
  static const std::vector<Waves> all = {
      {"smooth", [](vtkBrindleStripes& f) { f.SetField(kSmooth); }},
      {"curvature", [](vtkBrindleStripes& f) { f.SetField(kCurvature); }},
      {"direction",
       [](vtkBrindleStripes& f) {
         f.SetField(kDirection);
         f.SetDirection(1, 2, 3);
         f.SetRotate(20);
       }},
      {"cells",
       [](vtkBrindleStripes& f) {
         f.SetField(kArray);
         choose(f, 0, "cells", false);
       }},
      {"tensors",
       [](vtkBrindleStripes& f) {
         f.SetField(kArray);
         choose(f, 0, "tensor");
       }},
      {"numbers of points",
       [](vtkBrindleStripes& f) {
         f.SetField(kDirection);
         f.SetFrequencySource(kByArray);
         choose(f, 1, "number");
       }},
      {"lengths of cells' vectors",
       [](vtkBrindleStripes& f) {
         f.SetField(kDirection);
         f.SetFrequencySource(kFrequencyArray);
         choose(f, 1, "cells", false);
       }},
      {"cells at the scale of stripes",
       [](vtkBrindleStripes& f) {
         f.SetField(kArray);
         choose(f, 0, "cells", false);
         choose(f, 2, "number");
         f.SetFieldSmoothing(1);
       }},
      {"tensors and numbers at the scale of stripes",
       [](vtkBrindleStripes& f) {
         f.SetField(kArray);
         choose(f, 0, "tensor");
         f.SetFieldSmoothing(0.5);
         f.SetFrequencySource(kByArray);
         choose(f, 1, "number");
         f.SetFrequencySmoothing(1.5);
         f.SetRotate(30);
       }},
  };
  return all;
}

TEST(RankStripes, HaveOnePhaseWhereverTheWavesComeFrom) {
  for (const Cut& cut : cuts()) {
    const Pieces pieces("trefoil,resolution=24", cut);
    const auto data = pieces.polygons();
    add_arrays(*data);
    for (const Waves& waves : all_waves()) {
      SCOPED_TRACE(std::string(cut.name) + ", " + waves.name);
      vtkNew<vtkBrindleStripes> filter;
      filter->SetInputData(data);
      filter->SetTextureCoordinates(false);
      waves.set(*filter);
      Errors errors(*filter);
      filter->Update();
      ASSERT_TRUE(errors.messages.empty()) << errors.messages[0];
      expect_one_pattern(pieces.whole, *filter->GetOutput());
    }
  }
}

// Frequencies and directions from cells equal those of one process.
TEST(RankStripes, HaveTheWavesOfOneProcess) {
  const Mesh mesh = make_shape("trefoil,resolution=24");
  const Pieces all(
      mesh, {"all", [](const Mesh& m) { return std::vector<int>(m.triangle_count(), rank()); }});
  for (const Cut& cut : cuts()) {
    const Pieces pieces(mesh, cut);
    for (const Waves& waves : all_waves()) {
      if (waves.name == std::string("smooth") || waves.name == std::string("curvature")) continue;
      SCOPED_TRACE(std::string(cut.name) + ", " + waves.name);
      vtkNew<vtkBrindleStripes> filter, alone;
      const auto run = [&](vtkBrindleStripes& one, const Pieces& part) {
        const auto data = part.polygons();
        add_arrays(*data);
        one.SetInputData(data);
        one.SetTextureCoordinates(false);
        waves.set(one);
        one.Update();
      };
      run(*filter, pieces);
      {
        vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
        vtkMultiProcessController::SetGlobalController(nullptr);
        run(*alone, all);
        vtkMultiProcessController::SetGlobalController(controller);
      }
      const Gathered f(mesh.vertex_count(), *filter->GetOutput(), "frequency");
      const Gathered d(mesh.vertex_count(), *filter->GetOutput(), "direction");
      const std::vector<float> frequencies = numbers(*alone->GetOutput(), "frequency");
      const std::vector<float> directions = numbers(*alone->GetOutput(), "direction");
      double worst = 0;
      for (std::size_t i = 0; i < all.ids.size(); ++i) {
        const std::uint64_t v = all.ids[i];
        worst = std::max(worst, double(std::abs(f.values[v][0] / frequencies[i] - 1)));
        const Vec3 a(d.values[v].data()), b(&directions[3 * i]);
        worst = std::max(worst, double(std::min((a - b).norm(), (a + b).norm())));
      }
      EXPECT_LT(worst, 1e-4);
    }
  }
}

/// Whether the output's point is a global vertex with a wave, not a barycentre.
bool is_wavy_vertex(const Mesh& whole, vtkPolyData& output, vtkIdType point) {
  vtkPointData& data = *output.GetPointData();
  const auto v = static_cast<std::size_t>(data.GetArray("whole")->GetComponent(point, 0));
  const Vec3 place = Eigen::Vector3d(output.GetPoint(point)).cast<float>();
  return place == whole.positions[v] && data.GetArray("valid")->GetComponent(point, 0) != 0;
}

/// U at vertices in triangles shows their phase. Returns the number of such vertices.
std::size_t expect_shown_phases(const Mesh& whole, vtkPolyData& output) {
  std::set<vtkIdType> used;
  vtkNew<vtkIdList> corners;
  for (vtkIdType t = 0; t < output.GetNumberOfCells(); ++t) {
    output.GetCellPoints(t, corners);
    used.insert(corners->begin(), corners->end());
  }
  std::size_t compared = 0, wrong = 0;
  for (const vtkIdType point : used) {
    vtkDataArray& uv = *output.GetPointData()->GetTCoords();
    if (!is_wavy_vertex(whole, output, point) || uv.GetComponent(point, 1) == 0) continue;
    const double phase = 2 * std::numbers::pi * (uv.GetComponent(point, 0) - 0.25);
    const double sine = output.GetPointData()->GetArray("sin_phase")->GetComponent(point, 0);
    wrong += std::abs(std::sin(phase) - sine) < 2e-4 ? 0 : 1;
    ++compared;
  }
  EXPECT_EQ(wrong, 0u);
  return compared;
}

// Both sides of a border draw one stripe: phases agree, and U shows them.
TEST(RankStripes, TextureCoordinatesAgreeAtBorders) {
  for (const Cut& cut : cuts()) {
    const Pieces pieces("trefoil,resolution=24", cut);
    const auto data = pieces.polygons();
    add_arrays(*data);
    for (const Waves& waves : all_waves()) {
      SCOPED_TRACE(std::string(cut.name) + ", " + waves.name);
      vtkNew<vtkBrindleStripes> filter;
      filter->SetInputData(data);
      waves.set(*filter);
      filter->Update();
      vtkPolyData& output = *filter->GetOutput();
      EXPECT_EQ(expect_shown_phases(pieces.whole, output) > 0, output.GetNumberOfCells() > 0);
    }
  }
}

}  // namespace
}  // namespace brindle::paraview
