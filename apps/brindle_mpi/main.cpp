#include <algorithm>
#include <chrono>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <thread>
#include <vector>

#include "brindle/distributed/communicator.h"
#include "brindle/error.h"
#include "brindle/shapes.h"
#include "brindle/version.h"
#include "mpi_curves.h"
#include "mpi_sample.h"
#include "mpi_stripe.h"

namespace brindle::tool {
namespace {

enum ExitCode { kDone = 0, kFailed = 1, kWrongUsage = 2 };

/// Whether all ranks come here within some time. What one rank alone throws leaves the others
/// waiting for it elsewhere.
bool all_have_failed() {
  constexpr auto kPatience = std::chrono::seconds(5);
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

/// One message, whoever fails; ends the others where they wait.
ExitCode fail(ExitCode code, const std::string& message) {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (all_have_failed()) {
    if (rank == 0) std::cerr << "brindle-mpi: " << message << std::endl;
    return code;
  }
  std::cerr << "brindle-mpi: rank " << rank << ": " << message << std::endl;
  MPI_Abort(MPI_COMM_WORLD, code);
  return code;
}

ExitCode run(const Command& command) {
  try {
    command.run();
    std::cout.flush();
    if (!std::cout) throw Error("cannot write to standard output");
    return kDone;
  } catch (const CLI::ParseError& error) {
    return fail(kWrongUsage, error.what());
  } catch (const std::bad_alloc&) {
    return fail(kFailed, "not enough memory; take more ranks on more machines");
  } catch (const std::exception& error) {
    return fail(kFailed, error.what());
  }
}

/// "stripe " once that was asked for.
std::string help_of(const CLI::App& app) {
  const auto commands = app.get_subcommands();
  return commands.empty() ? "" : commands.front()->get_name() + " ";
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
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    if (ranks.rank() == 0) app.exit(success);
    return kDone;
  } catch (const CLI::ParseError& error) {
    return fail(kWrongUsage, error.what() + std::string("\nbrindle-mpi: 'brindle-mpi ") +
                                 help_of(app) + "--help' tells more");
  }
  return run(*std::ranges::find_if(commands,
                                   [](const Command& command) { return command.app->parsed(); }));
}

}  // namespace
}  // namespace brindle::tool

int main(int argc, char** argv) {
  // Other threads work between messages; they send none.
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
  int code = brindle::tool::kFailed;
  try {
    code = brindle::tool::parse_and_run(argc, argv);
  } catch (const std::exception& error) {
    code = brindle::tool::fail(brindle::tool::kFailed, error.what());
  }
  MPI_Finalize();
  return code;
}
