/// Stresses in the wall of a vessel under pressure.
#pragma once

#include <array>

#include <Eigen/Core>

#include "gallery/implicit.h"

namespace brindle {

/// Membrane stresses of a thin wall: the first along the direction of the larger curvature, around
/// the vessel, the second across it.
struct MembraneStress {
  double first = 0, second = 0;
};

/// Of pressure p inside of a wall of thickness t with principal curvatures k1 >= k2, in units of
/// the pressure. Equilibrium across the wall asks for
///
///   first * k1 + second * k2 = p / t    (Laplace),
///
/// and for what is left open the wall is taken for a shell of revolution whose parallels run along
/// the larger curvature, as they do around a vessel:
///
///   second = p / (2 t k1),    first = second * (2 - k2 / k1).
///
/// A sphere of radius r has p r / (2 t) in all directions, a tube p r / t around and half of it
/// along. `k1` counts as not smaller than `least_curvature`, above 0: flat walls would tear.
MembraneStress membrane_stress(double pressure, double thickness, double k1, double k2,
                               double least_curvature);

/// As a symmetric tensor in VTK's order: XX, YY, ZZ, XY, YZ, XZ.
std::array<float, 6> stress_tensor(const MembraneStress& stress, const LevelCurvature& curvature);

}  // namespace brindle
