/// Receives stages, progress and notes of a long job.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "brindle/progress.h"

namespace brindle::tool {

class JobListener {
 public:
  virtual ~JobListener() = default;

  /// All stages of the job, in order, for one common progress. Otherwise each stage has its own.
  void plan(std::vector<JobStage> stages) {
    planned_ = stages;
    stages_.emplace(whole_progress(), std::move(stages));
  }

  /// Progress of the present stage.
  Progress progress() { return stages_ ? present_ : whole_progress(); }

  /// Begins a stage. Throws Cancelled.
  void stage(std::string_view name) {
    const auto planned = std::ranges::find(planned_, name, &JobStage::name);
    if (planned != planned_.end()) {
      // A repeated stage, as for further surfaces, is part of the present one.
      planned_.erase(planned_.begin(), planned + 1);
      whole_stage_ = present_ = stages_->begin(name);
    } else {
      progress().report(name, 0);
    }
  }

  /// Maps further progress to the share `begin` to `end` of the present stage, in [0, 1], for
  /// frames that are jobs themselves. No effect without a plan.
  void narrow(double begin, double end) { present_ = whole_stage_.part(begin, end); }

  /// Lines for the user; ignores empty text.
  virtual void note(const std::string& text) = 0;

 private:
  /// Progress of the whole job, or of an unplanned stage.
  virtual Progress whole_progress() = 0;

  std::vector<JobStage> planned_;  // not begun yet
  std::optional<JobStages> stages_;
  Progress whole_stage_;
  Progress present_;  // of that
};

}  // namespace brindle::tool
