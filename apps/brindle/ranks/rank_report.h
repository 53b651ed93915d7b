/// Metrics of parallel runs, in addition to those of one process.
#pragma once

#include <iosfwd>

#include <nlohmann/json.hpp>

#include "brindle/communicator.h"
#include "brindle/distributed_stripes.h"

namespace brindle::tool {

/// Collective. Traffic, waiting and memory of all ranks, for the key "ranks".
nlohmann::ordered_json rank_metrics(Communicator& ranks, const DistributedSurface& surface,
                                    const DistributedStripeAnimator& animator);

/// Collective. Solves `count` frames starting from `waves`, whose directions turn by a degree per
/// frame about the normals, for the key "frames": the median time on the slowest rank; traffic per
/// frame on all ranks, of which sweeps have to send `halo_bytes`, and the spacing tolerance its
/// own; the busy time of the busiest rank relative to the mean.
nlohmann::ordered_json measure_frames(Communicator& ranks, const DistributedSurface& surface,
                                      DistributedStripeAnimator& animator, const WaveSet& waves,
                                      int count);

/// The same as text.
void print_ranks(std::ostream& out, const nlohmann::ordered_json& metrics);
void print_frames(std::ostream& out, const nlohmann::ordered_json& metrics);

}  // namespace brindle::tool
