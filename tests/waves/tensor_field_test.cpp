#include "brindle/tensor_field.h"

#include <array>
#include <cmath>
#include <limits>
#include <random>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/error.h"
#include "parametric_meshes.h"

namespace brindle {
namespace {

using Matrix = Eigen::Matrix3d;

constexpr std::array kAxes = {TensorAxis::minor, TensorAxis::major, TensorAxis::max_abs};

DataArray of_nine(const std::vector<Matrix>& tensors) {
  std::vector<double> numbers;
  for (const Matrix& tensor : tensors) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) numbers.push_back(tensor(i, j));
    }
  }
  return make_data_array("stress", 9, numbers);
}

DataArray of_six(const std::vector<Matrix>& tensors) {
  std::vector<double> numbers;
  for (const Matrix& t : tensors) {
    for (const double number : {t(0, 0), t(1, 1), t(2, 2), t(0, 1), t(1, 2), t(0, 2)}) {
      numbers.push_back(number);
    }
  }
  return make_data_array("stress", 6, numbers);
}

Matrix random_rotation(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
      .normalized()
      .toRotationMatrix();
}

/// A tensor per vertex with random axes and these eigenvalues.
std::vector<Matrix> with_eigenvalues(const std::vector<Matrix>& axes,
                                     const Eigen::Vector3d& values) {
  std::vector<Matrix> tensors;
  for (const Matrix& q : axes) {
    const Matrix tensor = q * values.asDiagonal() * q.transpose();
    tensors.emplace_back((tensor + tensor.transpose()) / 2);
  }
  return tensors;
}

std::vector<Matrix> random_axes(std::size_t count) {
  std::mt19937 random(5);
  std::vector<Matrix> axes(count);
  for (Matrix& q : axes) q = random_rotation(random);
  return axes;
}

Surface ball() { return make_surface(make_sphere({.resolution = 30})); }

/// Two triangles in the plane of x and y.
Surface unit_square() {
  return make_surface({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}});
}

TensorField on_square(const Matrix& tensor, TensorAxis axis) {
  return tensor_field_of(unit_square(), of_nine(std::vector<Matrix>(4, tensor)), axis);
}

/// Expects the projection of `axis`, up to sign, unless it is near to the normal. Returns whether
/// there is a wave.
bool expect_projected(const Vec3& direction, const Eigen::Vector3d& axis, const Vec3& normal,
                      double tolerance) {
  const double cosine = std::abs(axis.normalized().dot(normal.cast<double>()));
  if (std::abs(cosine - std::cos(std::acos(-1) / 12)) < 1e-6) return !direction.isZero(0);
  EXPECT_EQ(direction.isZero(0), cosine > std::cos(std::acos(-1) / 12)) << cosine;
  if (direction.isZero(0)) return false;
  const Vec3 expected = tangent_direction(axis.cast<float>(), normal);
  EXPECT_NEAR(std::abs(direction.dot(expected)), 1, tolerance);
  return true;
}

TEST(TensorField, RunsAlongTheEigenvectorsThatATensorIsMadeOf) {
  const Surface surface = ball();
  const auto axes = random_axes(surface.mesh.vertex_count());
  struct Case {
    Eigen::Vector3d values;
    std::array<int, 3> chosen;  // by kAxes
  };
  for (const Case& c :
       {Case{{1, 2, 3}, {0, 2, 2}}, Case{{-5, 2, 3}, {0, 2, 0}}, Case{{3, -1, 0.5}, {1, 0, 0}},
        Case{{-3, -1, -2}, {0, 1, 0}}, Case{{-2, 0, 2}, {0, 2, 2}}}) {
    const auto tensors = with_eigenvalues(axes, c.values);
    for (std::size_t k = 0; k < 3; ++k) {
      const TensorField field = tensor_field_of(surface, of_six(tensors), kAxes[k]);
      std::size_t waves = 0;
      for (std::size_t v = 0; v < axes.size(); ++v) {
        waves += expect_projected(field.directions[v], axes[v].col(c.chosen[k]), surface.normals[v],
                                  1e-6);
      }
      EXPECT_EQ(field.near_normal, axes.size() - waves);
      EXPECT_GT(field.near_normal, 0u);
      EXPECT_EQ(field.isotropic, 0u);
      EXPECT_EQ(field.not_symmetric, 0u);
    }
  }
}

