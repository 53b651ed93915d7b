/// Rounded segments and their blended unions: vessels, atoms, limbs.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "brindle/mesh.h"

namespace brindle {

/// A segment with linearly varying radius; a sphere if the ends coincide.
struct Capsule {
  Eigen::Vector3d a, b;
  double radius_a, radius_b;
};

/// The signed distance from a capsule, or slightly less, with slopes of at most 1.
class CapsuleDistance {
 public:
  explicit CapsuleDistance(const Capsule& capsule);
  double operator()(const Eigen::Vector3d& p) const;

 private:
  Eigen::Vector3d from_, axis_;
  double radius_, widening_;
  double over_length2_ = 0, scale_ = 1;
};

/// The smooth minimum of the distances to all capsules, of which there is at least one, with blends
/// of about radius `blend` above 0, for `isosurface`. With many capsules, a grid lists those that
/// matter in each cell, so that the cost depends on nearby ones alone.
class CapsuleUnion {
 public:
  CapsuleUnion(std::span<const Capsule> parts, double blend);
  double operator()(const Eigen::Vector3d& p) const;

 private:
  using Cell = Eigen::Vector3i;

  void fill(const Cell& lower, const Cell& upper, const std::vector<int>& candidates);
  double minimum(const Eigen::Vector3d& p, std::span<const int> parts) const;

  std::vector<CapsuleDistance> parts_;
  std::vector<int> all_;
  double blend_;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  double cell_ = 0;
  Cell cells_ = Cell::Zero();
  std::vector<std::vector<int>> near_;  ///< of every cell; empty: no grid
};

/// The box around all capsules, without blends.
BoundingBox box_around(std::span<const Capsule> parts);

/// The blended surface of capsules, from `isosurface`.
Mesh capsule_surface(std::span<const Capsule> parts, double blend, float edge_length,
                     const Progress& progress = {});

}  // namespace brindle
