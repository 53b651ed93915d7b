#include "brindle/tensor_field.h"

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <Eigen/Eigenvalues>

#include "brindle/base/array_numbers.h"
#include "brindle/base/array_rows.h"
#include "brindle/base/parallel.h"
#include "brindle/direction_field.h"
#include "brindle/error.h"
#include "brindle/waves/direction_graph.h"

namespace brindle {
namespace {

constexpr double kNearNormal = 0.9659258262890683;  // cosine of 15 degrees
constexpr double kSame = 1e-6;                      // share of the largest number

Eigen::Matrix3d matrix_of(const double* row, int components) {
  if (components == 9) return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(row);
  Eigen::Matrix3d matrix;
  matrix << row[0], row[3], row[5], row[3], row[1], row[4], row[5], row[4], row[2];
  return matrix;
}

/// Vertices without a wave, by reason, and asymmetric matrices.
struct TensorCounts {
  std::size_t near_normal = 0, isotropic = 0, not_symmetric = 0;

  TensorCounts operator+(const TensorCounts& other) const {
    return {near_normal + other.near_normal, isotropic + other.isotropic,
            not_symmetric + other.not_symmetric};
  }
};

bool is_tangent(TensorAxis axis) {
  return axis == TensorAxis::tangent_major || axis == TensorAxis::tangent_minor;
}

/// Differences up to this are rounding errors.
template <class Eigenvalues>
double tolerance(const Eigenvalues& eigenvalues) {
  return kSame * eigenvalues.cwiseAbs().maxCoeff();
}

/// The index of the axis's eigenvalue in ascending order.
Eigen::Index chosen(const Eigen::Vector3d& eigenvalues, TensorAxis axis) {
  if (axis == TensorAxis::major) return 2;
  if (axis == TensorAxis::minor) return 0;
  return -eigenvalues[0] > eigenvalues[2] + tolerance(eigenvalues) ? 0 : 2;
}

bool is_single(const Eigen::Vector3d& eigenvalues, Eigen::Index which) {
  return std::abs(eigenvalues[which] - eigenvalues[1]) > tolerance(eigenvalues);
}

/// The direction of an eigenvector of a symmetric matrix's tangential part.
Vec3 tangent_axis(const Eigen::Matrix3d& matrix, const Vec3& normal, TensorAxis axis,
                  TensorCounts& counts) {
  const TangentBasis tangents = tangent_basis(normal);
  Eigen::Matrix<double, 3, 2> basis;
  basis << tangents.x.cast<double>(), tangents.y.cast<double>();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(basis.transpose() * matrix * basis);
  const Eigen::Vector2d& values = solver.eigenvalues();
  if (values[1] - values[0] <= tolerance(values)) {
    ++counts.isotropic;
    return Vec3::Zero();
  }
  const Eigen::Index which = axis == TensorAxis::tangent_major ? 1 : 0;
  const Eigen::Vector3d vector = basis * solver.eigenvectors().col(which);
  return tangent_direction(vector.cast<float>(), normal);
}

Vec3 tensor_direction(Eigen::Matrix3d matrix, const Vec3& normal, TensorAxis axis,
                      TensorCounts& counts) {
  const double size = matrix.cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
  if (!std::isfinite(size)) return Vec3::Zero();
  if (size > 0) matrix /= size;  // squares of extreme numbers would overflow
  counts.not_symmetric += (matrix - matrix.transpose()).cwiseAbs().maxCoeff() > kSame;
  if (normal.isZero(0)) return Vec3::Zero();
  const Eigen::Matrix3d symmetric = (matrix + matrix.transpose()) / 2;
  if (is_tangent(axis)) return tangent_axis(symmetric, normal, axis, counts);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(symmetric);
  const Eigen::Index which = chosen(solver.eigenvalues(), axis);
  if (!is_single(solver.eigenvalues(), which)) {
    ++counts.isotropic;
    return Vec3::Zero();
  }
  const Eigen::Vector3d vector = solver.eigenvectors().col(which);
  if (std::abs(vector.dot(normal.cast<double>())) > kNearNormal) {
    ++counts.near_normal;
    return Vec3::Zero();
  }
  return tangent_direction(vector.cast<float>(), normal);
}

}  // namespace

namespace {

void check_is_tensor(const DataArray& tensors) {
  if (is_tensor(tensors)) return;
  throw Error("array '" + tensors.name + "' has " + std::to_string(tensors.components) +
              " numbers in a row; a symmetric tensor needs 6 (XX, YY, ZZ, XY, YZ, XZ) or 9");
}

float anisotropy_of(Eigen::Matrix3d matrix) {
  const double size = matrix.cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
  if (!std::isfinite(size)) return std::numeric_limits<float>::quiet_NaN();
  if (size == 0) return 0;
  matrix = (matrix + matrix.transpose().eval()) / (2 * size);
  const Eigen::Matrix3d deviator = matrix - matrix.trace() / 3 * Eigen::Matrix3d::Identity();
  return static_cast<float>(std::sqrt(1.5) * deviator.norm() / matrix.norm());
}

}  // namespace

std::vector<float> tensor_anisotropy(const DataArray& tensors) {
  check_is_tensor(tensors);
  const std::vector<double> numbers = doubles_of(tensors.view());
  const auto columns = static_cast<std::size_t>(tensors.components);
  std::vector<float> shares(tensors.rows());
  parallel_for(shares.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      shares[row] = anisotropy_of(matrix_of(&numbers[row * columns], tensors.components));
    }
  });
  return shares;
}

