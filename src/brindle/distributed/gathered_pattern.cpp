#include "brindle/distributed/gathered_pattern.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "brindle/distributed/parts_on_first.h"
#include "brindle/error.h"
#include "brindle/stripe_tracer.h"

namespace brindle {
namespace {

void check_pattern(const PiecePattern& pattern) {
  const RankSurface& surface = pattern.surface.rank_surface();
  const WaveSet& waves = pattern.waves;
  const std::size_t vertices = surface.vertex_of_piece.size();
  surface.ranks->throw_on_all([&] {
    for (const std::size_t count : {waves.positions.size(), waves.directions.size(),
                                    waves.frequencies.size(), pattern.z.size()}) {
      if (count == vertices) continue;
      throw Error("a pattern of a piece of " + std::to_string(vertices) + " vertices has " +
                  std::to_string(count) + " waves or phases; give one for each");
    }
  });
}

/// A part of a line within one rank's triangles, to be sent there.
struct SentLine {
  std::uint64_t points = 0;
  std::uint8_t closed = 0;
  std::array<CurveEnd, 2> ends{};
  std::array<std::optional<BorderCrossing>, 2> borders;
};
struct SentPoint {
  Vec3 position, normal;
  TrianglePoint place;
  std::array<double, 3> arrival;
};

/// By rank.
struct CutLines {
  std::vector<std::vector<SentLine>> lines;
  std::vector<std::vector<SentPoint>> points;
};

/// Cuts rank 0's curves at borders between ranks.
class CurveCutter {
 public:
  CurveCutter(const GatheredSurface& whole, const StripeCurves& curves,
              std::span<const TriangleOfPiece> triangles, CutLines& cut)
      : whole_(whole), curves_(curves), lines_(curves.lines), triangles_(triangles), cut_(cut) {}

  void cut() {
    for (std::size_t line = 0; line < lines_.count(); ++line) find_cuts(line);
    number_cuts();
    for (std::size_t line = 0; line < lines_.count(); ++line) cut_line(line);
  }

 private:
  /// A point at which a line enters another rank's triangles.
  struct Cut {
    Index at;  ///< index among the points of its line
    std::array<std::uint64_t, 2> edge;
    double along;  ///< position on the edge from its lower-numbered end
    std::uint32_t number = 0;
  };

  int rank_at(Index point) const { return triangles_[lines_.places[point].triangle].rank; }

  /// The positions of points are in the triangles of the segments that begin there.
  void find_cuts(std::size_t line) {
    const Index first = lines_.offsets[line], count = lines_.offsets[line + 1] - first;
    const bool closed = lines_.closed[line] != 0;
    std::vector<Cut>& cuts = cuts_.emplace_back();
    for (Index at = closed ? 0 : 1; at < (closed ? count : count - 1); ++at) {
      const Index before = first + (at + count - 1) % count, point = first + at;
      if (rank_at(before) != rank_at(point)) cuts.push_back(cut_at(at, before, point));
    }
  }

  /// On the common edge of both triangles; if points between them were left out, on an edge of the
  /// second one.
  Cut cut_at(Index at, Index before, Index point) const {
    const std::vector<Triangle>& triangles = whole_.surface().mesh.triangles;
    const TrianglePoint& place = lines_.places[point];
    const Triangle& corners = triangles[place.triangle];
    const Triangle& other = triangles[lines_.places[before].triangle];
    std::array<std::size_t, 3> order = {0, 1, 2};
    std::ranges::sort(order, std::ranges::greater{}, [&](std::size_t c) {
      return std::pair(std::ranges::count(other, corners[c]), place.barycentric[c]);
    });
    const auto [low, high] = corners[order[0]] < corners[order[1]] ? std::pair(order[0], order[1])
                                                                   : std::pair(order[1], order[0]);
    return {at, {whole_.ids()[corners[low]], whole_.ids()[corners[high]]}, place.barycentric[high]};
  }

  void number_cuts() {
    std::map<std::array<std::uint64_t, 2>, std::vector<Cut*>> at_edges;
    for (std::vector<Cut>& of_line : cuts_) {
      for (Cut& cut : of_line) at_edges[cut.edge].push_back(&cut);
    }
    for (auto& [edge, cuts] : at_edges) {
      std::ranges::stable_sort(cuts, {}, &Cut::along);
      std::uint32_t next = 0;
      for (Cut* cut : cuts) cut->number = next++;
    }
  }

