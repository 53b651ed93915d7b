/// The commands of the tool. Each adds itself to `app` and returns what to run when it is chosen.
#pragma once

#include <functional>

#include <CLI/CLI.hpp>

namespace brindle::tool {

struct Command {
  CLI::App* app;
  std::function<void()> run;
};

Command add_stripe_command(CLI::App& app);
Command add_compare_command(CLI::App& app);
Command add_curves_command(CLI::App& app);
Command add_sample_command(CLI::App& app);
Command add_animate_command(CLI::App& app);
Command add_info_command(CLI::App& app);
Command add_bench_command(CLI::App& app);

}  // namespace brindle::tool
