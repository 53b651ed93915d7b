/// Building blocks of option rows: groups, jobs and ranges of numbers.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

#include "brindle/option_table.h"
#include "brindle/waves/wave_check.h"

namespace brindle {

constexpr unsigned kStripe = static_cast<unsigned>(PatternJob::stripe);
constexpr unsigned kCurves = static_cast<unsigned>(PatternJob::curves);
constexpr unsigned kSample = static_cast<unsigned>(PatternJob::sample);
constexpr unsigned kAnimate = static_cast<unsigned>(PatternJob::animate);
constexpr unsigned kCompare = static_cast<unsigned>(PatternJob::compare);
constexpr unsigned kPaths = static_cast<unsigned>(PatternJob::paths);
constexpr unsigned kRelief = static_cast<unsigned>(PatternJob::relief);
constexpr unsigned kAll = kStripe | kCurves | kSample | kAnimate | kCompare | kPaths | kRelief;

constexpr NumberRange kAnyNumber = {};
constexpr NumberRange kNotNegative = {.least = 0};
constexpr NumberRange kPositive = {.least = 0, .above_least = true};
constexpr NumberRange kShare = {.least = 0, .most = 1};
constexpr NumberRange kWeight = {.least = 0, .most = kLargestWeight};
constexpr NumberRange kPixels = {.least = 0, .most = 10000, .above_least = true};

/// The reason for rejecting an option over MPI ranks.
constexpr std::string_view kNeedsWhole =
    "it needs the whole surface in one process; start brindle without mpirun";

/// Rows of one group. `common` has the group's name, and the stage, jobs, `one_process`, `own`
/// and `styles` of rows without their own. All lengths get the same metavariable and unit.
template <std::size_t N>
constexpr std::array<OptionInfo, N> in_group(const OptionInfo& common,
                                             const OptionInfo (&rows)[N]) {
  std::array<OptionInfo, N> result;
  for (std::size_t i = 0; i < N; ++i) {
    OptionInfo& row = result[i] = rows[i];
    row.group = common.group;
    row.own = row.own || common.own;
    row.styles = row.styles || common.styles;
    if (row.one_process.empty()) row.one_process = common.one_process;
    if (row.stale == OptionStage::none) row.stale = common.stale;
    if (row.jobs == 0) row.jobs = common.jobs;
    if (row.kind != OptionKind::length) continue;
    row.form = "L|P%";
    row.unit = "units of length, or percent of the diagonal";
  }
  return result;
}

template <std::size_t... Sizes>
constexpr auto joined(const std::array<OptionInfo, Sizes>&... parts) {
  std::array<OptionInfo, (Sizes + ...)> rows;
  auto next = rows.begin();
  ((next = std::copy(parts.begin(), parts.end(), next)), ...);
  return rows;
}

}  // namespace brindle
