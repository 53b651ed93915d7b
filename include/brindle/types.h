/// The scalar, vector and index types that every room shares.
#pragma once

#include <complex>
#include <cstdint>

#include <Eigen/Core>

#include "brindle/export.h"

namespace BRINDLE_EXPORT brindle {

/// Number of a vertex, node, edge or triangle.
using Index = std::uint32_t;

/// A point or direction in space.
using Vec3 = Eigen::Vector3f;

/// A phase as the complex number exp(i Phi), or a coupling between two phases.
using Complex = std::complex<float>;

}  // namespace brindle
