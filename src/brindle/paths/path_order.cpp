#include "brindle/paths/path_order.h"

#include <algorithm>
#include <cstddef>
#include <deque>
#include <functional>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "brindle/base/standard.h"
#include "brindle/geometry/box_tree.h"
#include "brindle/polylines.h"
#include "brindle/types.h"

namespace brindle {
namespace {

// Search for the ends of lines.

/// A point at which a line may begin.
struct LineStart {
  Vec3 point;
  Index line = 0;  ///< its place in `chosen`
};

/// Squared distances in float are this near to those of boxes.
constexpr double kRounding = 1 + 1e-6;

BoxTree tree_of(std::span<const LineStart> ends) {
  return {ends.size(), [&](Index i) { return BoundingBox{ends[i].point, ends[i].point}; }};
}

/// Both ends of open lines, and some points of closed ones.
class LineStarts {
 public:
  LineStarts(const Polylines& lines, std::span<const Index> chosen)
      : ends_(starts_of(lines, chosen)),
        tree_(tree_of(ends_)),
        in_tree_(chosen.size()),
        taken_(chosen.size()) {}

  std::span<const LineStart> all() const { return ends_; }

  /// The nearest one of lines that are left; of several, the first one. There must be one.
  const LineStart& nearest(const Vec3& point) const {
    std::pair<float, Index> found(std::numeric_limits<float>::infinity(), 0);
    tree_.visit(
        point.cast<double>(),
        [&](const BoundingBox&, double square) { return square <= kRounding * found.first; },
        [&](Index i) {
          if (is_taken(ends_[i].line)) return;
          found = std::min(found, std::pair((ends_[i].point - point).squaredNorm(), i));
        });
    return ends_[found.second];
  }

  /// Takes a line out of the search.
  void take(Index line) {
    taken_[line] = true;
    if (2 * ++taken_in_tree_ < in_tree_) return;
    std::erase_if(ends_, [&](const LineStart& end) { return is_taken(end.line); });
    tree_ = tree_of(ends_);
    in_tree_ -= std::exchange(taken_in_tree_, 0);
  }
  bool is_taken(Index line) const { return taken_[line]; }

 private:
  static std::vector<LineStart> starts_of(const Polylines& lines, std::span<const Index> chosen) {
    constexpr std::size_t kMostOfClosed = 16;
    std::vector<LineStart> ends;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      const std::span<const Vec3> points = lines.points_of(chosen[i]);
      const std::size_t last = points.size() - 1;
      const std::size_t step = lines.closed[chosen[i]]
                                   ? (points.size() + kMostOfClosed - 1) / kMostOfClosed
                                   : std::max<std::size_t>(last, 1);
      for (std::size_t p = 0; p <= last; p += step) {
        ends.push_back({points[p], static_cast<Index>(i)});
      }
    }
    return ends;
  }

  std::vector<LineStart> ends_;
  BoxTree tree_;
  std::size_t in_tree_, taken_in_tree_ = 0;  // lines
  std::vector<bool> taken_;                  // per line
};

constexpr std::size_t kLinesPerReport = 256;

double distance(const Vec3& a, const Vec3& b) {
  return (a.cast<double>() - b.cast<double>()).norm();
}

const Vec3& point_of(const Polylines& lines, const PlacedLine& placed, bool at_end) {
  const std::span<const Vec3> points = lines.points_of(placed.line);
  if (lines.closed[placed.line]) return points[placed.first];
  return placed.reversed != at_end ? points.back() : points.front();
}

/// The end farthest from the mean of all.
Vec3 outermost(std::span<const LineStart> ends) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const LineStart& end : ends) mean += end.point.cast<double>();
  mean /= static_cast<double>(ends.size());
  return ranges::max_element(
             ends, {},
             [&](const LineStart& end) { return (end.point.cast<double>() - mean).squaredNorm(); })
      ->point;
}

/// A line that begins at one of its points: of closed lines, at the nearest one.
PlacedLine begun_near(const Polylines& lines, Index line, const Vec3& from) {
  const std::span<const Vec3> points = lines.points_of(line);
  const auto square = [&](const Vec3& point) { return (point - from).squaredNorm(); };
  if (!lines.closed[line]) return {line, square(points.back()) < square(points.front())};
  const auto near = ranges::max_element(points, std::greater<>(), square);
  return {line, false, static_cast<Index>(near - points.begin())};
}

