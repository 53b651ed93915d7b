#include "brindle/geometry/subdivide.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "brindle/base/memory.h"
#include "brindle/base/parallel.h"
#include "brindle/error.h"
#include "brindle/geometry/rounded_midpoints.h"
#include "brindle/geometry/topology.h"
#include "brindle/mesh.h"

namespace brindle {
namespace {

/// Numbers edges in the order of their smaller, then of their larger end.
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

  /// The neighbours of v with larger numbers, each at the end of one edge of v.
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
        // Halved before the sum, which could overflow.
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
  // Half a vertex a triangle; twice, since the mesh is copied; and its neighborhood and normals,
  // which whatever follows needs.
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

std::vector<JobStage> subdivision_rounds(int times) {
  std::vector<JobStage> rounds;
  for (int i = 0; i < times; ++i) {
    rounds.push_back({"subdivide " + std::to_string(i + 1), std::pow(4.0, i)});
  }
  return rounds;
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

}  // namespace brindle
