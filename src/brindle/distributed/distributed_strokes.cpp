#include "brindle/distributed/distributed_strokes.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>

#include <Eigen/Geometry>

#include "brindle/distributed/surface/part_of_whole.h"
#include "brindle/distributed/surface/rank_surface.h"
#include "brindle/distributed_surface.h"
#include "brindle/geometry/measures.h"
#include "brindle/geometry/topology.h"
#include "brindle/nearest.h"
#include "brindle/waves/stroke_parts.h"

namespace brindle {
namespace {

struct SentAnchor {
  std::uint64_t id;
  std::array<float, 3> direction;
  float weight;
};

double squared_distance(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                        const Eigen::Vector3d& b) {
  const Eigen::Vector3d along = b - a;
  const double square = along.squaredNorm();
  const double share = square > 0 ? std::clamp((p - a).dot(along) / square, 0.0, 1.0) : 0.0;
  return (a + share * along - p).squaredNorm();
}

/// Own triangles that strokes may have to do with.
class NearTriangles {
 public:
  explicit NearTriangles(const RankSurface& surface)
      : surface_(surface), near_(surface.mesh.triangle_count()) {
    if (near_.empty()) return;
    nearest_.emplace(surface.mesh);
    own_.resize(surface.mesh.vertex_count());
    for (const Triangle& triangle : surface.mesh.triangles) {
      for (const Index v : triangle) own_[v] = 1;
    }
  }

  void add(const FieldStroke& stroke) {
    if (near_.empty()) return;
    for (const Eigen::Vector3d& place : places_of(stroke)) {
      const auto found = nearest_->nearest(place - surface_.mesh.origin);
      if (found) near_[found->triangle] = 1;
    }
    const std::vector<std::uint8_t> reached = vertices_near(stroke);
    for (std::size_t t = 0; t < near_.size(); ++t) {
      for (const Index v : surface_.mesh.triangles[t]) near_[t] |= reached[v];
    }
  }

  /// With these normals of all vertices.
  std::vector<SentTriangle> triangles(std::span<const Vec3> normals) const {
    std::vector<Index> sent;
    for (Index t = 0; t < near_.size(); ++t) {
      if (near_[t] != 0) sent.push_back(t);
    }
    return sent_triangles(surface_, sent, normals);
  }

 private:
  /// What a stroke reaches is within its radius of a place that it is allowed to be away from.
  std::vector<std::uint8_t> vertices_near(const FieldStroke& stroke) const {
    const double reach = (1 + 1e-5) * (stroke.radius + allowed_distance(stroke, surface_.diagonal));
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& point : stroke.points) box.extend(point - surface_.mesh.origin);
    std::vector<std::uint8_t> reached(surface_.vertex_count());
    for (std::size_t v = 0; v < reached.size(); ++v) {
      if (!own_[v]) continue;
      const Eigen::Vector3d p = surface_.mesh.positions[v].cast<double>();
      if (box.squaredExteriorDistance(p) > reach * reach) continue;
      for (std::size_t i = 0; i + 1 < stroke.points.size() && !reached[v]; ++i) {
        const double square = squared_distance(p, stroke.points[i] - surface_.mesh.origin,
                                               stroke.points[i + 1] - surface_.mesh.origin);
        reached[v] = square <= reach * reach ? 1 : 0;
      }
    }
    return reached;
  }

