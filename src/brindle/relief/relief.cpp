#include "brindle/relief.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>

#include "brindle/base/parallel.h"
#include "brindle/error.h"
#include "brindle/geometry/measures.h"
#include "brindle/geometry/topology.h"
#include "brindle/nearest.h"
#include "brindle/normals.h"
#include "brindle/relief/decimation.h"
#include "brindle/relief/refined_relief.h"
#include "brindle/relief/relief_bodies.h"
#include "brindle/relief/self_intersections.h"

namespace brindle {
namespace {

constexpr float kDefaultTolerance = 0.05f;  // share of the height
constexpr float kShareOfBall = 0.45f;       // two reliefs that face each other keep a gap
constexpr float kInsideBall = 0.9f;         // facets of a smooth surface cut less off a ball

void check_options(const ReliefTexture& texture, const ReliefOptions& options) {
  const auto refuse = [](const std::string& what) { throw Error("relief: " + what); };
  if (!(options.height > 0) || !std::isfinite(options.height)) refuse("the height is above 0");
  if (!(options.depth >= 0) || !std::isfinite(options.depth)) refuse("the depth is 0 or more");
  if (!(options.tolerance >= 0) || !std::isfinite(options.tolerance)) {
    refuse("the tolerance is 0 or more");
  }
  if (!(options.fill_holes >= 0)) refuse("the perimeter of filled holes is 0 or more");
  if (options.fill_holes > 0 && options.kind != ReliefKind::raised) {
    refuse("inlays and cuts are closed, and have no holes to fill");
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

/// Of a refined vertex, in units of length, after limits.
struct ReliefHeights {
  std::vector<float> above, below;
};

class ReliefMaker {
 public:
  ReliefMaker(const ReliefBase& base, const ReliefOptions& options, float tolerance)
      : base_(base), options_(options), tolerance_(tolerance) {}

  Relief make(const ReliefTexture& texture, const Progress& progress) {
    JobStages stages(progress, {{"refining", 4},
                                {"limiting heights", 2},
                                {"decimating", 4},
                                {"removing intersections", 2}});
    const RefinementLimits limits{0.5f * tolerance_ / options_.height, 0.5f * tolerance_,
                                  options_.kind != ReliefKind::raised};
    refined_ = refined_relief(base_, texture, limits, stages.begin("refining"));
    limit(stages.begin("limiting heights"));
    arrange();
    reduce(stages.begin("decimating"));
    Relief relief;
    relief.metrics.intersecting_triangles =
        lower_intersections(raised_, stages.begin("removing intersections"));
    measure(relief.metrics);
    relief.mesh = {raised_.positions(), std::move(raised_.triangles), base_.mesh.origin};
    measure_bodies(relief);
    stages.finish();
    return relief;
  }

 private:
  /// The height requested at a refined vertex.
  float requested(Index v) const {
    if (options_.kind != ReliefKind::raised) return options_.height;
    return options_.height * refined_.heights[v];
  }

  void limit(const Progress& progress) {
    const std::size_t count = refined_.positions.size();
    heights_.above.resize(count);
    heights_.below.assign(count, options_.depth);
    const NearestOnMesh nearest(base_.mesh, progress.part(0, 0.2));
    const auto limited = [&](std::size_t v, float height, float sign) {
      const float length = refined_.directions[v].norm();
      const float wanted = height * length / kShareOfBall;
      if (!(wanted > 0)) return 0.0f;
      const float radius = ball_radius(nearest, refined_.positions[v],
                                       sign / length * refined_.directions[v], wanted);
      return radius < wanted ? kShareOfBall * radius / length : height;
    };
    parallel_for(
        count, progress.part(0.2, 1),
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t v = begin; v < end; ++v) {
            heights_.above[v] = limited(v, requested(static_cast<Index>(v)), 1);
            heights_.below[v] = limited(v, options_.depth, -1);
          }
        },
        64);
  }

  /// The triangles of inlays, or of shells.
  std::vector<std::uint8_t> triangles_of_bodies() const {
    std::vector<std::uint8_t> taken(refined_.triangles.size());
    for (std::size_t t = 0; t < taken.size(); ++t) {
      float sum = 0;
      for (const Index v : refined_.triangles[t]) sum += refined_.heights[v] - 0.5f;
      const bool is_textured = base_.textured[refined_.base[t]] != 0;
      const bool is_high = is_textured && sum > 0;
      taken[t] = is_textured && is_high == (options_.kind == ReliefKind::inlay) ? 1 : 0;
    }
    return taken;
  }

  /// The refined mesh or bodies made of it.
  void arrange() {
    if (options_.kind == ReliefKind::raised) {
      raised_.triangles = refined_.triangles;
      vertices_.resize(refined_.positions.size());
      std::iota(vertices_.begin(), vertices_.end(), Index{0});
      below_.assign(vertices_.size(), 0);
    } else {
      ReliefBodies bodies = relief_bodies(refined_.triangles, triangles_of_bodies());
      raised_.triangles = std::move(bodies.triangles);
      raised_.least_share = 0.1f;  // flat bodies would have no volume
      vertices_ = std::move(bodies.vertices);
      below_ = std::move(bodies.below);
    }
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      const Index v = vertices_[i];
      raised_.rest.push_back(refined_.positions[v]);
      raised_.ways.push_back(below_[i] != 0 ? Vec3(-refined_.directions[v])
                                            : refined_.directions[v]);
      raised_.heights.push_back(below_[i] != 0 ? heights_.below[v] : heights_.above[v]);
    }
  }

