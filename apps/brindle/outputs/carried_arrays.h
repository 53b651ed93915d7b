/// Input arrays at positions on the mesh, for curves and samples.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "brindle/data_arrays.h"
#include "cli/job_listener.h"

namespace brindle::tool {

/// The joined own and input arrays (`join_arrays`) that the file can hold. Notes renamed arrays,
/// then left-out ones.
DataArrays fitted(const std::filesystem::path& path, DataArrays own, const DataArrays& input,
                  JobListener& listener);

/// The input arrays that a file of lines or samples can hold besides its `own` columns; of point
/// and triangle arrays with one name, those of points. Notes left-out arrays, then renamed ones.
DataArrays held_beside(std::span<const std::string> own, const std::filesystem::path& path,
                       const DataArrays& arrays, JobListener& listener);

}  // namespace brindle::tool
