/// Nearest-neighbour queries on points.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "brindle/points.h"
#include "brindle/progress.h"
#include "brindle/types.h"

namespace brindle {

class PointTree {
 public:
  /// The points must outlive the tree. Throws Error in a build without nanoflann, and Cancelled if
  /// `progress` asks for it.
  explicit PointTree(std::span<const Vec3> points, const Progress& progress = {});
  ~PointTree();
  PointTree(const PointTree&) = delete;
  PointTree& operator=(const PointTree&) = delete;

  /// Replaces `found` by the numbers of all points nearer to `point` than `radius`, nearest first.
  void within(const Vec3& point, float radius, std::vector<Index>& found) const;

  /// Replaces `found` by the numbers of the `count` points nearest to `point`, nearest first; of
  /// all if there are fewer.
  void nearest(const Vec3& point, std::size_t count, std::vector<Index>& found) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace brindle
