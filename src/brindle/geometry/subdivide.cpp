#include "brindle/geometry/subdivide.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "brindle/base/array_rows.h"
#include "brindle/base/memory.h"
#include "brindle/base/parallel.h"
#include "brindle/error.h"
#include "brindle/geometry/normals_around.h"
#include "brindle/geometry/topology.h"
#include "brindle/mesh.h"
#include "brindle/mesh_data.h"

namespace brindle {
namespace {

/// Midpoints of edges on a rounded surface.
///
/// Edges become cubic curves orthogonal to the normals at their ends (Vlachos et al. 2001). Each
/// edge has its own normals: averages over the triangles around its end within 40 degrees of the
/// edge's normal. Edges that bend by more, or have more than two triangles, stay straight.
class RoundedMidpoints {
 public:
  /// Keeps a reference to the mesh. Throws Cancelled if `progress` asks for it.
  explicit RoundedMidpoints(const Mesh& mesh, const Progress& progress = {});

  /// Offset from an edge's midpoint to that of its curve; symmetric in `a` and `b`.
  Vec3 shift(Index a, Index b) const;

 private:
  Vec3 normal_of_edge(Index a, Index b) const;
  Vec3 normal_at(Index vertex, const Vec3& of_edge) const;

  const Mesh& mesh_;
  VertexTriangles around_;
  std::vector<TriangleAngles> angles_;
};

RoundedMidpoints::RoundedMidpoints(const Mesh& mesh, const Progress& progress)
    : mesh_(mesh),
      around_(vertex_triangles(mesh, progress.part(0, 0.4))),
      angles_(mesh.triangle_count()) {
  std::vector<Vec3> normals(mesh.vertex_count());
  fill_vertex_normals(mesh, around_, {}, angles_, normals, progress.part(0.4, 1));
}

/// Zero at creases, at edges of more than two triangles, and without area.
Vec3 RoundedMidpoints::normal_of_edge(Index a, Index b) const {
  Vec3 sum = Vec3::Zero(), first = Vec3::Zero();
  bool first_runs_on = false;
  int count = 0;
  for (const Index t : around_.of(a)) {
    const Triangle& triangle = mesh_.triangles[t];
    const int c = corner_of(triangle, a);
    const bool runs_on = triangle[(c + 1) % 3] == b;
    if (!runs_on && triangle[(c + 2) % 3] != b) continue;
    // With equal winding, two triangles traverse their edge in opposite directions.
    const bool against = count == 1 && runs_on == first_runs_on;
    const Vec3 normal = against ? Vec3(-angles_[t].normal) : angles_[t].normal;
    if (++count == 1) {
      first = normal;
      first_runs_on = runs_on;
    } else if (count > 2 || normal.dot(first) < kCosineOfCrease) {
      return Vec3::Zero();
    }
    sum += normal;
  }
  return sum.normalized();
}

Vec3 RoundedMidpoints::normal_at(Index vertex, const Vec3& of_edge) const {
  Vec3 sum = Vec3::Zero();
  for (const Index t : around_.of(vertex)) {
    const TriangleAngles& angles = angles_[t];
    const float alike = angles.normal.dot(of_edge);
    if (std::abs(alike) < kCosineOfCrease) continue;
    const float angle = angles.angle[corner_of(mesh_.triangles[t], vertex)];
    sum += (alike < 0 ? -angle : angle) * angles.normal;
  }
  return sum.normalized();
}

Vec3 RoundedMidpoints::shift(Index a, Index b) const {
  if (a > b) std::swap(a, b);
  const Vec3 of_edge = normal_of_edge(a, b);
  if (of_edge.isZero(0)) return Vec3::Zero();
  const Vec3 way = mesh_.positions[b] - mesh_.positions[a];
  const Vec3 normal_a = normal_at(a, of_edge), normal_b = normal_at(b, of_edge);
  const Vec3 shift = (way.dot(normal_b) * normal_b - way.dot(normal_a) * normal_a) / 8;
  return shift.allFinite() ? shift : Vec3(Vec3::Zero());
}

/// Numbers edges by smaller end, then by larger end.
class EdgeNumbers {
 public:
  EdgeNumbers(const Mesh& mesh, const Progress& progress)
      : neighborhood_(vertex_neighborhood(mesh, vertex_triangles(mesh), progress)),
        first_(mesh.vertex_count() + 1, 0) {
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      first_[v + 1] = first_[v] + static_cast<Index>(larger(v).size());
    }
  }

