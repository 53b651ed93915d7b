#include "brindle/points/point_tree.h"

#include <algorithm>
#include <utility>

#include "brindle/error.h"

#ifdef BRINDLE_HAS_NANOFLANN
#include <nanoflann.hpp>
#endif

namespace brindle {

#ifdef BRINDLE_HAS_NANOFLANN

namespace {

/// The tree reads each point about twenty times per level.
constexpr std::size_t kReadsPerTick = 1 << 20;

/// Adapter for nanoflann, which has no progress callback: building a tree can only be cancelled
/// where it reads a point.
struct Points {
  std::span<const Vec3> positions;
  const Progress* progress = nullptr;  ///< while the tree is built
  mutable std::size_t reads = 0;

  std::size_t kdtree_get_point_count() const { return positions.size(); }
  float kdtree_get_pt(std::size_t i, std::size_t axis) const {
    if (progress != nullptr && ++reads % kReadsPerTick == 0) progress->tick();
    return positions[i][static_cast<Eigen::Index>(axis)];
  }
  template <class Box>
  bool kdtree_get_bbox(Box& /*box*/) const {
    return false;
  }
};

using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Points>,
                                                 Points, 3, Index>;

}  // namespace

struct PointTree::State {
  Points points;
  Tree tree{3, points};
};

PointTree::PointTree(std::span<const Vec3> points, const Progress& progress)
    : state_(new State{{points, progress.is_heard() ? &progress : nullptr}}) {
  state_->points.progress = nullptr;
}
PointTree::~PointTree() = default;
bool has_point_trees() { return true; }

void PointTree::within(const Vec3& point, float radius, std::vector<Index>& found) const {
  found.clear();
  std::vector<std::pair<Index, float>> matches;
  if (state_->points.positions.empty()) return;
  state_->tree.radiusSearch(point.data(), radius * radius, matches, nanoflann::SearchParams());
  for (const auto& [index, square] : matches) found.push_back(index);
}

void PointTree::nearest(const Vec3& point, std::size_t count, std::vector<Index>& found) const {
  found.resize(std::min(count, state_->points.positions.size()));
  if (found.empty()) return;
  std::vector<float> squares(found.size());
  nanoflann::KNNResultSet<float, Index> result(found.size());
  result.init(found.data(), squares.data());
  state_->tree.findNeighbors(result, point.data(), nanoflann::SearchParams());
}

#else

struct PointTree::State {};

PointTree::PointTree(std::span<const Vec3> /*points*/, const Progress& /*progress*/) {
  throw Error("this build cannot find points near points; configure with -DBRINDLE_NANOFLANN=ON");
}
PointTree::~PointTree() = default;
bool has_point_trees() { return false; }

void PointTree::within(const Vec3& /*point*/, float /*radius*/,
                       std::vector<Index>& /*found*/) const {}

void PointTree::nearest(const Vec3& /*point*/, std::size_t /*count*/,
                        std::vector<Index>& /*found*/) const {}

#endif

}  // namespace brindle
