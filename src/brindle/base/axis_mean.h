/// The mean of directions whose signs mean nothing.
#pragma once

#include <optional>
#include <span>

#include <Eigen/Core>

namespace brindle {

struct WeightedAxis {
  Eigen::Vector3d axis;
  double weight;  ///< above 0
};

/// The weighted mean of vectors as axes, v and -v being the same: that of vectors once all are on
/// the side of the eigenvector with the largest eigenvalue of sum w d d^T / |d| that the first one
/// is on. Nothing where they are so already: it is the mean of the vectors as they are. Not finite
/// if a vector is not.
std::optional<Eigen::Vector3d> mean_of_turned(std::span<const WeightedAxis> axes);

}  // namespace brindle
