/// Meshes with typical defects.
#pragma once

#include "brindle/mesh.h"

namespace brindle {

/// A hare with holes and missing triangles.
Mesh incomplete_mesh(double detail, const Progress& progress = {});
/// Five bent sheets that meet in a line: its edges have five triangles.
Mesh non_manifold_mesh(double detail);
/// A voxel segmentation: steps, loose components, edges with four triangles.
Mesh segmented_mesh(double detail, const Progress& progress = {});
/// A knot with vertex noise of up to 0.3 edge lengths.
Mesh noisy_mesh(double detail);

}  // namespace brindle
