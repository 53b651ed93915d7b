/// What `brindle curves` says of its curves.
#pragma once

#include <iosfwd>

#include <nlohmann/json.hpp>

#include "curves_job.h"

namespace brindle::tool {

nlohmann::ordered_json to_json(const CurveFamily& family);
nlohmann::ordered_json to_json(const CurvesJob& job, const PictureOptions& picture);

/// The same for people.
void print(std::ostream& out, const CurvesJob& job);

}  // namespace brindle::tool
