/// The stages of `brindle paths`, its files and its report.
#pragma once

#include <iosfwd>
#include <vector>

#include <nlohmann/json.hpp>

#include "jobs/curves_job.h"
#include "jobs/paths_arguments.h"

namespace brindle::tool {

struct PathsJob : DrawingTime {
  CurvesJob curves;
  ToolPaths paths;
  CurveCoverage coverage;
  MachineMetrics machine;
  double order_milliseconds = 0;
};

/// Its stages, in order, for `JobListener`.
std::vector<JobStage> paths_stages(const PathsArguments& arguments);

PathsJob make_paths_job(const PathsArguments& arguments, JobListener& listener);

nlohmann::ordered_json to_json(const PathsJob& job, const PathsArguments& arguments);

/// The same as text.
void print(std::ostream& out, const PathsJob& job);

/// Writes any kind. Throws Error if the file cannot be written.
void write_paths_file(const Output& output, const CLI::App& command,
                      const PathsArguments& arguments, const PathsJob& job, JobListener& listener);

}  // namespace brindle::tool
