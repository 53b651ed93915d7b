/// Positions in options, to be moved with the mouse.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "session/session_document.h"

namespace brindle::tool {

/// A position in options: the origin of distances (`distance:X,Y,Z`), or of another surface
/// (`--with MESH@X,Y,Z`).
struct NamedPlace {
  Eigen::Vector3d at;                ///< in file coordinates
  std::vector<std::string> options;  ///< with this position, without dashes, each once
};

/// All positions, each once, in the order of the options.
std::vector<NamedPlace> named_places(const OptionValues& options);

/// The place's options with `to` in its stead.
OptionValues with_place_at(const Eigen::Vector3d& to, const NamedPlace& place,
                           const OptionValues& options);

}  // namespace brindle::tool
