#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/progress.h"
#include "brindle/shapes.h"
#include "brindle/version.h"
#include "cli/blas_threads.h"
#include "cli/commands.h"
#include "cli/help.h"
#include "cli/option_parts.h"
#include "cli/progress_display.h"
#include "jobs/rank_jobs.h"
#ifdef BRINDLE_HAS_MPI
#include "ranks/over_ranks.h"
#endif

namespace brindle::tool {
namespace {

enum ExitCode { kDone = 0, kFailed = 1, kWrongUsage = 2 };

constexpr const char* kToolExamples = R"(Examples:
  brindle stripe shape:torus --output torus.png
  brindle stripe horse.ply --direction 0.31,0.9,0.27 --stripes 40 --output horse.png
  brindle compare horse.ply --stripes 160
  brindle animate horse.ply --scene vortices --output vortices.mp4
  brindle curves horse.ply --stripes 100 --output horse.svg
  brindle sample horse.ply --output samples.csv
  brindle paths horse.ply --scale 50:1 --output horse.gcode
  brindle relief shape:bracket --texture knurl --height 1% --spacing 4% --output knurled.stl
  brindle info horse.ply

'brindle COMMAND --help' describes each command, 'brindle help' values, lengths, cameras and files.
All end with 0 if the job is done, 1 if it failed, 2 if the command line is wrong and 130 if Ctrl-C
ended it (143 for SIGTERM, 129 for SIGHUP).)";

int fail(int code, const std::string& message, RankJobs* ranks = nullptr) {
  if (ranks != nullptr) return ranks->fail(code, message);
  std::cerr << "brindle: " << shown_lines(message) << '\n';
  return code;
}

// " (did you mean 'NAME'?)" for a mistyped word, or "".
std::string suggestion(const std::string& word, const std::vector<std::string>& known) {
  const std::string meant = nearest(word, known);
  return meant.empty() ? "" : " (did you mean '" + meant + "'?)";
}

// For the first unknown option in `words`.
std::string option_suggestion(const CLI::App& app, const std::vector<std::string>& words) {
  std::vector<std::string> known;
  for (const CLI::Option* option : app.get_options()) {
    if (is_part(*option, app)) continue;
    for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
  }
  for (const std::string& word : words) {
    const std::string name = word.substr(0, word.find('='));
    if (name.starts_with("--")) return suggestion(name, known);
  }
  return "";
}

// CLI11 lists unknown words from last to first.
std::string words_of(const CLI::ParseError& error, const std::vector<std::string>& unknown) {
  if (dynamic_cast<const CLI::ExtrasError*>(&error) == nullptr) return error.what();
  std::string words;
  for (const std::string& word : unknown) words += ' ' + word;
  return "not expected:" + words;
}

std::string referral(const std::string& command) {
  return "\nbrindle: 'brindle " + command + " --help' tells more";
}

// Explains a wrong command line, whose first word is `first`, and refers to help.
std::string explanation(const CLI::ParseError& error, const std::vector<Command>& commands,
                        const CLI::App& app, const std::string& first) {
  std::string names;
  std::vector<std::string> known;
  for (const Command& command : commands) {
    const std::string name = command.app->get_name();
    if (command.app->parsed()) {
      const std::vector<std::string> unknown = command.app->remaining();
      return in_command_words(*command.app, words_of(error, unknown)) +
             option_suggestion(*command.app, unknown) + referral(name);
    }
    known.push_back(name);
    names += (names.empty() ? "" : ", ") + name;
  }
  std::string wrong = first.empty() ? "name a command" : "'" + first + "' is no command";
  std::error_code ignored;
  const bool is_mesh = first.starts_with("shape:") || std::filesystem::exists(first, ignored);
  wrong += is_mesh ? "; did you mean 'stripe " + first + "'?" : suggestion(first, known);
  if (first.starts_with('-')) wrong = error.what() + option_suggestion(app, {first});
  return wrong + "; commands are: " + names + "\nbrindle: 'brindle --help' tells more";
}

void finish_output() {
  std::cout.flush();
  if (!std::cout) throw Error("cannot write to standard output");
}

int run(const Command& command, RankJobs* ranks) {
  const auto fail_as = [&](ExitCode code, const std::exception& error) {
    return fail(code, in_command_words(*command.app, error.what()), ranks);
  };
  try {
    if (ranks != nullptr && !command.over_ranks) ranks->check_for_one(*command.app);
    command.run();
    finish_output();
    return kDone;
  } catch (const CLI::ParseError& error) {
    return fail_as(kWrongUsage, error);
  } catch (const Cancelled&) {
    return fail(cancelled_exit_code(), "cancelled", ranks);
  } catch (const std::bad_alloc&) {
    return fail(kFailed, "not enough memory; try a smaller mesh or a smaller --subdivide", ranks);
  } catch (const std::exception& error) {
    return fail_as(kFailed, error);
  }
}

int parse_and_run(int argc, char** argv, RankJobs* ranks) {
  CLI::App app{"Lays stripe patterns over surfaces, aligned to a direction field.", "brindle"};
  app.formatter(std::make_shared<HelpFormatter>());
  app.set_help_all_flag("--help-all", "Print help with all options and exit");
  app.set_version_flag("--version", "brindle " BRINDLE_VERSION "\nbuilt in: " BRINDLE_BUILT_IN,
                       "Print the version and what is built in, and exit");
  app.add_flag_callback(
      "--shapes",
      [] {
        std::cout << shape_help();
        throw CLI::Success();
      },
      "List the built-in shapes and exit");
  app.require_subcommand(1);
  app.footer(kToolExamples);
  const std::vector<Command> commands = {
      add_stripe_command(app, ranks), add_compare_command(app), add_curves_command(app, ranks),
      add_paths_command(app),         add_relief_command(app),  add_sample_command(app, ranks),
      add_animate_command(app),       add_info_command(app),
#ifdef BRINDLE_HAS_WINDOW
      add_view_command(app),
#endif
      add_render_command(app),        add_gallery_command(app), add_help_command(app),
      add_completion_command(app)};
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  const std::string first = words.empty() ? "" : words.front();
#ifndef BRINDLE_HAS_WINDOW
  if (first == "view") {
    throw Error(
        "this build has no window; install GLFW and Dear ImGui (libglfw3-dev, libimgui-dev), and "
        "configure with -DBRINDLE_WINDOW=ON; 'brindle render' draws sessions without a window");
  }
#endif
  try {
    words = command_line_with_parts_apart(app, words);
  } catch (const CLI::ValidationError& error) {
    return fail(kWrongUsage, error.what() + referral(first), ranks);
  }
  std::ranges::reverse(words);  // CLI11's order
  try {
    app.parse(std::move(words));
  } catch (const CLI::Success& success) {
    const int status = app.exit(success);
    finish_output();
    return status == 0 ? kDone : kFailed;
  } catch (const CLI::ParseError& error) {
    return fail(kWrongUsage, explanation(error, commands, app, first), ranks);
  }
  return run(*std::ranges::find_if(commands, [](const Command& c) { return c.app->parsed(); }),
             ranks);
}

/// The number of processes that mpirun, mpiexec or srun has started, by the environment; 0 if there
/// are several and none of it gives their number. Empty without a launcher.
std::optional<int> launched_processes() {
  // Open MPI; MPICH, Intel MPI and Slurm's PMI; MVAPICH.
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MV2_COMM_WORLD_SIZE"}) {
    if (const char* count = std::getenv(name)) return std::atoi(count);
  }
  // Others that use PMIx give each process its rank alone.
  if (std::getenv("PMIX_RANK") != nullptr) return 0;
  return std::nullopt;
}

/// MPI takes time to start and stop, and is left alone without a launcher.
int run_anywhere(int argc, char** argv) {
  const std::optional<int> processes = launched_processes();
  if (!processes) return parse_and_run(argc, argv, nullptr);
#ifdef BRINDLE_HAS_MPI
  OverRanks ranks(*processes);
  try {
    ranks.check_words({argv + 1, argv + argc});
    return parse_and_run(argc, argv, &ranks);
  } catch (const CLI::ParseError& error) {
    return fail(kWrongUsage, error.what(), &ranks);
  } catch (const std::exception& error) {
    return fail(kFailed, error.what(), &ranks);
  }
#else
  if (*processes == 1) return parse_and_run(argc, argv, nullptr);
  throw Error(
      "this build has no MPI, and each process would do the whole job; configure with "
      "-DBRINDLE_MPI=ON ('./dev mpi'), or start brindle without mpirun");
#endif
}

}  // namespace
}  // namespace brindle::tool

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // exceeding the file size limit becomes an error message
  brindle::tool::leave_out_blas_threads(argv);
  try {
    return brindle::tool::run_anywhere(argc, argv);
  } catch (const std::exception& error) {
    return brindle::tool::fail(brindle::tool::kFailed, error.what());
  }
}
