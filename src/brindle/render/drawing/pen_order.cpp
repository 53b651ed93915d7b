#include "brindle/render/drawing/pen_order.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>

namespace brindle {
namespace {

constexpr std::size_t kStrokesPerReport = 256;

/// The ends of strokes that are left, in a k-d tree. End 2 i begins stroke i, and 2 i + 1 ends it.
class FreeEnds {
 public:
  explicit FreeEnds(const std::vector<Stroke>& strokes)
      : strokes_(strokes), ends_(2 * strokes.size()), place_(ends_.size()), left_(ends_.size()) {
    std::iota(ends_.begin(), ends_.end(), std::size_t{0});
    build(0, ends_.size(), 0);
    for (std::size_t i = 0; i < ends_.size(); ++i) place_[ends_[i]] = i;
    taken_.resize(strokes.size());
  }

  /// Of several, the one with the smallest number. There must be one.
  std::size_t nearest(const Eigen::Vector2f& point) const {
    Nearest found;
    search(0, ends_.size(), 0, point, found);
    return found.end;
  }

  void take(std::size_t stroke) {
    taken_[stroke] = true;
    for (const std::size_t end : {2 * stroke, 2 * stroke + 1}) count_out(place_[end]);
  }

 private:
  struct Nearest {
    float square = std::numeric_limits<float>::infinity();
    std::size_t end = std::numeric_limits<std::size_t>::max();
  };

  const Eigen::Vector2f& point_of(std::size_t end) const {
    const Stroke& stroke = strokes_[end / 2];
    return end % 2 == 0 ? stroke.front() : stroke.back();
  }

  /// The node of ends [begin, end) is the middle one; those before it are not beyond it on `axis`.
  void build(std::size_t begin, std::size_t end, int axis) {
    if (begin == end) return;
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::size_t i) { return ends_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end), [&](std::size_t a, std::size_t b) {
      return std::pair(point_of(a)[axis], a) < std::pair(point_of(b)[axis], b);
    });
    left_[middle] = end - begin;
    build(begin, middle, 1 - axis);
    build(middle + 1, end, 1 - axis);
  }

  void search(std::size_t begin, std::size_t end, int axis, const Eigen::Vector2f& point,
              Nearest& found) const {
    if (begin == end) return;
    const std::size_t middle = begin + (end - begin) / 2;
    if (left_[middle] == 0) return;
    const Eigen::Vector2f& here = point_of(ends_[middle]);
    if (!taken_[ends_[middle] / 2]) {
      const float square = (here - point).squaredNorm();
      if (std::pair(square, ends_[middle]) < std::pair(found.square, found.end)) {
        found = {square, ends_[middle]};
      }
    }
    const float beyond = point[axis] - here[axis];
    const auto search_before = [&] { search(begin, middle, 1 - axis, point, found); };
    const auto search_after = [&] { search(middle + 1, end, 1 - axis, point, found); };
    if (beyond <= 0) search_before();
    if (beyond > 0 || beyond * beyond <= found.square) search_after();
    if (beyond > 0 && beyond * beyond <= found.square) search_before();
  }

  /// Counts an end out of all nodes that contain it.
  void count_out(std::size_t place) {
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

  const std::vector<Stroke>& strokes_;
  std::vector<std::size_t> ends_;   // in the order of the tree
  std::vector<std::size_t> place_;  // of every end in `ends_`
  std::vector<std::size_t> left_;   // ends that are left in every node
  std::vector<bool> taken_;         // per stroke
};

std::vector<Stroke> ordered(std::vector<Stroke> strokes, const Progress& progress) {
  FreeEnds free(strokes);
  std::vector<std::size_t> begins;
  Eigen::Vector2f pen = Eigen::Vector2f::Zero();
  while (begins.size() < strokes.size()) {
    if (begins.size() % kStrokesPerReport == 0) {
      progress.report(static_cast<double>(begins.size()) / static_cast<double>(strokes.size()));
    }
    const std::size_t end = free.nearest(pen);
    free.take(end / 2);
    begins.push_back(end);
    pen = end % 2 == 0 ? strokes[end / 2].back() : strokes[end / 2].front();
  }
  std::vector<Stroke> result;
  for (const std::size_t end : begins) {
    Stroke& stroke = result.emplace_back(std::move(strokes[end / 2]));
    if (end % 2 == 1) std::reverse(stroke.begin(), stroke.end());
  }
  return result;
}

}  // namespace

void order_strokes(std::span<Pen> pens, const Progress& progress) {
  const auto count = static_cast<double>(pens.size());
  for (std::size_t i = 0; i < pens.size(); ++i) {
    const auto done = static_cast<double>(i);
    if (pens[i].filled) continue;
    pens[i].strokes =
        ordered(std::move(pens[i].strokes), progress.part(done / count, (done + 1) / count));
  }
}

}  // namespace brindle
