/// Values of a session at a point of its surface.
#pragma once

#include <string>
#include <vector>

#include "session/live_pattern.h"
#include "session/picking.h"

namespace brindle::tool {

struct PickedValue {
  std::string name;  ///< "frequency", or an array's name
  std::string text;
};

/// The point in file coordinates, its wave, and the values of the file's arrays. `point` was picked
/// on this state's surface.
std::vector<PickedValue> values_at(const LiveState& state, const PickedPoint& point);

}  // namespace brindle::tool
