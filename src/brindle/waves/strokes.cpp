#include "brindle/strokes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "brindle/base/elementary.h"
#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/error.h"
#include "brindle/geometry/measures.h"
#include "brindle/geometry/nearest_place.h"
#include "brindle/waves/direction_graph.h"

namespace brindle {
namespace {

using Vec3d = Eigen::Vector3d;

constexpr double kStepsPerRadius = 8;
constexpr double kMostSteps = 20'000;  // of one stroke
constexpr double kNearEnough = 0.01;   // of the diagonal: two meshes of one object may differ by it

std::string name_of(std::size_t stroke) { return "strokes[" + std::to_string(stroke) + "]"; }

double length_of(const FieldStroke& stroke) {
  double length = 0;
  for (std::size_t i = 1; i < stroke.points.size(); ++i) {
    length += (stroke.points[i] - stroke.points[i - 1]).norm();
  }
  return length;
}

void check_stroke(const FieldStroke& stroke, const std::string& name) {
  for (std::size_t i = 0; i < stroke.points.size(); ++i) {
    if (stroke.points[i].allFinite() && stroke.points[i].cwiseAbs().maxCoeff() < 1e18) continue;
    throw Error(name + ": point " + std::to_string(i) +
                " has a coordinate that is not finite or beyond 1e18; correct or leave it out");
  }
  if (stroke.points.size() < 2 || !(length_of(stroke) > 0)) {
    throw Error(name + " has no length; give two points or more at different places");
  }
  if (!(stroke.radius > 0) || !std::isfinite(stroke.radius)) {
    throw Error(name + ": the radius must be a finite number above 0");
  }
  if (!(stroke.strength >= 0) || !(stroke.strength <= 1e6)) {
    throw Error(name + ": the strength must be a number from 0 to 1000000");
  }
}

/// The points of a stroke in an order that does not depend on its direction, so that both
/// directions give the same bits.
std::vector<Vec3d> points_one_way(const FieldStroke& stroke) {
  std::vector<Vec3d> points = stroke.points;
  const auto less = [](const Vec3d& a, const Vec3d& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  };
  if (std::lexicographical_compare(points.rbegin(), points.rend(), points.begin(), points.end(),
                                   less)) {
    std::reverse(points.begin(), points.end());
  }
  return points;
}

/// The middle of one of the equal steps of a stroke.
struct StrokeStep {
  Vec3d position;
  Vec3 along;
  std::size_t segment;  ///< from this point of the stroke to the next
};

std::vector<StrokeStep> steps_along(const FieldStroke& stroke) {
  const std::vector<Vec3d> points = points_one_way(stroke);
  const double length = length_of(stroke);
  const double count =
      std::ceil(std::min(kMostSteps, 1 + kStepsPerRadius * length / stroke.radius));
  const double step = length / count;
  std::vector<StrokeStep> steps;
  double begin = 0;
  double next = step / 2;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec3d way = points[i + 1] - points[i];
    const double end = begin + way.norm();
    for (; next < end; next += step) {
      steps.push_back({points[i] + way * ((next - begin) / (end - begin)),
                       (way / way.norm()).cast<float>(), i});
    }
    begin = end;
  }
  return steps;
}

NearbyPlace place_near(const NearestPlace& places, const Vec3d& point) {
  const auto found = places.nearest(point);
  if (!found) throw Error("strokes need a surface with vertices");
  return *found;
}

/// Sums over the steps of one stroke at the vertices in their reach.
class StrokeReach {
 public:
  explicit StrokeReach(const Surface& surface)
      : surface_(surface),
        sums_(surface.mesh.vertex_count()),
        visit_of_(surface.mesh.vertex_count(), 0) {}

  /// Spreads over the neighbourhood, which excludes places that are near in space but far along the
  /// surface, like the other side of a sheet.
  void add(const StrokeStep& step, const NearbyPlace& place, float radius) {
    ++visit_;
    queue_.clear();
    for (const Index corner : place.corners) {
      // If the mesh is too coarse for the radius, the nearest vertices are used.
      visit(corner, step, std::min(distance(corner, place), radius / 2), radius);
    }
    for (std::size_t next = 0; next < queue_.size(); ++next) {
      for (const Index neighbor : surface_.neighborhood->of(queue_[next])) {
        const float d = distance(neighbor, place);
        if (d < radius) visit(neighbor, step, d, radius);
      }
    }
  }

