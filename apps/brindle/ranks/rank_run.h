/// What all commands over ranks need.
#pragma once

#include <cstddef>

#include "brindle/communicator.h"
#include "brindle/distributed_stripes.h"
#include "jobs/rank_jobs.h"

namespace brindle::tool {

/// The ranks, and the options that they alone have.
struct RankRun {
  Communicator& ranks;
  std::size_t plan_below = DistributedOptions().plan_below;
  int frames = 0;  ///< measured after the pattern is made

  bool is_first() const { return ranks.rank() == 0; }
};

/// Collective. Runs the command; throws CLI::ValidationError for options without effect.
void run_stripe_over(const RankRun& run, const CLI::App& command, const StripeArguments& arguments);
void run_curves_over(const RankRun& run, const CLI::App& command, const CurvesArguments& arguments);
void run_sample_over(const RankRun& run, const CLI::App& command, const SampleArguments& arguments);

}  // namespace brindle::tool
