/// Flows on surfaces.
#pragma once

#include <array>

#include "gallery/gallery.h"

namespace brindle {

/// Step `number` of kVortexSteps of two counter-rotating vortices on a pebble: the mesh with
/// `velocity`, `speed` and `near`, the distance from the nearer core; and a ball at each core,
/// where the velocity is zero and `core` is 0 or 1. Elsewhere `core` is NaN.
GalleryFile vortex_step(int number, const Mesh& pebble);
Mesh vortex_pebble(double detail, const Progress& progress = {});
constexpr int kVortexSteps = 60;

/// Positions of both cores at a step.
std::array<Eigen::Vector3d, 2> vortex_cores(int number);

/// `velocity` and `speed` on a hare: an Arnold-Beltrami-Childress flow along its surface.
GalleryFile hare_flow(double detail, const Progress& progress = {});

}  // namespace brindle