  Index count() const { return first_.back(); }
  Index first(Index v) const { return first_[v]; }

  /// The neighbours of v with larger numbers: the other ends of the edges numbered at v.
  std::span<const Index> larger(Index v) const {
    const auto row = neighborhood_.of(v);
    return {std::upper_bound(row.begin(), row.end(), v), row.end()};
  }

  Index operator()(Index a, Index b) const {
    if (a > b) std::swap(a, b);
    const auto row = larger(a);
    return first_[a] +
           static_cast<Index>(std::lower_bound(row.begin(), row.end(), b) - row.begin());
  }

 private:
  Adjacency neighborhood_;
  std::vector<Index> first_;
};

Mesh subdivide_once(Mesh mesh, Midpoints midpoints, const Progress& progress) {
  progress.report(0);
  std::optional<RoundedMidpoints> rounded;
  if (midpoints == Midpoints::rounded) rounded.emplace(mesh, progress.part(0, 0.3));
  const EdgeNumbers edges(mesh, progress.part(rounded ? 0.3 : 0, 0.5));
  const auto old_vertices = static_cast<Index>(mesh.vertex_count());
  mesh.positions.resize(mesh.vertex_count() + edges.count());
  parallel_for(old_vertices, progress.part(0.5, 0.7), [&](std::size_t begin, std::size_t end) {
    for (auto v = static_cast<Index>(begin); v < end; ++v) {
      Index midpoint = old_vertices + edges.first(v);
      for (const Index other : edges.larger(v)) {
        // Halved first, since the sum could overflow.
        Vec3& middle = mesh.positions[midpoint++];
        middle = 0.5f * mesh.positions[v] + 0.5f * mesh.positions[other];
        if (rounded) middle += rounded->shift(v, other);
      }
    }
  });
  std::vector<Triangle> finer(4 * mesh.triangle_count());
  parallel_for(mesh.triangle_count(), progress.part(0.7, 1),
               [&](std::size_t begin, std::size_t end) {
                 for (std::size_t t = begin; t < end; ++t) {
                   const auto& [a, b, c] = mesh.triangles[t];
                   const Index ab = old_vertices + edges(a, b), bc = old_vertices + edges(b, c),
                               ca = old_vertices + edges(c, a);
                   finer[4 * t] = {a, ab, ca};
                   finer[4 * t + 1] = {ab, b, bc};
                   finer[4 * t + 2] = {ca, bc, c};
                   finer[4 * t + 3] = {ab, bc, ca};
                 }
               });
  mesh.triangles = std::move(finer);
  return mesh;
}

/// One progress stage per subdivision, each four times as long as the one before.
std::vector<JobStage> subdivision_rounds(int times) {
  std::vector<JobStage> rounds;
  for (int i = 0; i < times; ++i) {
    rounds.push_back({"subdivide " + std::to_string(i + 1), std::pow(4.0, i)});
  }
  return rounds;
}

/// Sources of the vertices and triangles after one subdivision.
struct Parents {
  std::vector<RowBlend> of_vertices;
  std::vector<Index> of_triangles;
};

Parents parents_of(const Mesh& coarse, const Mesh& fine) {
  Parents parents;
  parents.of_vertices.resize(fine.vertex_count());
  for (Index v = 0; v < coarse.vertex_count(); ++v) {
    parents.of_vertices[v] = {{v, v, v}, {1, 0, 0}};
  }
  for (std::size_t t = 0; t < coarse.triangle_count(); ++t) {
    const Triangle& inner = fine.triangles[4 * t + 3];  // its corners: the midpoints ab, bc, ca
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [a, b] = std::minmax(coarse.triangles[t][i], coarse.triangles[t][(i + 1) % 3]);
      parents.of_vertices[inner[i]] = {{a, b, b}, {0.5, 0.5, 0}};
    }
  }
  parents.of_triangles.resize(fine.triangle_count());
  for (std::size_t t = 0; t < fine.triangle_count(); ++t) {
    parents.of_triangles[t] = static_cast<Index>(t / 4);
  }
  return parents;
}

}  // namespace

