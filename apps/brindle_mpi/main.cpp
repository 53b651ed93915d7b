#include <algorithm>
#include <chrono>
#include <csignal>
#include <exception>
#include <iostream>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "brindle/base/text.h"
#include "brindle/communicator.h"
#include "brindle/error.h"
#include "brindle/version.h"
#include "cli/blas_threads.h"
#include "mpi_curves.h"
#include "mpi_sample.h"
#include "mpi_stripe.h"
#include "request.h"
#include "stall_watch.h"

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
  std::cerr << "brindle-mpi: rank " << rank << ": " << shown_lines(message) << std::endl;
  MPI_Abort(MPI_COMM_WORLD, code);
  return code;
}

/// Prints one message, whichever ranks fail.
ExitCode fail(ExitCode code, const std::string& message) {
  if (!all_have_failed()) return fail_alone(code, message);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0) std::cerr << "brindle-mpi: " << shown_lines(message) << std::endl;
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
    return {request_of(argc, argv),
            {},
            error.what() + std::string("\nbrindle-mpi: 'brindle-mpi ") + help_of(app) +
                "--help' tells more"};
  }
  return {request_of(app, argc, argv), {}, {}};
}

ExitCode parse_and_run(int argc, char** argv) {
  Communicator ranks(MPI_COMM_WORLD);
  CLI::App app{"Lays stripe patterns over surfaces that many processes hold together (MPI).",
               "brindle-mpi"};
  app.set_version_flag("--version", "brindle-mpi " BRINDLE_VERSION, "Print the version and exit");
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

}  // namespace
}  // namespace brindle::tool

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // exceeding the file size limit becomes an error message
  brindle::tool::leave_out_blas_threads(argv);
  // Other threads run between messages, but send none.
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
  int code = brindle::tool::kFailed;
  try {
    code = brindle::tool::parse_and_run(argc, argv);
  } catch (const std::exception& error) {
    code = brindle::tool::fail_alone(brindle::tool::kFailed, error.what());
  }
  MPI_Finalize();
  return code;
}