  void cut_line(std::size_t line) {
    const std::vector<Cut>& cuts = cuts_[line];
    const auto count = static_cast<Index>(lines_.points_of(line).size());
    const bool closed = lines_.closed[line] != 0;
    if (cuts.empty()) return add_part(line, 0, closed ? count : count - 1, nullptr, nullptr);
    if (!closed) add_part(line, 0, cuts[0].at, nullptr, &cuts[0]);
    for (std::size_t c = 0; c + 1 < cuts.size(); ++c) {
      add_part(line, cuts[c].at, cuts[c + 1].at - cuts[c].at, &cuts[c], &cuts[c + 1]);
    }
    const Cut& last = cuts.back();
    if (closed) {
      add_part(line, last.at, count - last.at + cuts[0].at, &last, &cuts[0]);
    } else {
      add_part(line, last.at, count - 1 - last.at, &last, nullptr);
    }
  }

  /// Adds `segments` segments from a point of the line on.
  void add_part(std::size_t line, Index at, Index segments, const Cut* from, const Cut* to) {
    const Index first = lines_.offsets[line];
    const auto count = static_cast<Index>(lines_.points_of(line).size());
    const auto point = [&](Index segment) { return first + (at + segment) % count; };
    const auto rank = static_cast<std::size_t>(rank_at(point(0)));
    const bool closed = lines_.closed[line] != 0 && from == nullptr;
    std::vector<SentPoint>& points = cut_.points[rank];
    for (Index k = 0; k < segments; ++k) points.push_back(sent(point(k)));
    if (!closed) {
      // In the triangle of the last segment.
      SentPoint last = sent(point(segments > 0 ? segments - 1 : 0));
      if (segments > 0) last.place.barycentric = last.arrival;
      last.position = lines_.points[point(segments)];
      last.normal = lines_.normals[point(segments)];
      points.push_back(last);
    }
    cut_.lines[rank].push_back({segments + (closed ? 0u : 1u),
                                closed ? std::uint8_t{1} : std::uint8_t{0},
                                curves_.ends[line],
                                {crossing(from), crossing(to)}});
  }

  SentPoint sent(Index i) const {
    const auto& [triangle, barycentric] = lines_.places[i];
    return {lines_.points[i],
            lines_.normals[i],
            {triangles_[triangle].triangle, barycentric},
            lines_.arrivals[i]};
  }

  static std::optional<BorderCrossing> crossing(const Cut* cut) {
    if (cut == nullptr) return std::nullopt;
    return BorderCrossing{cut->edge, cut->number};
  }

