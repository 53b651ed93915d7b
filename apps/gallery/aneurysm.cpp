#include "gallery/aneurysm.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include "brindle/base/parallel.h"
#include "brindle/shapes/capsules.h"
#include "gallery/items.h"

namespace brindle {

MembraneStress membrane_stress(double pressure, double thickness, double k1, double k2,
                               double least_curvature) {
  const double around = std::max(k1, least_curvature);
  const double second = pressure / (2 * thickness * around);
  return {second * (2 - k2 / around), second};
}

std::array<float, 6> stress_tensor(const MembraneStress& stress, const LevelCurvature& curvature) {
  const Eigen::Matrix3d tensor =
      stress.first * curvature.larger_direction * curvature.larger_direction.transpose() +
      stress.second * curvature.smaller_direction * curvature.smaller_direction.transpose();
  const Eigen::Matrix3f t = tensor.cast<float>();
  return {t(0, 0), t(1, 1), t(2, 2), t(0, 1), t(1, 2), t(0, 2)};
}

namespace {

using Point = Eigen::Vector3d;

constexpr double kVesselWall = 0.28;     // mm
constexpr double kDomeWall = 0.16;       // mm, thinner at the bulge
constexpr double kLeastCurvature = 0.2;  // 1 / mm
constexpr double kAveraged = 0.12;       // mm, averaging length of curvatures
const Point kDome(0.25, 0.1, 4.2);

/// A vessel along a quadratic curve, from short segments.
ImplicitFunction vessel(const Point& from, const Point& bend, const Point& to, double radius_from,
                        double radius_to) {
  constexpr int kPieces = 40;
  constexpr double kBlend = 0.05;
  const auto at = [&](double t) -> Point {
    return (1 - t) * (1 - t) * from + 2 * t * (1 - t) * bend + t * t * to;
  };
  const auto radius = [&](double t) { return radius_from + t * (radius_to - radius_from); };
  std::vector<Capsule> pieces;
  for (int k = 0; k < kPieces; ++k) {
    const double t = static_cast<double>(k) / kPieces, u = static_cast<double>(k + 1) / kPieces;
    pieces.push_back({at(t), at(u), radius(t), radius(u)});
  }
  return CapsuleUnion(pieces, kBlend);
}

/// The end of a vessel and its direction.
struct End {
  Point at, outwards;
};

struct Wall {
  ImplicitFunction function;
  std::vector<End> ends;
};

// Radii of the daughters follow Murray's law. The bulge consists of ellipsoids, whose curvature is
// smooth.
Wall make_wall() {
  const Point root(-0.9, 0.5, -8.5), fork(0, 0, 0.2);
  const Point left(-8.2, -1.2, -0.6), right(7.6, 1.8, 1.2);
  const Point root_bend(0.9, -0.6, -4), left_bend(-3.4, 0.6, 3.2), right_bend(3.6, -0.8, 1.6);
  const std::vector<ImplicitFunction> parts = {
      vessel(root, root_bend, fork, 1.7, 1.55),
      vessel(fork, left_bend, left, 1.28, 1.15),
      vessel(fork, right_bend, right, 1.28, 1.1),
      ellipsoid({0.1, 0, 1.6}, {1.9, 1.75, 2.2}, turned(0, 8, 0)),
      ellipsoid(kDome, {3.35, 2.9, 3.05}, turned(20, 35, 0)),
      ellipsoid({2.2, -0.9, 6.35}, {1.75, 1.5, 2.1}, turned(10, 38, 0))};  // a bleb
  return {blended(parts, 0.42),
          {{root, (root - root_bend).normalized()},
           {left, (left - left_bend).normalized()},
           {right, (right - right_bend).normalized()}}};
}

double thickness_at(const Point& p) {
  const double t = std::clamp(((p - kDome).norm() - 3.2) / 2.2, 0.0, 1.0);
  return kDomeWall + (kVesselWall - kDomeWall) * t * t * (3 - 2 * t);
}

struct WallValues {
  std::vector<Vec3> directions;
  std::vector<float> stress, first, second, ratio, thickness, curvature_first, curvature_second;
};

WallValues values_of(const Mesh& mesh, const ImplicitFunction& wall, const Progress& progress) {
  const std::size_t count = mesh.vertex_count();
  WallValues values;
  values.stress.resize(6 * count);
  values.directions.resize(count);
  for (std::vector<float>* array : {&values.first, &values.second, &values.ratio, &values.thickness,
                                    &values.curvature_first, &values.curvature_second}) {
    array->resize(count);
  }
  parallel_for(
      count, progress,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
          const Point p = mesh.positions[v].cast<double>();
          const LevelCurvature curvature = level_curvature(wall, p, kAveraged);
          const double thickness = thickness_at(p);
          const MembraneStress stress = membrane_stress(
              kAneurysmPressure, thickness, curvature.larger, curvature.smaller, kLeastCurvature);
          const std::array<float, 6> tensor = stress_tensor(stress, curvature);
          std::ranges::copy(tensor, values.stress.begin() + static_cast<std::ptrdiff_t>(6 * v));
          values.directions[v] = curvature.larger_direction.cast<float>();
          values.first[v] = static_cast<float>(stress.first);
          values.second[v] = static_cast<float>(stress.second);
          values.ratio[v] = static_cast<float>(stress.second / stress.first);
          values.thickness[v] = static_cast<float>(thickness);
          values.curvature_first[v] = static_cast<float>(curvature.larger);
          values.curvature_second[v] = static_cast<float>(curvature.smaller);
        }
      },
      kParallelGrain, kFunctionSlice);
  return values;
}

