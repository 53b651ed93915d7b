#include "window/base/background_jobs.h"

#include <chrono>
#include <exception>
#include <mutex>
#include <utility>

#include "brindle/base/text.h"

namespace brindle::tool {

/// Called on the job's thread, read on the window's.
class BackgroundJobs::Listener : public JobListener {
 public:
  void note(const std::string& text) override {
    const std::lock_guard lock(mutex_);
    if (!text.empty()) notes_ += "\n" + text;
  }
  std::string notes() const {
    const std::lock_guard lock(mutex_);
    return notes_;
  }
  std::pair<std::string, double> progress_now() const {
    const std::lock_guard lock(mutex_);
    return {step_, fraction_};
  }
  void cancel() {
    const std::lock_guard lock(mutex_);
    cancelled_ = true;
  }

 private:
  Progress whole_progress() override {
    return Progress([this](const ProgressReport& report) {
      const std::lock_guard lock(mutex_);
      step_ = report.step;
      fraction_ = report.fraction;
      return !cancelled_;
    });
  }

  mutable std::mutex mutex_;
  std::string notes_, step_;
  double fraction_ = 0;
  bool cancelled_ = false;
};

void BackgroundJobs::start(std::function<std::string()> job, std::function<void()> then) {
  running_.push_back(
      {std::async(std::launch::async, std::move(job)), std::move(then), {}, nullptr});
}

void BackgroundJobs::write(const std::filesystem::path& path,
                           std::function<void(JobListener&)> job) {
  auto listener = std::make_shared<Listener>();
  auto run = [path, listener, job = std::move(job)] {
    try {
      job(*listener);
    } catch (const Cancelled&) {
      return "cancelled: " + shown(path.native()) + " is not written";
    }
    return "wrote " + shown(path.native()) + listener->notes();
  };
  running_.push_back({std::async(std::launch::async, std::move(run)), {}, path, listener});
}

std::vector<BackgroundJobs::Writing> BackgroundJobs::being_written() const {
  std::vector<Writing> writing;
  for (const Job& job : running_) {
    if (!job.listener) continue;
    auto [step, fraction] = job.listener->progress_now();
    writing.push_back(
        {job.path, std::move(step), fraction, [listener = job.listener] { listener->cancel(); }});
  }
  return writing;
}

bool BackgroundJobs::update() {
  std::vector<Job> done;
  for (std::size_t i = running_.size(); i-- > 0;) {
    if (running_[i].message.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
      continue;
    done.push_back(std::move(running_[i]));
    running_.erase(running_.begin() + static_cast<std::ptrdiff_t>(i));
  }
  for (Job& job : done) {
    try {
      const std::string message = job.message.get();
      if (!message.empty()) live_.add_message(MessageKind::note, message);
      if (job.then) job.then();
    } catch (const std::exception& error) {
      live_.add_message(MessageKind::error, error.what());
    }
  }
  return !done.empty();
}

}  // namespace brindle::tool