  /// Appends the anchors and clears the sums.
  void take(float strength, std::vector<FieldAnchor>& anchors) {
    ranges::sort(touched_.begin(), touched_.end());
    for (const Index v : touched_) {
      const Sum sum = std::exchange(sums_[v], {});
      const Complex mean = sum.line / sum.weight;
      const float weight = strength * sum.nearest * std::abs(mean);
      if (!(weight > 0)) continue;
      anchors.push_back({v, direction_of(mean, surface_.normals[v]), weight});
    }
    touched_.clear();
  }

 private:
  struct Sum {
    Complex line = 0;  ///< weighted sum of exp(2 i theta)
    float weight = 0;
    float nearest = 0;  ///< the largest weight of one step
  };

  float distance(Index v, const NearbyPlace& place) const {
    return (surface_.mesh.positions[v] - place.position.cast<float>()).norm();
  }

  void visit(Index v, const StrokeStep& step, float d, float radius) {
    if (visit_of_[v] == visit_) return;
    visit_of_[v] = visit_;
    queue_.push_back(v);
    const float inside = 1 - d * d / (radius * radius);
    const float weight = inside * inside;
    const Vec3& normal = surface_.normals[v];
    const float flat = (step.along - step.along.dot(normal) * normal).norm();
    Sum& sum = sums_[v];
    if (sum.weight == 0) touched_.push_back(v);
    sum.line += weight * flat * representation(tangent_direction(step.along, normal), normal, 2);
    sum.weight += weight;
    sum.nearest = std::max(sum.nearest, weight);
  }

  static Vec3 direction_of(Complex line, const Vec3& normal) {
    const float theta = elementary::arg(line) / 2;
    const TangentBasis basis = tangent_basis(normal);
    return elementary::cos(theta) * basis.x + elementary::sin(theta) * basis.y;
  }

  const Surface& surface_;
  std::vector<Sum> sums_;
  std::vector<Index> touched_, queue_;
  std::vector<Index> visit_of_;
  Index visit_ = 0;
};

[[noreturn]] void refuse_far(const std::string& what, double distance, double allowed,
                             const std::string& remedy) {
  throw Error(what + " is " + std::to_string(distance) +
              " from the surface, farther than its radius allows (" + std::to_string(allowed) +
              "); " + remedy);
}

/// Checks points first: a line that leaves the surface between them is another mistake.
void check_near(const FieldStroke& stroke, const std::string& name, const NearestPlace& places,
                const Vec3d& origin, double allowed) {
  for (std::size_t i = 0; i < stroke.points.size(); ++i) {
    const double distance = place_near(places, stroke.points[i] - origin).distance;
    if (distance <= allowed) continue;
    refuse_far(name + ": point " + std::to_string(i), distance, allowed,
               "move it, raise the radius, or use the coordinates and units of the mesh");
  }
}

double allowed_distance(const FieldStroke& stroke, double diagonal) {
  return std::max(stroke.radius, kNearEnough * diagonal);
}

}  // namespace

void check_strokes(std::span<const FieldStroke> strokes) {
  for (std::size_t i = 0; i < strokes.size(); ++i) check_stroke(strokes[i], name_of(i));
}

std::vector<FieldAnchor> stroke_anchors(const Surface& surface,
                                        std::span<const FieldStroke> strokes,
                                        const Progress& progress) {
  check_strokes(strokes);
  std::vector<FieldAnchor> anchors;
  if (strokes.empty()) return anchors;
  JobStages stages(progress, {{"nearest places", 3}, {"strokes", 1}});
  const NearestPlace places(surface.mesh, stages.begin("nearest places"));
  const Progress reaching = stages.begin("strokes");
  StrokeReach reach(surface);
  const double diagonal = bounding_box(surface.mesh).diagonal();
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    const FieldStroke& stroke = strokes[i];
    const double allowed = allowed_distance(stroke, diagonal);
    check_near(stroke, name_of(i), places, surface.mesh.origin, allowed);
    for (const StrokeStep& step : steps_along(stroke)) {
      reaching.report(static_cast<double>(i) / static_cast<double>(strokes.size()));
      const NearbyPlace place = place_near(places, step.position - surface.mesh.origin);
      if (place.distance > allowed) {
        refuse_far(name_of(i) + ": the line between two of its points", place.distance, allowed,
                   "add points between them that lie on the surface");
      }
      reach.add(step, place, static_cast<float>(stroke.radius));
    }
    reach.take(static_cast<float>(stroke.strength), anchors);
  }
  stages.finish();
  return anchors;
}

