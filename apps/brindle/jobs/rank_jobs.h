/// Commands over MPI ranks, in builds with MPI.
#pragma once

#include <string>

#include "cli/commands.h"
#include "jobs/curves_job.h"
#include "jobs/sample_job.h"
#include "jobs/stripe_job.h"

namespace brindle::tool {

/// The tool as one of the processes that a launcher has started. All of them call the same
/// functions.
class RankJobs {
 public:
  virtual ~RankJobs() = default;

  /// Adds the options that ranks alone have.
  virtual void add_options(CLI::App& command) = 0;

  /// Runs a command over all ranks. Returns false if it is for one process, and there is but one.
  virtual bool run(const CLI::App& command, const StripeArguments& arguments) = 0;
  virtual bool run(const CLI::App& command, const CurvesArguments& arguments) = 0;
  virtual bool run(const CLI::App& command, const SampleArguments& arguments) = 0;

  /// Throws CLI::ValidationError for other commands, unless there is but one process.
  virtual void check_for_one(const CLI::App& command) = 0;

  /// Prints the message once, for all ranks that fail, and returns the code.
  virtual int fail(int code, const std::string& message) = 0;
};

/// `add_command` for a command that also runs over ranks; null: there are none.
template <class Arguments, class AddOptions, class Run>
Command add_rank_command(CLI::App& app, RankJobs* ranks, const std::string& name,
                         const std::string& description, const std::string& examples,
                         const AddOptions& add_options, const Run& run) {
  Command added = add_command<Arguments>(
      app, name, description, examples,
      [&](CLI::App& command, Arguments& arguments) {
        add_options(command, arguments);
        if (ranks != nullptr) ranks->add_options(command);
      },
      [ranks, run](const CLI::App& command, Arguments& arguments) {
        stand_upright(arguments.picture, arguments.surface.mesh);
        if (ranks != nullptr && ranks->run(command, arguments)) return;
        refuse_pieces(arguments.outputs);
        run(command, arguments);
      });
  added.over_ranks = true;
  return added;
}

}  // namespace brindle::tool
