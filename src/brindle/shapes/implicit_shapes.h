/// Built-in shapes without a formula, polygonised from implicit functions.
///
/// All are closed, centred at the origin, about two units large, and wound outwards. `progress` may
/// throw Cancelled.
#pragma once

#include <cstdint>
#include <vector>

#include "brindle/mesh.h"
#include "brindle/shapes/capsules.h"

namespace brindle {

/// A vessel tree with binary splits and radii by Murray's law.
struct VesselsShape {
  int generations = 4;   ///< number of splits along a path
  float radius = 0.14f;  ///< of the trunk
  float spread = 0.6f;   ///< mean angle between a vessel and its parent, radians
  std::uint32_t seed = 1;
  int resolution = 110;  ///< edges per unit length
};
Mesh make_vessels(const VesselsShape& shape = {}, const Progress& progress = {});

/// A blended cluster of spheres of several sizes, like a molecular surface.
struct MoleculeShape {
  int atoms = 14;
  float blend = 0.06f;  ///< radius of the blends between the spheres
  std::uint32_t seed = 1;
  int resolution = 55;  ///< edges per unit length
};
Mesh make_molecule(const MoleculeShape& shape = {}, const Progress& progress = {});

/// The spheres of that molecule, in the coordinates of its mesh.
std::vector<Capsule> molecule_atoms(const MoleculeShape& shape = {});

/// A machined block with rounded edges and a hole along z with rounded rims.
struct BoxShape {
  float width = 2;      ///< along x
  float depth = 1.4f;   ///< along y
  float height = 0.8f;  ///< along z
  float fillet = 0.15f;
  float hole = 0.3f;    ///< radius; 0 for none
  int resolution = 55;  ///< edges per unit length
};
Mesh make_box(const BoxShape& shape = {}, const Progress& progress = {});

}  // namespace brindle
