/// What a run over many processes reports beside what one process does.
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
  std::size_t vertices_most = 0;  ///< that one rank owns
  double vertices_mean = 0;
  std::size_t ghosts = 0;
  std::uint64_t bytes_sent = 0, messages_sent = 0;
  double waiting_milliseconds_mean = 0, waiting_milliseconds_most = 0;
  std::size_t memory_peak_most = 0;  ///< bytes; 0 where the system does not tell
};

struct FrequencyTraffic {
  std::uint64_t bytes = 0, halo_bytes = 0;
};

/// Of frames that were measured one after the other. Means are over ranks.
struct FrameFigures {
  int count = 0;
  double milliseconds = 0;                    ///< the median frame, on the slowest rank
  double bytes_sent = 0;                      ///< a frame, by all ranks
  std::uint64_t halo_bytes = 0;               ///< of these what sweeps have to send at least
  std::optional<FrequencyTraffic> frequency;  ///< a frame, by all ranks: of frequencies that yield
  double waiting_milliseconds = 0;            ///< a frame
  double imbalance = 1;  ///< time without waiting of the busiest rank over the mean
};

/// Collective.
RankFigures rank_figures(Communicator& ranks, const DistributedSurface& surface,
                         const DistributedStripeAnimator& animator);

/// Collective. Solves so many frames on from `waves`, whose directions turn by a degree a frame
/// about the normals.
FrameFigures measure_frames(Communicator& ranks, const DistributedSurface& surface,
                            DistributedStripeAnimator& animator, const WaveSet& waves, int count);

nlohmann::ordered_json to_json(const RankFigures& figures);
nlohmann::ordered_json to_json(const FrameFigures& figures);

/// Lines for people.
void print_ranks(std::ostream& out, const RankFigures& figures);
void print_frames(std::ostream& out, const FrameFigures& figures);

}  // namespace brindle::tool
