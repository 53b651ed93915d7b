#include "brindle/shapes/capsules.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "brindle/base/elementary.h"
#include "brindle/shapes/isosurface.h"

namespace brindle {
namespace {

using Point = Eigen::Vector3d;

constexpr double kNegligible = 20;  // exp(-20) is below the accuracy of a float position
// A grid changes the last bits of sums. Built-in shapes have up to 255 parts and keep their bits.
constexpr std::size_t kPartsOfGrid = 256;
constexpr int kCellsAlong = 32;  // along the longest side of the grid

}  // namespace

CapsuleDistance::CapsuleDistance(const Capsule& capsule)
    : from_(capsule.a),
      axis_(capsule.b - capsule.a),
      radius_(capsule.radius_a),
      widening_(capsule.radius_b - capsule.radius_a) {
  const double length2 = axis_.squaredNorm();
  if (length2 == 0) return;
  over_length2_ = 1 / length2;
  // Along the axis, the slope of the radius adds to that of the distance.
  scale_ = 1 / std::sqrt(1 + widening_ * widening_ / length2);
}

double CapsuleDistance::operator()(const Point& p) const {
  const Point offset = p - from_;
  const double t = std::clamp(offset.dot(axis_) * over_length2_, 0.0, 1.0);
  return ((offset - t * axis_).norm() - radius_ - t * widening_) * scale_;
}

CapsuleUnion::CapsuleUnion(std::span<const Capsule> parts, double blend)
    : parts_(parts.begin(), parts.end()), all_(parts.size()), blend_(blend) {
  std::iota(all_.begin(), all_.end(), 0);
  if (parts.size() < kPartsOfGrid) return;
  const BoundingBox box = box_around(parts);
  const Point size = (box.upper - box.lower).cast<double>();
  cell_ = size.maxCoeff() / kCellsAlong;
  origin_ = box.lower.cast<double>();
  cells_ = (size / cell_).array().ceil().cast<int>().max(1);
  near_.resize(static_cast<std::size_t>(cells_.prod()));
  fill(Cell::Zero(), cells_, all_);
}

// `candidates` includes every part that matters in the range of cells; halves of the range have
// fewer.
void CapsuleUnion::fill(const Cell& lower, const Cell& upper, const std::vector<int>& candidates) {
  const Cell size = upper - lower;
  const Point middle = origin_ + 0.5 * cell_ * (lower + upper).cast<double>();
  const double reach = 0.5 * cell_ * size.cast<double>().norm();
  std::vector<double> distances;
  for (const int part : candidates) distances.push_back(parts_[part](middle));
  const double nearest = *std::min_element(distances.begin(), distances.end());
  std::vector<int> near;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (distances[i] <= nearest + 2 * reach + kNegligible * blend_) near.push_back(candidates[i]);
  }
  int axis = 0;
  if (size.maxCoeff(&axis) == 1) {
    near_[lower[0] + cells_[0] * (lower[1] + cells_[1] * lower[2])] = std::move(near);
    return;
  }
  Cell middle_upper = upper, middle_lower = lower;
  middle_upper[axis] = middle_lower[axis] = lower[axis] + size[axis] / 2;
  fill(lower, middle_upper, near);
  fill(middle_lower, upper, near);
}

double CapsuleUnion::operator()(const Point& p) const {
  if (near_.empty()) return minimum(p, all_);
  const Eigen::Array3d place = (p - origin_).array() / cell_;
  if ((place < 0).any() || (place >= cells_.cast<double>().array()).any()) return minimum(p, all_);
  const Cell cell = place.cast<int>();
  return minimum(p, near_[cell[0] + cells_[0] * (cell[1] + cells_[1] * cell[2])]);
}

double CapsuleUnion::minimum(const Point& p, std::span<const int> parts) const {
  double nearest = 1e30, sum = 0;
  for (const int part : parts) {
    const double d = parts_[part](p);
    if (d > nearest + kNegligible * blend_) continue;
    if (d < nearest) {
      sum = sum * elementary::exp((d - nearest) / blend_) + 1;
      nearest = d;
    } else {
      sum += elementary::exp((nearest - d) / blend_);
    }
  }
  return nearest - blend_ * elementary::log(sum);
}

BoundingBox box_around(std::span<const Capsule> parts) {
  Point lower = Point::Constant(1e30), upper = -lower;
  for (const Capsule& part : parts) {
    lower = lower.cwiseMin((part.a.array() - part.radius_a).matrix());
    lower = lower.cwiseMin((part.b.array() - part.radius_b).matrix());
    upper = upper.cwiseMax((part.a.array() + part.radius_a).matrix());
    upper = upper.cwiseMax((part.b.array() + part.radius_b).matrix());
  }
  return {lower.cast<float>(), upper.cast<float>()};
}

Mesh capsule_surface(std::span<const Capsule> parts, double blend, float edge_length,
                     const Progress& progress) {
  BoundingBox box = box_around(parts);
  // The smooth minimum is below the minimum, by at most this for that many equal distances.
  const auto margin =
      static_cast<float>(blend * elementary::log(static_cast<double>(parts.size()) + 1));
  box.lower.array() -= margin;
  box.upper.array() += margin;
  return isosurface(CapsuleUnion(parts, blend), box, edge_length, progress);
}

}  // namespace brindle
