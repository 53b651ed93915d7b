#include "brindle/relief.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "brindle/base/parallel.h"
#include "brindle/error.h"
#include "brindle/geometry/measures.h"
#include "brindle/geometry/topology.h"
#include "brindle/nearest.h"
#include "brindle/relief/decimation.h"
#include "brindle/relief/refined_relief.h"
#include "brindle/relief/relief_bodies.h"
#include "brindle/relief/self_intersections.h"
#include "brindle/relief/volume.h"

namespace brindle {
namespace {

constexpr float kDefaultTolerance = 0.05f;  // share of the height
constexpr float kShareOfBall = 0.45f;       // two reliefs that face each other keep a gap
constexpr float kInsideBall = 0.9f;         // facets of a smooth surface cut less off a ball
constexpr int kMostLowerings = 12;

void check_options(const ReliefTexture& texture, const ReliefOptions& options) {
  const auto refuse = [](const std::string& what) { throw Error("relief: " + what); };
  if (!(options.height > 0) || !std::isfinite(options.height)) refuse("the height is above 0");
  if (!(options.depth >= 0) || !std::isfinite(options.depth)) refuse("the depth is 0 or more");
  if (!(options.tolerance >= 0) || !std::isfinite(options.tolerance)) {
    refuse("the tolerance is 0 or more");
  }
  if (options.depth > 0 && options.kind != ReliefKind::inlay) refuse("only an inlay has a depth");
  if (!texture.height) refuse("the texture has no height");
  if (!(texture.detail >= 1.0f / 256) || !(texture.detail <= 0.25f)) {
    refuse("the texture's detail is from 1/256 to 1/4");
  }
}

/// The radius of the largest ball that touches the surface at `p`, on the side of the unit normal
/// `n`, with no part of the surface inside; at most `largest` (shrinking ball, Ma et al. 2012).
float ball_radius(const NearestOnMesh& nearest, const Vec3& p, const Vec3& n, float largest) {
  const Eigen::Vector3d from = p.cast<double>(), normal = n.cast<double>();
  double radius = largest;
  for (int i = 0; i < 16; ++i) {
    const auto found = nearest.nearest(from + radius * normal, kInsideBall * radius);
    if (!found) break;
    const Eigen::Vector3d way = found->position - from;
    radius = std::min(kInsideBall * radius, way.squaredNorm() / (2 * normal.dot(way)));
  }
  return static_cast<float>(radius);
}

/// The smaller one of the height and the limit at every vertex, in units of length.
struct ReliefHeights {
  std::vector<float> above, below;
};

class ReliefMaker {
 public:
  ReliefMaker(const ReliefBase& base, const ReliefOptions& options, float tolerance)
      : base_(base), options_(options), tolerance_(tolerance) {}

  Relief make(const ReliefTexture& texture, const Progress& progress) {
    JobStages stages(progress, {{"refining", 4}, {"limiting", 2}, {"decimating", 5}});
    const RefinementLimits limits{0.5f * tolerance_ / options_.height, 0.5f * tolerance_,
                                  options_.kind != ReliefKind::raised};
    refined_ = refined_relief(base_, texture, limits, stages.begin("refining"));
    limit(stages.begin("limiting"));
    arrange();
    Relief relief;
    relief.metrics.refined_triangles = mesh_.triangle_count();
    relief.mesh = reduced(stages.begin("decimating"), relief.metrics);
    measure(relief);
    stages.finish();
    return relief;
  }

 private:
  /// The height requested at a vertex.
  float requested(Index v) const {
    if (options_.kind != ReliefKind::raised) return options_.height;
    return options_.height * refined_.heights[v];
  }

  void limit(const Progress& progress) {
    const std::size_t count = refined_.positions.size();
    heights_.above.resize(count);
    heights_.below.assign(count, options_.depth);
    const NearestOnMesh nearest(base_.mesh, progress.part(0, 0.2));
    parallel_for(
        count, progress.part(0.2, 1),
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t v = begin; v < end; ++v) {
            const Vec3 normal = refined_.directions[v].normalized();
            const auto limited = [&](float height, float sign) {
              if (!(height > 0)) return height;
              const float radius =
                  ball_radius(nearest, refined_.positions[v], sign * normal, height / kShareOfBall);
              return radius < height / kShareOfBall ? kShareOfBall * radius : height;
            };
            heights_.above[v] = limited(requested(static_cast<Index>(v)), 1);
            heights_.below[v] = limited(options_.depth, -1);
          }
        },
        64);
  }

