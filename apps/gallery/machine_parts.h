/// Machined parts with rounded edges. z is the axis of both.
#pragma once

#include "gallery/implicit.h"

namespace brindle {

/// A flange with a hub: eight bolt holes in a disc of radius 1, a bore through the hub, four ribs.
Mesh flange_mesh(float edge_length, const Progress& progress = {});

/// A hollow ball of radius 0.9 with a round window towards each axis.
Mesh windowed_ball_mesh(float edge_length, const Progress& progress = {});

}  // namespace brindle
