/// A saccular aneurysm at an arterial fork, with wall stresses. Millimetres and kPa.
#pragma once

#include "gallery/gallery.h"

namespace brindle {

/// The wall as a mesh with open vessels and arrays per point: `stress`, a symmetric tensor; `first`
/// and `second`, its eigenvalues; `ratio`, the second over the first; `thickness`;
/// `curvature_first` and `curvature_second`, the principal curvatures. `directions`, unless null,
/// receives the unit direction of the first stress at every vertex.
GalleryFile aneurysm_wall(double detail, std::vector<Vec3>* directions = nullptr,
                          const Progress& progress = {});

constexpr double kAneurysmPressure = 16;  ///< kPa, 120 mmHg

}  // namespace brindle
