/// Distributed surfaces in VTK's form.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <numeric>
#include <random>
#include <string>
#include <unordered_map>
#include <vector>

#include <brindle/distributed_stripes.h>
#include <vtkGhostCellsGenerator.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkMultiProcessController.h>
#include <vtkUnsignedCharArray.h>

#include "ranks.h"
#include "vtk_surfaces.h"

namespace brindle::paraview {

inline constexpr const char* kShape = "torus,resolution=40";
inline constexpr double kCoarse = 20;  // number of stripes that it resolves

/// A singleton, because its creation is collective.
inline const Ranks& ranks() {
  static const Ranks all(MPI_COMM_WORLD);
  return all;
}
inline int rank() { return ranks().rank(); }
inline int rank_count() { return ranks().size(); }

/// Sums over all ranks.
inline double sum(double value) {
  double total = 0;
  for (const double other : ranks().all(value)) total += other;
  return total;
}

/// The rank of each triangle.
struct Cut {
  const char* name;
  std::function<std::vector<int>(const Mesh& mesh)> ranks_of;
};

/// The slab, perpendicular to the x axis, of every triangle.
inline std::vector<int> slabs(const Mesh& mesh, int count) {
  const BoundingBox box = bounding_box(mesh);
  const float width = (box.upper.x() - box.lower.x()) / static_cast<float>(count);
  std::vector<int> slab;
  for (const auto& [a, b, c] : mesh.triangles) {
    const float x = (mesh.positions[a].x() + mesh.positions[b].x() + mesh.positions[c].x()) / 3;
    slab.push_back(std::clamp(static_cast<int>((x - box.lower.x()) / width), 0, count - 1));
  }
  return slab;
}

inline const std::vector<Cut>& cuts() {
  static const std::vector<Cut> all = {
      {"slabs", [](const Mesh& mesh) { return slabs(mesh, rank_count()); }},
      {"islands",
       [](const Mesh& mesh) {
         std::vector<int> ranks = slabs(mesh, 5 * rank_count());
         for (int& r : ranks) r %= rank_count();
         return ranks;
       }},
      {"by chance",
       [](const Mesh& mesh) {
         std::mt19937 random(1);
         std::vector<int> ranks(mesh.triangle_count());
         for (int& r : ranks) r = static_cast<int>(random() % static_cast<unsigned>(rank_count()));
         return ranks;
       }},
      {"the first rank has one triangle",
       [](const Mesh& mesh) {
         std::vector<int> ranks = slabs(mesh, std::max(1, rank_count() - 1));
         for (int& r : ranks) r = std::min(r + 1, rank_count() - 1);
         ranks[ranks.size() / 2] = 0;
         return ranks;
       }},
      {"the last rank has nothing",
       [](const Mesh& mesh) { return slabs(mesh, std::max(1, rank_count() - 1)); }},
      {"the last rank has all",
       [](const Mesh& mesh) { return std::vector<int>(mesh.triangle_count(), rank_count() - 1); }},
  };
  return all;
}

/// Runs `work` as a single process.
inline void alone(const std::function<void()>& work) {
  auto* controller = vtkMultiProcessController::GetGlobalController();
  vtkMultiProcessController::SetGlobalController(nullptr);
  work();
  vtkMultiProcessController::SetGlobalController(controller);
}

/// The pieces of a file that a rank reads, distributed as by VTK's readers.
inline std::vector<int> dealt(int pieces) {
  std::vector<int> own;
  for (int p = pieces * rank() / rank_count(); p < pieces * (rank() + 1) / rank_count(); ++p) {
    own.push_back(p);
  }
  return own;
}

/// A mesh and this rank's partition, with the points of its triangles; on one rank, in the order of
/// the whole.
struct Pieces {
  Mesh whole;
  Mesh own;
  std::vector<std::uint64_t> ids;  ///< global numbers of own vertices

