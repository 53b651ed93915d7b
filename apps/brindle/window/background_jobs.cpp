#include "window/background_jobs.h"

#include <chrono>
#include <exception>
#include <utility>

namespace brindle::tool {

void BackgroundJobs::start(std::function<std::string()> job, std::function<void()> then) {
  running_.push_back({std::async(std::launch::async, std::move(job)), std::move(then)});
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
