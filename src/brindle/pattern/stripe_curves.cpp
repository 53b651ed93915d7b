#include "brindle/pattern/stripe_curves.h"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "brindle/base/error.h"
#include "brindle/base/parallel.h"
#include "brindle/waves/orientation.h"

namespace brindle {
namespace {

// A node is a place where a curve crosses an edge of the mesh, or a cut of a singular triangle. It
// has two slots, one for each triangle (or part of one) that the curve comes from. A slot's link is
// the slot it is joined to by a piece, or says why the curve ends.
using Link = Index;
constexpr Link kFirstEnd = 0x80000000;  // beyond: numbers of inner ends, then the reasons below
constexpr Link kNoWave = 0xffffffff;
constexpr Link kBoundary = 0xfffffffe;
constexpr Link kNonmanifold = 0xfffffffd;
constexpr Link kLastInnerEnd = 0xfffffff0;
constexpr std::size_t kMostNodes = kFirstEnd / 2;

bool is_slot(Link link) { return link < kFirstEnd; }

struct CurvePoint {
  Vec3 position;
  Vec3 normal;
};

/// An end within a triangle.
struct InnerEnd {
  CurvePoint point;
  CurveEnd reason;
};

class Tracer {
 public:
  Tracer(const LiftedWaves& lifted, const CurveOptions& options)
      : pattern_(lifted.pattern()), options_(options), lifted_(lifted) {}

  StripeCurves trace() {
    number_nodes();
    link_triangles();
    walk();
    return std::move(curves_);
  }

 private:
  Index crossings(Index edge) const {
    return static_cast<Index>(std::abs(lifted_.edge(edge).peaks));
  }

  /// An edge of three triangles or more has nodes for each of them.
  std::size_t copies(Index edge) const {
    const Index triangles = pattern_.edges.triangle_counts[edge];
    return triangles > 2 ? triangles : 1;
  }

  void number_nodes() {
    const std::size_t edges = pattern_.edges.count();
    first_node_.resize(edges + 1);
    std::size_t count = 0;
    for (std::size_t e = 0; e < edges; ++e) {
      first_node_[e] = static_cast<Index>(count);
      count += crossings(static_cast<Index>(e)) * copies(static_cast<Index>(e));
      check_count(count);
    }
    first_node_[edges] = static_cast<Index>(count);
    edge_of_node_.resize(count);
    links_.resize(count);
    parallel_for(edges, [&](std::size_t begin, std::size_t end) {
      for (std::size_t e = begin; e < end; ++e) {
        const Index triangles = pattern_.edges.triangle_counts[e];
        const Link other = triangles == 1 ? kBoundary : triangles > 2 ? kNonmanifold : kNoWave;
        for (Index node = first_node_[e]; node < first_node_[e + 1]; ++node) {
          edge_of_node_[node] = static_cast<Index>(e);
          links_[node] = {kNoWave, other};
        }
      }
    });
  }

  static void check_count(std::size_t nodes) {
    if (nodes < kMostNodes) return;
    throw Error("curves would cross edges more than " + std::to_string(kMostNodes) +
                " times; ask for fewer stripes");
  }

  /// Regular triangles touch slots of their own only. Others, few, add nodes and ends, in order.
  void link_triangles() {
    const std::size_t count = pattern_.mesh.triangle_count();
    std::vector<std::uint8_t> irregular(count);
    parallel_for(count, [&](std::size_t begin, std::size_t end) {
      std::vector<StripePiece> pieces;
      for (std::size_t t = begin; t < end; ++t) {
        const LiftedTriangle triangle = lifted_.triangle(t);
        if (triangle.kind == TriangleKind::regular) {
          stripe_pieces(triangle, options_.join, pieces);
          for (const StripePiece& piece : pieces) {
            join(edge_slot(t, piece.ends[0]), edge_slot(t, piece.ends[1]));
          }
        }
        irregular[t] = triangle.kind != TriangleKind::regular;
      }
    });
    for (std::size_t t = 0; t < count; ++t) {
      if (irregular[t]) link_irregular(t);
    }
  }

