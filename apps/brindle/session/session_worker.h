/// A thread that solves and draws, so that a window never waits.
#pragma once

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

/// What was solved and drawn of a request. Never changes.
struct SessionFrame {
  std::uint64_t revision = 0;
  std::uint64_t number = 0;  ///< 1, 2, 3 ... in the order in which frames were finished
  PictureQuality quality = PictureQuality::final;
  Image image;
  Camera camera;                           ///< with which it was drawn: for `pick`
  std::string nothing_left;                ///< why it shows nothing; empty if it shows anything
  std::shared_ptr<const LiveState> state;  ///< document, figures, notes, phases
  double draw_milliseconds = 0;
  double milliseconds = 0;  ///< all together

  const Surface& surface() const { return *state->job->surface; }
};

/// What a worker is at.
struct WorkerStep {
  std::string name;     ///< "multilevel"; empty if it is at nothing
  double fraction = 0;  ///< done of the step, in [0, 1]
  double seconds = 0;   ///< since the request that is being made was begun
};

/// Why a request has no frame.
struct SessionFailure {
  std::uint64_t revision = 0;
  std::string text;
  std::string unread_mesh = {};  ///< that cannot be read; empty if something else is the reason
};

/// One thread that owns a LivePattern and a LivePicture. Nothing here waits for it, but `wait`,
/// `stop` and the destructor, which stops it.
class SessionWorker {
 public:
  /// Threads that solve; 0: all that the machine has.
  explicit SessionWorker(int threads = 0);
  ~SessionWorker();
  SessionWorker(const SessionWorker&) = delete;
  SessionWorker& operator=(const SessionWorker&) = delete;

  /// Asks for a frame. One that waits is dropped. One that is being made is cancelled if its
  /// quality is final, its mesh another one, or this one is to be made afresh; else it is shown
  /// before this one, so that there is something to see while requests never stop. If one that was
  /// to be made afresh is dropped or cancelled, this one is made afresh instead.
  void request(SessionRequest request);

  /// The newest frame; null before the first one.
  std::shared_ptr<const SessionFrame> latest() const;

  /// The failure of the newest request that failed, once: then nothing until the next one.
  std::optional<SessionFailure> take_failure();

  /// Cancels what is going on and ends the thread; nothing that is asked for later is made.
  void stop();

  /// Gives up what is being made and what waits, at the next report. It fails for that reason,
  /// which `take_failure` has, so that a window goes back to what it shows. Nothing if it is idle.
  void cancel();

  /// Whether something is being made or waits, and what.
  bool busy() const;
  WorkerStep step() const;

  /// Waits until nothing is left to do.
  void wait() const;

 private:
  void run(const std::stop_token& stop);
  struct State;
  std::unique_ptr<State> state_;
  std::jthread thread_;  // last: stops before what it uses goes
};

}  // namespace brindle::tool