  /// Vertices of triangles without texture, which stay as they are.
  std::vector<std::uint8_t> locked_vertices() const {
    std::vector<std::uint8_t> locked(vertices_.size());
    if (options_.kind != ReliefKind::raised) return locked;
    for (std::size_t t = 0; t < refined_.triangles.size(); ++t) {
      if (base_.textured[refined_.base[t]] != 0) continue;
      for (const Index v : refined_.triangles[t]) locked[v] = 1;
    }
    return locked;
  }

  void reduce(const Progress& progress) {
    const Mesh mesh{raised_.positions(), std::move(raised_.triangles)};
    raised_.triangles =
        decimated(mesh, raised_.rest, locked_vertices(), 0.5f * tolerance_, progress);
    std::vector<Index> numbers(mesh.vertex_count(), 0), kept;
    for (const Triangle& t : raised_.triangles) {
      for (const Index v : t) numbers[v] = 1;
    }
    for (Index v = 0; v < numbers.size(); ++v) {
      if (numbers[v] == 0) continue;
      numbers[v] = static_cast<Index>(kept.size());
      kept.push_back(v);
    }
    for (Triangle& t : raised_.triangles) {
      for (Index& v : t) v = numbers[v];
    }
    const auto keep = [&](auto& list) {
      for (std::size_t i = 0; i < kept.size(); ++i) list[i] = list[kept[i]];
      list.resize(kept.size());
    };
    keep(raised_.rest);
    keep(raised_.ways);
    keep(raised_.heights);
    keep(vertices_);
    keep(below_);
  }

  /// Measures the heights.
  void measure(ReliefMetrics& metrics) const {
    metrics.refined_triangles = refined_.triangles.size();
    metrics.filled_holes = base_.filled_holes;
    for (std::size_t t = 0; t < base_.mesh.triangle_count(); ++t) {
      if (base_.textured[t] != 0)
        metrics.area += triangle_area(base_.mesh, base_.mesh.triangles[t]);
    }
    std::vector<std::uint8_t> lowered(refined_.positions.size());
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      const float height = raised_.heights[i];
      if (below_[i] == 0) metrics.greatest_height = std::max(metrics.greatest_height, height);
      if (height < (below_[i] != 0 ? options_.depth : requested(vertices_[i]))) {
        lowered[vertices_[i]] = 1;
      }
    }
    const Mesh rest{raised_.rest, {}};
    for (const Triangle& t : raised_.triangles) {
      if (below_[t[0]] + below_[t[1]] + below_[t[2]] > 0) continue;
      const double third = triangle_area(rest, t) / 3;
      for (const Index i : t) metrics.limited_area += lowered[vertices_[i]] != 0 ? third : 0;
    }
  }

  void measure_bodies(Relief& relief) const {
    const std::vector<Index> twins = twins_of(relief.mesh.triangles);
    relief.metrics.closed = !twins.empty() && ranges::none_of(twins, [](Index twin) {
      return twin == kNoTwin || twin == kManyTwins;
    });
    relief.metrics.bodies = component_count(relief.mesh);
    relief.metrics.volume_before = volume_of(base_.mesh);
    relief.metrics.volume = volume_of(relief.mesh);
  }

  const ReliefBase& base_;
  const ReliefOptions& options_;
  float tolerance_;
  RefinedRelief refined_;
  ReliefHeights heights_;
  RaisedMesh raised_;
  std::vector<Index> vertices_;      // refined, of those raised
  std::vector<std::uint8_t> below_;  // 1 for vertices below a body
};

}  // namespace

Relief make_relief(const Surface& surface, const ReliefTexture& texture,
                   const ReliefOptions& options, const Progress& progress) {
  check_options(texture, options);
  const ReliefBase base =
      relief_base(surface, texture.coordinates, options.only, options.fill_holes);
  const float tolerance =
      options.tolerance > 0 ? options.tolerance : kDefaultTolerance * options.height;
  return ReliefMaker(base, options, tolerance).make(texture, progress);
}

std::vector<std::uint8_t> chosen_faces(const Surface& surface, const ReliefFaces& faces) {
  if (!(faces.degrees >= 0) || !(faces.degrees <= 180)) {
    throw Error("relief: the angle of faces is from 0 to 180 degrees");
  }
  const std::size_t count = surface.mesh.triangle_count();
  std::vector<std::uint8_t> chosen(count, 1);
  if (faces.flat_width > 0) {
    chosen = flat_faces(surface, faces.flat_width);
    for (std::uint8_t& face : chosen) face = face != 0 ? 0 : 1;
  }
  // Triangles of crosses may have new vertices in their middle.
  const auto is_in = [&](Index v) { return v >= faces.weights.size() || faces.weights[v] > 0.5f; };
  const float cosine = std::cos(faces.degrees * std::numbers::pi_v<float> / 180);
  for (std::size_t t = 0; t < count; ++t) {
    const Triangle& corners = surface.mesh.triangles[t];
    const bool is_turned = !surface.turned.empty() && surface.turned[t] != 0;
    const Vec3 outwards = (is_turned ? -1.0f : 1.0f) * triangle_normal(surface.mesh, corners);
    const bool is_towards =
        faces.towards.isZero(0) || outwards.dot(faces.towards.normalized()) >= cosine;
    if (!is_towards || !ranges::all_of(corners, is_in)) chosen[t] = 0;
  }
  if (ranges::find(chosen, std::uint8_t{1}) == chosen.end()) {
    throw Error("no face has the relief; choose other faces, or do not leave out flat ones");
  }
  return chosen;
}

std::vector<std::uint8_t> flat_faces(const Surface& surface, float width) {
  constexpr float kFlatCosine = 1 - 1.5e-6f;  // of 0.1 degrees
  const Mesh mesh = joined_mesh(surface.mesh, surface.creases);
  const std::vector<Index> twins = twins_of(mesh.triangles);
  const auto normal = [&](Index t) { return triangle_normal(mesh, mesh.triangles[t]); };
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