/// Of a free surface, across which there is no stress: whatever the size of that zero among others.
TEST(TensorField, WithinTheSurfaceAxesAreThoseOfItsOwnStress) {
  const Surface surface = ball();
  const std::size_t count = surface.mesh.vertex_count();
  for (const Eigen::Vector2d& values : {Eigen::Vector2d(3, 1), Eigen::Vector2d(-1, -3)}) {
    std::vector<Matrix> tensors(count);
    std::vector<Vec3> axes(count);
    for (std::size_t v = 0; v < count; ++v) {
      const Eigen::Vector3d n = surface.normals[v].cast<double>().normalized();
      const Eigen::Vector3d a = n.unitOrthogonal(), b = n.cross(a);
      tensors[v] = values[0] * a * a.transpose() + values[1] * b * b.transpose();
      axes[v] = a.cast<float>();
    }
    const TensorField major = tensor_field_of(surface, of_nine(tensors), TensorAxis::tangent_major);
    const TensorField minor = tensor_field_of(surface, of_six(tensors), TensorAxis::tangent_minor);
    EXPECT_EQ(major.near_normal + major.isotropic + minor.near_normal + minor.isotropic, 0u);
    for (std::size_t v = 0; v < count; ++v) {
      EXPECT_NEAR(std::abs(major.directions[v].dot(axes[v])), 1, 1e-5) << v;
      EXPECT_NEAR(minor.directions[v].dot(axes[v]), 0, 1e-3) << v;
    }
  }
  const std::vector<Matrix> even(count, Matrix::Identity());
  EXPECT_EQ(tensor_field_of(surface, of_nine(even), TensorAxis::tangent_major).isotropic, count);
}

TEST(TensorField, AgreesWithASolverForAnyMatrix) {
  const Surface surface = ball();
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::vector<Matrix> tensors(surface.mesh.vertex_count());
  for (Matrix& t : tensors) {
    t = Matrix::NullaryExpr([&] { return normal(random); });
    t = (t + t.transpose()).eval();
  }
  const TensorField field = tensor_field_of(surface, of_nine(tensors), TensorAxis::major);
  for (std::size_t v = 0; v < tensors.size(); ++v) {
    const Eigen::EigenSolver<Matrix> solver(tensors[v]);
    Eigen::Index largest = 0;
    solver.eigenvalues().real().maxCoeff(&largest);
    expect_projected(field.directions[v], solver.eigenvectors().col(largest).real(),
                     surface.normals[v], 1e-5);
  }
}

TEST(TensorField, IsTheSameOfSixNumbersAndOfNineAndOfAnySize) {
  const Surface surface = ball();
  const auto tensors = with_eigenvalues(random_axes(surface.mesh.vertex_count()), {1, -2, 3});
  const TensorField six = tensor_field_of(surface, of_six(tensors), TensorAxis::minor);
  EXPECT_EQ(tensor_field_of(surface, of_nine(tensors), TensorAxis::minor).directions,
            six.directions);
  for (const double size : {0x1p-1000, 0x1p-100, 0x1p1000}) {
    std::vector<Matrix> scaled;
    for (const Matrix& t : tensors) scaled.emplace_back(size * t);
    EXPECT_EQ(tensor_field_of(surface, of_six(scaled), TensorAxis::minor).directions,
              six.directions);
  }
}

TEST(TensorField, TurnsWithTheSurface) {
  const Surface surface = ball();
  const auto tensors = with_eigenvalues(random_axes(surface.mesh.vertex_count()), {1, -2, 3});
  std::mt19937 random(3);
  const Matrix turn = random_rotation(random);
  Mesh turned_mesh = surface.mesh;
  for (Vec3& p : turned_mesh.positions) p = (turn * p.cast<double>()).cast<float>();
  const Surface turned_surface = make_surface(turned_mesh);
  std::vector<Matrix> turned_tensors;
  for (const Matrix& t : tensors) turned_tensors.emplace_back(turn * t * turn.transpose());
  const TensorField field = tensor_field_of(surface, of_nine(tensors), TensorAxis::max_abs);
  const TensorField turned =
      tensor_field_of(turned_surface, of_nine(turned_tensors), TensorAxis::max_abs);
  EXPECT_EQ(turned.not_symmetric, 0u) << "rounding errors do not count";
  std::size_t different = 0;  // at the limit of 15 degrees
  for (std::size_t v = 0; v < tensors.size(); ++v) {
    const Vec3 expected = (turn * field.directions[v].cast<double>()).cast<float>();
    if (expected.isZero(0) != turned.directions[v].isZero(0)) {
      ++different;
    } else if (!expected.isZero(0)) {
      EXPECT_NEAR(std::abs(expected.dot(turned.directions[v])), 1, 1e-5);
    }
  }
  EXPECT_LE(different, 1u);
}

TEST(TensorField, HasNoWaveWhereTheAxisIsNearToTheNormal) {
  for (const auto& [degrees, waves] : {std::pair{0.0, 0}, {14.9, 0}, {15.1, 4}, {90.0, 4}}) {
    const double angle = degrees * std::acos(-1) / 180;
    const Eigen::Vector3d axis(std::sin(angle), 0, std::cos(angle));
    const TensorField field = on_square(axis * axis.transpose(), TensorAxis::major);
    EXPECT_EQ(field.near_normal, 4u - static_cast<std::size_t>(waves)) << degrees;
    EXPECT_EQ(field.directions[0].isZero(0), waves == 0);
    EXPECT_EQ(field.directions[0].cwiseAbs(), waves > 0 ? Vec3(1, 0, 0) : Vec3(0, 0, 0));
  }
}

