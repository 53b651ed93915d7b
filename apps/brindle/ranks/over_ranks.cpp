#include "ranks/over_ranks.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <iostream>
#include <new>
#include <thread>
#include <vector>

#include "brindle/base/text.h"
#include "brindle/error.h"
#include "cli/command_line.h"
#include "ranks/pvtp_pieces.h"
#include "ranks/request.h"

namespace brindle::tool {
namespace {

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
void end_all(int rank, int code, const std::string& message) {
  std::cerr << "brindle: rank " << rank << ": " << shown_lines(message) << std::endl;
  MPI_Abort(MPI_COMM_WORLD, code);
}

}  // namespace

OverRanks::OverRanks(int processes) {
  if (processes != 1) start_mpi();
}

OverRanks::~OverRanks() {
  if (!ranks_) return;
  if (standard_output_ != nullptr) std::cout.rdbuf(standard_output_);
  ranks_.reset();
  MPI_Finalize();
}

void OverRanks::check_words(const std::vector<std::string>& words) {
  if (ranks_) check_same_words(*ranks_, words);
}

void OverRanks::start_mpi() {
  if (ranks_) return;
  // Other threads run between messages, but send none.
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
  ranks_.emplace(MPI_COMM_WORLD);
  if (ranks_->rank() != 0) standard_output_ = std::cout.rdbuf(&nowhere_);
}

void OverRanks::add_options(CLI::App& command) {
  constexpr const char* kGroup = "MPI ranks";
  command
      .add_option("--plan-below", plan_below_,
                  "solve smaller surfaces, in vertices, on rank 0, as one process does")
      ->type_name("N")
      ->group(kGroup)
      ->capture_default_str();
  add_stall_option(command, stall_limit_)->group(kGroup);
  if (command.get_name() != "stripe") return;
  command
      .add_option("--frames", frames_,
                  "then measure N frames, each turned by a degree; no files have them")
      ->type_name("N")
      ->group(kGroup)
      ->check(CLI::Range(0, 10000));
}

template <class Arguments>
bool OverRanks::run_over(const CLI::App& command, const Arguments& arguments,
                         void (*job)(const RankRun&, const CLI::App&, const Arguments&)) {
  const bool of_ranks = is_pvtp(arguments.surface.mesh) ||
                        std::ranges::any_of(arguments.outputs, is_pvtp) ||
                        is_given(command, "--plan-below") || is_given(command, "--frames");
  if (!several() && !of_ranks) return false;
  start_mpi();
  const int rank = ranks_->rank();
  const StallWatch watch(rank, stall_limit_);
  try {
    refuse_usage(command, [&](const IsGiven& given) {
      check_one_process(given, job_of(command.get_name()));
    });
    job({*ranks_, plan_below_, frames_}, command, arguments);
  } catch (const Cancelled& cancelled) {
    throw Error(cancelled.what());  // the signal may be another rank's
  } catch (const Error&) {
    throw;  // on all ranks (`Communicator::throw_on_all`)
  } catch (const CLI::ParseError&) {
    throw;
  } catch (const std::bad_alloc&) {
    end_all(rank, 1, "not enough memory; take more ranks on more machines");
  } catch (const std::exception& error) {
    end_all(rank, 1, error.what());
  }
  return true;
}

bool OverRanks::run(const CLI::App& command, const StripeArguments& arguments) {
  return run_over(command, arguments, run_stripe_over);
}

bool OverRanks::run(const CLI::App& command, const CurvesArguments& arguments) {
  return run_over(command, arguments, run_curves_over);
}

bool OverRanks::run(const CLI::App& command, const SampleArguments& arguments) {
  return run_over(command, arguments, run_sample_over);
}

void OverRanks::check_for_one(const CLI::App& command) {
  if (!several()) return;
  throw CLI::ValidationError("'brindle " + command.get_name() +
                                 "' runs in one process; start it without mpirun, or with -n 1",
                             CLI::ExitCodes::ValidationError);
}

int OverRanks::fail(int code, const std::string& message) {
  if (ranks_ && !all_have_failed()) {
    end_all(ranks_->rank(), code, message);
  } else if (!ranks_ || ranks_->rank() == 0) {
    std::cerr << "brindle: " << shown_lines(message) << std::endl;
  }
  return code;
}

}  // namespace brindle::tool
