#include "mpi_curves.h"

#include <iostream>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "brindle/base/parallel.h"
#include "brindle/base/stopwatch.h"
#include "brindle/curve_measures.h"
#include "brindle/files.h"
#include "command_line.h"
#include "formatted.h"
#include "option_values.h"
#include "outputs.h"
#include "piece_patterns.h"
#include "report.h"
#include "written_files.h"

namespace brindle::tool {
namespace {

constexpr const char* kMpiCurvesExamples = R"(Examples:
  mpirun -n 4 brindle-mpi curves shape:torus,resolution=512 --output torus.vtp
  mpirun -n 2 brindle-mpi curves pieces.pvtp --lines both --stripes 60 --output grid.obj
  mpirun -n 8 brindle-mpi curves scan.ply --min-length 2% --output long.csv --report long.json

Each rank follows the stripes' centre lines in its own triangles; rank 0 joins what ends at borders
and writes one file by its extension: .obj .ply .vtp .csv.)";

enum class CurveLines { u, v, both };

std::optional<CurveLines> parse_lines(std::string_view name) {
  if (name == "u") return CurveLines::u;
  if (name == "v") return CurveLines::v;
  if (name == "both") return CurveLines::both;
  return std::nullopt;
}

struct MpiCurvesArguments : PatternArguments {
  CurveLines lines = CurveLines::u;
  Length min_length;
};

/// One of U and V, on rank 0.
struct JoinedFamily {
  std::string name;
  StripeCurves curves;
  std::array<std::size_t, kCurveEndKinds> ends{};  ///< of all curves
  std::size_t short_curves = 0;                    ///< left out
  double energy = 0;
  std::size_t branches = 0;

