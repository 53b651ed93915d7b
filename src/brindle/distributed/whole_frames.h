/// Frames of a distributed surface that rank 0 solves alone.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "brindle/distributed/surface/gathered_surface.h"
#include "brindle/distributed_stripes.h"
#include "brindle/quality.h"

namespace brindle {

/// A wave that its owner sends.
struct SentWave {
  Vec3 position;
  Vec3 direction;
  float frequency = 1;
};

/// The waves as lists, which replace those of `waves`.
void list_waves(std::span<const SentWave> sent, WaveSet& waves);

/// A StripeAnimator for the whole surface on rank 0, with the bits of one process if triangles are
/// numbered. All functions are collective.
class WholeFrames {
 public:
  /// Tolerances and weights are by vertex of the partition. The surface must outlive this object.
  WholeFrames(const RankSurface& surface, const DistributedOptions& options);

  /// As StripeAnimator::frame, for own vertices. All ranks have `normals`, or none. If `progress`
  /// throws on one rank, all ranks throw.
  FrameResult frame(std::span<const SentWave> own, std::span<const Vec3> normals,
                    const Progress& progress);

  /// `crease_slip` of waves and phases of own vertices.
  std::optional<CreaseSlip> slip(std::span<const SentWave> own, std::span<const Complex> z) const;

  double energy() const;
  void restart();
  /// Of own vertices.
  void set_last_phases(std::span<const Complex> own);
  /// By vertex of the partition.
  void set_slack(const Slack& slack);

  /// Of rank 0.
  double topology_milliseconds() const;

  /// Sweeps of a descent over the finest level, including cycles.
  int sweeps() const;

 private:
  /// The outcome of a frame for all ranks, besides its values.
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
  // On rank 0 only.
  std::optional<StripeAnimator> animator_;
  std::vector<SentWave> sent_;
  WaveSet waves_;
  std::vector<Vec3> normals_;
};

}  // namespace brindle
