#include "session/session_worker.h"

#include <chrono>
#include <utility>

#include "brindle/base/stopwatch.h"
#include "brindle/error.h"
#include "brindle/threads.h"

namespace brindle::tool {
namespace {

constexpr const char* kGivenUp = "cancelled: all is as it was before";

/// Makes frames on the worker's thread.
class FrameMaker {
 public:
  std::shared_ptr<SessionFrame> frame(const SessionRequest& request, const Progress& progress) {
    Stopwatch watch;
    const bool draft = request.quality != PictureQuality::final;
    const bool loosely = draft && request.follow == Follow::last;
    pattern_.update(request.document, loosely ? Follow::loosely : request.follow, progress);
    const double solve_milliseconds = watch.lap();
    if (!picture_) picture_.emplace();
    auto frame = std::make_shared<SessionFrame>();
    frame->revision = request.revision;
    frame->quality = request.quality;
    frame->state = pattern_.state();
    frame->image = draft ? picture_->draft(frame->state, solve_milliseconds, progress)
                         : picture_->draw(frame->state, request.quality, progress);
    frame->camera = picture_->camera(*frame->state);
    frame->nothing_left = picture_->nothing_left(*frame->state);
    frame->draw_milliseconds = watch.lap();
    frame->milliseconds = solve_milliseconds + frame->draw_milliseconds;
    return frame;
  }

 private:
  LivePattern pattern_{CurveMetrics::brief};
  std::optional<LivePicture> picture_;
};

/// Whether the next request makes the current frame useless. Drafts are always shown: otherwise
/// nothing would be seen during continuous motion.
bool is_useless(const SessionRequest& current, const SessionRequest& next) {
  return current.quality == PictureQuality::final || next.follow == Follow::afresh ||
         current.document.mesh != next.document.mesh;
}

}  // namespace

Progress SessionWorker::progress(const std::stop_token& stop) {
  return Progress([this, stop](std::string_view name, double fraction) {
    const std::lock_guard lock(mutex_);
    step_.name = name;
    step_.fraction = fraction;
    return !cancelled_ && !stop.stop_requested();
  });
}

void SessionWorker::finish(std::shared_ptr<const SessionFrame> frame) {
  const std::lock_guard lock(mutex_);
  latest_ = std::move(frame);
}

void SessionWorker::fail(SessionFailure why) {
  const std::lock_guard lock(mutex_);
  failure_ = std::move(why);
}

std::optional<std::uint64_t> SessionWorker::take_given_up() {
  const std::lock_guard lock(mutex_);
  return std::exchange(given_up_, std::nullopt);
}

SessionWorker::SessionWorker(int threads)
    : thread_([this, threads](const std::stop_token& stop) {
        const ThreadLimit limit(threads);
        run(stop);
      }) {}

SessionWorker::~SessionWorker() { stop(); }

void SessionWorker::stop() {
  thread_.request_stop();
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void SessionWorker::run(const std::stop_token& stop) {
  FrameMaker maker;
  std::uint64_t frames = 0;
  while (true) {
    SessionRequest request;
    {
      std::unique_lock lock(mutex_);
      if (!changed_.wait(lock, stop, [&] { return next_.has_value(); })) return;
      current_ = std::exchange(next_, std::nullopt);
      cancelled_ = false;
      begun_ = std::chrono::steady_clock::now();
      request = *current_;
    }
    try {
      std::shared_ptr<SessionFrame> frame = maker.frame(request, progress(stop));
      frame->number = ++frames;
      finish(std::move(frame));
    } catch (const Cancelled&) {
      if (const auto revision = take_given_up()) fail({*revision, kGivenUp});
    } catch (const std::bad_alloc&) {
      fail({request.revision, "not enough memory for this"});
    } catch (const UnreadMesh& error) {
      fail({request.revision, error.what(), request.document.mesh});
    } catch (const std::exception& error) {
      fail({request.revision, error.what()});
    }
    const std::lock_guard lock(mutex_);
    current_.reset();
    given_up_.reset();
    step_ = {};
    changed_.notify_all();
  }
}

void SessionWorker::request(SessionRequest request) {
  const std::lock_guard lock(mutex_);
  // A dropped request from scratch makes this one from scratch.
  if (next_ && next_->follow == Follow::afresh) request.follow = Follow::afresh;
  if (current_ && is_useless(*current_, request)) {
    cancelled_ = true;
    if (current_->follow == Follow::afresh) request.follow = Follow::afresh;
  }
  next_ = std::move(request);
  changed_.notify_all();
}

std::shared_ptr<const SessionFrame> SessionWorker::latest() const {
  const std::lock_guard lock(mutex_);
  return latest_;
}

std::optional<SessionFailure> SessionWorker::take_failure() {
  const std::lock_guard lock(mutex_);
  return std::exchange(failure_, std::nullopt);
}

bool SessionWorker::busy() const {
  const std::lock_guard lock(mutex_);
  return !idle();
}

WorkerStep SessionWorker::step() const {
  const std::lock_guard lock(mutex_);
  WorkerStep step = step_;
  if (!current_) return step;
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begun_;
  step.seconds = passed.count();
  return step;
}

void SessionWorker::cancel() {
  const std::lock_guard lock(mutex_);
  if (!current_) return;
  cancelled_ = true;
  given_up_ = next_ ? next_->revision : current_->revision;
  next_.reset();
}

void SessionWorker::wait() const {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return idle(); });
}

}  // namespace brindle::tool
