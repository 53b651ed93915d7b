#include "brindle/feature_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "brindle/base/elementary.h"
#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/error.h"
#include "brindle/fragment_phase.h"
#include "brindle/geometry/measures.h"
#include "brindle/geometry/topology.h"
#include "brindle/render/line_segments.h"

namespace brindle {
namespace {

void check_normals(const Mesh& mesh, std::span<const Vec3> normals) {
  if (normals.size() == mesh.vertex_count()) return;
  throw Error("lines of a surface need a normal for each of its " +
              std::to_string(mesh.vertex_count()) + " vertices, not " +
              std::to_string(normals.size()));
}

/// The part of a line that becomes one dash.
struct Dash {
  std::size_t first, last;
};

/// A dash that reaches the end of a closed line continues at its first point.
void add_dash(const Polylines& lines, std::size_t line, const Dash& dash, Polylines& dashes) {
  for (std::size_t i = dash.first; i <= dash.last; ++i)
    dashes.add(lines.points[i], lines.normals[i]);
  const bool to_end = lines.closed[line] != 0 && dash.last + 1 == lines.offsets[line + 1];
  const bool whole = to_end && dash.first == lines.offsets[line];
  if (to_end && !whole) {
    dashes.add(lines.points[lines.offsets[line]], lines.normals[lines.offsets[line]]);
  }
  dashes.end_line(whole);
}

/// Whether a stroke of the pattern covers the point; true without a wave.
bool covered(const TrianglePoint& place, const Mesh& mesh, const WaveSet& waves,
             std::span<const Complex> z, float width) {
  const Triangle& t = mesh.triangles[place.triangle];
  std::array<CornerWave, 3> corners;
  Vec3 weights;
  for (int m = 0; m < 3; ++m) {
    corners[m] = {{mesh.positions[t[m]], waves.directions[t[m]], waves.frequencies[t[m]]}, z[t[m]]};
    weights[m] = static_cast<float>(place.barycentric[m]);
  }
  const Complex phase = fragment_phase(corners, weights).z;
  if (phase == Complex(0)) return true;
  const float turns = elementary::arg(phase) / (2 * std::numbers::pi_v<float>)-0.25f;
  return std::abs(turns - std::round(turns)) <= 0.5f * width;
}

/// Steps short enough to hit every dash.
float fine_spacing(const WaveSet& waves) {
  constexpr float kStepsPerPeriod = 40;
  const auto highest = ranges::max_element(waves.frequencies);
  return highest == waves.frequencies.end() || !(*highest > 0) ? 0
                                                               : 1 / (kStepsPerPeriod * *highest);
}

/// Zero crossings of linearly interpolated vertex values. Values `of_normals` change sign with the
/// normal: on a one-sided surface, normals flip somewhere.
std::vector<LineSegment> zero_segments(const Mesh& mesh, std::span<const Vec3> normals,
                                       std::vector<double> values, bool of_normals) {
  for (double& value : values) {
    if (value == 0) value = 1e-12;  // a line through a vertex passes beside it
  }
  std::map<std::array<Index, 2>, Index> nodes;  // by edge
  std::vector<LineSegment> segments;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const Triangle& corners = mesh.triangles[t];
    LineSegment segment{{}, static_cast<Index>(t), {}};
    int found = 0;
    for (int a = 0; a < 3; ++a) {
      const int b = (a + 1) % 3;
      const bool turned = of_normals && normals[corners[a]].dot(normals[corners[b]]) < 0;
      const double value_a = values[corners[a]], value_b = (turned ? -1 : 1) * values[corners[b]];
      if ((value_a > 0) == (value_b > 0)) continue;
      const std::array<Index, 2> edge{std::min(corners[a], corners[b]),
                                      std::max(corners[a], corners[b])};
      segment.nodes[found] =
          nodes.try_emplace(edge, static_cast<Index>(nodes.size())).first->second;
      segment.barycentric[found++] = zero_between(a, b, value_a, value_b);
    }
    if (found == 2) segments.push_back(segment);
  }
  return segments;
}

/// A triangle edge whose end positions coincide with those of another one.
struct PlacedSide {
  std::array<Index, 2> places;  ///< the first vertex at each end position, ascending
  Index triangle;
  std::array<int, 2> corners;
};

/// All edges at which a mesh is split; copies of one edge are adjacent.
std::vector<PlacedSide> split_sides(const Mesh& mesh) {
  const std::vector<Index> first = first_at_each_place(mesh.positions);
  std::vector<std::uint8_t> is_split(first.size());
  for (Index v = 0; v < first.size(); ++v) {
    if (first[v] != v) is_split[v] = is_split[first[v]] = 1;
  }
  std::vector<PlacedSide> sides;
  for (Index t = 0; t < mesh.triangle_count(); ++t) {
    for (int a = 0; a < 3; ++a) {
      const int b = (a + 1) % 3;
      const Index from = mesh.triangles[t][a], to = mesh.triangles[t][b];
      if (is_split[from] == 0 && is_split[to] == 0) continue;
      PlacedSide side{{first[from], first[to]}, t, {a, b}};
      if (side.places[1] < side.places[0]) side = {{first[to], first[from]}, t, {b, a}};
      sides.push_back(side);
    }
  }
  ranges::sort(sides.begin(), sides.end(), [](const PlacedSide& a, const PlacedSide& b) {
    return std::pair(a.places, a.triangle) < std::pair(b.places, b.triangle);
  });
  return sides;
}

/// Silhouettes along split edges: one side faces the viewer, the other does not. Nodes are numbered
/// from `first_node`.
void add_split_silhouettes(const Mesh& mesh, std::span<const double> facing, Index first_node,
                           std::vector<LineSegment>& segments) {
  const std::vector<PlacedSide> sides = split_sides(mesh);
  const auto is_seen = [&](const PlacedSide& side) {
    const Triangle& corners = mesh.triangles[side.triangle];
    return facing[corners[side.corners[0]]] + facing[corners[side.corners[1]]] > 0;
  };
  for (std::size_t k = 1; k < sides.size(); ++k) {
    if (sides[k].places != sides[k - 1].places || is_seen(sides[k]) == is_seen(sides[k - 1])) {
      continue;
    }
    LineSegment segment{
        {first_node + sides[k].places[0], first_node + sides[k].places[1]}, sides[k].triangle, {}};
    for (int i = 0; i < 2; ++i) segment.barycentric[i][sides[k].corners[i]] = 1;
    segments.push_back(segment);
  }
}

}  // namespace

