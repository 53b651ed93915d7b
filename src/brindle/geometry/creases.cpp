#include "brindle/creases.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

#include "brindle/base/elementary.h"
#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/error.h"
#include "brindle/geometry/normals_around.h"
#include "brindle/geometry/topology.h"
#include "brindle/surface.h"

namespace brindle {
namespace {

/// Sides of a crease bend by this share of the angle at least when they are averaged.
constexpr float kAveragedShare = 1.0f;
/// A side is averaged over so many triangles at most, which bounds the work at hubs.
constexpr std::size_t kMostOfSide = 24;

float cosine_of(float angle_deg) {
  return elementary::cos(angle_deg * std::numbers::pi_v<float> / 180);
}

/// Twice the area of every triangle along its normal.
std::vector<Vec3> area_vectors(const Mesh& mesh) {
  std::vector<Vec3> vectors(mesh.triangle_count());
  parallel_for(vectors.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const auto& [a, b, c] = mesh.triangles[t];
      const Vec3& p = mesh.positions[a];
      vectors[t] = (mesh.positions[b] - p).cross(mesh.positions[c] - p);
    }
  });
  return vectors;
}

/// Whether a and b, of any length, bend by less than the angle of this cosine; so does no area.
bool bends_less(const Vec3& a, const Vec3& b, float cosine) {
  const float lengths = std::sqrt(a.squaredNorm() * b.squaredNorm());
  return !(lengths > 0) || a.dot(b) >= cosine * lengths;
}

/// Whether any two triangles with a common edge bend by more than the angle: on most scans and
/// built-in shapes none do, and nothing else is looked at.
bool is_sharp_anywhere(const Mesh& mesh, const std::vector<Vec3>& areas, float cosine) {
  const VertexTriangles around = vertex_triangles(mesh);
  const auto is_sharp = [&](Index v, Index s, Index t) {
    const Triangle &a = mesh.triangles[s], &b = mesh.triangles[t];
    for (int m = 0; m < 3; ++m) {
      for (int n = 0; n < 3; ++n) {
        if (a[m] != b[n] || a[m] == v) continue;
        const bool against = (a[(m + 1) % 3] == v) == (b[(n + 1) % 3] == v);
        if (!bends_less(areas[s], against ? Vec3(-areas[t]) : areas[t], cosine)) return true;
      }
    }
    return false;
  };
  std::atomic<bool> found = false;
  parallel_for(mesh.vertex_count(), [&](std::size_t begin, std::size_t end) {
    for (auto v = static_cast<Index>(begin); v < end && !found; ++v) {
      const std::span<const Index> triangles = around.of(v);
      for (std::size_t j = 1; j < triangles.size(); ++j) {
        for (std::size_t i = 0; i < j; ++i) {
          if (bends_less(areas[triangles[i]], areas[triangles[j]], cosine)) continue;
          if (is_sharp(v, triangles[i], triangles[j])) found = true;
        }
      }
    }
  });
  return found;
}

class CreaseFinder {
 public:
  CreaseFinder(const Mesh& mesh, const std::vector<Vec3>& areas, float angle_deg,
               const Progress& progress)
      : mesh_(mesh),
        areas_(areas),
        cosine_(cosine_of(angle_deg)),
        averaged_cosine_(cosine_of(kAveragedShare * angle_deg)),
        edges_(mesh_edges(mesh, vertex_neighborhood(mesh, progress.part(0, 0.4)),
                          progress.part(0.4, 0.8))),
        crease_(edges_.count()) {
    for (Index e = 0; e < edges_.count(); ++e) crease_[e] = is_sharp(e) ? 1 : 0;
    drop_noise();
    drop_open_chains();
  }

  const MeshEdges& edges() const { return edges_; }
  bool any() const { return ranges::find(crease_, std::uint8_t{1}) != crease_.end(); }

  /// Whether the surface goes on without a crease from one half-edge to another of the same edge.
  bool goes_on(Index a, Index b) const {
    const Index edge = edges_.of_triangle[a / 3][a % 3];
    if (crease_[edge] == 0) return true;
    return edges_.triangle_count(edge) > 2 && bends_less(areas_[a / 3], turned_area(a, b), cosine_);
  }

  bool is_crease(Index edge) const { return crease_[edge] != 0; }

 private:
  /// Whether the triangles of two half-edges of one edge are wound against each other: those that
  /// are wound alike run along it in opposite ways.
  bool run_against(Index a, Index b) const {
    return vertex_at(mesh_.triangles, a) == vertex_at(mesh_.triangles, b);
  }

  /// A vector of b's triangle as seen from a's.
  Vec3 turned(Index a, Index b, const Vec3& vector) const {
    return run_against(a, b) ? Vec3(-vector) : vector;
  }
  Vec3 turned_area(Index a, Index b) const { return turned(a, b, areas_[b / 3]); }

