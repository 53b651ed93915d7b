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

/// A tree of vessels: each splits in two, the radii following Murray's law.
struct VesselsShape {
  int generations = 4;   ///< how often the trunk is split
  float radius = 0.14f;  ///< of the trunk
  float spread = 0.6f;   ///< mean angle between a vessel and its parent, radians
  std::uint32_t seed = 1;
  int resolution = 110;  ///< edges along one unit of length
};
Mesh make_vessels(const VesselsShape& shape = {}, const Progress& progress = {});

/// A cluster of spheres of a few sizes, blended: like a molecule's surface.
struct MoleculeShape {
  int atoms = 14;
  float blend = 0.06f;  ///< radius of the blends between the spheres
  std::uint32_t seed = 1;
  int resolution = 55;  ///< edges along one unit of length
};
Mesh make_molecule(const MoleculeShape& shape = {}, const Progress& progress = {});

/// The spheres of that molecule, as they are in its mesh.
std::vector<Capsule> molecule_atoms(const MoleculeShape& shape = {});

/// A machined block: edges rounded, and a hole along z whose rims are rounded too.
struct BoxShape {
  float width = 2;      ///< along x
  float depth = 1.4f;   ///< along y
  float height = 0.8f;  ///< along z
  float fillet = 0.15f;
  float hole = 0.3f;    ///< radius; 0 for none
  int resolution = 55;  ///< edges along one unit of length
};
Mesh make_box(const BoxShape& shape = {}, const Progress& progress = {});

}  // namespace brindle
