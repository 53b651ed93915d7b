/// Places that options name, so that they can be moved with the mouse.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "session/session_document.h"

namespace brindle::tool {

/// A place that values are distances from (`distance:X,Y,Z`), and that other surfaces are moved to
/// (`--with MESH@X,Y,Z`).
struct NamedPlace {
  Eigen::Vector3d at;                ///< in the coordinates of files
  std::vector<std::string> options;  ///< that name it, without dashes, each once
};

/// All of them, each once, in the order of the options.
std::vector<NamedPlace> named_places(const OptionValues& options);

/// The place's options with `to` instead of it.
OptionValues with_place_at(const Eigen::Vector3d& to, const NamedPlace& place,
                           const OptionValues& options);

}  // namespace brindle::tool