  std::size_t end(CurveEnd kind) const { return ends[static_cast<std::size_t>(kind)]; }
};

JoinedFamily join_family(const char* name, const PiecePatterns& patterns,
                         const SolvedPattern& solved, const MpiCurvesArguments& arguments) {
  const PiecePattern pattern = patterns.piece(solved, arguments);
  JoinedFamily family{name, joined_curves(*patterns.surface, piece_curves(pattern))};
  family.ends = family.curves.end_counts();
  family.energy = solved.energy;
  family.branches = solved.quality.branches;
  const float least = arguments.min_length.on(static_cast<float>(patterns.surface->diagonal()));
  if (least > 0) {
    const std::size_t all = family.curves.lines.count();
    family.curves = longer_than(family.curves, static_cast<double>(least));
    family.short_curves = all - family.curves.lines.count();
  }
  return family;
}

nlohmann::ordered_json to_json(const JoinedFamily& family) {
  const Polylines& lines = family.curves.lines;
  const CurveLengths lengths = curve_lengths(lines);
  return {{"energy", family.energy},
          {"branches", family.branches},
          {"curves", lines.count()},
          {"closed", lengths.closed},
          {"open", lengths.open},
          {"short_curves_left_out", family.short_curves},
          {"points", lines.points.size()},
          {"length", lengths.closed_length + lengths.open_length},
          {"ends",
           {{"total", std::accumulate(family.ends.begin(), family.ends.end(), std::size_t{0})},
            {"boundary", family.end(CurveEnd::boundary)},
            {"no_wave", family.end(CurveEnd::no_wave)},
            {"nonmanifold", family.end(CurveEnd::nonmanifold)},
            {"branch", family.end(CurveEnd::branch)},
            {"singularity", family.end(CurveEnd::singularity)}}}};
}

void print(std::ostream& out, const JoinedFamily& family) {
  const CurveLengths lengths = curve_lengths(family.curves.lines);
  out << formatted("%s         %zu curves, %zu of them closed, length %g\n", family.name.c_str(),
                   family.curves.lines.count(), lengths.closed,
                   lengths.closed_length + lengths.open_length)
      << formatted(
             "          ends: %zu at the boundary, %zu at branches, %zu at singularities, %zu "
             "beside vertices without wave, %zu at edges of three triangles or more\n",
             family.end(CurveEnd::boundary), family.end(CurveEnd::branch),
             family.end(CurveEnd::singularity), family.end(CurveEnd::no_wave),
             family.end(CurveEnd::nonmanifold));
  if (family.short_curves > 0) {
    out << formatted("          %zu shorter curves left out\n", family.short_curves);
  }
}

void check(const CLI::App& command, const MpiCurvesArguments& arguments, Communicator& ranks) {
  if (!arguments.output.empty() && !is_polyline_format(arguments.output)) {
    refuse_output(arguments.output,
                  "lines over many processes are written as .obj, .ply, .vtp or "
                  ".csv; 'brindle curves' draws");
  }
  if (arguments.lines == CurveLines::u) {
    refuse_given(command, {"--stripes-v", "--frequency-v"},
                 "V is not traced; add --lines v or --lines both");
  }
  check_pattern_options(command, arguments, ranks);
}

/// On rank 0.
void tell(const CLI::App& command, const MpiCurvesArguments& arguments,
          const std::vector<JoinedFamily>& families, const PiecePatterns& patterns,
          const nlohmann::ordered_json& report) {
  std::vector<NamedLines> lines;
  for (const JoinedFamily& family : families) lines.push_back({family.name, family.curves.lines});
  if (!arguments.output.empty()) write_polylines(arguments.output, lines);
  write_pattern_report(command, arguments, report);
  if (arguments.quiet) return;
  print_waves(std::cout, patterns.figures);
  for (const JoinedFamily& family : families) print(std::cout, family);
  print_pattern_ranks(std::cout, report);
  if (!arguments.output.empty()) print_written(std::cout, arguments.output);
  if (!arguments.report.empty()) print_written(std::cout, arguments.report);
}

void run_mpi_curves(const CLI::App& command, const MpiCurvesArguments& arguments,
                    Communicator& ranks) {
  check(command, arguments, ranks);
  const ThreadLimit threads(arguments.solving.threads);
  PiecePatterns patterns;
  std::vector<JoinedFamily> families;
  double extract = 0;
  {
    ProgressDisplay display(arguments.quiet || ranks.rank() != 0);
    patterns = make_piece_patterns(ranks, arguments, arguments.lines != CurveLines::v,
                                   arguments.lines != CurveLines::u, display);
    ranks.together([&] { display.stage("curves"); });
    Stopwatch watch;
    if (patterns.u) families.push_back(join_family("u", patterns, *patterns.u, arguments));
    if (patterns.v) families.push_back(join_family("v", patterns, *patterns.v, arguments));
    extract = watch.lap();
    for (const JoinedFamily& family : families) {
      if (family.curves.lines.count() == 0) {
        display.note(family.name + ": no curves; ask for more stripes, or for shorter ones\n");
      }
    }
  }
  nlohmann::ordered_json report = to_json(ranks, patterns, extract);
  for (const JoinedFamily& family : families) report[family.name] = to_json(family);
  ranks.together([&] {
    if (ranks.rank() == 0) tell(command, arguments, families, patterns, report);
  });
}

void add_mpi_curves_options(CLI::App& command, MpiCurvesArguments& arguments) {
  add_pattern_options(command, arguments, "the curves, whole: .obj .ply .vtp .csv", "FILE");
  add_named_option(command, "--lines", arguments.lines, parse_lines, "u|v|both",
                   "across the field (u, default), along it (v: stripes of the field turned by 90 "
                   "degrees), or both");
  add_parsed_option(command, "--min-length", arguments.min_length, parse_length,
                    "leave out shorter curves")
      ->type_name("L|P%");
}

}  // namespace

Command add_mpi_curves_command(CLI::App& app, Communicator& ranks) {
  return add_command<MpiCurvesArguments>(
      app, "curves", "Trace the stripes of a surface that all ranks hold together as lines",
      kMpiCurvesExamples, add_mpi_curves_options,
      [&ranks](const CLI::App& command, const MpiCurvesArguments& arguments) {
        run_mpi_curves(command, arguments, ranks);
      });
}

}  // namespace brindle::tool
