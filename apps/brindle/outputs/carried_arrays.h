/// Arrays of the input's file at places on the mesh, for curves and samples.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "brindle/data_arrays.h"
#include "cli/job_listener.h"

namespace brindle::tool {

/// The part of a command's own arrays and those of its input (`join_arrays`) that the file can
/// hold. Notes what was renamed, then what the file cannot hold.
DataArrays fitted(const std::filesystem::path& path, DataArrays own, const DataArrays& input,
                  JobListener& listener);

/// What a file of lines or samples has place for beside its `own` columns: of arrays of points and
/// of triangles with one name, those of points. Notes what it cannot hold, and what was renamed.
DataArrays held_beside(std::span<const std::string> own, const std::filesystem::path& path,
                       const DataArrays& arrays, JobListener& listener);

}  // namespace brindle::tool
