#include "background_jobs.h"

#include <chrono>
#include <exception>
#include <utility>

namespace brindle::tool {

void BackgroundJobs::start(std::function<std::string()> job) {
  running_.push_back(std::async(std::launch::async, std::move(job)));
}

bool BackgroundJobs::update() {
  const std::size_t before = running_.size();
  std::erase_if(running_, [this](std::future<std::string>& job) {
    if (job.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return false;
    try {
      live_.add_message(MessageKind::note, job.get());
    } catch (const std::exception& error) {
      live_.add_message(MessageKind::error, error.what());
    }
    return true;
  });
  return running_.size() != before;
}

}  // namespace brindle::tool
