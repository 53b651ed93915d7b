#include "brindle/creases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include <Eigen/Geometry>

#include "brindle/base/elementary.h"
#include "brindle/base/graph.h"
#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/error.h"
#include "brindle/geometry/crease_edges.h"
#include "brindle/geometry/normals_around.h"
#include "brindle/geometry/topology.h"
#include "brindle/surface.h"

namespace brindle {
namespace {

/// Most triangles in the mean normal of a side; bounds the work at vertices of high valence.
constexpr std::size_t kMostOfSide = 24;

/// Fewest edges of a chain that is a crease of any surface. Noise makes shorter ones.
constexpr std::size_t kLongChain = 20;

float cosine_of(float angle_deg) {
  return elementary::cos(angle_deg * std::numbers::pi_v<float> / 180);
}

/// Area vectors: normals times twice the area.
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

/// In doubles, as below.
std::vector<Vec3> unit_or_zero(std::span<const Vec3> vectors) {
  std::vector<Vec3> units(vectors.size());
  parallel_for(vectors.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      units[t] = vectors[t].cast<double>().normalized().cast<float>();
    }
  });
  return units;
}

/// Whether a and b, of any length, enclose less than the angle of this cosine; true for zero
/// vectors. In doubles: squared areas leave the range of float in very small or large units.
bool bends_less(const Vec3& a, const Vec3& b, double cosine) {
  const Eigen::Vector3d x = a.cast<double>(), y = b.cast<double>();
  const double lengths = std::sqrt(x.squaredNorm() * y.squaredNorm());
  return !(lengths > 0) || x.dot(y) >= cosine * lengths;
}

/// An edge at a vertex, in one of its triangles.
struct Spoke {
  Index other;  ///< the vertex at its other end
  Index half_edge;
  Index number;  ///< index of the triangle among those around the vertex
};

/// Calls `visit` with the spokes of each edge at the vertex, sorted by other end, then by
/// half-edge.
template <class Visit>
void for_each_edge(const Mesh& mesh, Index v, std::span<const Index> around, const Visit& visit) {
  thread_local std::vector<Spoke> spokes;
  spokes.clear();
  for (Index n = 0; n < around.size(); ++n) {
    const Triangle& triangle = mesh.triangles[around[n]];
    const Index leaving = 3 * around[n] + static_cast<Index>(corner_of(triangle, v));
    const Index coming = previous_in_triangle(leaving);
    spokes.push_back({vertex_at(mesh.triangles, next_in_triangle(leaving)), leaving, n});
    spokes.push_back({vertex_at(mesh.triangles, coming), coming, n});
  }
  ranges::sort(spokes.begin(), spokes.end(), [](const Spoke& a, const Spoke& b) {
    return std::pair(a.other, a.half_edge) < std::pair(b.other, b.half_edge);
  });
  for (std::size_t begin = 0, end = 0; begin < spokes.size(); begin = end) {
    while (end < spokes.size() && spokes[end].other == spokes[begin].other) ++end;
    visit(std::span<const Spoke>(spokes).subspan(begin, end - begin));
  }
}

/// Finds creases from the triangles around vertices. Most surfaces have few sharp edges, so that a
/// quick test rejects nearly all vertices. At first, all sharp edges are creases.
class CreaseFinder {
 public:
  CreaseFinder(const Mesh& mesh, float angle_deg, const Progress& progress)
      : mesh_(mesh),
        cosine_(cosine_of(angle_deg)),
        areas_(area_vectors(mesh)),
        normals_(unit_or_zero(areas_)),
        around_(vertex_triangles(mesh, progress.part(0, 0.5))),
        is_crease_(3 * mesh.triangle_count()) {
    find_sharp_edges(progress.part(0.5, 1));
  }

  /// Whether any edge is sharp, or has three or more triangles: whether those are sharp depends on
  /// the order of triangles.
  bool may_split() const {
    bool found = !ends_.empty();
    for (Index v = 0; v < around_.size() && !found; ++v) {
      if (is_smooth(v)) continue;
      for_each_edge(mesh_, v, around_.of(v), [&](auto edge) { found = found || edge.size() > 2; });
    }
    return found;
  }