/// Of the lines beside `last` that are left, the one whose nearest end is nearest to `from`.
const Index* next_beside(const Polylines& lines, std::span<const Index> chosen,
                         const LineStarts& ends, std::span<const Index> beside, const Vec3& from) {
  const Index* next = nullptr;
  float least = std::numeric_limits<float>::infinity();
  for (const Index& other : beside) {
    if (ends.is_taken(other)) continue;
    const PlacedLine placed = begun_near(lines, chosen[other], from);
    const float square = (begin_of(lines, placed) - from).squaredNorm();
    if (square < least) least = square, next = &other;
  }
  return next;
}

}  // namespace

const Vec3& begin_of(const Polylines& lines, const PlacedLine& placed) {
  return point_of(lines, placed, false);
}

const Vec3& end_of(const Polylines& lines, const PlacedLine& placed) {
  return point_of(lines, placed, true);
}

double travel_of(const Polylines& lines, std::span<const PlacedLine> order,
                 const std::optional<Vec3>& start) {
  double travel = 0;
  const Vec3* from = start ? &*start : nullptr;
  for (const PlacedLine& placed : order) {
    if (from != nullptr) travel += distance(*from, begin_of(lines, placed));
    from = &end_of(lines, placed);
  }
  return travel;
}

std::vector<PlacedLine> nearest_order(const Polylines& lines, std::span<const Index> chosen,
                                      const std::optional<Vec3>& start, const LinesBeside& beside,
                                      const Progress& progress) {
  std::vector<PlacedLine> order;
  if (chosen.empty()) return order;
  LineStarts ends(lines, chosen);
  Vec3 from = start ? *start : outermost(ends.all());
  Index last = 0;
  while (order.size() < chosen.size()) {
    if (order.size() % kLinesPerReport == 0) {
      progress.report(static_cast<double>(order.size()) / static_cast<double>(chosen.size()));
    }
    const Index* next = order.empty() || beside.empty()
                            ? nullptr
                            : next_beside(lines, chosen, ends, beside[last], from);
    last = next != nullptr ? *next : ends.nearest(from).line;
    ends.take(last);
    order.push_back(begun_near(lines, chosen[last], from));
    from = end_of(lines, order.back());
  }
  return order;
}

namespace {

/// Positions count lines in the order; an end is 2 * id + side of a line whose `id` never changes.
class TravelShortener {
 public:
  TravelShortener(const Polylines& lines, std::vector<PlacedLine>& order,
                  const std::optional<Vec3>& start)
      : start_(start ? &*start : nullptr), order_(order), count_(order.size()) {
    for (std::size_t i = 0; i < count_; ++i) {
      points_.push_back(begin_of(lines, order[i]));
      points_.push_back(end_of(lines, order[i]));
      entry_.push_back(static_cast<Index>(2 * i));
      position_.push_back(i);
    }
  }

  void run(const Progress& progress) {
    count_ <= kMostExact ? solve_exactly() : improve(progress);
    std::vector<PlacedLine> result;
    for (const Index entry : entry_) {
      PlacedLine placed = order_[entry / 2];
      placed.reversed ^= entry % 2 == 1;
      result.push_back(placed);
    }
    order_ = std::move(result);
  }

 private:
  static constexpr std::size_t kMostExact = 8;
  static constexpr std::size_t kNeighbors = 8;
  static constexpr std::ptrdiff_t kLongestMoved = 3;
  // Runs that are reversed or passed over are shorter, so that many lines do not take for ever.
  static constexpr std::ptrdiff_t kLongestRun = 50'000;

  using Place = std::ptrdiff_t;

  const Vec3* entry(Place at) const {
    return at < static_cast<Place>(count_) ? &points_[entry_[static_cast<std::size_t>(at)]]
                                           : nullptr;
  }
  const Vec3* exit(Place at) const {
    return at < 0 ? start_ : &points_[entry_[static_cast<std::size_t>(at)] ^ 1];
  }
  static double gap(const Vec3* from, const Vec3* to) {
    return from == nullptr || to == nullptr ? 0 : distance(*from, *to);
  }
  double before(Place at) const { return gap(exit(at - 1), entry(at)); }

  void queue(Place at) {
    if (at < 0 || at >= static_cast<Place>(count_)) return;
    const Index id = entry_[static_cast<std::size_t>(at)] / 2;
    for (const Index end : {2 * id, 2 * id + 1}) {
      if (waiting_[end]) continue;
      waiting_[end] = true;
      queue_.push_back(end);
    }
  }

