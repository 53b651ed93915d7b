#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "brindle/distributed/curves/rank_pattern.h"
#include "brindle/distributed/curves/rank_walks.h"
#include "brindle/distributed_pattern.h"
#include "brindle/error.h"
#include "brindle/pattern/stripe_curves.h"
#include "brindle/pattern/trimmed_ends.h"

namespace brindle {
namespace {

std::optional<BorderCrossing> border_crossing(const RankTriangles& triangles,
                                              const std::optional<CutCurve::Crossing>& cut) {
  if (!cut) return std::nullopt;
  const auto [a, b] = triangles.edges.vertices[cut->edge];
  return BorderCrossing{{triangles.ids[a], triangles.ids[b]}, cut->number};
}

PieceCurves with_ids(const CutCurves& curves, const RankTriangles& triangles,
                     const WavePattern& pattern, const std::vector<Index>& triangle_of_piece) {
  PieceCurves result;
  result.joined_ends = curves.joined_ends;
  result.ends_at_neighbors = curves.ends_at_neighbors;
  result.lines.origin = triangles.mesh.origin;
  for (const CutCurve& curve : curves.curves) {
    for (const CurvePoint& point : curve.points) {
      result.lines.points.push_back(point.position);
      result.lines.normals.push_back(point.normal);
      result.forward.push_back(point.forward);
      result.sizes.push_back(point.size);
    }
    result.lines.offsets.push_back(static_cast<Index>(result.lines.points.size()));
    const bool closed = curve.ends[0] == CurveEnd::closed;
    add_places(triangles.mesh, curve.points, closed, result.lines);
    result.lines.closed.push_back(closed);
    result.ends.push_back(curve.ends);
    result.borders.push_back(
        {border_crossing(triangles, curve.cuts[0]), border_crossing(triangles, curve.cuts[1])});
  }
  result.frequencies = frequencies_along(pattern, result.lines);
  for (TrianglePoint& place : result.lines.places) {
    place.triangle = triangle_of_piece[place.triangle];
  }
  return result;
}

/// A curve of a rank and one of its points, as they are sent.
struct SentEnd {
  std::uint64_t low = 0, high = 0;
  std::uint32_t number = 0;
  CurveEnd end = CurveEnd::closed;
  bool crosses = false;
};
struct SentCurve {
  std::array<SentEnd, 2> ends;
  std::uint64_t points = 0;
};
struct SentPoint {
  Vec3 position, normal, forward;
  float size = 0, frequency = 0;
};

SentEnd sent_end(const PieceCurves& curves, std::size_t line, std::size_t e) {
  const std::optional<BorderCrossing>& border = curves.borders[line][e];
  SentEnd sent;
  sent.end = curves.ends[line][e];
  if (!border) return sent;
  sent.crosses = true;
  sent.low = border->edge[0];
  sent.high = border->edge[1];
  sent.number = border->number;
  return sent;
}

/// Puts the curves of all ranks together.
class CurveJoiner {
 public:
  CurveJoiner(std::vector<SentCurve> curves, std::vector<SentPoint> points)
      : curves_(std::move(curves)), points_(std::move(points)), visited_(curves_.size()) {
    std::size_t first = 0;
    for (std::size_t c = 0; c < curves_.size(); ++c) {
      first_.push_back(first);
      first += curves_[c].points;
      for (std::size_t e = 0; e < 2; ++e) {
        if (curves_[c].ends[e].crosses) ends_[crossing_of(curves_[c].ends[e])].push_back({c, e});
      }
    }
  }

  StripeCurves join() {
    for (std::size_t c = 0; c < curves_.size(); ++c) {
      for (std::size_t e = 0; e < 2; ++e) {
        if (!visited_[c] && !curves_[c].ends[e].crosses) follow({c, e});
      }
    }
    for (std::size_t c = 0; c < curves_.size(); ++c) {
      if (!visited_[c]) follow({c, 0});
    }
    return std::move(joined_);
  }

  /// Of every point of the joined curves the number among all points.
  const std::vector<Index>& sources() const { return sources_; }

  /// At every point of the joined curves.
  std::vector<float> frequencies() const {
    std::vector<float> frequencies;
    for (const Index source : sources_) frequencies.push_back(points_[source].frequency);
    return frequencies;
  }

 private:
  struct End {
    std::size_t curve, end;
  };

  static BorderCrossing crossing_of(const SentEnd& end) {
    return {{end.low, end.high}, end.number};
  }

  /// The other end at the same crossing.
  End partner(const End& end) const {
    const std::vector<End>& both = ends_.at(crossing_of(curves_[end.curve].ends[end.end]));
    if (both.size() != 2) {
      throw Error("curves of " + std::to_string(both.size()) +
                  " ranks meet at one point of an edge; give each triangle to one rank alone");
    }
    return both[0].curve == end.curve && both[0].end == end.end ? both[1] : both[0];
  }