  void drop_noise_and_folds() {
    drop_noise();
    drop_short_chains();
  }

  std::span<const Index> around(Index v) const { return around_.of(v); }

  /// Whether the surface is smooth between two half-edges of an edge with `triangles` triangles.
  bool goes_on(Index a, Index b, std::size_t triangles) const {
    if (is_crease_[a] == 0) return true;
    return triangles > 2 && bends_less(areas_[a / 3], turned_area(a, b), cosine_);
  }

  /// Calls `visit` with the ends (lower number first) and the half-edges of all creases.
  template <class Visit>
  void for_each_crease(const Visit& visit) const {
    for (std::size_t e = 0; e < ends_.size(); ++e) {
      if (is_crease(e)) visit(ends_[e], half_edges_.of(e));
    }
  }

 private:
  bool is_crease(std::size_t edge) const { return is_crease_[half_edges_.of(edge)[0]] != 0; }
  void drop(std::size_t edge) {
    for (const Index h : half_edges_.of(edge)) is_crease_[h] = 0;
  }

  /// Whether the triangles of two half-edges of an edge have opposite winding. With equal winding
  /// they traverse the edge in opposite directions.
  bool run_against(Index a, Index b) const {
    return vertex_at(mesh_.triangles, a) == vertex_at(mesh_.triangles, b);
  }

  /// A vector of b's triangle in the orientation of a's.
  Vec3 turned(Index a, Index b, const Vec3& vector) const {
    return run_against(a, b) ? Vec3(-vector) : vector;
  }
  Vec3 turned_area(Index a, Index b) const { return turned(a, b, areas_[b / 3]); }

  bool is_sharp(std::span<const Spoke> edge) const {
    for (std::size_t k = 1; k < edge.size(); ++k) {
      const Index a = edge[k - 1].half_edge;
      if (!bends_less(areas_[a / 3], turned_area(a, edge[k].half_edge), cosine_)) return true;
    }
    return false;
  }

  /// Quick test that no edge at the vertex is sharp or has more than two triangles: winding is
  /// consistent, and neighbours bend by less than the angle, by more than rounding. Triangles
  /// without area fail it.
  bool is_smooth(Index v) const {
    constexpr std::size_t kFew = 12;
    constexpr float kRounding = 1e-5f;
    const std::span<const Index> around = around_.of(v);
    if (around.size() > kFew) return false;
    std::array<Index, kFew> next, previous;
    for (std::size_t n = 0; n < around.size(); ++n) {
      const Triangle& triangle = mesh_.triangles[around[n]];
      const int corner = corner_of(triangle, v);
      next[n] = triangle[(corner + 1) % 3];
      previous[n] = triangle[(corner + 2) % 3];
      for (std::size_t k = 0; k < n; ++k) {
        if (next[k] == next[n] || previous[k] == previous[n]) return false;
        if (next[k] != previous[n] && previous[k] != next[n]) continue;
        const float cosine = normals_[around[k]].dot(normals_[around[n]]);
        if (cosine < cosine_ + kRounding) return false;
      }
    }
    return true;
  }

  /// Sorted by higher end, then by lower end.
  void find_sharp_edges(const Progress& progress) {
    const auto for_sharp_below = [&](Index v, const auto& visit) {
      for_each_edge(mesh_, v, around_.of(v), [&](std::span<const Spoke> edge) {
        if (edge[0].other < v && is_sharp(edge)) visit(edge);
      });
    };
    std::vector<std::uint8_t> has_sharp(mesh_.vertex_count());
    parallel_for(has_sharp.size(), progress, [&](std::size_t begin, std::size_t end) {
      for (auto v = static_cast<Index>(begin); v < end; ++v) {
        if (!is_smooth(v)) for_sharp_below(v, [&](const auto&) { has_sharp[v] = 1; });
      }
    });
    for (Index v = 0; v < has_sharp.size(); ++v) {
      if (has_sharp[v] == 0) continue;
      for_sharp_below(v, [&](std::span<const Spoke> edge) {
        ends_.push_back({edge[0].other, v});
        for (const Spoke& spoke : edge) {
          half_edges_.entries.push_back(spoke.half_edge);
          is_crease_[spoke.half_edge] = 1;
        }
        half_edges_.offsets.push_back(static_cast<Index>(half_edges_.entries.size()));
      });
    }
  }

