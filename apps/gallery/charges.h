/// A molecule with charged atoms in water. Nanometres, elementary charges, kT/e.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "gallery/gallery.h"

namespace brindle {

/// The Bjerrum length of water at 25 degrees Celsius: two elementary charges at this distance have
/// the energy kT.
constexpr double kBjerrumLength = 0.7;

struct PointCharge {
  Eigen::Vector3d at;
  double charge = 0;
};

/// One charge per atom; their sum is 0.
std::vector<PointCharge> charges_of_molecule();

/// Coulomb's law: kBjerrumLength times the sum of charge / distance.
double potential_at(const Eigen::Vector3d& at, std::span<const PointCharge> charges);

/// The surface, with `potential` per point.
GalleryFile charged_molecule(double detail, const Progress& progress = {});

}  // namespace brindle
