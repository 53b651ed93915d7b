/// A liver: hull, vessels, a tumour and a needle. Millimetres; x to the patient's left, y to the
/// back, z up.
#pragma once

#include <vector>

#include "brindle/shapes/capsules.h"
#include "gallery/implicit.h"

namespace brindle {

ImplicitFunction liver_hull();
ImplicitFunction liver_tumour();
std::vector<Capsule> liver_vessels();

/// A needle with its tip at the origin, from the front and above.
Mesh needle_mesh(double detail, const Progress& progress = {});

Mesh liver_hull_mesh(double detail, const Progress& progress = {});
Mesh liver_tumour_mesh(double detail, const Progress& progress = {});
Mesh liver_vessels_mesh(double detail, const Progress& progress = {});

}  // namespace brindle
