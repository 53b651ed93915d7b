/// A saccular aneurysm at the fork of an artery, with stresses in its wall. Millimetres and kPa.
#pragma once

#include "gallery/gallery.h"

namespace brindle {

/// The wall as a mesh, its vessels cut open, with arrays per point: `stress`, a tensor of 6
/// numbers; `first` and `second`, its eigenvalues; `ratio`, the second over the first; `thickness`;
/// `curvature_first` and `curvature_second`, the principal curvatures that they follow from.
/// `directions`, unless null, receives the unit direction of the first stress at every vertex.
GalleryFile aneurysm_wall(double detail, std::vector<Vec3>* directions = nullptr,
                          const Progress& progress = {});

constexpr double kAneurysmPressure = 16;  ///< kPa, 120 mmHg

}  // namespace brindle
