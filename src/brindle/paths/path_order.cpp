#include "brindle/paths/path_order.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <functional>
#include <limits>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "brindle/base/standard.h"
#include "brindle/polylines.h"
#include "brindle/types.h"

namespace brindle {
namespace {

// Search for the ends of lines.

/// A point at which a line may begin.
struct LineStart {
  Vec3 point;
  Index line = 0;   ///< its place in `chosen`
  Index first = 0;  ///< number of the point in the line
};

/// Both ends of open lines, and some points of closed ones, in a k-d tree.
class LineStarts {
 public:
  LineStarts(const Polylines& lines, std::span<const Index> chosen);
  explicit LineStarts(std::vector<LineStart> ends, std::size_t line_count);

  const LineStart& operator[](std::size_t end) const { return ends_[end]; }
  std::span<const LineStart> all() const { return ends_; }

  /// The nearest one of lines that are left; of several, the one with the smallest number. There
  /// must be one.
  std::size_t nearest(const Vec3& point) const;

  /// Up to `count` ends of other lines than `line`, the nearest first.
  std::vector<Index> nearest_of_others(const Vec3& point, Index line, std::size_t count) const;

  /// Takes a line out of the search.
  void take(Index line);
  bool is_taken(Index line) const { return taken_[line]; }

 private:
  template <class Visit>
  void search(std::size_t begin, std::size_t end, int axis, const Vec3& point,
              const Visit& visit) const;
  void build(std::size_t begin, std::size_t end, int axis);
  void build_all(std::size_t line_count);
  void count_out(std::size_t place);

  std::vector<LineStart> ends_;
  std::vector<std::size_t> tree_;    // numbers of ends; the middle of a range is its node
  std::vector<std::size_t> place_;   // of every end in `tree_`
  std::vector<std::size_t> left_;    // ends that are left in every node
  std::vector<std::size_t> begins_;  // of every line in `ends_`
  std::vector<bool> taken_;          // per line
};

constexpr std::size_t kMostOfClosed = 16;

LineStarts::LineStarts(const Polylines& lines, std::span<const Index> chosen) {
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const auto line = static_cast<Index>(i);
    const std::span<const Vec3> points = lines.points_of(chosen[i]);
    const std::size_t last = points.size() - 1;
    const std::size_t step = lines.closed[chosen[i]]
                                 ? (points.size() + kMostOfClosed - 1) / kMostOfClosed
                                 : std::max<std::size_t>(last, 1);
    for (std::size_t p = 0; p <= last; p += step) {
      ends_.push_back({points[p], line, static_cast<Index>(p)});
    }
  }
  build_all(chosen.size());
}

LineStarts::LineStarts(std::vector<LineStart> ends, std::size_t line_count)
    : ends_(std::move(ends)) {
  build_all(line_count);
}

void LineStarts::build_all(std::size_t line_count) {
  tree_.resize(ends_.size());
  place_.resize(ends_.size());
  left_.resize(ends_.size());
  taken_.resize(line_count);
  begins_.assign(line_count + 1, 0);
  for (const LineStart& end : ends_) ++begins_[end.line + 1];
  std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
  std::iota(tree_.begin(), tree_.end(), std::size_t{0});
  build(0, ends_.size(), 0);
  for (std::size_t i = 0; i < tree_.size(); ++i) place_[tree_[i]] = i;
}

/// The node of ends [begin, end) is the middle one; those before it are not beyond it on `axis`.
void LineStarts::build(std::size_t begin, std::size_t end, int axis) {
  if (begin == end) return;
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::size_t i) { return tree_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end), [&](std::size_t a, std::size_t b) {
    return std::pair(ends_[a].point[axis], a) < std::pair(ends_[b].point[axis], b);
  });
  left_[middle] = end - begin;
  build(begin, middle, (axis + 1) % 3);
  build(middle + 1, end, (axis + 1) % 3);
}

