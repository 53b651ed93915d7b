/// The tool as one of the processes that a launcher of MPI programs has started.
#pragma once

#include <optional>
#include <streambuf>
#include <string>
#include <vector>

#include "brindle/communicator.h"
#include "jobs/rank_jobs.h"
#include "ranks/rank_run.h"
#include "ranks/stall_watch.h"

namespace brindle::tool {

/// Starts MPI if there may be several processes, or the command needs it. MPI ends with it.
class OverRanks final : public RankJobs {
 public:
  /// `processes`: of the launcher; 0 if unknown.
  explicit OverRanks(int processes);
  ~OverRanks() override;
  OverRanks(const OverRanks&) = delete;
  OverRanks& operator=(const OverRanks&) = delete;

  /// Throws CLI::ValidationError as `check_same_words` does.
  void check_words(const std::vector<std::string>& words);

  void add_options(CLI::App& command) override;
  bool run(const CLI::App& command, const StripeArguments& arguments) override;
  bool run(const CLI::App& command, const CurvesArguments& arguments) override;
  bool run(const CLI::App& command, const SampleArguments& arguments) override;
  void check_for_one(const CLI::App& command) override;
  int fail(int code, const std::string& message) override;

 private:
  bool several() const { return ranks_ && ranks_->size() > 1; }
  void start_mpi();
  template <class Arguments>
  bool run_over(const CLI::App& command, const Arguments& arguments,
                void (*job)(const RankRun&, const CLI::App&, const Arguments&));

  /// What other ranks than the first print, such as help.
  struct Nowhere : std::streambuf {
    int overflow(int letter) override { return letter; }
  } nowhere_;
  std::streambuf* standard_output_ = nullptr;  // of ranks whose output goes nowhere
  std::optional<Communicator> ranks_;
  std::size_t plan_below_ = DistributedOptions().plan_below;
  int frames_ = 0;
  double stall_limit_ = kStallLimit;
};

}  // namespace brindle::tool
