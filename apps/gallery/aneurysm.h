/// A saccular aneurysm at an arterial fork, with stresses in its wall. Millimetres and kPa.
#pragma once

#include <array>

#include <Eigen/Core>

#include "gallery/gallery.h"
#include "gallery/implicit.h"

namespace brindle {

/// Membrane stresses of a thin wall: the first along the direction of the larger curvature, around
/// the vessel, the second across it.
struct MembraneStress {
  double first = 0, second = 0;
};

/// For internal pressure p, wall thickness t and principal curvatures k1 >= k2, in units of the
/// pressure. Equilibrium across the wall requires
///    first * k1 + second * k2 = p / t    (Laplace).
/// The wall is treated as a shell of revolution whose parallels follow the larger curvature, as
/// around a vessel:
///    second = p / (2 t k1),    first = second * (2 - k2 / k1).
/// A sphere of radius r has p r / (2 t) in all directions, a tube p r / t around and half of it
/// along. `k1` is at least `least_curvature`, above 0: flat walls would have infinite stress.
MembraneStress membrane_stress(double pressure, double thickness, double k1, double k2,
                               double least_curvature);

/// As a symmetric tensor in VTK's order: XX, YY, ZZ, XY, YZ, XZ.
std::array<float, 6> stress_tensor(const MembraneStress& stress, const LevelCurvature& curvature);

/// The wall as a mesh with open vessels and arrays per point: `stress`, a symmetric tensor; `first`
/// and `second`, its eigenvalues; `ratio`, the second over the first; `thickness`;
/// `curvature_first` and `curvature_second`, the principal curvatures. `directions`, unless null,
/// receives the unit direction of the first stress at every vertex.
GalleryFile aneurysm_wall(double detail, std::vector<Vec3>* directions = nullptr,
                          const Progress& progress = {});

constexpr double kAneurysmPressure = 16;  ///< kPa, 120 mmHg

}  // namespace brindle