  bool is_sharp(Index edge) const {
    const std::span<const Index> along = edges_.half_edges.of(edge);
    for (std::size_t k = 1; k < along.size(); ++k) {
      const Index a = along[k - 1];
      if (!bends_less(areas_[a / 3], turned_area(a, along[k]), cosine_)) return true;
    }
    return false;
  }

  /// A triangle of a side, and whether it is wound as the first.
  struct SideTriangle {
    Index triangle;
    bool alike;
  };

  /// The mean normal, of any length, of the triangles nearest to this one that are reached from it
  /// over edges that are not sharp.
  Vec3 side(Index triangle) const {
    std::vector<SideTriangle> reached = {{triangle, true}};
    Vec3 sum = Vec3::Zero();
    for (std::size_t next = 0; next < reached.size(); ++next) {
      const auto [t, alike] = reached[next];
      sum += alike ? areas_[t] : Vec3(-areas_[t]);
      for (Index m = 0; m < 3 && reached.size() < kMostOfSide; ++m) {
        const Index edge = edges_.of_triangle[t][m];
        const Index beyond = edges_.beyond(t, static_cast<int>(m));
        if (beyond == kNoTriangle || crease_[edge] != 0) continue;
        const auto is_same = [&](const SideTriangle& s) { return s.triangle == beyond; };
        if (std::any_of(reached.begin(), reached.end(), is_same)) continue;
        const std::span<const Index> along = edges_.half_edges.of(edge);
        reached.push_back({beyond, alike != run_against(along[0], along[1])});
      }
    }
    return sum;
  }

  void drop_noise() {
    std::vector<std::uint8_t> kept = crease_;
    parallel_for(edges_.count(), [&](std::size_t begin, std::size_t end) {
      for (Index e = static_cast<Index>(begin); e < end; ++e) {
        if (crease_[e] == 0 || edges_.triangle_count(e) != 2) continue;
        const std::span<const Index> along = edges_.half_edges.of(e);
        const Vec3 a = side(along[0] / 3);
        const Vec3 b = turned(along[0], along[1], side(along[1] / 3));
        if (bends_less(a, b, averaged_cosine_)) kept[e] = 0;
      }
    });
    crease_ = std::move(kept);
  }

  /// Creases of a part go round its faces: they close, or run from boundary to boundary. Chains
  /// that do neither are folds of something round, or noise.
  void drop_open_chains() {
    std::vector<std::uint8_t> at_boundary(mesh_.vertex_count());
    for (Index e = 0; e < edges_.count(); ++e) {
      if (edges_.triangle_count(e) != 1) continue;
      for (const Index v : edges_.vertices[e]) at_boundary[v] = 1;
    }
    const CompressedRows<Index> at_vertex =
        compressed_rows<Index>(mesh_.vertex_count(), [&](const auto& add) {
          for (Index e = 0; e < edges_.count(); ++e) {
            if (crease_[e] == 0) continue;
            for (const Index v : edges_.vertices[e]) add(v, e);
          }
        });
    std::vector<std::uint8_t> seen(mesh_.vertex_count());
    std::vector<Index> vertices, chain;
    for (Index first = 0; first < seen.size(); ++first) {
      if (seen[first] != 0 || at_vertex.of(first).empty()) continue;
      vertices.assign(1, first);
      chain.clear();
      seen[first] = 1;
      std::size_t ends_at_boundary = 0;
      for (std::size_t next = 0; next < vertices.size(); ++next) {
        const Index v = vertices[next];
        ends_at_boundary += at_boundary[v];
        for (const Index e : at_vertex.of(v)) {
          const auto& [low, high] = edges_.vertices[e];
          const Index other = v == low ? high : low;
          if (v == low) chain.push_back(e);
          if (std::exchange(seen[other], std::uint8_t{1}) == 0) vertices.push_back(other);
        }
      }
      if (chain.size() >= vertices.size() || ends_at_boundary > 1) continue;
      for (const Index e : chain) crease_[e] = 0;
    }
  }

  const Mesh& mesh_;
  const std::vector<Vec3>& areas_;
  float cosine_;
  float averaged_cosine_;
  MeshEdges edges_;
  std::vector<std::uint8_t> crease_;  ///< by edge
};

/// Splits the vertices of a mesh at the creases that were found.
class Splitter {
 public:
  Splitter(Mesh& mesh, const CreaseFinder& found) : mesh_(mesh), found_(found) {}

  Creases split() {
    const VertexTriangles around = vertex_triangles(mesh_);
    std::vector<std::uint8_t> on_crease(mesh_.vertex_count());
    for (Index e = 0; e < found_.edges().count(); ++e) {
      if (!found_.is_crease(e)) continue;
      for (const Index v : found_.edges().vertices[e]) on_crease[v] = 1;
    }
    const std::vector<Triangle> before = mesh_.triangles;
    for (Index v = 0; v < on_crease.size(); ++v) {
      if (on_crease[v] != 0) split_vertex(v, around.of(v), before);
    }
    add_edges(before);
    return std::move(result_);
  }

