#include "ranks/mpi_sample.h"

#include <filesystem>
#include <iostream>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "brindle/base/parallel.h"
#include "brindle/base/stopwatch.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/files/vtk/vtp_rows.h"
#include "brindle/points.h"
#include "brindle/recipe/report.h"
#include "cli/command_line.h"
#include "cli/option_fields.h"
#include "jobs/sample_job.h"
#include "outputs/outputs.h"
#include "outputs/written_files.h"
#include "ranks/piece_output.h"
#include "ranks/piece_patterns.h"
#include "ranks/stall_watch.h"

namespace brindle::tool {
namespace {

constexpr const char* kMpiSampleExamples = R"(Examples:
  mpirun -n 4 brindle sample shape:torus,resolution=512 --output torus.vtp
  mpirun -n 2 brindle sample pieces.pvtp --stripes 60 --stripes-v 30 --output samples.csv
  mpirun -n 8 brindle sample scan.ply --report samples.json

Rank 0 finds the samples of the whole surface, leaves out those too near to others and writes one
file by its extension: .csv .ply .vtp. With several ranks, each sample has the rank of its triangle
and the triangle's number in that rank's partition. In a .pvtp, every rank writes its own.)";

struct MpiSampleArguments : PatternArguments {
  float min_distance = kDoubleShare;
};

struct GatheredSamples {
  std::vector<Sample> own;         ///< kept samples of this rank
  std::vector<Sample> samples;     ///< on rank 0: those of all ranks
  std::vector<std::int32_t> rank;  ///< with the triangle of each sample
  std::size_t doubles = 0;         ///< left out, on all ranks
  std::optional<SampleSpacing> spacing;
};

GatheredSamples gather_samples(Communicator& ranks, const PiecePatterns& patterns,
                               const MpiSampleArguments& arguments) {
  const DistributedSurface& surface = *patterns.surface;
  std::vector<Sample> own =
      wave_samples(patterns.piece(*patterns.u, arguments), patterns.piece(*patterns.v, arguments));
  GatheredSamples gathered;
  if (has_point_trees()) gathered.doubles = drop_doubles(surface, own, arguments.min_distance);
  const std::vector<std::size_t> counts = ranks.all(own.size());
  gathered.samples = gathered_samples(surface, own);
  gathered.own = std::move(own);
  if (ranks.rank() != 0) return gathered;
  for (std::size_t r = 0; r < counts.size(); ++r) {
    gathered.rank.insert(gathered.rank.end(), counts[r], static_cast<std::int32_t>(r));
  }
  return gathered;
}

/// Collective.
void write_sample_pieces(Communicator& ranks, const std::string& path, const Mesh& mesh,
                         std::span<const Sample> own) {
  // As in `write_samples`.
  DataArrays announced;
  for (const char* name : {"normal", "direction_u", "direction_v", "barycentric"}) {
    announced.points.push_back({name, NumberType::float32, 3, {}});
  }
  for (const char* name : {"spacing_u", "spacing_v", "frequency_u", "frequency_v"}) {
    announced.points.push_back({name, NumberType::float32, 1, {}});
  }
  announced.points.push_back({"triangle", NumberType::uint32, 1, {}});
  write_pieces(ranks, path, mesh.origin, announced,
               [&](OutputStream& out, const std::filesystem::path& piece) {
                 write_vtp_samples(out, piece, own, mesh.origin, frequency_arrays(own));
               });
}

nlohmann::ordered_json to_json(const GatheredSamples& gathered, const PiecePatterns& patterns) {
  nlohmann::ordered_json json = {{"samples", gathered.samples.size()},
                                 {"doubles_left_out", gathered.doubles},
                                 {"branches_u", patterns.u->quality.branches},
                                 {"branches_v", patterns.v->quality.branches}};
  add_frequency_change(*patterns.u, "frequency_change_u", json);
  add_frequency_change(*patterns.v, "frequency_change_v", json);
  if (gathered.spacing) json["nearest_neighbour"] = brindle::to_json(*gathered.spacing);
  return json;
}

void print(std::ostream& out, const GatheredSamples& gathered, const PiecePatterns& patterns) {
  out << formatted("samples   %zu, %zu more left out as too near to others\n",
                   gathered.samples.size(), gathered.doubles)
      << formatted("branches  %zu of U, %zu of V\n", patterns.u->quality.branches,
                   patterns.v->quality.branches);
  if (!gathered.spacing || gathered.spacing->samples == 0) return;
  out << formatted("nearest   %.3f of the ideal grid's distance on average, deviation %.3f\n",
                   gathered.spacing->mean, gathered.spacing->deviation);
}

/// On rank 0.
void tell(const CLI::App& command, const MpiSampleArguments& arguments,
          const GatheredSamples& gathered, const PiecePatterns& patterns,
          const nlohmann::ordered_json& report, int ranks) {
  if (!arguments.output.empty() && !writes_pieces(arguments)) {
    const std::vector<Sample>& samples = gathered.samples;
    std::vector<DataArray> arrays = frequency_arrays(samples);
    if (ranks > 1) arrays.push_back(make_data_array("rank", 1, gathered.rank));
    write_samples(arguments.output, samples, patterns.read.piece.mesh.origin, arrays);
  }
  write_pattern_report(command, arguments, report);
  if (arguments.quiet) return;
  print_waves(std::cout, patterns.figures);
  print(std::cout, gathered, patterns);
  print_pattern_ranks(std::cout, report);
  if (!arguments.output.empty()) print_written(std::cout, arguments.output);
  if (!arguments.report.empty()) print_written(std::cout, arguments.report);
}

void check(const CLI::App& command, const MpiSampleArguments& arguments, Communicator& ranks) {
  if (!arguments.output.empty() && !writes_pieces(arguments) &&
      !is_sample_format(arguments.output)) {
    refuse_output(arguments.output,
                  "samples over many processes are written as .csv, .ply or .vtp, or in pieces as "
                  ".pvtp; 'brindle sample' without mpirun draws");
  }
  if (!has_point_trees()) {
    refuse_given(command, {"--min-distance"},
                 "this build has no nanoflann; configure with -DBRINDLE_NANOFLANN=ON");
  }
  check_pattern_options(command, arguments, ranks);
}

void run_mpi_sample(const CLI::App& command, const MpiSampleArguments& arguments,
                    Communicator& ranks) {
  check(command, arguments, ranks);
  const ThreadLimit threads(arguments.solving.threads);
  PiecePatterns patterns;
  GatheredSamples gathered;
  double extract = 0;
  {
    ProgressDisplay display(arguments.quiet || ranks.rank() != 0);
    patterns = make_piece_patterns(ranks, arguments, true, true, display);
    enter_stage(ranks, display, "samples");
    Stopwatch watch;
    gathered = gather_samples(ranks, patterns, arguments);
    ranks.throw_on_all([&] {
      if (has_point_trees()) gathered.spacing = measure_sample_spacing(gathered.samples);
    });
    extract = watch.lap();
    if (writes_pieces(arguments)) {
      enter_stage(ranks, display, "writing");
      write_sample_pieces(ranks, arguments.output, patterns.read.piece.mesh, gathered.own);
    }
    if (ranks.rank() == 0 && gathered.samples.empty()) display.note(kNoSamples);
  }
  nlohmann::ordered_json report = to_json(ranks, patterns, extract);
  report.update(to_json(gathered, patterns));
  ranks.throw_on_all([&] {
    if (ranks.rank() == 0) tell(command, arguments, gathered, patterns, report, ranks.size());
  });
}

void add_mpi_sample_options(CLI::App& command, MpiSampleArguments& arguments) {
  add_pattern_options(command, arguments, "the samples: .csv .ply .vtp, or in pieces as .pvtp",
                      "FILE");
  add_field(command, "--min-distance", arguments.min_distance);
}

}  // namespace

Command add_mpi_sample_command(CLI::App& app, Communicator& ranks) {
  return add_command<MpiSampleArguments>(
      app, "sample", "Sample a surface that all ranks hold together where two patterns cross",
      kMpiSampleExamples, add_mpi_sample_options,
      [&ranks](const CLI::App& command, const MpiSampleArguments& arguments) {
        run_mpi_sample(command, arguments, ranks);
      });
}

}  // namespace brindle::tool