namespace {

/// Chains of edges from corner to corner. Corners are vertices where other than two edges meet, or
/// two at more than 45 degrees.
class EdgeChains {
 public:
  EdgeChains(const Mesh& mesh, const std::vector<std::array<Index, 2>>& edges,
             const Progress& progress)
      : mesh_(mesh), edges_(edges), edges_at_(mesh.vertex_count()), used_(edges.size()) {
    for (std::size_t e = 0; e < edges.size(); ++e) {
      if (e % kReportSlice == 0) progress.tick();
      for (const Index v : edges[e]) edges_at_[v].push_back(e);
    }
  }

  std::vector<std::vector<Index>> chains(const Progress& progress) {
    std::vector<std::vector<Index>> all;
    const auto count = static_cast<Index>(edges_at_.size());
    const auto report = [&](Index v, double before) {
      if (v % kReportSlice == 0) progress.report(before + 0.5 * v / count);
    };
    const auto start_at = [&](Index v) {
      for (const std::size_t e : edges_at_[v]) {
        if (!used_[e]) all.push_back(chain(v, e));
      }
    };
    for (Index v = 0; v < count; ++v) {
      report(v, 0);
      if (is_corner(v)) start_at(v);
    }
    for (Index v = 0; v < count; ++v) {
      report(v, 0.5);
      start_at(v);
    }
    return all;
  }

 private:
  bool is_corner(Index v) const {
    const auto& edges = edges_at_[v];
    if (edges.size() != 2) return true;
    const Vec3 in = (mesh_.positions[v] - mesh_.positions[other(edges[0], v)]).stableNormalized();
    const Vec3 out = (mesh_.positions[other(edges[1], v)] - mesh_.positions[v]).stableNormalized();
    return in.dot(out) < 0.7f;
  }

  Index other(std::size_t edge, Index v) const {
    return edges_[edge][0] == v ? edges_[edge][1] : edges_[edge][0];
  }

  std::vector<Index> chain(Index start, std::size_t edge) {
    std::vector<Index> vertices = {start};
    for (Index v = start;;) {
      used_[edge] = true;
      v = other(edge, v);
      vertices.push_back(v);
      if (is_corner(v)) return vertices;
      const auto& next = edges_at_[v];
      edge = next[0] == edge ? next[1] : next[0];
      if (used_[edge]) return vertices;
    }
  }

  const Mesh& mesh_;
  const std::vector<std::array<Index, 2>>& edges_;
  std::vector<std::vector<std::size_t>> edges_at_;
  std::vector<bool> used_;
};

/// Chains as strokes.
std::vector<FieldStroke> strokes_along(const Mesh& mesh,
                                       const std::vector<std::array<Index, 2>>& edges,
                                       double radius, double strength, const Progress& progress) {
  std::vector<FieldStroke> strokes;
  EdgeChains edge_chains(mesh, edges, progress);
  for (const std::vector<Index>& chain : edge_chains.chains(progress)) {
    FieldStroke stroke{{}, radius, strength};
    for (const Index v : chain) {
      stroke.points.push_back(mesh.positions[v].cast<double>() + mesh.origin);
    }
    if (length_of(stroke) > 0) strokes.push_back(std::move(stroke));
  }
  return strokes;
}

}  // namespace

std::vector<FieldStroke> feature_strokes(const Surface& surface, float angle_deg, double radius,
                                         double strength, const Progress& progress) {
  const Mesh& mesh = surface.mesh;
  JobStages stages(progress, {{"edges", 3}, {"features", 1}, {"strokes", 2}});
  const MeshEdges all = mesh_edges(mesh, *surface.neighborhood, stages.begin("edges"));
  const auto edges = feature_edges(mesh, all, angle_deg, stages.begin("features"));
  std::vector<FieldStroke> strokes =
      strokes_along(mesh, edges, radius, strength, stages.begin("strokes"));
  stages.finish();
  return strokes;
}

}  // namespace brindle
