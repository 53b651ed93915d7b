#include "brindle/distributed/shifted_phases.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "brindle/base/elementary.h"
#include "brindle/distributed/surface/rank_surface.h"
#include "brindle/orientation.h"
#include "brindle/pattern/stripe_curves.h"

namespace brindle {
namespace {

constexpr std::uint64_t kNoGroup = std::numeric_limits<std::uint64_t>::max();

/// Vertices of one rank that are joined by waves and run alike.
struct Group {
  std::uint64_t number;        ///< among all ranks'
  std::uint64_t first_vertex;  ///< the lowest number of its vertices in the whole
  std::int64_t sign;           ///< that this one was given: -1 if it was turned round
};

/// How far two groups run alike where they meet.
struct Agreement {
  std::uint64_t one, other;
  double sum;
};

/// On rank 0: what turns all groups so that they run alike.
std::map<std::uint64_t, std::int64_t> signs_of(std::vector<Group> groups,
                                               const std::vector<Agreement>& agreements) {
  std::map<std::uint64_t, std::map<std::uint64_t, double>> beside;
  for (const Agreement& a : agreements) {
    beside[a.one][a.other] += a.sum;
    beside[a.other][a.one] += a.sum;
  }
  // The first vertex of all keeps its direction, as in one process.
  std::ranges::sort(groups, {}, &Group::first_vertex);
  std::map<std::uint64_t, std::int64_t> signs;
  for (const Group& start : groups) {
    if (signs.contains(start.number)) continue;
    signs[start.number] = start.sign;
    std::vector<std::uint64_t> queue = {start.number};
    for (std::size_t next = 0; next < queue.size(); ++next) {
      for (const auto& [other, ignored] : beside[queue[next]]) {
        if (signs.contains(other)) continue;
        double agreement = 0;
        for (const auto& [known, sum] : beside[other]) {
          const auto sign = signs.find(known);
          if (sign != signs.end()) agreement += static_cast<double>(sign->second) * sum;
        }
        signs[other] = agreement < 0 ? -1 : 1;
        queue.push_back(other);
      }
    }
  }
  return signs;
}

/// Lets directions of all ranks run alike.
class RankOrientation {
 public:
  RankOrientation(const RankSurface& surface, std::vector<Vec3> own_directions)
      : surface_(surface),
        adjacency_(*surface.graph.adjacency),
        ranks_(*surface.ranks),
        directions_(std::move(own_directions)) {
    const std::vector<Vec3> before = directions_;
    orient_alike(adjacency_, directions_);
    find_groups(before);
    turn_groups();
  }

  /// By node; ghosts have those of their owners.
  const std::vector<Vec3>& directions() const { return directions_; }

  /// Edges of all ranks across which directions do not run alike.
  std::size_t reflecting() const {
    std::size_t inside = 0, across = 0;
    for (Index i = 0; i < surface_.graph.own; ++i) {
      for (const Index j : adjacency_.of(i)) {
        if (!(directions_[i].dot(directions_[j]) < 0)) continue;
        inside += j < i && j < surface_.graph.own;
        across += j >= surface_.graph.own;
      }
    }
    return ranks_.sum(inside) + ranks_.sum(across) / 2;
  }

 private:
  void find_groups(const std::vector<Vec3>& before) {
    const std::vector<std::uint64_t> ids = known_ids(surface_);
    group_.assign(directions_.size(), kNoGroup);
    for (Index start = 0; start < surface_.graph.own; ++start) {
      if (group_[start] != kNoGroup || directions_[start].isZero(0)) continue;
      Group group{groups_.size(), ids[start], 1};
      std::vector<Index> queue = {start};
      group_[start] = group.number;
      for (std::size_t next = 0; next < queue.size(); ++next) {
        const Index v = queue[next];
        if (ids[v] <= group.first_vertex) {
          group.first_vertex = ids[v];
          group.sign = directions_[v] == before[v] ? 1 : -1;
        }
        for (const Index other : adjacency_.of(v)) {
          const bool known = other >= surface_.graph.own || group_[other] != kNoGroup;
          if (known || directions_[other].isZero(0)) continue;
          group_[other] = group.number;
          queue.push_back(other);
        }
      }
      groups_.push_back(group);
    }
    const std::vector<std::size_t> counts = ranks_.all(groups_.size());
    for (int r = 0; r < ranks_.rank(); ++r) first_group_ += counts[static_cast<std::size_t>(r)];
    for (Group& group : groups_) group.number += first_group_;
    for (std::uint64_t& group : group_) group += group == kNoGroup ? 0 : first_group_;
    counts_ = counts;
  }

