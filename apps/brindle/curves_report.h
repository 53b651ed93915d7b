/// What `brindle curves` says of its curves.
#pragma once

#include <array>
#include <cstddef>
#include <iosfwd>
#include <string>

#include <nlohmann/json.hpp>

#include "curves_job.h"

namespace brindle::tool {

/// Why curves end, for the key "ends", and as a line for people.
using CurveEnds = std::array<std::size_t, kCurveEndKinds>;
nlohmann::ordered_json ends_to_json(const CurveEnds& ends);
std::string line_of_ends(const CurveEnds& ends);

nlohmann::ordered_json to_json(const CurveFamily& family);
nlohmann::ordered_json to_json(const CurvesJob& job, const PictureOptions& picture);

/// The same for people.
void print(std::ostream& out, const CurvesJob& job);

}  // namespace brindle::tool
