#include "brindle/distributed/curves/rank_walks.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "brindle/error.h"

namespace brindle {
namespace {

/// Crossings of walks are numbered apart from those of waves, of which an edge has fewer.
constexpr std::uint32_t kFirstOfWalks = std::uint32_t{1} << 31;

/// The numbers of an edge's ends in the whole.
using EdgeIds = std::array<std::uint64_t, 2>;

/// A walk on its way to the next rank, and the point on the edge that it comes over.
struct SentWalk {
  EdgeIds edge;
  std::uint32_t crossing;
  std::uint32_t origin, walk;  // the rank that it began on, and its number there
  std::uint32_t triangles;
  CurveEnd reason;
  std::array<double, 3> direction;
  std::array<double, 2> between;
  double reach, passed;
  std::array<float, 3> position, normal;
  float size;
};

/// How a walk has ended, as its first rank hears of it.
struct EndedWalk {
  std::uint32_t walk;
  bool met;
  double passed;
};

/// A walk's way through one rank.
struct Leg {
  std::uint32_t origin, walk;
  CutCurve curve;
};

std::array<float, 3> numbers(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

/// Which ranks have the two triangles of an edge between pieces; rank (lower number mod ranks)
/// knows.
class BorderRanks {
 public:
  BorderRanks(Communicator& ranks, const RankTriangles& triangles,
              std::span<const EdgeBeyond> beyond)
      : ranks_(ranks) {
    std::vector<std::vector<EdgeIds>> outgoing(size());
    for (Index e = 0; e < beyond.size(); ++e) {
      if (beyond[e] != EdgeBeyond::triangle) continue;
      const auto [a, b] = triangles.edges.vertices[e];
      const EdgeIds edge = {triangles.ids[a], triangles.ids[b]};
      own_[edge] = e;
      outgoing[knows(edge)].push_back(edge);
    }
    const auto incoming = ranks_.swap_lists(outgoing);
    for (std::size_t r = 0; r < incoming.size(); ++r) {
      for (const EdgeIds& edge : incoming[r]) holders_[edge].push_back(r);
    }
  }

  /// This rank's number of the edge.
  Index own(const EdgeIds& edge) const { return own_.at(edge); }

  /// Collective: brings walks over their edges.
  std::vector<SentWalk> pass_on(const std::vector<SentWalk>& walks) {
    std::vector<std::vector<SentWalk>> outgoing(size()), forwarded(size());
    for (const SentWalk& walk : walks) outgoing[knows(walk.edge)].push_back(walk);
    const auto incoming = ranks_.swap_lists(outgoing);
    for (std::size_t r = 0; r < incoming.size(); ++r) {
      for (const SentWalk& walk : incoming[r]) {
        const std::vector<std::size_t>& both = holders_.at(walk.edge);
        forwarded[both[0] == r ? both.back() : both[0]].push_back(walk);
      }
    }
    std::vector<SentWalk> arrived;
    for (const auto& list : ranks_.swap_lists(forwarded)) {
      arrived.insert(arrived.end(), list.begin(), list.end());
    }
    return arrived;
  }

 private:
  std::size_t size() const { return static_cast<std::size_t>(ranks_.size()); }
  std::size_t knows(const EdgeIds& edge) const { return edge[0] % size(); }

  Communicator& ranks_;
  std::map<EdgeIds, Index> own_;
  std::map<EdgeIds, std::vector<std::size_t>> holders_;
};

/// The walks of all ranks, until every one has met a curve or is lost.
class RankWalks {
 public:
  RankWalks(Communicator& ranks, const RankTriangles& triangles, const LiftedWaves& waves,
            std::span<const EdgeBeyond> beyond, CutCurves& curves)
      : ranks_(ranks),
        triangles_(triangles),
        waves_(waves),
        borders_(ranks, triangles, beyond),
        end_walks_(waves, beyond),
        curves_(curves) {}

  /// Collective.
  void go() {
    ranks_.together([&] { begin(); });
    while (ranks_.any(!leaving_.empty())) {
      const std::vector<SentWalk> arrived = borders_.pass_on(std::exchange(leaving_, {}));
      ranks_.together([&] {
        for (const SentWalk& walk : arrived) go_on(walk);
      });
    }
    hear_of_ends();
    choose();
    keep_chosen_legs();
  }

 private:
  /// An end of a curve that waits for two walks, which have the numbers 2 i and 2 i + 1.
  struct Waiting {
    std::size_t curve, end;
    std::array<std::optional<CutCurve::Crossing>, 2> left;  // the piece, there
    std::optional<std::size_t> chosen;
  };

  std::array<Walk, 2>& walks(const Waiting& end) {
    return *curves_.curves[end.curve].walks[end.end];
  }

  void begin() {
    for (std::size_t c = 0; c < curves_.curves.size(); ++c) {
      for (std::size_t e = 0; e < 2; ++e) {
        if (!curves_.curves[c].walks[e]) continue;
        Waiting& end = waiting_.emplace_back(Waiting{c, e, {}, {}});
        for (std::uint32_t side = 0; side < 2; ++side) {
          const Walk& walk = walks(end)[side];
          if (walk.state != Walk::State::beyond) continue;
          const auto number = static_cast<std::uint32_t>(2 * (waiting_.size() - 1) + side);
          const CurvePoint last = point_in_triangle(waves_.pattern(), walk.way.back());
          end.left[side] = leave(walk, last, static_cast<std::uint32_t>(ranks_.rank()), number,
                                 curves_.curves[c].ends[e]);
        }
      }
    }
  }

  /// Where a walk crosses the border, on its way to another rank.
  CutCurve::Crossing leave(const Walk& walk, const CurvePoint& last, std::uint32_t origin,
                           std::uint32_t number, CurveEnd reason) {
    const auto size = static_cast<std::uint32_t>(ranks_.size());
    if (left_ >= kFirstOfWalks / size) throw Error("too many curves run on into their neighbours");
    const std::uint32_t crossing =
        kFirstOfWalks + left_++ * size + static_cast<std::uint32_t>(ranks_.rank());
    const auto [a, b] = triangles_.edges.vertices[walk.edge];
    leaving_.push_back({{triangles_.ids[a], triangles_.ids[b]},
                        crossing,
                        origin,
                        number,
                        walk.triangles,
                        reason,
                        {walk.direction.x(), walk.direction.y(), walk.direction.z()},
                        walk.between,
                        walk.reach,
                        walk.passed,
                        numbers(last.position),
                        numbers(last.normal),
                        last.size});
    return {walk.edge, crossing};
  }

  void go_on(const SentWalk& sent) {
    Walk before;
    before.direction = Eigen::Vector3d(sent.direction.data());
    before.reach = sent.reach;
    before.passed = sent.passed;
    before.triangles = sent.triangles;
    before.between = sent.between;
    const Index edge = borders_.own(sent.edge);
    const Walk walk = end_walks_.go_on(before, edge);
    Leg& leg = legs_.emplace_back(Leg{sent.origin, sent.walk, {}});
    leg.curve.ends = {sent.reason, sent.reason};
    leg.curve.cuts[0] = {edge, sent.crossing};
    add_points(walk, leg.curve.points);
    // To the bit as where it comes from.
    leg.curve.points.front().position = Vec3(sent.position.data());
    leg.curve.points.front().normal = Vec3(sent.normal.data());
    leg.curve.points.front().size = sent.size;
    if (walk.state == Walk::State::beyond) {
      leg.curve.cuts[1] = leave(walk, leg.curve.points.back(), sent.origin, sent.walk, sent.reason);
    } else {
      ended_.emplace_back(sent.origin,
                          EndedWalk{sent.walk, walk.state == Walk::State::met, walk.passed});
    }
  }

  void add_points(const Walk& walk, std::vector<CurvePoint>& points) const {
    for (const TrianglePoint& place : walk.way) {
      points.push_back(point_in_triangle(waves_.pattern(), place));
    }
  }

  /// Collective: walks that began here and ended elsewhere.
  void hear_of_ends() {
    std::vector<std::vector<EndedWalk>> outgoing(static_cast<std::size_t>(ranks_.size()));
    for (const auto& [origin, walk] : ended_) outgoing[origin].push_back(walk);
    for (const auto& list : ranks_.swap_lists(outgoing)) {
      for (const EndedWalk& ended : list) {
        Walk& walk = walks(waiting_[ended.walk / 2])[ended.walk % 2];
        walk.state = ended.met ? Walk::State::met : Walk::State::lost;
        walk.passed = ended.passed;
      }
    }
  }

  void choose() {
    for (Waiting& end : waiting_) {
      end.chosen = shorter(walks(end)[0], walks(end)[1]);
      if (!end.chosen) continue;
      ++curves_.ends_at_neighbors;
      CutCurve& curve = curves_.curves[end.curve];
      curve.cuts[end.end] = end.left[*end.chosen];
      // Ways lead away from the curve.
      if (end.end == 0) std::ranges::reverse(curve.points);
      add_points(walks(end)[*end.chosen], curve.points);
      if (end.end == 0) std::ranges::reverse(curve.points);
    }
  }

  /// Collective: legs here of walks that were chosen where they began.
  void keep_chosen_legs() {
    const auto size = static_cast<std::size_t>(ranks_.size());
    std::vector<std::vector<std::uint32_t>> asked(size);
    for (const Leg& leg : legs_) asked[leg.origin].push_back(leg.walk);
    std::vector<std::vector<std::uint8_t>> answers(size);
    const auto incoming = ranks_.swap_lists(asked);
    for (std::size_t r = 0; r < size; ++r) {
      for (const std::uint32_t walk : incoming[r]) {
        answers[r].push_back(waiting_[walk / 2].chosen == walk % 2 ? 1 : 0);
      }
    }
    const auto chosen = ranks_.swap_lists(answers);
    std::vector<std::size_t> next(size);
    for (Leg& leg : legs_) {
      if (chosen[leg.origin][next[leg.origin]++] == 0) continue;
      curves_.curves.push_back(std::move(leg.curve));
    }
  }

  Communicator& ranks_;
  const RankTriangles& triangles_;
  const LiftedWaves& waves_;
  BorderRanks borders_;
  EndWalks end_walks_;
  CutCurves& curves_;
  std::vector<Waiting> waiting_;
  std::vector<SentWalk> leaving_;
  std::vector<Leg> legs_;
  std::vector<std::pair<std::uint32_t, EndedWalk>> ended_;  // by the rank that they began on
  std::uint32_t left_ = 0;                                  // how many walks have left so far
};

}  // namespace

void continue_ends(const RankSurface& surface, const RankTriangles& triangles,
                   const LiftedWaves& waves, std::span<const EdgeBeyond> beyond,
                   CutCurves& curves) {
  RankWalks(*surface.ranks, triangles, waves, beyond, curves).go();
}

}  // namespace brindle
