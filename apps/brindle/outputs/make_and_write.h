/// Runs a job and writes its files.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "brindle/base/stopwatch.h"
#include "brindle/base/text.h"
#include "cli/progress_display.h"
#include "outputs/outputs.h"

namespace brindle::tool {

/// The time for pictures, by `drawn`.
struct DrawingTime {
  std::optional<double> draw_milliseconds;

  void drawn(OutputKind kind, double milliseconds) {
    if (kind != OutputKind::picture) return;
    draw_milliseconds = draw_milliseconds.value_or(0) + milliseconds;
  }
};

/// Returns the result of `make(display)`, after `write(output, result, display)` for all files.
/// `stages` are those of `make`. `drawn(output.kind, milliseconds)` of the result receives the time
/// that each file took.
auto make_and_write(const CLI::App& command, const Outputs& outputs, bool quiet,
                    std::vector<JobStage> stages, const auto& make, const auto& write) {
  const auto writing = [](const Output& output) {
    return "writing " + shown(output.path.native());
  };
  ProgressDisplay display(quiet, &command);
  for (const Output& output : outputs) stages.push_back({writing(output), 2});
  display.plan(std::move(stages));
  auto result = make(display);
  for (const Output& output : outputs) {
    display.stage(writing(output));
    Stopwatch watch;
    write(output, result, display);
    result.drawn(output.kind, watch.lap());
  }
  return result;
}

}  // namespace brindle::tool
