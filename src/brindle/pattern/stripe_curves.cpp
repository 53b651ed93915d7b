#include "brindle/pattern/stripe_curves.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include "brindle/base/compressed_rows.h"
#include "brindle/base/elementary.h"
#include "brindle/base/memory.h"
#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/direction_field.h"
#include "brindle/error.h"
#include "brindle/pattern/fairing/faired_curves.h"
#include "brindle/pattern/lifted_waves.h"
#include "brindle/pattern/trimmed_ends.h"

namespace brindle {
namespace {

// A node is a crossing of a curve with an edge of the mesh or with a cut of a singular triangle. It
// has two slots, one for each adjacent triangle (or part of one). A slot's link is the slot to
// which a piece joins it, or the reason why the curve ends.
using Link = Index;
constexpr Link kFirstEnd = 0x80000000;  // from here: numbers of inner ends, then the reasons below
constexpr Link kNoWave = 0xffffffff;
constexpr Link kBoundary = 0xfffffffe;
constexpr Link kNonmanifold = 0xfffffffd;
constexpr Link kCrease = 0xfffffffc;
constexpr Link kLastInnerEnd = 0xfffffff0;
constexpr std::size_t kMostNodes = kFirstEnd / 2;
// Crossings on the two sides of a crease are one curve if they are nearer than this, in periods.
constexpr double kMeetingPeriods = 0.25;
constexpr double kTracedBeforeTrim = 0.8;  // share of the time before fairing
constexpr double kBeforeFair = 0.5;        // share of the total time

bool is_slot(Link link) { return link < kFirstEnd; }

/// Whether the link is an end without points of its own.
bool is_bare(Link link) { return link > kLastInnerEnd; }

/// Points nearer than this, over the size of their edge or triangle, coincide: phases are too
/// coarse to distinguish them where a curve passes a vertex.
constexpr float kSamePlace = 1e-4f;

bool at_same_place(const CurvePoint& a, const CurvePoint& b) {
  return (a.position - b.position).norm() <= kSamePlace * std::max(a.size, b.size);
}

/// Drops points that coincide with the previous one. Both ends of an open curve stay; an end that
/// replaces another point takes over that point's triangles, in which the curve continues.
void drop_repeats(std::vector<CurvePoint>& curve, bool closed) {
  CurvePoint last = closed ? curve.front() : curve.back();
  std::size_t kept = 0;
  for (const CurvePoint& point : curve) {
    if (kept == 0 || !at_same_place(curve[kept - 1], point)) {
      curve[kept++] = point;
    } else if (kept == 1 && !closed) {
      curve.front().place = point.place;
    }
  }
  for (; kept > 1 && at_same_place(curve[kept - 1], last); --kept) {
    last.place = curve[kept - 1].place;
  }
  curve.resize(kept);
  if (!closed) curve.push_back(last);
}

/// Whether waves run to the right of the curve, as seen from outside, along most of its length.
bool runs_backward(const std::vector<CurvePoint>& curve, bool closed) {
  double left = 0;
  for (std::size_t i = closed ? 0 : 1; i < curve.size(); ++i) {
    const CurvePoint& a = curve[i > 0 ? i - 1 : curve.size() - 1];
    const CurvePoint& b = curve[i];
    left += (a.normal + b.normal).cross(b.position - a.position).dot(a.forward + b.forward);
  }
  return left < 0;
}

/// Starts a closed curve at its point farthest along a fixed direction, so that the starts of
/// neighbouring rings line up.
void rotate_to_start(std::vector<CurvePoint>& ring) {
  const Vec3 along(0.36f, 0.48f, 0.8f);  // no symmetry axis of usual shapes: few ties
  const auto less = [&](const CurvePoint& a, const CurvePoint& b) {
    return a.position.dot(along) < b.position.dot(along);
  };
  std::rotate(ring.begin(), std::max_element(ring.begin(), ring.end(), less), ring.end());
}

/// Drops repeated points, orients the curve so that waves run to its left, and sets the start of
/// closed curves. Returns false if too few points remain.
bool tidy_curve(std::vector<CurvePoint>& curve, std::array<CurveEnd, 2>& ends) {
  const bool closed = ends[0] == CurveEnd::closed;
  drop_repeats(curve, closed);
  if (closed && curve.size() <= 2) return false;
  if (runs_backward(curve, closed)) {
    std::reverse(curve.begin(), curve.end());
    std::swap(ends[0], ends[1]);
  }
  if (closed) rotate_to_start(curve);
  return true;
}

/// Appends the places of a curve's points and the ends of their segments.
void add_places(const Mesh& mesh, std::span<const CurvePoint> curve, bool closed,
                Polylines& lines) {
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const bool last = !closed && i + 1 == curve.size();
    const MeshPoint& from = curve[last && i > 0 ? i - 1 : i].place;
    const MeshPoint& to = curve[last ? i : (i + 1) % curve.size()].place;
    const PlacedSegment segment = placed_segment(mesh, from, to);
    lines.places.push_back({segment.triangle, last ? segment.to : segment.from});
    lines.arrivals.push_back(segment.to);
  }
}

std::size_t ends_inside(const std::vector<StripePiece>& pieces) {
  return static_cast<std::size_t>(std::count_if(
      pieces.begin(), pieces.end(),
      [](const StripePiece& piece) { return piece.ends[1].side == PieceEnd::kInside; }));
}

/// The number of curves that end in a triangle if none are joined.
std::size_t ends_apart(const LiftedTriangle& triangle) {
  std::vector<StripePiece> pieces;
  stripe_pieces(triangle, false, pieces);
  return ends_inside(pieces);
}

/// Rows are ascending, because edges are sorted by their higher vertex, then the lower one.
Adjacency adjacency_of(const MeshEdges& edges, std::size_t vertex_count) {
  auto rows = compressed_rows<Index>(vertex_count, [&](const auto& add) {
    for (const auto& [a, b] : edges.vertices) {
      add(a, b);
      add(b, a);
    }
  });
  return {std::move(rows.offsets), std::move(rows.entries)};
}

/// The directions of all waves, oriented alike, independent of their given signs.
std::vector<Vec3> directions_alike(const LiftedWaves& lifted, const Progress& progress) {
  const WavePattern& pattern = lifted.pattern();
  std::vector<Vec3> directions(pattern.mesh.vertex_count());
  for (std::size_t v = 0; v < directions.size(); ++v) {
    directions[v] = lifted.wave(static_cast<Index>(v)).wave.direction;
  }
  progress.report(0);
  const Adjacency adjacency = adjacency_of(pattern.edges, directions.size());
  orient_alike(adjacency, directions, progress.part(0.3, 1));
  return directions;
}

/// An end within a triangle.
struct InnerEnd {
  CurvePoint point;
  CurveEnd reason;
  std::vector<CurvePoint> way{};  ///< path to a neighbour
};

class Tracer {
 public:
  Tracer(const LiftedWaves& lifted, const CurveOptions& options, const Progress& progress)
      : pattern_(lifted.pattern()),
        options_(options),
        lifted_(lifted),
        stages_(progress, {{"crossings", 2}, {"pieces", 4}, {"directions", 3}, {"curves", 6}}) {}

