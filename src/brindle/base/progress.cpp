#include "brindle/progress.h"

#include <algorithm>
#include <cmath>
#include <utility>

#if !defined(BRINDLE_SILENT)

namespace brindle {

struct Progress::State {
  Callback callback;
  JobCallback job_callback;
  std::vector<JobStage> stages;  // of the whole job
  std::size_t stage = 0;
  double done = 0;
  std::string step;  // of the last report
  double step_fraction = 0;
};

Progress::Progress(Callback callback) {
  if (!callback) return;
  state_ = std::make_shared<State>();
  state_->callback = std::move(callback);
}

Progress::Progress(JobCallback callback) {
  if (!callback) return;
  state_ = std::make_shared<State>();
  state_->job_callback = std::move(callback);
}

void Progress::tell(double whole, std::string_view step, double fraction) const {
  State& s = *state_;
  // Never decreases, even if a step or rounding goes back.
  s.done = std::max(s.done, std::min(whole, 1.0));
  s.step = step;
  s.step_fraction = fraction;
  const bool goes_on = s.callback ? s.callback(step, fraction)
                                  : s.job_callback({s.done, step, fraction, s.stages, s.stage});
  if (!goes_on) throw Cancelled("cancelled");
}

void Progress::report(std::string_view step, double fraction) const {
  if (state_) tell(begin_ + fraction * (end_ - begin_), step, fraction);
}

void Progress::report(double fraction) const {
  if (state_) {
    tell(begin_ + fraction * (end_ - begin_), step_, from_ + fraction * (to_ - from_));
  }
}

void Progress::report(const ProgressReport& inner) const {
  if (state_) tell(begin_ + inner.fraction * (end_ - begin_), inner.step, inner.step_fraction);
}

void Progress::tick() const {
  if (!state_) return;
  const bool is_under_way = state_->step == step_;
  tell(state_->done, step_, is_under_way ? state_->step_fraction : from_);
}

Progress Progress::part(double begin, double end) const {
  Progress result = *this;
  result.is_whole_ = false;
  result.begin_ = begin_ + begin * (end_ - begin_);
  result.end_ = begin_ + end * (end_ - begin_);
  result.from_ = from_ + begin * (to_ - from_);
  result.to_ = from_ + end * (to_ - from_);
  return result;
}

Progress Progress::step(std::string_view name) const {
  Progress result = *this;
  result.step_ = name;
  result.from_ = 0;
  result.to_ = 1;
  return result;
}

std::span<const JobStage> Progress::stages() const {
  return state_ ? std::span<const JobStage>(state_->stages) : std::span<const JobStage>();
}

JobStages::JobStages(const Progress& progress, std::vector<JobStage> stages)
    : progress_(progress), stages_(std::move(stages)), begins_{0} {
  double sum = 0;
  for (const JobStage& stage : stages_) {
    if (!(stage.weight > 0) || !std::isfinite(stage.weight)) {
      throw Error("progress: the weight of stage '" + stage.name + "' must be above 0");
    }
    sum += stage.weight;
  }
  if (stages_.empty()) throw Error("progress: a job needs a stage");
  for (JobStage& stage : stages_) {
    stage.weight /= sum;
    begins_.push_back(begins_.back() + stage.weight);
  }
  begins_.back() = 1;
  if (!progress_.state_ || !progress_.is_whole_) return;
  progress_.state_->stages = stages_;
  progress_.state_->stage = 0;
  progress_.state_->done = 0;
}

Progress JobStages::begin(std::string_view name) {
  const auto found =
      std::find_if(stages_.begin() + static_cast<std::ptrdiff_t>(next_), stages_.end(),
                   [&](const JobStage& stage) { return stage.name == name; });
  if (found == stages_.end()) {
    throw Error("progress: no stage '" + std::string(name) + "' is left of this job");
  }
  const auto number = static_cast<std::size_t>(found - stages_.begin());
  next_ = number + 1;
  if (!progress_.state_) return {};
  if (progress_.is_whole_) progress_.state_->stage = number;
  Progress result = progress_.part(begins_[number], begins_[number + 1]);
  result.step_ = name;
  result.from_ = 0;
  result.to_ = 1;
  result.report(0);
  return result;
}

void JobStages::finish() const {
  if (progress_.state_) progress_.tell(progress_.end_, stages_.back().name, 1);
}

}  // namespace brindle

#endif