  /// The half-edge of the adjacent triangle; nullopt at boundaries and non-manifold edges.
  std::optional<Index> across(Index half_edge) const {
    const Index a = vertex_at(mesh_.triangles, half_edge);
    const Index b = vertex_at(mesh_.triangles, next_in_triangle(half_edge));
    std::optional<Index> found;
    for (const Index t : around_.of(a)) {
      const Triangle& triangle = mesh_.triangles[t];
      if (t == half_edge / 3 || ranges::find(triangle, b) == triangle.end()) continue;
      if (found) return std::nullopt;
      const Index leaving = 3 * t + static_cast<Index>(corner_of(triangle, a));
      const bool leads = vertex_at(mesh_.triangles, next_in_triangle(leaving)) == b;
      found = leads ? leaving : previous_in_triangle(leaving);
    }
    return found;
  }

  /// A triangle of a side, and whether its winding equals that of the first.
  struct SideTriangle {
    Index triangle;
    bool alike;
  };

  /// The surface on one side of an edge.
  struct Side {
    Vec3 normal = Vec3::Zero();  ///< mean normal, of any length
    double area = 0;             ///< its length if the side is flat
    std::size_t count = 0;       ///< of triangles

    bool is_flat() const { return normal.cast<double>().norm() >= 0.999 * area; }
    /// A few triangles are flat by chance.
    bool is_face() const { return is_flat() && count > 3; }
  };

  /// The triangles nearest to this one that are connected to it without sharp edges. They bend from
  /// it by less than 90 degrees: normals all around a hole would cancel.
  Side side(Index triangle) const {
    std::array<SideTriangle, kMostOfSide> reached;
    reached[0] = {triangle, true};
    Side found;
    found.count = 1;
    for (std::size_t next = 0; next < found.count; ++next) {
      const auto [t, alike] = reached[next];
      found.normal += alike ? areas_[t] : Vec3(-areas_[t]);
      found.area += areas_[t].cast<double>().norm();
      for (Index h = 3 * t; h < 3 * t + 3 && found.count < kMostOfSide; ++h) {
        if (is_crease_[h] != 0) continue;
        const std::optional<Index> beyond = across(h);
        if (!beyond) continue;
        const auto is_same = [&](const SideTriangle& s) { return s.triangle == *beyond / 3; };
        if (std::any_of(reached.begin(), reached.begin() + found.count, is_same)) continue;
        const SideTriangle more{*beyond / 3, alike != run_against(h, *beyond)};
        const Vec3& area = areas_[more.triangle];
        if (!bends_less(areas_[triangle], more.alike ? area : Vec3(-area), 0)) continue;
        reached[found.count++] = more;
      }
    }
    return found;
  }

  /// Also finds `is_clean_`.
  void drop_noise() {
    std::vector<std::uint8_t> is_noise(ends_.size());
    is_clean_.assign(ends_.size(), 1);
    const auto find_noise = [&](std::size_t begin, std::size_t end) {
      for (std::size_t e = begin; e < end; ++e) {
        const std::span<const Index> along = half_edges_.of(e);
        if (along.size() != 2) continue;
        const Side a = side(along[0] / 3), b = side(along[1] / 3);
        is_noise[e] = bends_less(a.normal, turned(along[0], along[1], b.normal), cosine_) ? 1 : 0;
        const bool both_flat = a.is_flat() && b.is_flat();
        is_clean_[e] = both_flat || a.is_face() || b.is_face() ? 1 : 0;
      }
    };
    constexpr std::size_t kGrain = 64;
    parallel_for(ends_.size(), find_noise, kGrain);
    for (std::size_t e = 0; e < ends_.size(); ++e) {
      if (is_noise[e] != 0) drop(e);
    }
  }

  bool is_at_boundary(Index v) const {
    bool found = false;
    for_each_edge(mesh_, v, around_.of(v), [&](auto edge) { found = found || edge.size() == 1; });
    return found;
  }

