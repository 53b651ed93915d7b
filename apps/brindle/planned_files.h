/// Files that a command was asked for: planned before a long job, written after it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "brindle/base/output_file.h"
#include "progress_display.h"

namespace brindle::tool {

/// Paths, and what each asks for. `Kind` is an enumeration with a `report`.
template <typename Kind>
using PlannedFiles = std::vector<std::pair<Kind, std::string>>;

/// What each path asks for, as `plan` tells by throwing or returning a Kind. `report`, unless it is
/// empty, is a report whatever its extension. Throws Error if that could not be written.
template <typename Kind>
PlannedFiles<Kind> plan_files(const std::vector<std::string>& paths, const std::string& report,
                              const auto& plan) {
  PlannedFiles<Kind> files;
  for (const std::string& path : paths) files.emplace_back(plan(path), path);
  if (!report.empty()) {
    check_output_path(report);
    files.emplace_back(Kind::report, report);
  }
  return files;
}

/// What `make` returns, after `write` has written it into all files. Both stand under one display
/// of progress.
template <typename Kind>
auto make_and_write(const PlannedFiles<Kind>& files, bool quiet, const auto& make,
                    const auto& write) {
  ProgressDisplay display(quiet);
  auto result = make(display);
  for (const auto& [kind, path] : files) {
    display.stage("writing " + path);
    write(kind, path, result);
  }
  return result;
}

}  // namespace brindle::tool
