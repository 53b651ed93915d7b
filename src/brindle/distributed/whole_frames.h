/// Frames of a surface in pieces that rank 0 solves alone.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "brindle/distributed/surface/gathered_surface.h"
#include "brindle/distributed_stripes.h"

namespace brindle {

/// A wave as owners tell others of it.
struct SentWave {
  Vec3 position;
  Vec3 direction;
  float frequency = 1;
};

/// A StripeAnimator of the whole surface, which rank 0 has: its bits are those of one process where
/// triangles have numbers. All functions must be called by all ranks.
class WholeFrames {
 public:
  /// Slack and calm by vertex are those of the piece's vertices. The surface must live as long.
  WholeFrames(const RankSurface& surface, const DistributedOptions& options);

  /// As StripeAnimator::frame, of own vertices. `normals` are there on all ranks or none. Any
  /// rank's `progress` cancels all.
  FrameResult frame(std::span<const SentWave> own, std::span<const Vec3> normals,
                    const Progress& progress);

  double energy() const;
  void restart();
  /// Of own vertices.
  void set_last_phases(std::span<const Complex> own);
  /// Of the piece's vertices.
  void set_slack(const Slack& slack);

  /// Of rank 0.
  double topology_milliseconds() const;

  /// Sweeps of a descent over the finest level, cycles included.
  int sweeps() const;

 private:
  /// What ranks hear of a frame beside its values.
  struct Outcome {
    bool unchanged = false;
    double phase_step = 0;
    FrequencyChange change;
    FrameMilliseconds milliseconds;
  };

  Slack slack_of_whole(const Slack& of_piece) const;
  FrameInput gather(std::span<const SentWave> own, std::span<const Vec3> normals);

  Communicator& ranks_;
  GatheredSurface whole_;
  AnimatorOptions options_;
  bool has_descended_ = false;
  std::vector<Complex> z_;  ///< of own vertices
  std::vector<float> frequencies_;
  // On rank 0 alone.
  std::optional<StripeAnimator> animator_;
  std::vector<SentWave> waves_;
  std::vector<Vec3> positions_, directions_, normals_;
  std::vector<float> wanted_;
};

}  // namespace brindle
