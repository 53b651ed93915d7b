#include "brindle/distributed/curves/joined_measures.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "brindle/base/parallel.h"
#include "brindle/distributed/surface/rank_surface.h"
#include "brindle/points/point_tree.h"

namespace brindle {
namespace {

constexpr std::size_t kPointsAtOnce = std::size_t{1} << 16;  // what rank 0 has room for, by ranks

/// A rank's own vertices, and frequencies there.
struct OwnFrequencies {
  std::vector<Vec3> positions;
  std::vector<std::uint64_t> numbers;  ///< in the whole
  MarkFrequencies at;
};

using Place = std::array<float, 3>;

/// The vertex of a rank that is nearest to a point.
struct NearestVertex {
  double square = std::numeric_limits<double>::infinity();  ///< of the distance
  std::uint64_t number = 0;                                 ///< in the whole
  float chosen = 0, wanted = 0;                             ///< frequencies

  auto key() const { return std::tuple(square, number); }
};

OwnFrequencies own_frequencies(const PiecePattern& pattern, std::span<const float> wanted) {
  const RankSurface& surface = pattern.surface.rank_surface();
  const std::vector<float>& chosen = pattern.waves.frequencies;
  OwnFrequencies own;
  for (std::size_t p = 0; p < surface.vertex_of_piece.size(); ++p) {
    const Index v = surface.vertex_of_piece[p];
    if (v >= surface.graph.own) continue;
    own.positions.push_back(surface.mesh.positions[v]);
    own.numbers.push_back(surface.piece_ids[p]);
    own.at.chosen.push_back(chosen[p]);
    own.at.wanted.push_back(wanted.empty() ? chosen[p] : wanted[p]);
  }
  return own;
}

/// The smallest and the largest of all ranks' numbers.
std::pair<float, float> range_of(Communicator& ranks, std::span<const float> numbers) {
  float least = std::numeric_limits<float>::infinity(), most = -least;
  for (const float number : numbers) {
    least = std::min(least, number);
    most = std::max(most, number);
  }
  return {-ranks.greatest(-least), ranks.greatest(most)};
}

std::vector<NearestVertex> nearest_own(const OwnFrequencies& own, const PointTree& tree,
                                       std::span<const Place> points) {
  std::vector<NearestVertex> nearest(points.size());
  if (own.positions.empty()) return nearest;
  parallel_for(points.size(), [&](std::size_t begin, std::size_t end) {
    std::vector<Index> found;
    for (std::size_t i = begin; i < end; ++i) {
      const Vec3 point(points[i].data());
      tree.nearest(point, 1, found);
      const Index v = found[0];
      const double square = (own.positions[v] - point).cast<double>().squaredNorm();
      nearest[i] = {square, own.numbers[v], own.at.chosen[v], own.at.wanted[v]};
    }
  });
  return nearest;
}

/// On rank 0 the frequencies at its points; all ranks answer.
MarkFrequencies asked_frequencies(Communicator& ranks, const OwnFrequencies& own,
                                  std::span<const Vec3> points) {
  const PointTree tree(own.positions);
  const std::uint64_t count = ranks.greatest(std::uint64_t{points.size()});
  MarkFrequencies frequencies;
  for (std::size_t begin = 0; begin < count; begin += kPointsAtOnce) {
    std::vector<Place> some;
    if (ranks.rank() == 0) {
      for (const Vec3& p : points.subspan(begin, std::min(kPointsAtOnce, points.size() - begin))) {
        some.push_back({p.x(), p.y(), p.z()});
      }
    }
    some = ranks.of_first(some);
    const std::vector<NearestVertex> nearest = nearest_own(own, tree, some);
    const auto lists = ranks.gather(std::as_bytes(std::span(nearest)));
    const std::vector<NearestVertex> all = joined<NearestVertex>(lists);
    for (std::size_t i = 0; i < some.size() && ranks.rank() == 0; ++i) {
      NearestVertex best;
      for (std::size_t at = i; at < all.size(); at += some.size()) {
        best =
            std::min(best, all[at], [](const auto& a, const auto& b) { return a.key() < b.key(); });
      }
      frequencies.chosen.push_back(best.chosen);
      frequencies.wanted.push_back(best.wanted);
    }
  }
  return frequencies;
}

}  // namespace

CurveSpacing measure_joined_spacing(const PiecePattern& pattern, const StripeCurves& curves,
                                    std::span<const float> wanted) {
  Communicator& ranks = *pattern.surface.rank_surface().ranks;
  const OwnFrequencies own = own_frequencies(pattern, wanted);
  const auto [least, most] = range_of(ranks, own.at.chosen);
  const auto [least_wanted, most_wanted] = range_of(ranks, own.at.wanted);
  std::optional<CurveMarks> marks;
  ranks.together([&, most = most] {
    if (ranks.rank() == 0 && most > 0) marks = curve_marks(curves, most);
  });
  const std::size_t count = marks ? marks->lines.points.size() : 0;
  MarkFrequencies frequencies{std::vector<float>(count, most),
                              std::vector<float>(count, most_wanted)};
  if (least != most || least_wanted != most_wanted) {
    const std::span<Vec3> none;
    frequencies = asked_frequencies(ranks, own, marks ? std::span(marks->lines.points) : none);
  }
  CurveSpacing spacing;
  ranks.together([&] {
    if (marks) spacing = measure_curve_spacing(*marks, frequencies);
  });
  return spacing;
}

CurveCoverage measure_joined_coverage(const DistributedSurface& surface, const Polylines& lines,
                                      double width) {
  const RankSurface& own = surface.rank_surface();
  Communicator& ranks = *own.ranks;
  AreaShare share;
  int rank = 0;
  for (const double area : ranks.all(area_of(own.mesh))) {
    if (rank == ranks.rank()) share.before = share.all;
    share.all += area;
    if (rank++ == ranks.rank()) share.behind = share.all;
  }
  const std::vector<Eigen::Vector3d> places = coverage_places(own.mesh, share);
  const auto of_all = joined<Eigen::Vector3d>(
      ranks.gather(std::as_bytes(std::span<const Eigen::Vector3d>(places))));
  CurveCoverage coverage;
  ranks.together([&] { coverage = measure_coverage(of_all, lines, width); });
  return coverage;
}

}  // namespace brindle
