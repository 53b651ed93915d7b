/// Arguments of `brindle stripe`.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "brindle/communicator.h"
#include "brindle/distributed_stripes.h"
#include "input/solving_options.h"
#include "input/surface_options.h"
#include "input/used_files.h"
#include "input/wave_options.h"

namespace brindle::tool {

/// The options of `brindle stripe` that work on many processes, and `frames`.
struct MpiArguments {
  SurfaceOptions surface;
  WaveOptions waves;
  SolvingOptions solving;
  std::size_t plan_below = DistributedOptions().plan_below;
  std::string output;  ///< .pvtp; empty: none
  std::string report;  ///< .json; empty: none
  int frames = 0;      ///< measured after the pattern is made
  bool quiet = false;
};

/// --plan-below.
void add_bounds_options(CLI::App& command, std::size_t& plan_below);

void add_mpi_options(CLI::App& command, MpiArguments& arguments);

/// Throws CLI::ValidationError for options of waves and solving without effect, and for those that
/// need the whole surface in one process.
void check_mpi_waves(const CLI::App& command, const WaveOptions& waves,
                     const SolvingOptions& solving);

/// Throws CLI::ValidationError for options without effect, and for those that need the whole
/// surface in one process.
void check_mpi_options(const CLI::App& command, const MpiArguments& arguments);

/// Collective. All input files, including those of a .pvtp.
std::vector<UsedFile> mpi_inputs(Communicator& ranks, const SurfaceOptions& surface,
                                 const WaveOptions& waves, const SolvingOptions& solving);

}  // namespace brindle::tool
