/// The commands of the tool. Each function adds its command to `app` and returns what to run.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "cli/described_options.h"

namespace brindle::tool {

struct Command {
  CLI::App* app;
  std::function<void()> run;
  bool over_ranks = false;  ///< MPI ranks can run it together
};

/// Adds a command. `add_options(app, arguments)` adds its options, `run(app, arguments)` does the
/// work; both receive the command and the parsed arguments.
template <class Arguments, class AddOptions, class Run>
Command add_command(CLI::App& app, const std::string& name, const std::string& description,
                    const std::string& examples, const AddOptions& add_options, const Run& run) {
  CLI::App* command = app.add_subcommand(name, description);
  command->footer(examples);
  const auto arguments = std::make_shared<Arguments>();
  add_options(*command, *arguments);
  describe_options(*command, job_of(name));
  return {command, [command, arguments, run] { run(*command, *arguments); }};
}

class RankJobs;

/// The first three also run over MPI ranks; null: there are none.
Command add_stripe_command(CLI::App& app, RankJobs* ranks = nullptr);
Command add_curves_command(CLI::App& app, RankJobs* ranks = nullptr);
Command add_sample_command(CLI::App& app, RankJobs* ranks = nullptr);
Command add_compare_command(CLI::App& app);
Command add_animate_command(CLI::App& app);
Command add_paths_command(CLI::App& app);
Command add_info_command(CLI::App& app);
Command add_relief_command(CLI::App& app);
Command add_render_command(CLI::App& app);
Command add_gallery_command(CLI::App& app);
Command add_view_command(CLI::App& app);
Command add_help_command(CLI::App& app);
Command add_completion_command(CLI::App& app);

}  // namespace brindle::tool
