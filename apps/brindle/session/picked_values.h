/// What a session knows of a point of its surface.
#pragma once

#include <string>
#include <vector>

#include "session/live_pattern.h"
#include "session/picking.h"

namespace brindle::tool {

struct PickedValue {
  std::string name;  ///< "frequency", or that of an array
  std::string text;
};

/// Where the point is in the coordinates of files, the wave there, and what the mesh's file says of
/// it. `point` was picked on the surface of this state.
std::vector<PickedValue> values_at(const LiveState& state, const PickedPoint& point);

}  // namespace brindle::tool