  /// The mesh before displacement, and the refined vertex of each of its vertices.
  void arrange() {
    Mesh surface{refined_.positions, refined_.triangles, base_.mesh.origin};
    if (options_.kind == ReliefKind::raised) {
      bodies_.vertices.resize(surface.vertex_count());
      for (Index v = 0; v < bodies_.vertices.size(); ++v) bodies_.vertices[v] = v;
      bodies_.below.assign(surface.vertex_count(), 0);
      mesh_ = std::move(surface);
      return;
    }
    std::vector<std::uint8_t> taken(surface.triangle_count());
    for (std::size_t t = 0; t < taken.size(); ++t) {
      float sum = 0;
      for (const Index v : surface.triangles[t]) sum += refined_.heights[v] - 0.5f;
      const bool high = sum > 0;
      const bool textured = base_.textured[refined_.base[t]] != 0;
      taken[t] = options_.kind == ReliefKind::inlay ? (high ? 1 : 0) : (textured && !high ? 1 : 0);
    }
    bodies_ = relief_bodies(surface, taken);
    mesh_ = std::move(bodies_.mesh);
  }

  Vec3 displaced(std::size_t i) const {
    const Index v = bodies_.vertices[i];
    const float height = bodies_.below[i] != 0 ? -heights_.below[v] : heights_.above[v];
    return refined_.positions[v] + height * refined_.directions[v];
  }

  void displace() {
    parallel_for(mesh_.vertex_count(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) mesh_.positions[i] = displaced(i);
    });
  }

  /// Lowers vertices until no triangles intersect before decimation.
  void lower(const Progress& progress) {
    std::vector<std::uint8_t> tested;
    for (int i = 0; i < kMostLowerings; ++i) {
      const std::vector<std::uint8_t> found = intersecting_triangles(
          mesh_, progress.part(static_cast<double>(i) / kMostLowerings, 1), tested);
      tested = lower_at(found, i + 1 == kMostLowerings);
      if (tested.empty()) return;
      displace();
    }
  }

  /// Lowers the vertices of triangles. Returns the triangles that move; empty: none.
  std::vector<std::uint8_t> lower_at(const std::vector<std::uint8_t>& found, bool to_zero) {
    std::vector<std::uint8_t> lowered(refined_.positions.size());
    for (std::size_t t = 0; t < found.size(); ++t) {
      if (found[t] == 0) continue;
      for (const Index i : mesh_.triangles[t]) {
        const Index v = bodies_.vertices[i];
        lowered[v] = heights_.above[v] > 0 || heights_.below[v] > 0 ? 1 : 0;
      }
    }
    if (ranges::find(lowered, std::uint8_t{1}) == lowered.end()) return {};
    const float share = to_zero && options_.kind == ReliefKind::raised ? 0.0f : 0.6f;
    for (std::size_t v = 0; v < lowered.size(); ++v) {
      if (lowered[v] == 0) continue;
      heights_.above[v] *= share;
      heights_.below[v] *= share;
    }
    std::vector<std::uint8_t> moved(found.size());
    for (std::size_t t = 0; t < moved.size(); ++t) {
      for (const Index i : mesh_.triangles[t]) moved[t] |= lowered[bodies_.vertices[i]];
    }
    return moved;
  }

  /// Vertices that decimation must keep: those of triangles without texture.
  std::vector<std::uint8_t> locked_vertices() const {
    std::vector<std::uint8_t> locked(mesh_.vertex_count());
    if (options_.kind != ReliefKind::raised) return locked;
    for (std::size_t t = 0; t < refined_.triangles.size(); ++t) {
      if (base_.textured[refined_.base[t]] != 0) continue;
      for (const Index v : refined_.triangles[t]) locked[v] = 1;
    }
    return locked;
  }

  /// The displaced and decimated mesh. If triangles intersect, vertices are lowered; if they
  /// intersect after that, their vertices stay in decimation.
  Mesh reduced(const Progress& progress, ReliefMetrics& metrics) {
    displace();
    std::vector<std::uint8_t> locked = locked_vertices();
    constexpr int kRounds = 5;
    for (int i = 0; i < kRounds; ++i) {
      const double begin = 1 - std::pow(0.5, i), end = 1 - std::pow(0.5, i + 1);
      const double middle = 0.5 * (begin + end);
      Mesh mesh = decimated(mesh_, locked, 0.5f * tolerance_, progress.part(begin, middle));
      const std::vector<std::uint8_t> found =
          intersecting_triangles(mesh, progress.part(middle, end));
      const auto count = static_cast<std::size_t>(ranges::count(found, std::uint8_t{1}));
      if (count == 0 || i + 1 == kRounds) {
        metrics.intersecting_triangles = count;
        return mesh;
      }
      if (i == 0) {
        lower(progress.part(end, end));
      } else {
        lock_around(mesh, found, locked);
      }
    }
    return mesh_;
  }

  /// Locks the vertices in boxes around triangles of a decimated mesh.
  void lock_around(const Mesh& mesh, const std::vector<std::uint8_t>& found,
                   std::vector<std::uint8_t>& locked) const {
    Mesh bad{mesh.positions, {}, mesh.origin};
    for (std::size_t t = 0; t < found.size(); ++t) {
      if (found[t] != 0) bad.triangles.push_back(mesh.triangles[t]);
    }
    const NearestOnMesh nearest(bad);
    const double reach = 4.0 * tolerance_;
    parallel_for(mesh_.vertex_count(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        if (nearest.nearest(mesh_.positions[i].cast<double>(), reach)) locked[i] = 1;
      }
    });
  }

  void measure(Relief& relief) const {
    ReliefMetrics& metrics = relief.metrics;
    const std::vector<Index> twins = twins_of(relief.mesh.triangles);
    metrics.closed = !twins.empty() && ranges::none_of(twins, [](Index twin) {
      return twin == kNoTwin || twin == kManyTwins;
    });
    metrics.bodies = component_count(relief.mesh);
    metrics.volume_before = volume_of(base_.mesh);
    metrics.volume = volume_of(relief.mesh);
    metrics.least_height = options_.height;
    const Mesh surface{refined_.positions, {}, base_.mesh.origin};
    for (std::size_t t = 0; t < refined_.triangles.size(); ++t) {
      if (base_.textured[refined_.base[t]] == 0) continue;
      const double area = triangle_area(surface, refined_.triangles[t]);
      bool lower = false;
      for (const Index v : refined_.triangles[t]) {
        metrics.least_height = std::min(metrics.least_height, heights_.above[v]);
        metrics.greatest_height = std::max(metrics.greatest_height, heights_.above[v]);
        lower = lower || heights_.above[v] < requested(v) || heights_.below[v] < options_.depth;
      }
      metrics.area += area;
      metrics.limited_area += lower ? area : 0;
    }
    metrics.least_height = std::min(metrics.least_height, metrics.greatest_height);
  }

  const ReliefBase& base_;
  const ReliefOptions& options_;
  float tolerance_;
  RefinedRelief refined_;
  ReliefHeights heights_;
  ReliefBodies bodies_;  // without their mesh
  Mesh mesh_;
};

}  // namespace