  void improve(const Progress& progress) {
    const BoxTree tree(points_.size(), [&](Index e) {
      return BoundingBox{points_[e], points_[e]};
    });
    for (Index e = 0; e < points_.size(); ++e) near_.push_back(nearest_of_others(tree, e));
    waiting_.resize(points_.size());
    for (std::size_t i = 0; i < count_; ++i) queue(static_cast<Place>(i));
    for (std::size_t done = 0; !queue_.empty(); ++done) {
      if (done % kLinesPerReport == 0) {
        // The number of moves is unknown: the fraction approaches 1 ever more slowly.
        const auto all = static_cast<double>(2 * points_.size());
        progress.report(static_cast<double>(done) / (all + static_cast<double>(done)));
      }
      const Index end = queue_.front();
      queue_.pop_front();
      waiting_[end] = false;
      while (improve_at(end)) {
      }
    }
  }

  /// Up to `kNeighbors` ends of other lines, the nearest first.
  std::vector<Index> nearest_of_others(const BoxTree& tree, Index end) const {
    std::vector<std::pair<float, Index>> found;
    tree.visit(
        points_[end].cast<double>(),
        [&](const BoundingBox&, double square) {
          return found.size() < kNeighbors || square <= kRounding * found.back().first;
        },
        [&](Index other) {
          const std::pair here((points_[other] - points_[end]).squaredNorm(), other);
          const bool is_full = found.size() == kNeighbors;
          if (other / 2 == end / 2 || (is_full && here >= found.back())) return;
          if (is_full) found.pop_back();
          found.insert(std::upper_bound(found.begin(), found.end(), here), here);
        });
    std::vector<Index> ends;
    for (const auto& near : found) ends.push_back(near.second);
    return ends;
  }

  /// Tries to link an end with ends that are nearer than the one after or before it in the order.
  bool improve_at(Index end) {
    const auto at = static_cast<Place>(position_[end / 2]);
    const bool is_exit = entry_[position_[end / 2]] != end;
    const double now = before(is_exit ? at + 1 : at);
    for (const Index other : near_[end]) {
      if (distance(points_[end], points_[other]) >= now) return false;
      const auto there = static_cast<Place>(position_[other / 2]);
      const bool other_is_exit = entry_[position_[other / 2]] != other;
      if (is_exit == other_is_exit) {
        const Place first = std::min(at, there) + (is_exit ? 1 : 0);
        if (reverse(first, std::max(at, there) - (is_exit ? 0 : 1))) return true;
      }
      if (move_to(there, other_is_exit, at, is_exit)) return true;
      if (move_to(at, is_exit, there, other_is_exit)) return true;
    }
    return false;
  }

  static bool helps(double before, double after) { return after < before * (1 - 1e-9); }

  bool reverse(Place first, Place last) {
    if (last - first > kLongestRun) return false;
    const double now = before(first) + before(last + 1);
    const double then = gap(exit(first - 1), exit(last)) + gap(entry(first), entry(last + 1));
    if (!helps(now, then)) return false;
    turn(first, last);
    for (const Place at : {first - 1, first, last, last + 1}) queue(at);
    return true;
  }

  /// Moves up to three lines, of which the one at `at` comes next to the end at `there`.
  bool move_to(Place at, bool from_exit, Place there, bool to_exit) {
    const Place gap_at = to_exit ? there + 1 : there;
    for (Place more = 0; more < kLongestMoved; ++more) {
      const Place first = from_exit ? at - more : at, last = from_exit ? at : at + more;
      if (first < 0 || last >= static_cast<Place>(count_)) return false;
      if (gap_at >= first && gap_at <= last + 1) return false;
      if (move(first, last, gap_at, from_exit == to_exit)) return true;
    }
    return false;
  }

  /// Moves lines before the one at `target`.
  bool move(Place first, Place last, Place target, bool reversed) {
    if (std::max(last, target) - std::min(first, target) > kLongestRun) return false;
    const Vec3* head = reversed ? exit(last) : entry(first);
    const Vec3* tail = reversed ? entry(first) : exit(last);
    const double now = before(first) + before(last + 1) + before(target);
    const double then = gap(exit(first - 1), entry(last + 1)) + gap(exit(target - 1), head) +
                        gap(tail, entry(target));
    if (!helps(now, then)) return false;
    const Place size = last - first + 1;
    const bool later = target > last;
    const Place begin = later ? first : target, middle = later ? last + 1 : first,
                end = later ? target : last + 1;
    std::rotate(entry_.begin() + begin, entry_.begin() + middle, entry_.begin() + end);
    const Place moved = later ? target - size : target;
    if (reversed) turn(moved, moved + size - 1);
    renumber(begin, end);
    for (const Place at : {begin - 1, begin, begin + size - 1, begin + size, end - size - 1,
                           end - size, end - 1, end}) {
      queue(at);
    }
    return true;
  }