Polylines silhouette_lines(const Mesh& mesh, std::span<const Vec3> normals, const Vec3& eye) {
  check_normals(mesh, normals);
  std::vector<double> facing(mesh.vertex_count());
  for (std::size_t v = 0; v < facing.size(); ++v) {
    const Vec3 view = eye - mesh.positions[v];
    facing[v] = static_cast<double>(normals[v].dot(view.normalized()));
  }
  std::vector<LineSegment> segments = zero_segments(mesh, normals, facing, true);
  add_split_silhouettes(mesh, facing, static_cast<Index>(3 * mesh.triangle_count()), segments);
  return joined_lines(mesh, normals, segments);
}

Polylines slice_lines(const Mesh& mesh, std::span<const Vec3> normals,
                      const Eigen::Hyperplane<float, 3>& slice) {
  constexpr float kWithin = 1e-4f;  // of the diagonal: on the kept side
  check_normals(mesh, normals);
  const float within = kWithin * bounding_box(mesh).diagonal();
  std::vector<double> beyond(mesh.vertex_count());
  for (std::size_t v = 0; v < beyond.size(); ++v) {
    beyond[v] = static_cast<double>(slice.signedDistance(mesh.positions[v]) + within);
  }
  return joined_lines(mesh, normals, zero_segments(mesh, normals, std::move(beyond), false));
}

Polylines crease_lines(const Mesh& split, std::span<const Vec3> normals, float angle_deg,
                       const Progress& heard) {
  check_normals(split, normals);
  Mesh mesh = split;
  join_vertices(mesh);
  JobStages stages(heard, {{"creases", 1}});
  const Progress progress = stages.begin("creases");
  const Adjacency neighborhood = vertex_neighborhood(mesh, progress.part(0, 0.2));
  const MeshEdges edges = mesh_edges(mesh, neighborhood, progress.part(0.2, 0.4));
  const auto features = feature_edges(mesh, edges, angle_deg, progress.part(0.4, 0.6));
  std::map<std::array<Index, 2>, std::optional<LineSegment>> of_edge;
  for (const auto& [from, to] : features) of_edge[{std::min(from, to), std::max(from, to)}];
  reported_for(mesh.triangle_count(), progress.part(0.6, 0.9), [&](std::size_t t) {
    for (int a = 0; a < 3; ++a) {
      const int b = (a + 1) % 3;
      const Index from = mesh.triangles[t][a], to = mesh.triangles[t][b];
      const auto found = of_edge.find({std::min(from, to), std::max(from, to)});
      if (found == of_edge.end() || found->second) continue;
      LineSegment segment{{from, to}, static_cast<Index>(t), {}};
      segment.barycentric[0][a] = segment.barycentric[1][b] = 1;
      found->second = segment;
    }
  });
  std::vector<LineSegment> segments;
  for (const auto& [from, to] : features) {
    segments.push_back(*of_edge.at({std::min(from, to), std::max(from, to)}));
  }
  progress.report(0.9);
  Polylines lines = joined_lines(mesh, normals, segments);
  stages.finish();
  return lines;
}

Polylines dashes_of(const Polylines& lines, const Mesh& mesh, const WaveSet& waves,
                    std::span<const Complex> z, float width) {
  const float spacing = fine_spacing(waves);
  if (!(spacing > 0)) return lines;
  const Polylines fine = resampled(lines, spacing);
  Polylines dashes;
  dashes.origin = lines.origin;
  for (std::size_t line = 0; line < fine.count(); ++line) {
    std::optional<Dash> dash;
    for (std::size_t i = fine.offsets[line]; i < fine.offsets[line + 1]; ++i) {
      const bool on = covered(fine.places[i], mesh, waves, z, width);
      if (on) dash = dash ? Dash{dash->first, i} : Dash{i, i};
      const bool ends = !on || i + 1 == fine.offsets[line + 1];
      if (dash && ends) {
        add_dash(fine, line, *dash, dashes);
        dash.reset();
      }
    }
  }
  return dashes;
}

std::vector<Stroke> dashed(std::span<const Stroke> strokes, float on, float off) {
  if (!(on > 0) || !(off > 0)) throw Error("dashes and gaps must be longer than 0 pixels");
  std::vector<Stroke> dashes;
  for (const Stroke& stroke : strokes) {
    bool pen = true;
    float left = on;
    if (!stroke.empty()) dashes.push_back({stroke.front()});
    for (std::size_t i = 1; i < stroke.size(); ++i) {
      Eigen::Vector2f from = stroke[i - 1];
      float length = (stroke[i] - from).norm();
      while (length > left) {
        from += left / length * (stroke[i] - from);
        length -= left;
        if (pen) dashes.back().push_back(from);
        pen = !pen;
        left = pen ? on : off;
        if (pen) dashes.push_back({from});
      }
      left -= length;
      if (pen) dashes.back().push_back(stroke[i]);
    }
  }
  return dashes;
}

}  // namespace brindle