namespace {

constexpr int kZero = -1;

/// For each component in VTK's order its place in a row.
std::array<int, 6> places_of(const DataArray& tensors, TensorOrder order) {
  const int columns = tensors.components;
  if (order == TensorOrder::voigt && columns == 6) return {0, 1, 2, 5, 3, 4};
  if (order == TensorOrder::plane && columns == 3) return {0, 1, kZero, 2, kZero, kZero};
  if (order == TensorOrder::plane && columns == 4) return {0, 3, kZero, 1, kZero, kZero};
  throw Error("array '" + tensors.name + "' has " + std::to_string(columns) +
              " numbers in a row; " +
              (order == TensorOrder::voigt ? "Voigt's order has 6 (XX, YY, ZZ, YZ, XZ, XY)"
                                           : "a tensor in the plane has 3 (XX, YY, XY) or 4"));
}

}  // namespace

DataArray in_vtk_order(const DataArray& tensors, TensorOrder order) {
  if (order == TensorOrder::vtk) return tensors;
  const std::array<int, 6> places = places_of(tensors, order);
  const std::vector<double> numbers = doubles_of(tensors.view());
  const auto columns = static_cast<std::size_t>(tensors.components);
  std::vector<double> ordered;
  ordered.reserve(6 * tensors.rows());
  for (std::size_t row = 0; row < tensors.rows(); ++row) {
    const double* given = &numbers[row * columns];
    for (const int place : places) ordered.push_back(place == kZero ? 0 : given[place]);
    // Of all 4, the symmetric part counts.
    if (columns == 4) ordered.end()[-3] = (given[1] + given[2]) / 2;
  }
  return make_data_array(tensors.name, 6, ordered);
}

bool is_tensor(const DataArray& array) { return array.components == 6 || array.components == 9; }

TensorField tensor_field_of(const Surface& surface, const DataArray& tensors, TensorAxis axis) {
  check_rows_per_vertex(tensors, surface.mesh.vertex_count());
  check_is_tensor(tensors);
  const std::vector<double> numbers = doubles_of(tensors.view());
  const auto columns = static_cast<std::size_t>(tensors.components);
  TensorField field;
  field.directions.resize(tensors.rows());
  const auto counts =
      parallel_sum<TensorCounts>(tensors.rows(), [&](std::size_t begin, std::size_t end) {
        TensorCounts sum;
        for (std::size_t v = begin; v < end; ++v) {
          field.directions[v] = tensor_direction(
              matrix_of(&numbers[v * columns], tensors.components), surface.normals[v], axis, sum);
        }
        return sum;
      });
  field.near_normal = counts.near_normal;
  field.isotropic = counts.isotropic;
  field.not_symmetric = counts.not_symmetric;
  orient_alike(surface, field.directions);
  return field;
}

}  // namespace brindle