  void turn(Place first, Place last) {
    std::reverse(entry_.begin() + first, entry_.begin() + last + 1);
    for (Place at = first; at <= last; ++at) entry_[static_cast<std::size_t>(at)] ^= 1;
    renumber(first, last + 1);
  }

  void renumber(Place begin, Place end) {
    for (auto at = static_cast<std::size_t>(begin); at < static_cast<std::size_t>(end); ++at) {
      position_[entry_[at] / 2] = at;
    }
  }

  /// All orders, by dynamic programming over sets of lines (Held and Karp 1962).
  void solve_exactly() {
    constexpr double kNever = std::numeric_limits<double>::infinity();
    const std::size_t sets = std::size_t{1} << count_, ends = 2 * count_;
    // Of the shortest travel through a set that leaves its last line, entered at `e`.
    std::vector<double> travel(sets * ends, kNever);
    std::vector<std::size_t> previous(sets * ends, ends);
    for (std::size_t e = 0; e < ends; ++e) {
      travel[(std::size_t{1} << e / 2) * ends + e] = gap(start_, &points_[e]);
    }
    for (std::size_t set = 1; set < sets; ++set) {
      for (std::size_t e = 0; e < ends; ++e) {
        const double now = travel[set * ends + e];
        if (now == kNever) continue;
        for (std::size_t next = 0; next < ends; ++next) {
          if ((set >> next / 2 & 1) != 0) continue;
          const std::size_t state = (set | std::size_t{1} << next / 2) * ends + next;
          const double then = now + distance(points_[e ^ 1], points_[next]);
          if (then < travel[state]) travel[state] = then, previous[state] = e;
        }
      }
    }
    std::size_t set = sets - 1;
    const auto last = travel.end() - static_cast<std::ptrdiff_t>(ends);
    auto e = static_cast<std::size_t>(std::min_element(last, travel.end()) - last);
    for (std::size_t at = count_; at-- > 0;) {
      entry_[at] = static_cast<Index>(e);
      const std::size_t before = previous[set * ends + e];
      set &= ~(std::size_t{1} << e / 2);
      e = before;
    }
  }

  const Vec3* start_;
  std::vector<PlacedLine>& order_;
  std::size_t count_;
  std::vector<Vec3> points_;           // of all ends
  std::vector<Index> entry_;           // by position: the end at which the line there begins
  std::vector<std::size_t> position_;  // by id
  std::vector<std::vector<Index>> near_;
  std::vector<bool> waiting_;
  std::deque<Index> queue_;
};

/// Lets closed lines begin where the travel to and from them is least. Returns whether any moved.
bool turn_closed(const Polylines& lines, std::vector<PlacedLine>& order,
                 const std::optional<Vec3>& start) {
  bool moved = false;
  for (std::size_t i = 0; i < order.size(); ++i) {
    PlacedLine& placed = order[i];
    if (!lines.closed[placed.line]) continue;
    const Vec3* from = i > 0 ? &end_of(lines, order[i - 1]) : start ? &*start : nullptr;
    const Vec3* to = i + 1 < order.size() ? &begin_of(lines, order[i + 1]) : nullptr;
    const std::span<const Vec3> points = lines.points_of(placed.line);
    const auto travel = [&](const Vec3& point) {
      return (from != nullptr ? distance(*from, point) : 0) +
             (to != nullptr ? distance(point, *to) : 0);
    };
    const auto best = ranges::max_element(points, std::greater<>(), travel);
    if (!(travel(*best) < travel(points[placed.first]) * (1 - 1e-6))) continue;
    placed.first = static_cast<Index>(best - points.begin());
    moved = true;
  }
  return moved;
}

}  // namespace

void shorten_travel(const Polylines& lines, std::vector<PlacedLine>& order,
                    const std::optional<Vec3>& start, const Progress& progress) {
  constexpr int kMostRounds = 4;
  const bool turns = ranges::any_of(
      order, [&](const PlacedLine& placed) { return lines.closed[placed.line] != 0; });
  for (int round = 0; round < kMostRounds && order.size() > 1; ++round) {
    TravelShortener(lines, order, start)
        .run(progress.part(static_cast<double>(round) / kMostRounds,
                           turns ? (round + 1.0) / kMostRounds : 1));
    if (!turns || !turn_closed(lines, order, start)) break;
  }
}

}  // namespace brindle