  void link_irregular(std::size_t t) {
    const LiftedTriangle triangle = lifted_.triangle(t);
    const bool singular = triangle.kind == TriangleKind::field_singularity;
    const CurveEnd reason = singular ? CurveEnd::singularity : CurveEnd::branch;
    std::array<Index, 3> first_cut_node{};
    for (int m = 0; m < 3 && singular; ++m) {
      first_cut_node[m] = static_cast<Index>(links_.size());
      links_.resize(links_.size() + cut_crossings(triangle, m), {kNoWave, kNoWave});
      check_count(links_.size());
      inner_points_.resize(links_.size() - edge_of_node_.size());
    }
    const auto slot = [&](const PieceEnd& end, int part) {
      if (end.side < 3) return edge_slot(t, end);
      // The part of edge m has the cuts from corners m and m + 1.
      const int corner = end.side - 3;
      const Index node = first_cut_node[corner] + end.crossing;
      inner_points_[node - edge_of_node_.size()] = point_in(t, end);
      return 2 * node + (part == corner ? 0 : 1);
    };
    std::vector<StripePiece> pieces;
    stripe_pieces(triangle, options_.join, pieces);
    for (const StripePiece& piece : pieces) {
      const Link from = slot(piece.ends[0], piece.part);
      if (piece.ends[1].side == PieceEnd::kInside) {
        links_[from / 2][from % 2] = add_end(t, piece.ends[1], reason);
      } else {
        join(from, slot(piece.ends[1], piece.part));
      }
    }
  }

  Link edge_slot(std::size_t t, const PieceEnd& end) const {
    const Index edge = pattern_.edges.of_triangle[t][end.side];
    const Index rank = pattern_.edges.ranks[t][end.side];
    const Index node = first_node_[edge] + end.crossing;
    return copies(edge) == 1 ? 2 * node + rank : 2 * (node + rank * crossings(edge));
  }

  void join(Link a, Link b) {
    links_[a / 2][a % 2] = b;
    links_[b / 2][b % 2] = a;
  }

  Link add_end(std::size_t t, const PieceEnd& end, CurveEnd reason) {
    inner_ends_.push_back({point_in(t, end), reason});
    check_count(inner_ends_.size());
    return kFirstEnd + static_cast<Link>(inner_ends_.size() - 1);
  }

  CurvePoint point_in(std::size_t t, const PieceEnd& end) const {
    const Triangle& triangle = pattern_.mesh.triangles[t];
    const Vec3& first = pattern_.mesh.positions[triangle[0]];
    CurvePoint result{first, Vec3::Zero()};
    for (int m = 0; m < 3; ++m) {
      const auto weight = static_cast<float>(end.barycentric[m]);
      result.position += weight * (pattern_.mesh.positions[triangle[m]] - first);
      add_normal(result.normal, weight, triangle[m]);
    }
    result.normal.stableNormalize();
    return result;
  }

  /// Normals of unorientable surfaces may point either way.
  void add_normal(Vec3& sum, float weight, Index vertex) const {
    const Vec3& normal = pattern_.normals[vertex];
    sum += (sum.dot(normal) < 0 ? -weight : weight) * normal;
  }

  CurvePoint point_of(Index node) const {
    if (node >= edge_of_node_.size()) return inner_points_[node - edge_of_node_.size()];
    const Index edge = edge_of_node_[node];
    const auto [a, b] = pattern_.edges.vertices[edge];
    const Turns start = lifted_.turns(a);
    const Turns end = lifted_end(lifted_.edge(edge), lifted_.turns(b));
    const Index number = (node - first_node_[edge]) % crossings(edge);
    const auto t = static_cast<float>(crossing_position(start, end, number));
    const Vec3& from = pattern_.mesh.positions[a];
    CurvePoint result{from + t * (pattern_.mesh.positions[b] - from), Vec3::Zero()};
    add_normal(result.normal, 1 - t, a);
    add_normal(result.normal, t, b);
    result.normal.stableNormalize();
    return result;
  }

  void walk() {
    const auto nodes = static_cast<Index>(links_.size());
    curves_.lines.points.reserve(nodes + inner_ends_.size());
    curves_.lines.normals.reserve(nodes + inner_ends_.size());
    visited_.resize(nodes);
    for (Index node = 0; node < nodes; ++node) {
      for (Link side = 0; side < 2; ++side) {
        const bool passed_by =
            links_[node][side] > kLastInnerEnd && links_[node][1 - side] > kLastInnerEnd;
        if (visited_[node] || passed_by || is_slot(links_[node][side])) continue;
        walk_open(2 * node + side);
      }
    }
    for (Index node = 0; node < nodes; ++node) {
      const bool on_curve = is_slot(links_[node][0]);
      if (!visited_[node] && on_curve) walk_closed(node);
    }
  }

