/// Files of curves.
#pragma once

#include <filesystem>
#include <span>

#include "jobs/curves_job.h"

namespace brindle::tool {

/// The kind of output of a path; for a mesh file, tubes if `tubes`. Throws CLI::ValidationError
/// with a remedy for files that cannot hold curves.
OutputKind planned_curves(const std::filesystem::path& path, bool tubes);

/// Throws Error if there is nothing to write.
void write_tube_mesh(const std::filesystem::path& path, const std::vector<Ornament>& ornaments);

/// Curves on their surface, by reference.
struct TracedSurface {
  const CurvesArguments& arguments;
  const Surface& surface;
  const DataArrays& arrays;  ///< from the surface's file
  std::span<const CurveFamily> families;
};

/// Writes any kind but reports and pieces. Throws Error if the file cannot be written.
void write_curves(const Output& output, const TracedSurface& traced, JobListener& listener);

/// The same for a job of `brindle curves`, and its report.
void write_curves_file(const Output& output, const CLI::App& command,
                       const CurvesArguments& arguments, const CurvesJob& job,
                       JobListener& listener);

}  // namespace brindle::tool
