/// Output files, planned before a long job and written after it.
#pragma once

#include <algorithm>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "brindle/base/stopwatch.h"
#include "cli/progress_display.h"
#include "input/used_files.h"
#include "outputs/written_files.h"

namespace brindle::tool {

/// Paths and their kinds. `Kind` is an enumeration with a `report`.
template <typename Kind>
using PlannedFiles = std::vector<std::pair<Kind, std::string>>;

/// The kind of each path: `plan` returns it or throws. Reports are last and include `report` unless
/// it is empty. Throws CLI::ValidationError as `check_files` and `check_report` do, Error if the
/// report is not writable.
template <typename Kind>
PlannedFiles<Kind> plan_files(const std::vector<UsedFile>& inputs,
                              const std::vector<std::string>& paths, const std::string& report,
                              const auto& plan) {
  PlannedFiles<Kind> files;
  std::vector<UsedFile> outputs;
  for (const std::string& path : paths) {
    files.emplace_back(plan(path), path);
    outputs.push_back({"--output", path});
  }
  if (!report.empty()) {
    check_report("--report", report);
    files.emplace_back(Kind::report, report);
    outputs.push_back({"--report", report});
  }
  check_files(inputs, outputs);
  std::stable_partition(files.begin(), files.end(),
                        [](const auto& file) { return file.first != Kind::report; });
  return files;
}

/// Whether one of the files has this kind.
template <typename Kind>
bool has(const PlannedFiles<Kind>& files, Kind kind) {
  return std::any_of(files.begin(), files.end(),
                     [kind](const auto& file) { return file.first == kind; });
}

template <typename Kind>
void print_written(std::ostream& out, const PlannedFiles<Kind>& files) {
  for (const auto& [kind, path] : files) print_written(out, std::filesystem::path(path));
}

/// A stage per file.
template <typename Files>
void add_writing_stages(const Files& files, std::vector<JobStage>& stages) {
  for (const auto& [kind, path] : files) stages.push_back({"writing " + path, 2});
}

/// Returns the result of `make(display)`, after `write(kind, path, result, display)` for all files.
/// `stages` are those of `make`. `draw_milliseconds` of the result receives the time of pictures.
template <typename Kind>
auto make_and_write(const CLI::App& command, const PlannedFiles<Kind>& files, bool quiet,
                    std::vector<JobStage> stages, const auto& make, const auto& write) {
  ProgressDisplay display(quiet, &command);
  add_writing_stages(files, stages);
  display.plan(std::move(stages));
  auto result = make(display);
  for (const auto& [kind, path] : files) {
    display.stage("writing " + path);
    Stopwatch watch;
    write(kind, path, result, display);
    if (kind == Kind::picture) {
      result.draw_milliseconds = result.draw_milliseconds.value_or(0) + watch.lap();
    }
  }
  return result;
}

}  // namespace brindle::tool