  Pieces(const char* shape, const Cut& cut) : Pieces(make_shape(shape), cut) {}
  Pieces(Mesh mesh, const Cut& cut) : whole(std::move(mesh)) {
    if (rank_count() == 1) {
      take_in_order();
      return;
    }
    std::unordered_map<Index, Index> number;
    const std::vector<int> rank_of = cut.ranks_of(whole);
    for (std::size_t t = 0; t < whole.triangle_count(); ++t) {
      if (rank_of[t] != rank()) continue;
      Triangle corners = whole.triangles[t];
      for (Index& v : corners) {
        const auto [place, is_new] = number.emplace(v, static_cast<Index>(ids.size()));
        if (is_new) {
          ids.push_back(v);
          own.positions.push_back(whole.positions[v]);
        }
        v = place->second;
      }
      own.triangles.push_back(corners);
    }
  }

  void take_in_order() {
    own = whole;
    ids.resize(whole.vertex_count());
    std::iota(ids.begin(), ids.end(), std::uint64_t{0});
  }

  /// With the array `whole` of global numbers; optionally as VTK's global ids.
  vtkSmartPointer<vtkPolyData> polygons(bool with_ids = false) const {
    auto data = polygons_of(own);
    vtkNew<vtkIdTypeArray> numbers;
    numbers->SetName("whole");
    for (const std::uint64_t id : ids) numbers->InsertNextValue(static_cast<vtkIdType>(id));
    data->GetPointData()->AddArray(numbers);
    if (with_ids) data->GetPointData()->SetGlobalIds(numbers);
    return data;
  }
};

/// The same data with a layer of ghosts, as from ParaView's Ghost Cells.
template <class Data>
vtkSmartPointer<Data> with_ghosts(Data* data) {
  vtkNew<vtkGhostCellsGenerator> generator;
  generator->SetInputData(data);
  generator->SetBuildIfRequired(false);
  generator->SetNumberOfGhostLayers(1);
  generator->Update();
  return Data::SafeDownCast(generator->GetOutputDataObject(0));
}

inline long ghost_count(vtkDataSet& data) {
  vtkUnsignedCharArray* flags = data.GetCellGhostArray();
  long count = 0;
  for (vtkIdType i = 0; flags != nullptr && i < flags->GetNumberOfTuples(); ++i) {
    count += (flags->GetValue(i) & vtkDataSetAttributes::DUPLICATECELL) != 0;
  }
  return count;
}

/// A row of numbers for every global vertex, from all ranks that have it.
class Gathered {
 public:
  /// Adds rows of the output's point array, which must agree at shared vertices.
  Gathered(std::size_t vertices, vtkDataSet& output, const char* name) : known(vertices) {
    std::vector<Row> rows;
    vtkDataArray* numbers = output.GetPointData()->GetArray("whole");
    vtkDataArray* array = output.GetPointData()->GetArray(name);
    for (vtkIdType i = 0; array != nullptr && i < output.GetNumberOfPoints(); ++i) {
      const auto vertex = static_cast<std::uint64_t>(numbers->GetComponent(i, 0));
      Row row{vertex, {}};
      for (int c = 0; c < std::min(3, array->GetNumberOfComponents()); ++c) {
        row.numbers[static_cast<std::size_t>(c)] = static_cast<float>(array->GetComponent(i, c));
      }
      rows.push_back(row);
    }
    const Ranks all = ranks();
    const auto everybodys =
        all.swap_lists(std::vector<std::vector<Row>>(static_cast<std::size_t>(all.size()), rows));
    values.resize(vertices);
    for (const auto& list : everybodys) {
      for (const Row& row : list) take(row);
    }
  }

  std::vector<std::array<float, 3>> values;
  std::vector<char> known;
  std::size_t shared = 0;     ///< rows of vertices that were already known
  std::size_t different = 0;  ///< of these, with different bits

  std::vector<float> first() const {
    std::vector<float> numbers;
    for (const auto& row : values) numbers.push_back(row[0]);
    return numbers;
  }

 private:
  struct Row {
    std::uint64_t vertex;
    std::array<float, 3> numbers;
  };

  void take(const Row& row) {
    if (known[row.vertex] != 0) {
      ++shared;
      for (std::size_t c = 0; c < 3; ++c) {
        const float a = values[row.vertex][c], b = row.numbers[c];
        if (!(a == b || (std::isnan(a) && std::isnan(b)))) {
          ++different;
          break;
        }
      }
    }
    known[row.vertex] = 1;
    values[row.vertex] = row.numbers;
  }
};

}  // namespace brindle::paraview
