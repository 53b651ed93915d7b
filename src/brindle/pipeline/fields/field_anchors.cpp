#include "brindle/pipeline/fields/field_anchors.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/base/elementary.h"
#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/direction_field.h"
#include "brindle/error.h"
#include "brindle/geometry/measures.h"
#include "brindle/geometry/topology.h"
#include "brindle/phases/screened.h"
#include "brindle/waves/direction_graph.h"

namespace brindle {
namespace {

/// Mean feature direction of every vertex as a line (N = 2). A crease that zigzags along edges
/// keeps its direction; orthogonal creases cancel.
std::vector<Complex> feature_lines(const Mesh& mesh, const Adjacency& neighborhood,
                                   std::span<const Vec3> normals, float angle_deg) {
  const MeshEdges edges = mesh_edges(mesh, neighborhood);
  std::vector<Complex> lines(mesh.vertex_count());
  std::vector<float> lengths(mesh.vertex_count());
  for (const auto& [a, b] : feature_edges(mesh, edges, angle_deg)) {
    const Vec3 edge = mesh.positions[b] - mesh.positions[a];
    for (const Index i : {a, b}) {
      const Vec3& normal = normals[i];
      lines[i] += edge.norm() * representation(tangent_direction(edge, normal), normal, 2);
      lengths[i] += edge.norm();
    }
  }
  for (Index i = 0; i < lines.size(); ++i) {
    if (lengths[i] > 0) lines[i] /= lengths[i];
  }
  return lines;
}

}  // namespace

void check_field_anchor(const FieldAnchor& anchor, std::size_t vertices) {
  const bool finite = anchor.direction.allFinite() && std::isfinite(anchor.weight);
  if (anchor.vertex < vertices && finite) return;
  throw Error("smooth field: anchor at vertex " + std::to_string(anchor.vertex) +
              (finite ? ", but the surface has " + std::to_string(vertices)
                      : " has a direction or weight that is not finite; correct or leave it out"));
}

Complex pull_of(const FieldAnchor& anchor, const Adjacency& neighborhood, const Vec3& normal,
                int symmetry) {
  const Vec3 tangent = anchor.direction - anchor.direction.dot(normal) * normal;
  const auto degree = static_cast<float>(neighborhood.of(anchor.vertex).size());
  return anchor.weight * degree * representation(tangent, normal, symmetry);
}

std::vector<float> curvature_differences(std::span<const PrincipalCurvature> curvatures) {
  std::vector<float> difference(curvatures.size());
  for (std::size_t i = 0; i < difference.size(); ++i) {
    difference[i] = std::abs(curvatures[i].maximum - curvatures[i].minimum);
  }
  return difference;
}

void add_curvature_anchors(PhaseGraph& graph, std::span<const Vec3> normals,
                           std::span<const PrincipalCurvature> curvatures, float scale,
                           const SmoothFieldOptions& options) {
  const DirectionField directions =
      curvature_direction_field(curvatures, options.curvature_direction);
  const std::vector<float> difference = curvature_differences(curvatures);
  const float factor = scale > 0 ? 1 / scale : 0;
  for (Index i = 0; i < curvatures.size(); ++i) {
    const float trust = std::min(1.0f, difference[i] * factor);
    const auto degree = static_cast<float>(graph.adjacency->of(i).size());
    graph.anchor[i] += options.curvature_anchor * trust * degree *
                       representation(directions[i], normals[i], options.symmetry);
  }
}

void add_feature_anchors(PhaseGraph& graph, const Mesh& mesh, const Adjacency& neighborhood,
                         std::span<const Vec3> normals, const SmoothFieldOptions& options) {
  const int half_symmetry = options.symmetry / 2;
  const auto turns = static_cast<float>(half_symmetry);
  const std::vector<Complex> lines =
      feature_lines(mesh, neighborhood, normals, options.feature_angle_deg);
  for (Index i = 0; i < graph.node_count(); ++i) {
    const auto degree = static_cast<float>(graph.adjacency->of(i).size());
    graph.anchor[i] += elementary::polar(options.feature_anchor * degree * std::abs(lines[i]),
                                         turns * elementary::arg(lines[i]));
  }
}

namespace {

/// Weight of the last field while it is smoothed, relative to the pull of all neighbours. The
/// smoothing length is 1 / sqrt(screening) edges: about half the width of a surface of this size,
/// and at least ten.
float screening_of(std::size_t vertices) {
  return std::min(0.01f, 5 / static_cast<float>(std::max<std::size_t>(vertices, 1)));
}

/// Isolated vertices do not count.
std::size_t coupled_nodes(const Adjacency& adjacency) {
  std::size_t count = 0;
  for (Index i = 0; i + 1 < adjacency.offsets.size(); ++i) count += adjacency.of(i).empty() ? 0 : 1;
  return count;
}

/// Weight of the last field relative to new measurements: averages their noise over several steps.
constexpr float kHold = 3;

float degree_of(const PhaseGraph& graph, Index node) {
  return static_cast<float>(graph.adjacency->of(node).size());
}

Complex unit_of(const Complex& u) {
  const float length = std::abs(u);
  return length > 0 ? u / length : Complex(0);
}

/// The last field, with gaps filled from `found`.
std::vector<Complex> filled(const PhaseGraph& graph, std::span<const Complex> last,
                            std::span<const Complex> found) {
  std::vector<Complex> start(last.begin(), last.end());
  for (Index i = 0; i < graph.node_count(); ++i) {
    if (start[i] == Complex(0)) start[i] = found[i];
  }
  return start;
}

/// Weight of the last field at a node.
float hold_of(const PhaseGraph& graph, const LastValues& last, Index node, float weight) {
  const float noisy = last.noisy.empty() ? 0 : last.noisy[node];
  return last.confidence[node] * (weight * degree_of(graph, node) + kHold * noisy);
}

}  // namespace

std::vector<float> anchor_strengths(const PhaseGraph& graph) {
  std::vector<float> strengths(graph.anchor.size());
  ranges::transform(graph.anchor, strengths.begin(),
                    [](const Complex& pull) { return std::abs(pull); });
  return strengths;
}

std::vector<Complex> warm_start(PhaseGraph& graph, const LastValues& last,
                                const std::function<std::vector<Complex>()>& fill) {
  const std::size_t count = graph.node_count();
  const std::vector<Complex> others =
      graph.anchor.empty() ? std::vector<Complex>(count) : graph.anchor;
  const float screening = screening_of(coupled_nodes(*graph.adjacency));
  std::vector<float> screenings(count);
  graph.anchor.assign(count, Complex(0));
  std::size_t known = 0, unknown = 0;
  for (Index i = 0; i < count; ++i) {
    const float hold = last.u[i] == Complex(0) ? 0 : hold_of(graph, last, i, screening);
    graph.anchor[i] = others[i] + hold * last.u[i];
    screenings[i] = std::abs(others[i]) + hold;
    if (!graph.adjacency->of(i).empty()) ++(hold > 0 ? known : unknown);
  }
  std::vector<Complex> start = unknown > 0 ? filled(graph, last.u, fill()) : last.u;
  if (known == 0) return start;  // no previous field
  const std::vector<Complex> smooth = smooth_screened(graph, screenings, start);
  for (Index i = 0; i < count; ++i) {
    const Complex unit = unit_of(smooth[i]);
    if (unit != Complex(0)) start[i] = unit;
    if (last.u[i] == Complex(0)) {
      graph.anchor[i] = others[i];
    } else {
      graph.anchor[i] = others[i] + hold_of(graph, last, i, last.weight) * start[i];
    }
  }
  return start;
}

void check_known(const KnownDirections& known, std::size_t vertices, const char* what) {
  const auto require = [&](bool holds, const std::string& message) {
    if (!holds) throw Error("smooth field: " + (what + (": " + message)));
  };
  const auto strength = [](float number) { return std::isfinite(number) && number >= 0; };
  require(strength(known.weight), "the weight must be a finite number of 0 or above");
  if (known.directions.empty()) return;
  require(known.directions.size() == vertices,
          "there are " + std::to_string(known.directions.size()) + " directions for " +
              std::to_string(vertices) + " vertices; give one to each, or none");
  require(known.confidence.empty() || known.confidence.size() == vertices,
          "there are " + std::to_string(known.confidence.size()) + " confidences for " +
              std::to_string(vertices) + " vertices; give one to each, or none");
  require(ranges::all_of(known.directions, [](const Vec3& d) { return d.allFinite(); }),
          "directions must be finite; zero says that nothing is known");
  require(ranges::all_of(known.confidence, strength),
          "confidences must be finite numbers of 0 or above");
}

LastValues last_values(const KnownDirections& known, std::span<const Vec3> normals, int symmetry) {
  LastValues last{std::vector<Complex>(normals.size()), known.confidence, known.weight};
  if (last.confidence.empty()) last.confidence.assign(normals.size(), 1);
  parallel_for(normals.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (last.confidence[i] == 0) continue;
      const Vec3 tangent = tangent_direction(known.directions[i], normals[i]);
      last.u[i] = representation(tangent, normals[i], symmetry);
    }
  });
  return last;
}

Vec3 direction_near(const Vec3& last, Complex u, const Vec3& normal, int symmetry) {
  const Complex turned = u * std::conj(representation(last, normal, symmetry));
  const float radians = std::arg(turned) / static_cast<float>(symmetry);
  return std::cos(radians) * last + std::sin(radians) * normal.cross(last);
}

void align_with_previous(const Adjacency& neighborhood, std::span<const Complex> u,
                         std::span<const Vec3> normals, std::span<const Vec3> last, int symmetry,
                         DirectionField& field) {
  std::vector<std::uint8_t> settled(field.size());
  for (std::size_t i = 0; i < field.size(); ++i) {
    const Vec3 before = tangent_direction(last[i], normals[i]);
    if (before.isZero(0)) continue;
    field[i] = direction_near(before, u[i], normals[i], symmetry);
    settled[i] = 1;
  }
  // Vectors keep their sign.
  if (symmetry % 2 == 0) orient_alike(neighborhood, settled, field);
}

}  // namespace brindle
