/// Surfaces as they come: nothing that a mesh should be.
#pragma once

#include "brindle/mesh.h"

namespace brindle {

/// A hare with holes, and without triangles here and there.
Mesh incomplete_mesh(double detail, const Progress& progress = {});
/// Five bent sheets that meet in one line: its edges have five triangles.
Mesh non_manifold_mesh(double detail);
/// Voxels of a segmentation: steps, loose parts, edges with four triangles.
Mesh segmented_mesh(double detail, const Progress& progress = {});
/// A knot whose vertices are up to 0.3 edge lengths off.
Mesh noisy_mesh(double detail);

}  // namespace brindle
