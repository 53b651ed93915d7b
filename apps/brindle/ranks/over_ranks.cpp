#include "ranks/over_ranks.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <exception>
#include <iostream>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "brindle/base/text.h"
#include "brindle/communicator.h"
#include "brindle/error.h"
#include "brindle/version.h"
#include "ranks/mpi_curves.h"
#include "ranks/mpi_sample.h"
#include "ranks/mpi_stripe.h"
#include "ranks/request.h"
#include "ranks/stall_watch.h"

namespace brindle::tool {
namespace {

enum ExitCode { kDone = 0, kFailed = 1, kWrongUsage = 2 };

/// Whether all ranks fail within some time. An exception on a single rank leaves the others waiting
/// elsewhere, which is rare; late ranks on a busy machine are not.
bool all_have_failed() {
  constexpr auto kPatience = std::chrono::seconds(60);
  MPI_Request request;
  MPI_Ibarrier(MPI_COMM_WORLD, &request);
  const auto end = std::chrono::steady_clock::now() + kPatience;
  int done = 0;
  while (done == 0 && std::chrono::steady_clock::now() < end) {
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (done == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return done != 0;
}

/// For a failure on one rank: ends the waiting others.
ExitCode fail_alone(ExitCode code, const std::string& message) {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  std::cerr << "brindle: rank " << rank << ": " << shown_lines(message) << std::endl;
  MPI_Abort(MPI_COMM_WORLD, code);
  return code;
}

/// Prints one message, whichever ranks fail.
ExitCode fail(ExitCode code, const std::string& message) {
  if (!all_have_failed()) return fail_alone(code, message);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0) std::cerr << "brindle: " << shown_lines(message) << std::endl;
  return code;
}

/// Collective operations raise an error of one rank on all, as Error (`Communicator::together`).
/// Other exceptions belong to one rank.
ExitCode run(const Command& command) {
  try {
    command.run();
    std::cout.flush();
    if (!std::cout) throw std::runtime_error("cannot write to standard output");
    return kDone;
  } catch (const CLI::ParseError& error) {
    return fail(kWrongUsage, error.what());
  } catch (const Error& error) {
    return fail(kFailed, error.what());
  } catch (const std::bad_alloc&) {
    return fail_alone(kFailed, "not enough memory; take more ranks on more machines");
  } catch (const std::exception& error) {
    return fail_alone(kFailed, error.what());
  }
}

/// "stripe " after the command stripe.
std::string help_of(const CLI::App& app) {
  const auto commands = app.get_subcommands();
  return commands.empty() ? "" : commands.front()->get_name() + " ";
}

/// The words of this rank, valid or not.
struct Parsed {
  Request request;
  std::optional<CLI::Success> asked_for_help;
  std::optional<std::string> error;
};

Parsed parse(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return {request_of(argc, argv), success, {}};
  } catch (const CLI::ParseError& error) {
    return {
        request_of(argc, argv),
        {},
        error.what() + std::string("\nbrindle: 'brindle ") + help_of(app) + "--help' tells more"};
  }
  return {request_of(app, argc, argv), {}, {}};
}

/// Whether the command line is for ranks: it names a command that has them, or none.
bool has_ranks(const std::vector<std::string>& words) {
  constexpr std::array<std::string_view, 3> kCommands = {"stripe", "curves", "sample"};
  return words.empty() || words[0].starts_with('-') ||
         std::ranges::find(kCommands, words[0]) != kCommands.end();
}

ExitCode parse_and_run(Communicator& ranks, int argc, char** argv) {
  CLI::App app{"Lays stripe patterns over surfaces that many processes hold together (MPI).",
               "brindle"};
  app.set_version_flag("--version", "brindle " BRINDLE_VERSION, "Print the version and exit");
  app.require_subcommand(1);
  const std::vector<Command> commands = {add_mpi_stripe_command(app, ranks),
                                         add_mpi_curves_command(app, ranks),
                                         add_mpi_sample_command(app, ranks)};
  double stall_limit = kStallLimit;
  for (const Command& command : commands) add_stall_option(*command.app, stall_limit);
  const Parsed parsed = parse(app, argc, argv);
  const StallWatch watch(ranks.rank(), stall_limit);
  try {
    check_same_request(ranks, parsed.request);
  } catch (const CLI::ParseError& error) {
    return fail(kWrongUsage, error.what());
  }
  if (parsed.asked_for_help) {
    if (ranks.rank() == 0) app.exit(*parsed.asked_for_help);
    return kDone;
  }
  if (parsed.error) return fail(kWrongUsage, *parsed.error);
  return run(*std::ranges::find_if(commands,
                                   [](const Command& command) { return command.app->parsed(); }));
}

int run_ranks(int argc, char** argv, const std::function<int(int, char**)>& alone) {
  Communicator ranks(MPI_COMM_WORLD);
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (has_ranks(words)) return parse_and_run(ranks, argc, argv);
  if (ranks.size() == 1) return alone(argc, argv);
  return fail(kWrongUsage, "'brindle " + words[0] +
                               "' runs in one process; start it without mpirun, or with -n 1");
}

}  // namespace

int run_over_ranks(int argc, char** argv, const std::function<int(int, char**)>& alone) {
  // Other threads run between messages, but send none.
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
  int code = kFailed;
  try {
    code = run_ranks(argc, argv, alone);
  } catch (const std::exception& error) {
    code = fail_alone(kFailed, error.what());
  }
  MPI_Finalize();
  return code;
}

}  // namespace brindle::tool
