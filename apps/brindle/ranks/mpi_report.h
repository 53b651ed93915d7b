/// Metrics of parallel runs, in addition to those of one process.
#pragma once

#include <iosfwd>
#include <optional>

#include <nlohmann/json.hpp>

#include "brindle/communicator.h"
#include "brindle/distributed_stripes.h"

namespace brindle::tool {

/// Of all ranks.
struct RankFigures {
  int ranks = 1;
  std::size_t distributed_levels = 0;
  std::size_t vertices_most = 0;  ///< largest number of owned vertices
  double vertices_mean = 0;
  std::size_t ghosts = 0;
  std::uint64_t bytes_sent = 0, messages_sent = 0;
  double waiting_milliseconds_mean = 0, waiting_milliseconds_most = 0;
  std::size_t memory_peak_most = 0;  ///< bytes; 0 if the system does not report it
};

struct FrequencyTraffic {
  std::uint64_t bytes = 0, halo_bytes = 0;
};

/// Of consecutive measured frames. Means are over ranks.
struct FrameFigures {
  int count = 0;
  double milliseconds = 0;                    ///< the median frame, on the slowest rank
  double bytes_sent = 0;                      ///< per frame, on all ranks
  std::uint64_t halo_bytes = 0;               ///< of these, the least that sweeps have to send
  std::optional<FrequencyTraffic> frequency;  ///< per frame, on all ranks, by the spacing tolerance
  double waiting_milliseconds = 0;            ///< per frame
  double imbalance = 1;  ///< busy time of the busiest rank relative to the mean
};

/// Collective.
RankFigures rank_figures(Communicator& ranks, const DistributedSurface& surface,
                         const DistributedStripeAnimator& animator);

/// Collective. Solves `frames` frames starting from `waves`; directions turn by a degree per frame
/// about the normals.
FrameFigures measure_frames(Communicator& ranks, const DistributedSurface& surface,
                            DistributedStripeAnimator& animator, const WaveSet& waves, int count);

nlohmann::ordered_json to_json(const RankFigures& figures);
nlohmann::ordered_json to_json(const FrameFigures& figures);

/// As text.
void print_ranks(std::ostream& out, const RankFigures& figures);
void print_frames(std::ostream& out, const FrameFigures& figures);

}  // namespace brindle::tool