  /// From one end on, over all borders.
  void follow(End from) {
    std::array<CurveEnd, 2> ends = {curves_[from.curve].ends[from.end].end, CurveEnd::closed};
    const bool open = !curves_[from.curve].ends[from.end].crosses;
    if (!open) ends[0] = CurveEnd::closed;
    std::vector<CurvePoint> curve;
    std::size_t pieces = 0;
    while (!visited_[from.curve]) {
      visited_[from.curve] = 1;
      append(from, curve);
      ++pieces;
      const End to{from.curve, 1 - from.end};
      if (!curves_[to.curve].ends[to.end].crosses) {
        ends[1] = curves_[to.curve].ends[to.end].end;
        break;
      }
      from = partner(to);
    }
    // Back at the first point, which is there already.
    if (!open && curve.size() > 1) curve.pop_back();
    // Between two triangles without waves.
    if (open && pieces > 1 && curve.size() == 1) return;
    if (tidy_curve(curve, ends)) add(curve, ends);
  }

  /// The points from that end to the other; the first is where the one before has ended.
  void append(const End& from, std::vector<CurvePoint>& curve) const {
    const std::size_t count = curves_[from.curve].points, first = first_[from.curve];
    for (std::size_t i = curve.empty() ? 0 : 1; i < count; ++i) {
      const SentPoint& p = points_[first + (from.end == 0 ? i : count - 1 - i)];
      const auto row = static_cast<Index>(&p - points_.data());
      curve.push_back({p.position, p.normal, p.forward, p.size, {{row, row, row}, {1, 0, 0}, {}}});
    }
  }

  void add(const std::vector<CurvePoint>& curve, const std::array<CurveEnd, 2>& ends) {
    Polylines& lines = joined_.lines;
    for (const CurvePoint& point : curve) {
      lines.points.push_back(point.position);
      lines.normals.push_back(point.normal);
      sources_.push_back(point.place.vertices[0]);
    }
    lines.offsets.push_back(static_cast<Index>(lines.points.size()));
    lines.closed.push_back(ends[0] == CurveEnd::closed);
    joined_.ends.push_back(ends);
  }

  std::vector<SentCurve> curves_;
  std::vector<SentPoint> points_;
  std::vector<std::size_t> first_;  // point of every curve
  std::vector<std::uint8_t> visited_;
  std::map<BorderCrossing, std::vector<End>> ends_;
  StripeCurves joined_;
  std::vector<Index> sources_;
};

StripeCurves trimmed(const StripeCurves& whole, const CurveJoiner& joiner, float least_gap,
                     std::vector<Index>* sources) {
  std::vector<Index> rows;
  StripeCurves result = trimmed_ends(whole, joiner.frequencies(), least_gap, {}, &rows);
  if (sources != nullptr) {
    sources->clear();
    for (const Index row : rows) sources->push_back(joiner.sources()[row]);
  }
  return result;
}

}  // namespace

PieceCurves piece_curves(const PiecePattern& pattern, const CurveOptions& options) {
  const RankSurface& surface = pattern.surface.rank_surface();
  const RankTriangles triangles = rank_triangles(surface);
  const RankWaves waves = rank_waves(pattern, triangles);
  const std::vector<EdgeBeyond> beyond = edges_beyond(surface, triangles);
  std::optional<LiftedWaves> lifted;
  CutCurves cut;
  surface.ranks->together([&] {
    check_curve_options(options);
    if (options.fair > 0) {
      throw Error("fair: curves that end at borders keep their kinks; ask for whole_curves");
    }
    lifted.emplace(wave_pattern(triangles, waves, pattern.phase_shift));
    cut = cut_stripe_curves(*lifted, beyond, options);
  });
  if (options.join) continue_ends(surface, triangles, *lifted, beyond, cut);
  PieceCurves curves;
  surface.ranks->together(
      [&] { curves = with_ids(cut, triangles, lifted->pattern(), surface.triangle_of_piece); });
  curves.trim = options.trim;
  return curves;
}

StripeCurves joined_curves(const DistributedSurface& surface, const PieceCurves& curves,
                           std::vector<Index>* sources) {
  Communicator& ranks = *surface.rank_surface().ranks;
  std::vector<SentCurve> sent;
  std::vector<SentPoint> points;
  for (std::size_t line = 0; line < curves.lines.count(); ++line) {
    sent.push_back({{sent_end(curves, line, 0), sent_end(curves, line, 1)},
                    curves.lines.points_of(line).size()});
  }
  for (std::size_t i = 0; i < curves.lines.points.size(); ++i) {
    points.push_back({curves.lines.points[i], curves.lines.normals[i], curves.forward[i],
                      curves.sizes[i], curves.frequencies[i]});
  }
  auto all_curves = joined<SentCurve>(ranks.gather(std::as_bytes(std::span(sent))));
  auto all_points = joined<SentPoint>(ranks.gather(std::as_bytes(std::span(points))));
  StripeCurves whole;
  ranks.together([&] {
    CurveJoiner joiner(std::move(all_curves), std::move(all_points));
    whole = joiner.join();
    if (sources != nullptr) *sources = joiner.sources();
    if (curves.trim > 0 && ranks.rank() == 0) whole = trimmed(whole, joiner, curves.trim, sources);
  });
  whole.lines.origin = surface.rank_surface().mesh.origin;
  const std::size_t joined_ends = ranks.sum(curves.joined_ends);
  const std::size_t ends_at_neighbors = ranks.sum(curves.ends_at_neighbors);
  if (ranks.rank() != 0) return whole;
  whole.joined_ends = joined_ends;
  whole.ends_at_neighbors = ends_at_neighbors;
  return whole;
}

}  // namespace brindle