TEST(TensorField, HasNoWaveWhereNoAxisIsChosen) {
  const auto count = [](const Eigen::Vector3d& values, TensorAxis axis) {
    return on_square(values.asDiagonal(), axis).isotropic;
  };
  for (const TensorAxis axis : kAxes) {
    EXPECT_EQ(count({0, 0, 0}, axis), 4u);
    EXPECT_EQ(count({-3, -3, -3}, axis), 4u);
    EXPECT_EQ(count({1, 2, 4}, axis), 0u);
  }
  EXPECT_EQ(count({2, 2, 1}, TensorAxis::major), 4u);
  EXPECT_EQ(count({2, 1, 2}, TensorAxis::max_abs), 4u);
  EXPECT_EQ(count({1, 2, 2}, TensorAxis::minor), 0u);
  EXPECT_EQ(count({1, 2, 1}, TensorAxis::minor), 4u);
  EXPECT_EQ(count({2, 2 + 1e-3, 1}, TensorAxis::major), 0u);
}

TEST(TensorField, OfFloatsIsIsotropicButForRounding) {
  const Surface surface = ball();
  const auto tensors = with_eigenvalues(random_axes(surface.mesh.vertex_count()), {5, 5, 1});
  std::vector<float> numbers;
  for (const Matrix& t : tensors) {
    for (const double number : {t(0, 0), t(1, 1), t(2, 2), t(0, 1), t(1, 2), t(0, 2)}) {
      numbers.push_back(static_cast<float>(number));
    }
  }
  const TensorField field =
      tensor_field_of(surface, make_data_array("stress", 6, numbers), TensorAxis::major);
  EXPECT_EQ(field.isotropic, surface.mesh.vertex_count());
}

TEST(TensorField, TakesThePositiveOfTwoAxesOfOneSize) {
  Matrix shear = Matrix::Zero();
  shear(0, 1) = shear(1, 0) = -3;  // eigenvalue 3 along (1, -1), -3 along (1, 1)
  const TensorField field = on_square(shear, TensorAxis::max_abs);
  const float h = std::sqrt(0.5f);
  EXPECT_NEAR(std::abs(field.directions[0].dot(Vec3(h, -h, 0))), 1, 1e-6);
  const TensorField minor = on_square(shear, TensorAxis::minor);
  EXPECT_NEAR(std::abs(minor.directions[0].dot(Vec3(h, h, 0))), 1, 1e-6);
}

TEST(TensorField, IsThatOfTheSymmetricPart) {
  Matrix gradient;
  gradient << 1, 5, 0, -1, 1, 0, 0, 0, 0;
  const TensorField field = on_square(gradient, TensorAxis::major);
  EXPECT_EQ(field.not_symmetric, 4u);
  const float h = std::sqrt(0.5f);
  EXPECT_NEAR(std::abs(field.directions[0].dot(Vec3(h, h, 0))), 1, 1e-6);
}

TEST(TensorField, HasNoWaveWhereANumberIsNotFinite) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    std::vector<Matrix> tensors(4, Matrix(Eigen::Vector3d(3, 2, 1).asDiagonal()));
    tensors[1](0, 2) = bad;
    const TensorField field = tensor_field_of(unit_square(), of_nine(tensors), TensorAxis::major);
    EXPECT_EQ(field.directions[1], Vec3::Zero());
    EXPECT_EQ(field.directions[0].cwiseAbs(), Vec3(1, 0, 0));
    EXPECT_EQ(field.near_normal + field.isotropic + field.not_symmetric, 0u);
  }
}

TEST(TensorField, RunsLikeItsNeighbours) {
  const Surface surface = make_surface(make_plane({.resolution = 20}));
  const auto count = surface.mesh.vertex_count();
  std::vector<Matrix> tensors;
  for (std::size_t v = 0; v < count; ++v) {
    // Turned a little from vertex to vertex: eigenvectors alone have any sign.
    const double angle = 3 * static_cast<double>(surface.mesh.positions[v].x());
    const Eigen::Vector3d axis(std::cos(angle), std::sin(angle), 0);
    tensors.emplace_back(axis * axis.transpose());
  }
  const TensorField field = tensor_field_of(surface, of_six(tensors), TensorAxis::major);
  for (Index v = 0; v < count; ++v) {
    for (const Index neighbor : surface.neighborhood->of(v)) {
      EXPECT_GT(field.directions[v].dot(field.directions[neighbor]), 0);
    }
  }
}

TEST(TensorField, RefusesWhatIsNoTensorPerVertex) {
  const auto call = [](int components, std::size_t rows) {
    const std::vector<double> values(rows * static_cast<std::size_t>(components), 1);
    tensor_field_of(unit_square(), make_data_array("stress", components, values),
                    TensorAxis::major);
  };
  EXPECT_THROW(call(3, 4), Error);
  EXPECT_THROW(call(1, 4), Error);
  EXPECT_THROW(call(6, 3), Error);
  EXPECT_NO_THROW(call(6, 4));
}

}  // namespace
}  // namespace brindle