  /// From a slot whose link is an end to the other end.
  void walk_open(Link slot) {
    std::array<CurveEnd, 2> ends{};
    ends[0] = end_at(links_[slot / 2][slot % 2]);
    while (true) {
      visit(slot / 2);
      const Link next = links_[slot / 2][1 - slot % 2];
      if (!is_slot(next)) {
        ends[1] = end_at(next);
        break;
      }
      slot = next;
    }
    finish(ends);
  }

  void walk_closed(Index start) {
    Link slot = 2 * start;
    do {
      visit(slot / 2);
      slot = links_[slot / 2][1 - slot % 2];
    } while (slot / 2 != start);
    finish({CurveEnd::closed, CurveEnd::closed});
  }

  void visit(Index node) {
    visited_[node] = 1;
    append(point_of(node));
  }

  /// The reason of an end, whose point is added if it is not a node.
  CurveEnd end_at(Link link) {
    if (link == kBoundary) return CurveEnd::boundary;
    if (link == kNonmanifold) return CurveEnd::nonmanifold;
    if (link == kNoWave) return CurveEnd::no_wave;
    append(inner_ends_[link - kFirstEnd].point);
    return inner_ends_[link - kFirstEnd].reason;
  }

  void append(const CurvePoint& point) {
    curves_.lines.points.push_back(point.position);
    curves_.lines.normals.push_back(point.normal);
  }

  void finish(const std::array<CurveEnd, 2>& ends) {
    Polylines& lines = curves_.lines;
    lines.offsets.push_back(static_cast<Index>(lines.points.size()));
    lines.closed.push_back(ends[0] == CurveEnd::closed);
    curves_.ends.push_back(ends);
  }

  const WavePattern& pattern_;
  const CurveOptions& options_;
  const LiftedWaves& lifted_;
  std::vector<Index> first_node_;           // edges + 1 entries
  std::vector<Index> edge_of_node_;         // nodes on edges; those on cuts come after them
  std::vector<std::array<Link, 2>> links_;  // one per node
  std::vector<CurvePoint> inner_points_;    // nodes on cuts
  std::vector<InnerEnd> inner_ends_;
  std::vector<std::uint8_t> visited_;  // one per node
  StripeCurves curves_;
};

}  // namespace

std::array<std::size_t, kCurveEndKinds> StripeCurves::end_counts() const {
  std::array<std::size_t, kCurveEndKinds> counts{};
  for (const auto& curve : ends) {
    if (curve[0] == CurveEnd::closed) continue;
    for (const CurveEnd end : curve) ++counts[static_cast<std::size_t>(end)];
  }
  return counts;
}

StripeCurves stripe_curves(const LiftedWaves& waves, const CurveOptions& options) {
  StripeCurves curves = Tracer(waves, options).trace();
  curves.lines.origin = waves.pattern().mesh.origin;
  return curves;
}

StripeCurves longer_than(const StripeCurves& curves, double length) {
  StripeCurves longer;
  Polylines& lines = longer.lines;
  lines.origin = curves.lines.origin;
  for (std::size_t line = 0; line < curves.lines.count(); ++line) {
    if (length_of(curves.lines, line) < length) continue;
    const auto points = curves.lines.points_of(line);
    const auto normals = curves.lines.normals_of(line);
    lines.points.insert(lines.points.end(), points.begin(), points.end());
    lines.normals.insert(lines.normals.end(), normals.begin(), normals.end());
    lines.offsets.push_back(static_cast<Index>(lines.points.size()));
    lines.closed.push_back(curves.lines.closed[line]);
    longer.ends.push_back(curves.ends[line]);
  }
  return longer;
}

std::size_t move_peaks(const Adjacency& neighborhood, float periods, WaveSet& waves,
                       std::span<Complex> z) {
  const bool either_way = std::round(2 * periods) == 2 * periods;
  std::size_t reflecting = 0;
  if (!either_way) {
    const std::vector<Vec3> before = waves.directions;
    orient_alike(neighborhood, waves.directions);
    for (std::size_t i = 0; i < z.size(); ++i) {
      if (waves.directions[i].dot(before[i]) < 0) z[i] = -std::conj(z[i]);
      for (const Index j : neighborhood.of(static_cast<Index>(i))) {
        reflecting += j < i && waves.directions[i].dot(waves.directions[j]) < 0;
      }
    }
  }
  const float turn = -2 * std::numbers::pi_v<float> * (periods - std::floor(periods));
  for (Complex& value : z) value *= std::polar(1.0f, turn);
  return reflecting;
}

}  // namespace brindle
