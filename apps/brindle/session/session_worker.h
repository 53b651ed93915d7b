/// A thread that solves and draws, so that a window never waits.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "session/live_pattern.h"
#include "session/live_picture.h"

namespace brindle::tool {

struct SessionRequest {
  SessionDocument document;
  std::uint64_t revision = 0;
  PictureQuality quality = PictureQuality::final;  ///< else a draft
  Follow follow = Follow::afresh;                  ///< `Session::follows`
};

/// The result of a request. Immutable.
struct SessionFrame {
  std::uint64_t revision = 0;
  std::uint64_t number = 0;  ///< 1, 2, 3 ... in the order of completion
  PictureQuality quality = PictureQuality::final;
  Image image;
  Camera camera;                           ///< of the picture, for `pick`
  std::string nothing_left;                ///< the reason why it shows nothing; else empty
  std::shared_ptr<const LiveState> state;  ///< document, metrics, notes, phases
  double draw_milliseconds = 0;
  double milliseconds = 0;  ///< in total

  const Surface& surface() const { return *state->job->surface; }
};

/// The present activity of a worker.
struct WorkerStep {
  std::string name;     ///< "multilevel"; empty if idle
  double fraction = 0;  ///< progress of the step, in [0, 1]
  double seconds = 0;   ///< since the start of the current request
};

/// The reason why a request has no frame.
struct SessionFailure {
  std::uint64_t revision = 0;
  std::string text;
  std::string unread_mesh = {};  ///< that cannot be read; empty for other reasons
};

/// A thread that owns a LivePattern and a LivePicture. Only `wait`, `stop` and the destructor
/// block.
class SessionWorker {
 public:
  /// `threads` for solving; 0: all hardware threads.
  explicit SessionWorker(int threads = 0);
  ~SessionWorker();
  SessionWorker(const SessionWorker&) = delete;
  SessionWorker& operator=(const SessionWorker&) = delete;

  /// Requests a frame, replacing a waiting request. Cancels the current one if its quality is
  /// final, its mesh differs, or the new one is from scratch; else it is shown first, so that there
  /// is something to see during continuous requests. If a request from scratch is replaced or
  /// cancelled, this one is made from scratch.
  void request(SessionRequest request);

  /// The newest frame; null before the first one.
  std::shared_ptr<const SessionFrame> latest() const;

  /// The failure of the newest failed request, once; then empty until the next one.
  std::optional<SessionFailure> take_failure();

  /// Cancels everything and ends the thread; later requests are ignored.
  void stop();

  /// Cancels the current and the waiting request. `take_failure` then returns the cancellation, so
  /// that a window can go back. Does nothing if idle.
  void cancel();

  /// Whether a request is current or waiting, and the present step.
  bool busy() const;
  WorkerStep step() const;

  /// Waits until the worker is idle.
  void wait() const;

 private:
  void run(const std::stop_token& stop);
  Progress progress(const std::stop_token& stop);
  void finish(std::shared_ptr<const SessionFrame> frame);
  void fail(SessionFailure why);
  std::optional<std::uint64_t> take_given_up();
  bool idle() const { return !next_ && !current_; }

  // Shared by the window's and the worker's thread; guarded by the mutex.
  mutable std::mutex mutex_;
  mutable std::condition_variable_any changed_;
  std::optional<SessionRequest> next_;
  std::optional<SessionRequest> current_;
  bool cancelled_ = false;                 // `current_` is obsolete
  std::optional<std::uint64_t> given_up_;  // newest revision passed to `cancel`
  std::shared_ptr<const SessionFrame> latest_;
  std::optional<SessionFailure> failure_;
  WorkerStep step_;
  std::chrono::steady_clock::time_point begun_;  // of `current_`
  std::jthread thread_;  // declared last: stops before its members are destroyed
};

}  // namespace brindle::tool
