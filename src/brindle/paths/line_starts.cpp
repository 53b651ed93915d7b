#include "brindle/paths/line_starts.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "brindle/base/standard.h"

namespace brindle {
namespace {

constexpr std::size_t kMostOfClosed = 16;

}  // namespace

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

}  // namespace brindle