 private:
  /// A half-edge at the vertex, with the number of its triangle among those around.
  struct Spoke {
    Index edge;
    Index half_edge;
    Index number;
  };

  void split_vertex(Index v, std::span<const Index> around, const std::vector<Triangle>& before) {
    spokes_.clear();
    sector_.resize(around.size());
    std::iota(sector_.begin(), sector_.end(), Index{0});
    for (Index n = 0; n < around.size(); ++n) {
      for (Index m = 0; m < 3; ++m) {
        const Index half_edge = 3 * around[n] + m;
        if (vertex_at(before, half_edge) != v &&
            vertex_at(before, next_in_triangle(half_edge)) != v) {
          continue;
        }
        spokes_.push_back({found_.edges().of_triangle[around[n]][m], half_edge, n});
      }
    }
    ranges::sort(spokes_.begin(), spokes_.end(), [](const Spoke& a, const Spoke& b) {
      return std::pair(a.edge, a.half_edge) < std::pair(b.edge, b.half_edge);
    });
    for (std::size_t i = 0; i < spokes_.size(); ++i) {
      for (std::size_t j = i + 1; j < spokes_.size() && spokes_[j].edge == spokes_[i].edge; ++j) {
        if (found_.goes_on(spokes_[i].half_edge, spokes_[j].half_edge)) {
          merge(spokes_[i].number, spokes_[j].number);
        }
      }
    }
    copy_sectors(v, around);
  }

  Index first_of(Index n) const {
    while (sector_[n] != n) n = sector_[n];
    return n;
  }

  void merge(Index a, Index b) {
    const Index first = first_of(a), second = first_of(b);
    sector_[std::max(first, second)] = std::min(first, second);
  }

  /// The first triangle's sector keeps the vertex.
  void copy_sectors(Index v, std::span<const Index> around) {
    copy_.assign(around.size(), v);
    for (Index n = 1; n < around.size(); ++n) {
      const Index first = first_of(n);
      if (first == n) {
        copy_[n] = static_cast<Index>(mesh_.vertex_count());
        mesh_.positions.push_back(Vec3(mesh_.positions[v]));
        result_.copied.push_back(v);
      } else {
        copy_[n] = copy_[first];
      }
      for (Index& corner : mesh_.triangles[around[n]]) {
        if (corner == v) corner = copy_[n];
      }
    }
  }

  /// The edges whose sides have vertices of their own now.
  void add_edges(const std::vector<Triangle>& before) {
    for (Index e = 0; e < found_.edges().count(); ++e) {
      if (!found_.is_crease(e)) continue;
      const std::span<const Index> along = found_.edges().half_edges.of(e);
      for (std::size_t k = 1; k < along.size(); ++k) {
        const auto side = [&](std::size_t n) -> std::array<Index, 2> {
          const auto [low, high] = found_.edges().vertices[e];
          return {now_at(before, along[n] / 3, low), now_at(before, along[n] / 3, high)};
        };
        const CreaseEdge edge{side(k - 1), side(k)};
        if (edge.first != edge.second) result_.edges.push_back(edge);
      }
    }
  }

  Index now_at(const std::vector<Triangle>& before, Index t, Index v) const {
    return mesh_.triangles[t][static_cast<std::size_t>(corner_of(before[t], v))];
  }

  Mesh& mesh_;
  const CreaseFinder& found_;
  Creases result_;
  std::vector<Spoke> spokes_;
  std::vector<Index> sector_;  ///< of each triangle around: one before it in its sector, or itself
  std::vector<Index> copy_;
};

}  // namespace

Creases split_at_creases(Mesh& mesh, float angle_deg, const Progress& progress) {
  if (!(angle_deg >= 0 && angle_deg <= 180)) {
    throw Error("the angle of creases must be from 0 to 180 degrees (180: none)");
  }
  if (angle_deg == 180) return {};
  check_mesh(mesh);
  const std::vector<Vec3> areas = area_vectors(mesh);
  progress.tick();
  if (!is_sharp_anywhere(mesh, areas, cosine_of(angle_deg))) return {};
  const CreaseFinder found(mesh, areas, angle_deg, progress);
  if (!found.any()) return {};
  return Splitter(mesh, found).split();
}

Mesh joined_mesh(const Mesh& mesh, const Creases& creases) {
  Mesh joined = mesh;
  for (Triangle& triangle : joined.triangles) {
    for (Index& corner : triangle) corner = creases.original(corner, mesh.vertex_count());
  }
  return joined;
}

void add_rows_of_copies(const Creases& creases, DataArrays& arrays) {
  if (creases.empty()) return;
  std::vector<Index> rows;
  for (DataArray& array : arrays.points) {
    rows.resize(array.rows());
    std::iota(rows.begin(), rows.end(), Index{0});
    add_rows_of_copies(creases, rows);
    array = rows_of(array, rows);
  }
}

}  // namespace brindle
