#include "session/session_worker.h"

#include <chrono>
#include <utility>

#include "brindle/base/stopwatch.h"
#include "brindle/error.h"
#include "brindle/threads.h"

namespace brindle::tool {

/// Shared by the window's and the worker's thread; guarded by the mutex, except for the worker's
/// own members.
struct SessionWorker::State {
  int threads = 0;
  mutable std::mutex mutex;
  mutable std::condition_variable_any changed;
  std::optional<SessionRequest> next;
  std::optional<SessionRequest> current;
  bool cancelled = false;                 ///< `current` is obsolete
  std::optional<std::uint64_t> given_up;  ///< newest revision passed to `cancel`
  std::shared_ptr<const SessionFrame> latest;
  std::optional<SessionFailure> failure;
  WorkerStep step;
  std::chrono::steady_clock::time_point begun;  ///< of `current`
  std::uint64_t frames = 0;

  bool idle() const { return !next && !current; }
  Progress progress(const std::stop_token& stop);
  void finish(std::shared_ptr<const SessionFrame> frame);
  void fail(SessionFailure why);
  std::optional<std::uint64_t> take_given_up();
};

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

Progress SessionWorker::State::progress(const std::stop_token& stop) {
  return Progress([this, stop](std::string_view name, double fraction) {
    const std::lock_guard lock(mutex);
    step.name = name;
    step.fraction = fraction;
    return !cancelled && !stop.stop_requested();
  });
}

void SessionWorker::State::finish(std::shared_ptr<const SessionFrame> frame) {
  const std::lock_guard lock(mutex);
  latest = std::move(frame);
}

void SessionWorker::State::fail(SessionFailure why) {
  const std::lock_guard lock(mutex);
  failure = std::move(why);
}

std::optional<std::uint64_t> SessionWorker::State::take_given_up() {
  const std::lock_guard lock(mutex);
  return std::exchange(given_up, std::nullopt);
}

SessionWorker::SessionWorker(int threads) : state_(std::make_unique<State>()), thread_() {
  state_->threads = threads;
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

SessionWorker::~SessionWorker() { stop(); }

void SessionWorker::stop() {
  thread_.request_stop();
  state_->changed.notify_all();
  if (thread_.joinable()) thread_.join();
}

void SessionWorker::run(const std::stop_token& stop) {
  State& s = *state_;
  const ThreadLimit limit(s.threads);
  FrameMaker maker;
  while (true) {
    SessionRequest request;
    {
      std::unique_lock lock(s.mutex);
      if (!s.changed.wait(lock, stop, [&] { return s.next.has_value(); })) return;
      s.current = std::exchange(s.next, std::nullopt);
      s.cancelled = false;
      s.begun = std::chrono::steady_clock::now();
      request = *s.current;
    }
    try {
      std::shared_ptr<SessionFrame> frame = maker.frame(request, s.progress(stop));
      frame->number = ++s.frames;
      s.finish(std::move(frame));
    } catch (const Cancelled&) {
      if (const auto revision = s.take_given_up()) s.fail({*revision, kGivenUp});
    } catch (const std::bad_alloc&) {
      s.fail({request.revision, "not enough memory for this"});
    } catch (const UnreadMesh& error) {
      s.fail({request.revision, error.what(), request.document.mesh});
    } catch (const std::exception& error) {
      s.fail({request.revision, error.what()});
    }
    const std::lock_guard lock(s.mutex);
    s.current.reset();
    s.given_up.reset();
    s.step = {};
    s.changed.notify_all();
  }
}

void SessionWorker::request(SessionRequest request) {
  State& s = *state_;
  const std::lock_guard lock(s.mutex);
  // A dropped request from scratch makes this one from scratch.
  if (s.next && s.next->follow == Follow::afresh) request.follow = Follow::afresh;
  if (s.current && is_useless(*s.current, request)) {
    s.cancelled = true;
    if (s.current->follow == Follow::afresh) request.follow = Follow::afresh;
  }
  s.next = std::move(request);
  s.changed.notify_all();
}

std::shared_ptr<const SessionFrame> SessionWorker::latest() const {
  const std::lock_guard lock(state_->mutex);
  return state_->latest;
}

std::optional<SessionFailure> SessionWorker::take_failure() {
  const std::lock_guard lock(state_->mutex);
  return std::exchange(state_->failure, std::nullopt);
}

bool SessionWorker::busy() const {
  const std::lock_guard lock(state_->mutex);
  return !state_->idle();
}

WorkerStep SessionWorker::step() const {
  const std::lock_guard lock(state_->mutex);
  WorkerStep step = state_->step;
  if (!state_->current) return step;
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - state_->begun;
  step.seconds = passed.count();
  return step;
}

void SessionWorker::cancel() {
  State& s = *state_;
  const std::lock_guard lock(s.mutex);
  if (!s.current) return;
  s.cancelled = true;
  s.given_up = s.next ? s.next->revision : s.current->revision;
  s.next.reset();
}

void SessionWorker::wait() const {
  std::unique_lock lock(state_->mutex);
  state_->changed.wait(lock, [this] { return state_->idle(); });
}

}  // namespace brindle::tool