Relief make_relief(const Surface& surface, const ReliefTexture& texture,
                   const ReliefOptions& options, const Progress& progress) {
  check_options(texture, options);
  const ReliefBase base = relief_base(surface, texture.coordinates, options.only);
  const float tolerance =
      options.tolerance > 0 ? options.tolerance : kDefaultTolerance * options.height;
  return ReliefMaker(base, options, tolerance).make(texture, progress);
}

std::vector<std::uint8_t> flat_faces(const Surface& surface, float width) {
  constexpr float kFlatCosine = 1 - 1.5e-6f;  // of 0.1 degrees
  const Mesh mesh = joined_mesh(surface.mesh, surface.creases);
  const std::vector<Index> twins = twins_of(mesh.triangles);
  const auto normal = [&](Index t) {
    const Triangle& c = mesh.triangles[t];
    return Vec3((mesh.positions[c[1]] - mesh.positions[c[0]])
                    .cross(mesh.positions[c[2]] - mesh.positions[c[0]])
                    .normalized());
  };
  std::vector<std::uint8_t> flat(mesh.triangle_count()), seen(mesh.triangle_count());
  std::vector<Index> face;
  for (Index start = 0; start < seen.size(); ++start) {
    if (seen[start] != 0) continue;
    seen[start] = 1;
    face.assign(1, start);
    const Vec3 first = normal(start);
    double area = 0, perimeter = 0;
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Index t = face[i];
      area += triangle_area(mesh, mesh.triangles[t]);
      for (Index h = 3 * t; h < 3 * t + 3; ++h) {
        const bool inside = twins[h] != kNoTwin && twins[h] != kManyTwins &&
                            std::abs(first.dot(normal(twins[h] / 3))) > kFlatCosine;
        if (!inside) {
          perimeter += (mesh.positions[vertex_at(mesh.triangles, h)] -
                        mesh.positions[vertex_at(mesh.triangles, next_in_triangle(h))])
                           .norm();
        } else if (seen[twins[h] / 3] == 0) {
          seen[twins[h] / 3] = 1;
          face.push_back(twins[h] / 3);
        }
      }
    }
    if (2 * area > width * perimeter) {
      for (const Index t : face) flat[t] = 1;
    }
  }
  return flat;
}

}  // namespace brindle