  StripeCurves trace() {
    if (options_.join) end_walks_.emplace(lifted_);
    number_nodes(stages_.begin("crossings"));
    link_triangles(stages_.begin("pieces"));
    for (const CreaseEdge& crease : pattern_.creases) link_over(crease);
    if (!links_.empty()) directions_ = directions_alike(lifted_, stages_.begin("directions"));
    walk(stages_.begin("curves"));
    stages_.finish();
    return std::move(curves_);
  }

 private:
  bool is_nonmanifold(Index edge) const { return pattern_.edges.triangle_count(edge) > 2; }

  Index crossings(Index edge) const {
    return static_cast<Index>(std::abs(lifted_.edge(edge).peaks));
  }

  /// An edge of three triangles or more has separate nodes for each of them.
  std::size_t copies(Index edge) const {
    return is_nonmanifold(edge) ? pattern_.edges.triangle_count(edge) : 1;
  }

  void number_nodes(const Progress& progress) {
    const std::size_t edges = pattern_.edges.count();
    first_node_.resize(edges + 1);
    std::size_t count = 0;
    for (std::size_t e = 0; e < edges; ++e) {
      first_node_[e] = static_cast<Index>(count);
      count += crossings(static_cast<Index>(e)) * copies(static_cast<Index>(e));
    }
    check_memory(count);
    check_count(count);
    first_node_[edges] = static_cast<Index>(count);
    edge_of_node_.resize(count);
    links_.resize(count);
    parallel_for(edges, progress, [&](std::size_t begin, std::size_t end) {
      for (std::size_t e = begin; e < end; ++e) {
        const Link other = beyond_edge(static_cast<Index>(e));
        for (Index node = first_node_[e]; node < first_node_[e + 1]; ++node) {
          edge_of_node_[node] = static_cast<Index>(e);
          links_[node] = {kNoWave, other};
        }
      }
    });
  }