  const GatheredSurface& whole_;
  const StripeCurves& curves_;
  const Polylines& lines_;
  std::span<const TriangleOfPiece> triangles_;  // of the whole surface
  CutLines& cut_;
  std::vector<std::vector<Cut>> cuts_;  // by line
};

PieceCurves received(const std::vector<SentLine>& lines, const std::vector<SentPoint>& points) {
  PieceCurves result;
  for (const SentPoint& point : points) {
    result.lines.add(point.position, point.normal, point.place, point.arrival);
  }
  for (const SentLine& line : lines) {
    result.lines.offsets.push_back(result.lines.offsets.back() + static_cast<Index>(line.points));
    result.lines.closed.push_back(line.closed);
    result.ends.push_back(line.ends);
    result.borders.push_back(line.borders);
  }
  return result;
}

}  // namespace

StripePattern gathered_pattern(const GatheredSurface& whole, const PiecePattern& pattern) {
  check_pattern(pattern);
  StripePattern gathered;
  gathered.phase_shift = pattern.phase_shift;
  gathered.waves.positions = whole.of_vertices(pattern.waves.positions);
  gathered.waves.directions = whole.of_vertices(pattern.waves.directions);
  gathered.waves.frequencies = whole.of_vertices(pattern.waves.frequencies);
  gathered.solution.z = whole.of_vertices(pattern.z);
  return gathered;
}

WholeCurves whole_curves(const PiecePattern& pattern, const CurveOptions& options,
                         const Progress& progress) {
  const GatheredSurface whole(pattern.surface.rank_surface());
  Communicator& ranks = *whole.piece().ranks;
  const StripePattern gathered = gathered_pattern(whole, pattern);
  const std::vector<TriangleOfPiece> triangles = whole.triangles_of_pieces();
  WholeCurves result;
  ranks.on_first(progress, [&](const Progress& heard) {
    result.curves = StripeTracer(whole.surface()).curves(gathered, options, heard);
    for (TrianglePoint& place : result.curves.lines.places) {
      result.rank_of_point.push_back(triangles[place.triangle].rank);
      place.triangle = triangles[place.triangle].triangle;
    }
  });
  return result;
}

PieceCurves piece_curves(const PiecePattern& pattern, const CurveOptions& options) {
  const RankSurface& surface = pattern.surface.rank_surface();
  Communicator& ranks = *surface.ranks;
  ranks.throw_on_all([&] {
    if (options.fair > 0) {
      throw Error("fair: curves that end at borders keep their kinks; ask for whole_curves");
    }
  });
  const GatheredSurface whole(surface);
  const StripePattern gathered = gathered_pattern(whole, pattern);
  StripeCurves curves;
  ranks.throw_on_all([&] {
    if (whole.is_first()) curves = StripeTracer(whole.surface()).curves(gathered, options);
  });
  return cut_curves(whole, curves);
}

PieceCurves cut_curves(const GatheredSurface& whole, const StripeCurves& curves) {
  Communicator& ranks = *whole.piece().ranks;
  const std::vector<TriangleOfPiece> triangles = whole.triangles_of_pieces();
  CutLines cut;
  cut.lines.resize(static_cast<std::size_t>(ranks.size()));
  cut.points.resize(cut.lines.size());
  ranks.throw_on_all([&] {
    if (whole.is_first()) CurveCutter(whole, curves, triangles, cut).cut();
  });
  PieceCurves pieces = received(ranks.swap_lists(cut.lines)[0], ranks.swap_lists(cut.points)[0]);
  pieces.lines.origin = whole.piece().mesh.origin;
  return pieces;
}

std::vector<Sample> wave_samples(const PiecePattern& u, const PiecePattern& v) {
  const RankSurface& surface = u.surface.rank_surface();
  surface.ranks->throw_on_all([&] {
    if (&surface == &v.surface.rank_surface()) return;
    throw Error("samples need two patterns on one surface");
  });
  const GatheredSurface whole(surface);
  const StripePattern all_u = gathered_pattern(whole, u), all_v = gathered_pattern(whole, v);
  const std::vector<TriangleOfPiece> triangles = whole.triangles_of_pieces();
  std::vector<std::vector<Sample>> samples(static_cast<std::size_t>(surface.ranks->size()));
  surface.ranks->throw_on_all([&] {
    if (!whole.is_first()) return;
    for (Sample& sample : StripeTracer(whole.surface()).crossings(all_u, all_v)) {
      const auto& [rank, triangle] = triangles[sample.triangle];
      sample.triangle = triangle;
      samples[static_cast<std::size_t>(rank)].push_back(sample);
    }
  });
  return std::move(surface.ranks->swap_lists(samples)[0]);
}

std::size_t drop_doubles(const DistributedSurface& surface, std::vector<Sample>& samples,
                         float share) {
  Communicator& ranks = *surface.rank_surface().ranks;
  if (ranks.size() == 1) return drop_doubles(samples, share);
  const PartsOnFirst parts(ranks, samples.size());
  std::vector<Sample> all;
  parts.gather(std::span<const Sample>(samples), all);
  std::vector<std::uint8_t> kept(all.size()), own(samples.size());
  ranks.throw_on_all([&] {
    for (std::size_t i = 0; i < all.size(); ++i) all[i].triangle = static_cast<Index>(i);
    if (ranks.rank() == 0) drop_doubles(all, share);
    for (const Sample& sample : all) kept[sample.triangle] = 1;
  });
  parts.scatter(std::span<const std::uint8_t>(kept), std::span(own));
  std::size_t left = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (own[i]) samples[left++] = samples[i];
  }
  const std::size_t dropped = samples.size() - left;
  samples.resize(left);
  return ranks.sum(dropped);
}

std::vector<Sample> gathered_samples(const DistributedSurface& surface,
                                     std::span<const Sample> samples) {
  std::vector<Sample> all;
  PartsOnFirst(*surface.rank_surface().ranks, samples.size()).gather(samples, all);
  return all;
}

}  // namespace brindle