  /// Connected creases, and their vertices.
  struct Chain {
    std::vector<Index> edges;
    std::vector<Index> vertices;
  };

  /// Long chains are features. Short ones are too if they run from boundary to boundary, or if they
  /// bound the faces of a part. Others are noise, or too short for the mesh.
  void drop_short_chains() {
    at_vertex_ = compressed_rows<Index>(mesh_.vertex_count(), [&](const auto& add) {
      for (std::size_t e = 0; e < ends_.size(); ++e) {
        if (!is_crease(e)) continue;
        for (const Index v : ends_[e]) add(v, static_cast<Index>(e));
      }
    });
    std::vector<std::uint8_t> seen(mesh_.vertex_count());
    Chain chain;
    for (Index first = 0; first < seen.size(); ++first) {
      if (seen[first] != 0 || at_vertex_.of(first).empty()) continue;
      find_chain(first, seen, chain);
      if (chain.edges.size() >= kLongChain) continue;
      if (ranges::count_if(chain.vertices, [&](Index v) { return is_at_boundary(v); }) > 1)
        continue;
      drop_open_ends(chain);
      if (bounds_faces(chain)) continue;
      for (const Index e : chain.edges) drop(e);
    }
  }

  void find_chain(Index first, std::vector<std::uint8_t>& seen, Chain& chain) const {
    chain.vertices.assign(1, first);
    chain.edges.clear();
    seen[first] = 1;
    for (std::size_t next = 0; next < chain.vertices.size(); ++next) {
      const Index v = chain.vertices[next];
      for (const Index e : at_vertex_.of(v)) {
        const auto& [low, high] = ends_[e];
        const Index other = v == low ? high : low;
        if (v == low) chain.edges.push_back(e);
        if (std::exchange(seen[other], std::uint8_t{1}) == 0) chain.vertices.push_back(other);
      }
    }
  }

  bool ends_at(Index v) const {
    return ranges::count_if(at_vertex_.of(v), [&](Index e) { return is_crease(e); }) == 1;
  }

  void drop_open_ends(Chain& chain) {
    const auto drop_end = [&](Index e) {
      const bool is_end = ends_at(ends_[e][0]) || ends_at(ends_[e][1]);
      if (is_end) drop(e);
      return is_end;
    };
    while (std::erase_if(chain.edges, drop_end) > 0) {
    }
    std::erase_if(chain.vertices, [&](Index v) {
      return ranges::none_of(at_vertex_.of(v), [&](Index e) { return is_crease(e); });
    });
  }

  /// Whether a closed chain is one of a part's: most of its faces are flat, or as coarse as the
  /// chain, so that nearly all vertices around are on creases.
  bool bounds_faces(const Chain& chain) const {
    if (chain.edges.empty()) return false;
    const auto clean = ranges::count_if(chain.edges, [&](Index e) { return is_clean_[e] != 0; });
    if (2 * clean >= std::ssize(chain.edges)) return true;
    std::vector<Index> off;
    for (const Index v : chain.vertices) {
      for (const Index t : around_.of(v)) {
        for (const Index w : mesh_.triangles[t]) {
          if (at_vertex_.of(w).empty() && ranges::find(off, w) == off.end()) off.push_back(w);
        }
      }
    }
    return 3 * off.size() <= chain.vertices.size();
  }

  const Mesh& mesh_;
  float cosine_;
  std::vector<Vec3> areas_;
  std::vector<Vec3> normals_;  ///< unit, or zero without area
  VertexTriangles around_;
  std::vector<std::array<Index, 2>> ends_;  ///< of sharp edges, the lower number first
  CompressedRows<Index> half_edges_;        ///< of sharp edges, in ascending order
  std::vector<std::uint8_t> is_crease_;     ///< by half-edge
  std::vector<std::uint8_t> is_clean_;      ///< by sharp edge: between flat faces, not noisy ones
  CompressedRows<Index> at_vertex_;         ///< the sharp edges at a vertex that are not noise
};