  /// The link on the second side of an edge until a piece is joined there.
  Link beyond_edge(Index edge) const {
    if (is_nonmanifold(edge)) return kNonmanifold;
    return pattern_.edges.triangle_count(edge) > 1 ? kNoWave : kBoundary;
  }

  /// The triangles on both sides of a node; on an edge of three or more, twice its own one.
  std::array<Index, 2> triangles_at(Index node, Index edge) const {
    const std::span<const Index> along = pattern_.edges.half_edges.of(edge);
    if (copies(edge) > 1) {
      const Index own = along[(node - first_node_[edge]) / crossings(edge)] / 3;
      return {own, own};
    }
    return {along.front() / 3, along.back() / 3};
  }

  /// Checks memory for the nodes and their shares of curves.
  static void check_memory(std::size_t nodes) {
    constexpr double kBytes = 3 * sizeof(Link) + 1 + 2 * sizeof(Vec3) + sizeof(TrianglePoint) +
                              sizeof(std::array<double, 3>) + sizeof(CurvePoint);
    check_fits(
        static_cast<double>(nodes), kBytes, "curves", "crossings of edges", [&](double most) {
          return "ask for fewer stripes: " + rounded_down(most / static_cast<double>(nodes)) +
                 " times as many would do";
        });
  }

  static void check_count(std::size_t nodes) {
    if (nodes < kMostNodes) return;
    throw Error("curves would cross edges more than " + std::to_string(kMostNodes) +
                " times; ask for fewer stripes");
  }

