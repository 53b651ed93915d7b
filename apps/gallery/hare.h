/// A sitting hare: x where it looks, z up, about 2.4 units high.
#pragma once

#include "gallery/implicit.h"

namespace brindle {

ImplicitFunction hare();
Mesh hare_mesh(float edge_length, const Progress& progress = {});

/// What a pen draws black in its eyes, and what it leaves white in there.
Mesh hare_pupils(float edge_length, const Progress& progress = {});
Mesh hare_glints(float edge_length, const Progress& progress = {});

/// With every triangle of such a mesh cut into 16, whose vertices are on the surface, too: faster
/// than to make it of short edges.
Mesh fine_hare_mesh(float edge_length, const Progress& progress = {});

}  // namespace brindle