  std::vector<Agreement> agreements() {
    exchange(ranks_, surface_.graph.halo, std::span(directions_));
    exchange(ranks_, surface_.graph.halo, std::span(group_));
    std::map<std::pair<std::uint64_t, std::uint64_t>, double> sums;
    for (Index i = 0; i < surface_.graph.own; ++i) {
      for (const Index j : adjacency_.of(i)) {
        if (j < surface_.graph.own || group_[i] == kNoGroup || group_[j] == kNoGroup) continue;
        sums[{group_[i], group_[j]}] += static_cast<double>(directions_[i].dot(directions_[j]));
      }
    }
    std::vector<Agreement> list;
    for (const auto& [groups, sum] : sums) list.push_back({groups.first, groups.second, sum});
    return list;
  }

  void turn_groups() {
    const std::vector<Agreement> own = agreements();
    auto all_groups = joined<Group>(ranks_.gather(std::as_bytes(std::span(groups_))));
    const auto all = joined<Agreement>(ranks_.gather(std::as_bytes(std::span(own))));
    std::vector<std::vector<std::int64_t>> outgoing(static_cast<std::size_t>(ranks_.size()));
    if (ranks_.rank() == 0) {
      std::uint64_t number = 0;
      const auto signs = signs_of(std::move(all_groups), all);
      for (std::size_t r = 0; r < outgoing.size(); ++r) {
        for (std::size_t g = 0; g < counts_[r]; ++g) outgoing[r].push_back(signs.at(number++));
      }
    }
    const auto incoming = ranks_.swap_lists(outgoing);
    for (Index v = 0; v < surface_.graph.own; ++v) {
      if (group_[v] == kNoGroup) continue;
      if (incoming[0][group_[v] - first_group_] < 0) directions_[v] = -directions_[v];
    }
    exchange(ranks_, surface_.graph.halo, std::span(directions_));
  }

  const RankSurface& surface_;
  const Adjacency& adjacency_;
  Communicator& ranks_;
  std::vector<Vec3> directions_;      // by node
  std::vector<std::uint64_t> group_;  // by node
  std::vector<Group> groups_;         // of this rank
  std::vector<std::size_t> counts_;   // of groups of all ranks
  std::uint64_t first_group_ = 0;
};

}  // namespace

std::size_t shift_phases(const DistributedSurface& distributed, float periods, WaveSet& waves,
                         std::span<Complex> z) {
  const RankSurface& surface = distributed.rank_surface();
  const bool either_way = std::round(2 * periods) == 2 * periods;
  if (either_way || surface.ranks->size() == 1) {
    return shift_phases(*surface.graph.adjacency, periods, waves, z);
  }
  std::vector<Vec3> own(surface.graph.node_count(), Vec3::Zero());
  std::vector<Complex> turned(surface.vertex_count());
  for (std::size_t p = 0; p < surface.vertex_of_piece.size(); ++p) {
    const Index v = surface.vertex_of_piece[p];
    if (v >= surface.graph.own) continue;
    own[v] = waves.directions[p];
    turned[v] = z[p];
  }
  const std::vector<Vec3> before = own;
  const RankOrientation orientation(surface, std::move(own));
  std::vector<Vec3> directions = orientation.directions();
  directions.resize(surface.vertex_count(), Vec3::Zero());
  for (Index v = 0; v < surface.graph.own; ++v) {
    if (directions[v].dot(before[v]) < 0) turned[v] = -std::conj(turned[v]);
  }
  surface.exchange_all(std::span(directions));
  surface.exchange_all(std::span(turned));
  waves.directions = surface.to_piece(std::span<const Vec3>(directions));
  std::ranges::copy(surface.to_piece(std::span<const Complex>(turned)), z.begin());
  const float turn = -2 * std::numbers::pi_v<float> * (periods - std::floor(periods));
  for (Complex& value : z) value *= elementary::polar(1.0f, turn);
  return orientation.reflecting();
}

}  // namespace brindle