  /// Regular triangles only write to their own slots, so they are linked in parallel. The few
  /// others add nodes and ends, in order.
  void link_triangles(const Progress& progress) {
    const std::size_t count = pattern_.mesh.triangle_count();
    std::vector<std::uint8_t> irregular(count);
    parallel_for(count, progress.part(0, 0.8), [&](std::size_t begin, std::size_t end) {
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
    reported_for(count, progress.part(0.8, 1), [&](std::size_t t) {
      if (irregular[t]) link_irregular(t);
    });
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
      inner_points_[node - edge_of_node_.size()] = point_in(t, end.barycentric);
      return 2 * node + (part == corner ? 0 : 1);
    };
    std::vector<StripePiece> pieces;
    stripe_pieces(triangle, options_.join, pieces);
    if (options_.join) curves_.joined_ends += ends_apart(triangle) - ends_inside(pieces);
    for (const StripePiece& piece : pieces) {
      const Link from = slot(piece.ends[0], piece.part);
      if (piece.ends[1].side == PieceEnd::kInside) {
        links_[from / 2][from % 2] = add_end(t, piece, pieces, reason);
      } else {
        join(from, slot(piece.ends[1], piece.part));
      }
    }
  }

  /// One side of a crease, with crossings counted from its first end.
  struct Side {
    Index edge;
    bool forward;  ///< whether the edge runs the same way
  };

  std::optional<Side> side_of(const std::array<Index, 2>& ends) const {
    const Index edge = pattern_.edges.between(ends[0], ends[1]);
    if (pattern_.edges.triangle_count(edge) != 1) return std::nullopt;
    return Side{edge, pattern_.edges.vertices[edge][0] == ends[0]};
  }

  Index node_on(const Side& side, Index n) const {
    const Index count = crossings(side.edge);
    return first_node_[side.edge] + (side.forward ? n : count - 1 - n);
  }

  double share_of(const Side& side, Index n) const {
    const double share = share_along(node_on(side, n), side.edge);
    return side.forward ? share : 1 - share;
  }

  /// The phase change along a side, in turns.
  double turns_along(const Side& side) const {
    const auto [a, b] = pattern_.edges.vertices[side.edge];
    const Turns turns = lifted_end(lifted_.edge(side.edge), lifted_.turns(b)) - lifted_.turns(a);
    return std::abs(static_cast<double>(turns)) / static_cast<double>(kWholeTurn);
  }

  /// Continues curves over a crease where those of the other side are near enough. Both sides have
  /// their crossings in the same order.
  void link_over(const CreaseEdge& crease) {
    const auto a = side_of(crease.first), b = side_of(crease.second);
    if (!a || !b) return;
    const Index in_a = crossings(a->edge), in_b = crossings(b->edge);
    for (Index n = 0; n < in_a; ++n) links_[node_on(*a, n)][1] = kCrease;
    for (Index n = 0; n < in_b; ++n) links_[node_on(*b, n)][1] = kCrease;
    const double turns = std::max(turns_along(*a), turns_along(*b));
    for (Index n = 0, m = 0; n < in_a && m < in_b;) {
      const double ahead = share_of(*b, m) - share_of(*a, n);
      if (std::abs(ahead) * turns <= kMeetingPeriods) {
        join(2 * node_on(*a, n++) + 1, 2 * node_on(*b, m++) + 1);
      } else if (ahead > 0) {
        ++n;
      } else {
        ++m;
      }
    }
  }

  Link edge_slot(std::size_t t, const PieceEnd& end) const {
    const Index edge = pattern_.edges.of_triangle[t][end.side];
    const std::span<const Index> along = pattern_.edges.half_edges.of(edge);
    const auto rank = static_cast<Index>(ranges::find(along, 3 * t + end.side) - along.begin());
    const Index node = first_node_[edge] + end.crossing;
    return copies(edge) == 1 ? 2 * node + rank : 2 * (node + rank * crossings(edge));
  }

  void join(Link a, Link b) {
    links_[a / 2][a % 2] = b;
    links_[b / 2][b % 2] = a;
  }

  Link add_end(std::size_t t, const StripePiece& piece, std::span<const StripePiece> pieces,
               CurveEnd reason) {
    InnerEnd end{point_in(t, piece.ends[1].barycentric), reason};
    if (const auto way = end_walks_ ? end_walks_->way_on(t, piece, pieces) : std::nullopt) {
      ++curves_.ends_at_neighbors;
      for (const TrianglePoint& place : *way) end.way.push_back(point_in_triangle(pattern_, place));
    }
    inner_ends_.push_back(std::move(end));
    check_count(inner_ends_.size());
    return kFirstEnd + static_cast<Link>(inner_ends_.size() - 1);
  }

  CurvePoint point_in(std::size_t t, const std::array<double, 3>& barycentric) const {
    return point_in_triangle(pattern_, {static_cast<Index>(t), barycentric});
  }

  /// The position of a node along its edge, 0 to 1.
  double share_along(Index node, Index edge) const {
    const auto [a, b] = pattern_.edges.vertices[edge];
    const Turns start = lifted_.turns(a);
    const Turns end = lifted_end(lifted_.edge(edge), lifted_.turns(b));
    return crossing_position(start, end, (node - first_node_[edge]) % crossings(edge));
  }

  CurvePoint point_of(Index node) const {
    if (node >= edge_of_node_.size()) return inner_points_[node - edge_of_node_.size()];
    const Index edge = edge_of_node_[node];
    const auto [a, b] = pattern_.edges.vertices[edge];
    const auto t = static_cast<float>(share_along(node, edge));
    const Vec3& from = pattern_.mesh.positions[a];
    const Vec3 way = pattern_.mesh.positions[b] - from;
    const double share = t;
    CurvePoint result{from + t * way,
                      Vec3::Zero(),
                      (1 - t) * directions_[a] + t * directions_[b],
                      way.norm(),
                      {{a, b, b}, {1 - share, share, 0}, triangles_at(node, edge)}};
    add_normal(pattern_, 1 - t, a, result.normal);
    add_normal(pattern_, t, b, result.normal);
    result.normal.stableNormalize();
    return result;
  }

  void walk(const Progress& progress) {
    walking_ = progress;
    const auto nodes = static_cast<Index>(links_.size());
    curves_.lines.points.reserve(nodes + inner_ends_.size());
    curves_.lines.normals.reserve(nodes + inner_ends_.size());
    visited_.resize(nodes);
    for (Index node = 0; node < nodes; ++node) {
      for (Link side = 0; side < 2; ++side) {
        const bool passed_by = is_bare(links_[node][side]) && is_bare(links_[node][1 - side]);
        if (visited_[node] || passed_by || is_slot(links_[node][side])) continue;
        walk_open(2 * node + side);
      }
    }
    for (Index node = 0; node < nodes; ++node) {
      const bool on_curve = is_slot(links_[node][0]);
      if (!visited_[node] && on_curve) walk_closed(node);
    }
  }

  /// Walks from a slot whose link is an end to the other end.
  void walk_open(Link slot) {
    std::array<CurveEnd, 2> ends{};
    ends[0] = end_at(links_[slot / 2][slot % 2]);
    std::reverse(curve_.begin(), curve_.end());
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
    if (walked_++ % kReportSlice == 0) {
      walking_.report(static_cast<double>(walked_) / static_cast<double>(links_.size() + 1));
    }
    visited_[node] = 1;
    curve_.push_back(point_of(node));
  }

  /// Returns the reason of an end; appends the points of an inner end.
  CurveEnd end_at(Link link) {
    if (link == kBoundary) return CurveEnd::boundary;
    if (link == kNonmanifold) return CurveEnd::nonmanifold;
    if (link == kCrease) return CurveEnd::crease;
    if (link == kNoWave) return CurveEnd::no_wave;
    const InnerEnd& end = inner_ends_[link - kFirstEnd];
    curve_.push_back(end.point);
    curve_.insert(curve_.end(), end.way.begin(), end.way.end());
    return end.reason;
  }

  void finish(std::array<CurveEnd, 2> ends) {
    if (tidy_curve(curve_, ends)) add_curve(ends);
    curve_.clear();
  }

  void add_curve(const std::array<CurveEnd, 2>& ends) {
    Polylines& lines = curves_.lines;
    const bool closed = ends[0] == CurveEnd::closed;
    for (const CurvePoint& point : curve_) lines.add(point.position, point.normal);
    add_places(pattern_.mesh, curve_, closed, lines);
    lines.end_line(closed);
    curves_.ends.push_back(ends);
  }

  const WavePattern& pattern_;
  const CurveOptions& options_;
  const LiftedWaves& lifted_;
  JobStages stages_;
  Progress walking_;
  std::size_t walked_ = 0;
  std::vector<Index> first_node_;           // edges + 1 entries
  std::vector<Index> edge_of_node_;         // for nodes on edges; nodes on cuts follow
  std::vector<std::array<Link, 2>> links_;  // one per node
  std::vector<CurvePoint> inner_points_;    // points of nodes on cuts
  std::vector<InnerEnd> inner_ends_;
  std::optional<EndWalks> end_walks_;  // for `join`
  std::vector<Vec3> directions_;       // one per vertex, oriented alike where possible
  std::vector<std::uint8_t> visited_;  // one per node
  std::vector<CurvePoint> curve_;      // the current one
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

std::vector<float> frequencies_along(const WavePattern& pattern, const Polylines& lines) {
  std::vector<float> frequencies(lines.points.size());
  for (std::size_t i = 0; i < frequencies.size(); ++i) {
    const auto& [triangle, barycentric] = lines.places[i];
    for (std::size_t m = 0; m < 3; ++m) {
      frequencies[i] += static_cast<float>(barycentric[m]) *
                        pattern.waves.frequencies[pattern.mesh.triangles[triangle][m]];
    }
  }
  return frequencies;
}

StripeCurves stripe_curves(const LiftedWaves& waves, const CurveOptions& options,
                           const Progress& progress) {
  check_curve_options(options);
  const WavePattern& pattern = waves.pattern();
  const float trim = options.least_gap();
  const bool trims = trim > 0, fairs = options.fair > 0;
  const double traced = (trims ? kTracedBeforeTrim : 1) * (fairs ? kBeforeFair : 1);
  StripeCurves curves = Tracer(waves, options, progress.part(0, traced)).trace();
  curves.lines.origin = pattern.mesh.origin;
  if (trims) {
    curves = trimmed_ends(curves, frequencies_along(pattern, curves.lines), trim,
                          progress.part(traced, fairs ? kBeforeFair : 1));
  }
  if (!fairs) return curves;
#ifdef BRINDLE_HAS_FAIRING
  return faired_curves(curves, pattern, options.fair, progress.part(kBeforeFair, 1));
#else
  throw Error("this build cannot fair curves; configure with -DBRINDLE_FAIRING=ON");
#endif
}

void check_curve_options(const CurveOptions& options) {
  const float trim = options.least_gap();
  if (!(trim >= 0 && trim <= 1)) {
    throw Error("trim: ends are cut back to a share of the spacing from 0 to 1");
  }
  if (trim > 0 && options.join) {
    throw Error("trim: ends that are joined run on into their neighbours; leave one of both out");
  }
  if (!(options.fair >= 0 && options.fair <= 1)) {
    throw Error("fair: kinks are taken out up to a share of the spacing from 0 to 1");
  }
}

StripeCurves longer_than(const StripeCurves& curves, double length) {
  StripeCurves longer;
  longer.joined_ends = curves.joined_ends;
  longer.ends_at_neighbors = curves.ends_at_neighbors;
  longer.smooth_forks = curves.smooth_forks;
  longer.trimmed_ends = curves.trimmed_ends;
  longer.trimmed_away = curves.trimmed_away;
  longer.largest_move = curves.largest_move;
  Polylines& lines = longer.lines;
  lines.origin = curves.lines.origin;
  for (std::size_t line = 0; line < curves.lines.count(); ++line) {
    if (length_of(curves.lines, line) < length) continue;
    lines.add(curves.lines, curves.lines.offsets[line], curves.lines.offsets[line + 1]);
    lines.end_line(curves.lines.closed[line]);
    longer.ends.push_back(curves.ends[line]);
  }
  return longer;
}

std::size_t shift_phases(const Adjacency& neighborhood, float periods, WaveSet& waves,
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
  for (Complex& value : z) value *= elementary::polar(1.0f, turn);
  return reflecting;
}

}  // namespace brindle
