/// Who hears of a long job.
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

  /// All stages of the job, in their order, so that it has one fraction. Without, each stage has
  /// its own.
  void plan(std::vector<JobStage> stages) {
    planned_ = stages;
    stages_.emplace(whole_progress(), std::move(stages));
  }

  /// What to hand to what the present stage does.
  Progress progress() { return stages_ ? present_ : whole_progress(); }

  /// Names the stage that begins. Throws Cancelled if the job is to stop.
  void stage(std::string_view name) {
    const auto planned = std::ranges::find(planned_, name, &JobStage::name);
    if (planned != planned_.end()) {
      // A stage that comes once more, as other surfaces are read, is part of the present one.
      planned_.erase(planned_.begin(), planned + 1);
      whole_stage_ = present_ = stages_->begin(name);
    } else {
      progress().report(name, 0);
    }
  }

  /// What is done from now on is this share of the present stage, `begin` to `end`, in [0, 1]: of
  /// frames that are each many jobs. Without a plan nothing changes.
  void narrow(double begin, double end) { present_ = whole_stage_.part(begin, end); }

  /// Lines for the user; nothing if the text is empty.
  virtual void note(const std::string& text) = 0;

 private:
  /// What to hand to the whole job, or to a stage of one that was not planned.
  virtual Progress whole_progress() = 0;

  std::vector<JobStage> planned_;  // those that have not begun
  std::optional<JobStages> stages_;
  Progress whole_stage_;
  Progress present_;  // of that
};

}  // namespace brindle::tool