  const RankSurface& surface_;
  std::vector<std::uint8_t> near_, own_;  // by triangle, and by vertex of these
  std::optional<NearestOnMesh> nearest_;
};

struct SentFeature {
  std::array<std::uint64_t, 2> ids;  ///< the lower one first
  std::array<std::array<float, 3>, 2> positions;
};

/// Each edge is told of by the owner of its end of lower number, who has all its triangles.
std::vector<SentFeature> own_features(const RankSurface& surface, float angle_deg) {
  std::vector<std::uint64_t> ids = known_ids(surface);
  surface.exchange_all(std::span(ids));  // ghosts need not be in the piece
  const Mesh mesh = triangles_around_own(surface);
  std::vector<SentFeature> sent;
  surface.ranks->together([&] {
    const MeshEdges edges = mesh_edges(mesh, vertex_neighborhood(mesh));
    for (auto [a, b] : feature_edges(mesh, edges, angle_deg)) {
      if (ids[b] < ids[a]) std::swap(a, b);
      if (a >= surface.graph.own) continue;
      sent.push_back(
          {{ids[a], ids[b]}, {floats_of(mesh.positions[a]), floats_of(mesh.positions[b])}});
    }
  });
  return sent;
}

std::vector<FieldStroke> strokes_of(std::vector<SentFeature> edges, const Eigen::Vector3d& origin,
                                    double radius, double strength) {
  // As `mesh_edges` has them.
  std::ranges::sort(edges, {}, [](const SentFeature& e) { return std::pair(e.ids[1], e.ids[0]); });
  std::map<std::uint64_t, std::array<float, 3>> corners;
  for (const SentFeature& edge : edges) {
    for (std::size_t end = 0; end < 2; ++end) corners[edge.ids[end]] = edge.positions[end];
  }
  Mesh mesh;
  mesh.origin = origin;
  std::unordered_map<std::uint64_t, Index> vertex_of;
  for (const auto& [id, position] : corners) {
    vertex_of[id] = static_cast<Index>(mesh.positions.size());
    mesh.positions.push_back(vector_of(position));
  }
  std::vector<std::array<Index, 2>> of_mesh;
  for (const SentFeature& edge : edges) {
    of_mesh.push_back({vertex_of.at(edge.ids[0]), vertex_of.at(edge.ids[1])});
  }
  return strokes_along(mesh, of_mesh, radius, strength);
}

/// Rank 0's points, stroke by stroke, on all ranks.
std::vector<FieldStroke> of_first_rank(Communicator& ranks, const std::vector<FieldStroke>& strokes,
                                       double radius, double strength) {
  std::vector<std::uint64_t> counts;
  std::vector<std::array<double, 3>> points;
  for (const FieldStroke& stroke : strokes) {
    counts.push_back(stroke.points.size());
    for (const Eigen::Vector3d& p : stroke.points) points.push_back({p.x(), p.y(), p.z()});
  }
  points = ranks.of_first(points);
  std::vector<FieldStroke> strokes_of_all;
  std::size_t next = 0;
  for (const std::uint64_t count : ranks.of_first(counts)) {
    FieldStroke& stroke = strokes_of_all.emplace_back(FieldStroke{{}, radius, strength});
    for (std::uint64_t i = 0; i < count; ++i) {
      const auto& [x, y, z] = points[next++];
      stroke.points.emplace_back(x, y, z);
    }
  }
  return strokes_of_all;
}

}  // namespace

std::vector<FieldStroke> feature_strokes(const DistributedSurface& distributed, float angle_deg,
                                         double radius, double strength) {
  const RankSurface& surface = distributed.rank_surface();
  Communicator& ranks = *surface.ranks;
  const std::vector<SentFeature> own = own_features(surface, angle_deg);
  auto all = joined<SentFeature>(ranks.gather(std::as_bytes(std::span(own))));
  std::vector<FieldStroke> strokes;
  ranks.together([&] {
    if (ranks.rank() == 0) {
      strokes = strokes_of(std::move(all), surface.mesh.origin, radius, strength);
    }
  });
  return of_first_rank(ranks, strokes, radius, strength);
}

std::vector<FieldAnchor> stroke_anchors(const DistributedSurface& distributed,
                                        std::span<const FieldStroke> strokes) {
  return stroke_anchors(distributed, strokes, distributed.rank_surface().normals);
}

std::vector<FieldAnchor> stroke_anchors(const DistributedSurface& distributed,
                                        std::span<const FieldStroke> strokes,
                                        std::span<const Vec3> normals) {
  const RankSurface& surface = distributed.rank_surface();
  Communicator& ranks = *surface.ranks;
  ranks.together([&] { check_strokes(strokes); });
  NearTriangles near(surface);
  for (const FieldStroke& stroke : strokes) near.add(stroke);
  const std::vector<SentTriangle> own = near.triangles(normals);
  auto all = joined<SentTriangle>(ranks.gather(std::as_bytes(std::span(own))));
  std::vector<SentAnchor> found;
  ranks.together([&] {
    if (ranks.rank() != 0) return;
    const PartOfWhole part = part_of(std::move(all), surface.mesh.origin);
    for (const FieldAnchor& anchor : stroke_anchors(part.surface, strokes, surface.diagonal)) {
      found.push_back({part.ids[anchor.vertex], floats_of(anchor.direction), anchor.weight});
    }
  });
  std::unordered_map<std::uint64_t, Index> vertex_of;
  for (Index p = 0; p < surface.piece_ids.size(); ++p) vertex_of[surface.piece_ids[p]] = p;
  std::vector<FieldAnchor> anchors;
  for (const SentAnchor& anchor : ranks.of_first(found)) {
    const auto vertex = vertex_of.find(anchor.id);
    if (vertex == vertex_of.end()) continue;
    anchors.push_back({vertex->second, vector_of(anchor.direction), anchor.weight});
  }
  return anchors;
}

}  // namespace brindle
