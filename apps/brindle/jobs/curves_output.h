/// Files of curves.
#pragma once

#include <span>
#include <string>

#include "jobs/curves_job.h"

namespace brindle::tool {

/// What a path asks for; of a mesh file, tubes if they are wanted. Throws CLI::ValidationError,
/// naming what to do, for what it cannot hold.
CurveOutput planned_curves(const std::string& path, bool tubes);

/// Throws Error if there is nothing to write.
void write_tube_mesh(const std::string& path, const std::vector<Ornament>& ornaments);

/// Curves on their surface; all of it lives elsewhere.
struct TracedSurface {
  const CurvesArguments& arguments;
  const Surface& surface;
  const DataArrays& arrays;  ///< of the surface's file
  std::span<const CurveFamily> families;
};

/// Every kind but a report. Throws Error if the file cannot be written.
void write_curves(CurveOutput kind, const std::string& path, const TracedSurface& traced,
                  JobListener& listener);

}  // namespace brindle::tool