/// `visit(end, square)` returns the squared distance beyond which nothing counts.
template <class Visit>
void LineStarts::search(std::size_t begin, std::size_t end, int axis, const Vec3& point,
                        const Visit& visit) const {
  if (begin == end) return;
  const std::size_t middle = begin + (end - begin) / 2;
  if (left_[middle] == 0) return;
  const LineStart& here = ends_[tree_[middle]];
  const float square = taken_[here.line] ? std::numeric_limits<float>::infinity()
                                         : (here.point - point).squaredNorm();
  visit(tree_[middle], square);
  const float beyond = point[axis] - here.point[axis];
  const int next = (axis + 1) % 3;
  const auto reaches = [&] {
    return beyond * beyond <= visit(tree_[middle], std::numeric_limits<float>::infinity());
  };
  if (beyond <= 0) {
    search(begin, middle, next, point, visit);
    if (reaches()) search(middle + 1, end, next, point, visit);
  } else {
    search(middle + 1, end, next, point, visit);
    if (reaches()) search(begin, middle, next, point, visit);
  }
}

std::size_t LineStarts::nearest(const Vec3& point) const {
  std::pair<float, std::size_t> found(std::numeric_limits<float>::infinity(), ends_.size());
  search(0, ends_.size(), 0, point, [&](std::size_t end, float square) {
    found = std::min(found, {square, end});
    return found.first;
  });
  return found.second;
}

std::vector<Index> LineStarts::nearest_of_others(const Vec3& point, Index line,
                                                 std::size_t count) const {
  constexpr float kNone = std::numeric_limits<float>::infinity();
  std::vector<std::pair<float, Index>> found;
  search(0, ends_.size(), 0, point, [&](std::size_t end, float square) {
    const std::pair<float, Index> here(square, static_cast<Index>(end));
    const bool counts = square < kNone && ends_[end].line != line;
    if (counts && (found.size() < count || here < found.back())) {
      if (found.size() == count) found.pop_back();
      found.insert(std::upper_bound(found.begin(), found.end(), here), here);
    }
    return found.size() < count ? kNone : found.back().first;
  });
  std::vector<Index> ends;
  for (const auto& near : found) ends.push_back(near.second);
  return ends;
}

void LineStarts::take(Index line) {
  taken_[line] = true;
  for (std::size_t end = begins_[line]; end < begins_[line + 1]; ++end) count_out(place_[end]);
}

/// Counts an end out of all nodes that contain it.
void LineStarts::count_out(std::size_t place) {
  std::size_t begin = 0, end = ends_.size();
  while (true) {
    const std::size_t middle = begin + (end - begin) / 2;
    --left_[middle];
    if (place == middle) return;
    if (place < middle) {
      end = middle;
    } else {
      begin = middle + 1;
    }
  }
}

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
std::size_t outermost(const LineStarts& ends) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const LineStart& end : ends.all()) mean += end.point.cast<double>();
  mean /= static_cast<double>(ends.all().size());
  const auto far = ranges::max_element(ends.all(), {}, [&](const LineStart& end) {
    return (end.point.cast<double>() - mean).squaredNorm();
  });
  return static_cast<std::size_t>(far - ends.all().begin());
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
  Vec3 from = start ? *start : ends[outermost(ends)].point;
  Index last = 0;
  while (order.size() < chosen.size()) {
    if (order.size() % kLinesPerReport == 0) {
      progress.report(static_cast<double>(order.size()) / static_cast<double>(chosen.size()));
    }
    const Index* next = order.empty() || beside.empty()
                            ? nullptr
                            : next_beside(lines, chosen, ends, beside[last], from);
    last = next != nullptr ? *next : ends[ends.nearest(from)].line;
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
    std::vector<LineStart> ends;
    for (std::size_t e = 0; e < points_.size(); ++e) {
      ends.push_back({points_[e], static_cast<Index>(e / 2)});
    }
    const LineStarts tree(ends, count_);
    for (const LineStart& end : ends) {
      near_.push_back(tree.nearest_of_others(end.point, end.line, kNeighbors));
    }
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