void check_subdivisions(std::size_t triangles, int times) {
  if (times < 0) throw Error("a mesh cannot be subdivided " + std::to_string(times) + " times");
  std::size_t finer = triangles;
  for (int i = 0; i < times && finer > 0; ++i) {
    finer *= 4;
    // A neighbourhood has up to six entries per triangle.
    if (finer > std::numeric_limits<Index>::max() / 6) {
      throw Error("subdividing " + std::to_string(triangles) + " triangles " +
                  std::to_string(times) + " times makes more than brindle can number; at most " +
                  std::to_string(i) + " times is possible");
    }
  }
  // Half a vertex per triangle; twice, since the mesh is copied; plus neighbourhood and normals,
  // which later steps need.
  constexpr double kBytes = 2 * (sizeof(Triangle) + sizeof(Vec3) / 2) + 78;
  check_fits(
      static_cast<double>(finer), kBytes,
      "subdividing " + std::to_string(triangles) + " triangles " + std::to_string(times) + " times",
      "triangles", [&](double most) {
        const double rounds = std::log2(most / static_cast<double>(triangles)) / 2;
        return "at most " + std::to_string(std::max(0, static_cast<int>(rounds))) +
               " times is possible";
      });
}

Mesh subdivide(Mesh mesh, int times, const Progress& progress) {
  return subdivide(std::move(mesh), times, Midpoints::straight, progress);
}

Mesh subdivide(Mesh mesh, int times, Midpoints midpoints, const Progress& progress) {
  check_subdivisions(mesh.triangle_count(), times);
  if (times == 0 || mesh.triangles.empty()) return mesh;
  const std::vector<JobStage> rounds = subdivision_rounds(times);
  JobStages stages(progress, rounds);
  for (const JobStage& round : rounds) {
    mesh = subdivide_once(std::move(mesh), midpoints, stages.begin(round.name));
  }
  stages.finish();
  return mesh;
}

void subdivide(Mesh& mesh, DataArrays& arrays, int times, const Progress& progress) {
  subdivide(mesh, arrays, times, Midpoints::straight, progress);
}

void subdivide(Mesh& mesh, DataArrays& arrays, int times, Midpoints midpoints,
               const Progress& progress) {
  check_subdivisions(mesh.triangle_count(), times);
  for (const DataArray& array : arrays.points) {
    check_rows_per_vertex(array, mesh.vertex_count());
  }
  for (const DataArray& array : arrays.cells) {
    check_rows_per_triangle(array, mesh.triangle_count());
  }
  if (arrays == DataArrays{}) {
    mesh = progress.is_heard() ? subdivide(mesh, times, midpoints, progress)
                               : subdivide(std::move(mesh), times, midpoints);
    return;
  }
  if (times == 0 || mesh.triangles.empty()) return;
  const std::vector<JobStage> rounds = subdivision_rounds(times);
  JobStages stages(progress, rounds);
  Mesh result = mesh;
  DataArrays data = arrays;
  for (const JobStage& round : rounds) {
    const Progress stage = stages.begin(round.name);
    Mesh finer = subdivide(result, 1, midpoints, stage.part(0, 0.5));
    stage.report(0.5);
    const Parents parents = parents_of(result, finer);
    data = {blended(data.points, parents.of_vertices), rows_of(data.cells, parents.of_triangles)};
    result = std::move(finer);
  }
  stages.finish();
  mesh = std::move(result);
  arrays = std::move(data);
}

}  // namespace brindle