std::vector<GalleryFile> make_aneurysm(double detail, const Progress& progress) {
  return {aneurysm_wall(detail, nullptr, progress)};
}

}  // namespace

GalleryFile aneurysm_wall(double detail, std::vector<Vec3>* directions, const Progress& progress) {
  const Wall wall = make_wall();
  GalleryFile file{"aneurysm.vtp", {}, {}, {}};
  file.mesh = isosurface(wall.function, {{-11, -6, -11}, {11, 6, 10}},
                         static_cast<float>(0.13 / detail), progress.part(0, 0.9));
  for (const End& end : wall.ends)
    cut_open(file.mesh, end.at - 0.4 * end.outwards, end.outwards, 4);
  WallValues values = values_of(file.mesh, wall.function, progress.part(0.9, 1));
  file.arrays.points = {make_data_array("stress", 6, values.stress),
                        make_data_array("first", 1, values.first),
                        make_data_array("second", 1, values.second),
                        make_data_array("ratio", 1, values.ratio),
                        make_data_array("thickness", 1, values.thickness),
                        make_data_array("curvature_first", 1, values.curvature_first),
                        make_data_array("curvature_second", 1, values.curvature_second)};
  if (directions != nullptr) *directions = std::move(values.directions);
  return file;
}

GalleryItem aneurysm_item() {
  return {"aneurysm",
          "stress in the wall of an artery with a bulge",
          make_aneurysm,
          {{"stress",
            "stripes along the first principal stress, wider where the second is as large",
            "stripe {surface=aneurysm.vtp} --field {field=array:stress} --along --stripes 70 "
            "--frequency-by distance:camera@0.7..1.3,inverse "
            "--width-by {values=array:ratio}@0.15..0.72 "
            "--color-by {values=array:first}{own=@60..220} --threshold {own=220} "
            "--legend {own='first principal stress in kPa'} "
            "--colors #1d3b3a,#f2dcc0,#ffffff --up z --camera 200,12,1.01",
            "800x590",
            {"stripes", "frequency-range", "width-range", "color-range", "threshold"}},
           {"second",
            "stripes along the second principal stress",
            "stripe {surface=aneurysm.vtp} --field {field=array:stress} --stripes 64 "
            "--width-by {values=array:ratio}@0.15..0.7 "
            "--color-by {values=array:second}{own=@20..220} "
            "--threshold {own=220} --legend {own='second principal stress in kPa'} "
            "--colors #1d3b3a,#f2dcc0,#ffffff --up z --camera 200,12,1.01",
            "800x590",
            {"stripes", "width-range", "color-range", "threshold"}}}};
}

}  // namespace brindle