/// Splits the vertices of a mesh at the creases that were found.
class Splitter {
 public:
  Splitter(Mesh& mesh, const CreaseFinder& found) : mesh_(mesh), found_(found) {}

  Creases split() {
    std::vector<std::uint8_t> on_crease(mesh_.vertex_count());
    found_.for_each_crease([&](const std::array<Index, 2>& ends, std::span<const Index>) {
      for (const Index v : ends) on_crease[v] = 1;
    });
    for (Index v = 0; v < on_crease.size(); ++v) {
      if (on_crease[v] != 0) split_vertex(v);
    }
    for (const auto& [corner, copy] : moved_) mesh_.triangles[corner / 3][corner % 3] = copy;
    found_.for_each_crease([&](const std::array<Index, 2>& ends, std::span<const Index> along) {
      add_edges(ends[0], along);
    });
    return std::move(result_);
  }

 private:
  void split_vertex(Index v) {
    const std::span<const Index> around = found_.around(v);
    MergedSets sectors(around.size());  // of triangles around
    for_each_edge(mesh_, v, around, [&](std::span<const Spoke> edge) {
      for (std::size_t i = 0; i < edge.size(); ++i) {
        for (std::size_t j = i + 1; j < edge.size(); ++j) {
          if (found_.goes_on(edge[i].half_edge, edge[j].half_edge, edge.size())) {
            sectors.merge(edge[i].number, edge[j].number);
          }
        }
      }
    });
    copy_sectors(v, around, sectors);
  }

  /// The first triangle's sector keeps the vertex.
  void copy_sectors(Index v, std::span<const Index> around, MergedSets& sectors) {
    copy_.assign(around.size(), v);
    for (Index n = 1; n < around.size(); ++n) {
      const Index first = sectors.of(n);
      if (first == n) {
        copy_[n] = static_cast<Index>(mesh_.vertex_count());
        mesh_.positions.push_back(Vec3(mesh_.positions[v]));
        result_.copied.push_back(v);
      } else {
        copy_[n] = copy_[first];
      }
      if (copy_[n] == v) continue;
      for (Index corner = 3 * around[n]; corner < 3 * around[n] + 3; ++corner) {
        if (vertex_at(mesh_.triangles, corner) == v) moved_.push_back({corner, copy_[n]});
      }
    }
  }

  /// Records edges whose sides now have separate vertices, the lower end first.
  void add_edges(Index low, std::span<const Index> along) {
    const auto side = [&](Index half_edge) -> std::array<Index, 2> {
      const Index from = vertex_at(mesh_.triangles, half_edge);
      const Index to = vertex_at(mesh_.triangles, next_in_triangle(half_edge));
      if (result_.original(from, mesh_.vertex_count()) == low) return {from, to};
      return {to, from};
    };
    for (std::size_t k = 1; k < along.size(); ++k) {
      const CreaseEdge edge{side(along[k - 1]), side(along[k])};
      if (edge.first != edge.second) result_.edges.push_back(edge);
    }
  }

  /// A corner that is moved to a copy of its vertex.
  struct MovedCorner {
    Index corner;
    Index copy;
  };

  Mesh& mesh_;
  const CreaseFinder& found_;
  Creases result_;
  std::vector<MovedCorner> moved_;  ///< applied last: the search needs the triangles unchanged
  std::vector<Index> copy_;
};

/// Whether the angle allows creases.
bool allows_creases(float angle_deg) {
  if (!(angle_deg >= 0 && angle_deg <= 180)) {
    throw Error("the angle of creases must be from 0 to 180 degrees (180: none)");
  }
  return angle_deg < 180;
}

}  // namespace

Creases split_at_creases(Mesh& mesh, float angle_deg, const Progress& progress) {
  if (!allows_creases(angle_deg)) return {};
  check_mesh(mesh);
  CreaseFinder found(mesh, angle_deg, progress);
  found.drop_noise_and_folds();
  return Splitter(mesh, found).split();
}

bool may_have_creases(const Mesh& mesh, float angle_deg) {
  if (!allows_creases(angle_deg)) return false;
  check_mesh(mesh);
  return CreaseFinder(mesh, angle_deg, {}).may_split();
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
