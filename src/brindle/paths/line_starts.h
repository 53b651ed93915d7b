/// Search for the ends of lines.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "brindle/polylines.h"
#include "brindle/types.h"

namespace brindle {

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

}  // namespace brindle
