/// A sitting hare: x forwards, z up, about 2.4 units high.
#pragma once

#include "gallery/implicit.h"

namespace brindle {

ImplicitFunction hare();
Mesh hare_mesh(float edge_length, const Progress& progress = {});

/// The black parts of its eyes in a pen drawing.
Mesh hare_pupils(float edge_length, const Progress& progress = {});
Mesh hare_glints(float edge_length, const Progress& progress = {});

/// Such a mesh with every triangle split into 16 and new vertices on the surface: faster than a
/// direct mesh with short edges.
Mesh fine_hare_mesh(float edge_length, const Progress& progress = {});

}  // namespace brindle
