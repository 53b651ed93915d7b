#include "ranks/mpi_curves.h"

#include <algorithm>
#include <cstdint>
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
#include "brindle/corner_phases.h"
#include "brindle/curve_measures.h"
#include "brindle/distributed/gathered_pattern.h"
#include "brindle/files.h"
#include "brindle/files/vtk/vtp_rows.h"
#include "brindle/points.h"
#include "brindle/recipe/making_report.h"
#include "brindle/recipe/report.h"
#include "cli/command_line.h"
#include "cli/option_fields.h"
#include "jobs/curves_output.h"
#include "jobs/curves_report.h"
#include "outputs/outputs.h"
#include "outputs/written_files.h"
#include "ranks/piece_output.h"
#include "ranks/piece_patterns.h"
#include "ranks/stall_watch.h"

namespace brindle::tool {
namespace {

constexpr const char* kMpiCurvesExamples = R"(Examples:
  mpirun -n 4 brindle curves shape:torus,resolution=512 --output torus.vtp
  mpirun -n 2 brindle curves pieces.pvtp --lines both --stripes 60 --output grid.obj
  mpirun -n 8 brindle curves scan.ply --min-length 2% --output long.csv --report long.json
  mpirun -n 4 brindle curves scan.ply --offset 0.5 --tube-radius 0.3% --output gaps.glb

Rank 0 traces the stripes' centre lines over the whole surface and writes one file by its extension:
.obj .ply .vtp .csv, and of tubes .gltf .glb. In a .pvtp, every rank has the parts of lines in its
own triangles. At cuts, border_edge has the global numbers of the edge's vertices and
border_crossing counts the cuts along it; elsewhere both are -1.)";

struct MpiCurvesArguments : PatternArguments, TracingOptions {};

/// U or V, on rank 0.
struct JoinedFamily {
  std::string name;
  StripeCurves curves;
  CurveEnds ends{};              ///< of all curves
  std::size_t short_curves = 0;  ///< number left out
  std::size_t jogs = 0;          ///< edges at which moved curves have a jog
  double energy = 0;
  std::size_t branches = 0, field_singularities = 0;
  CurveLengths lengths = {};              ///< before lines were reshaped
  std::optional<CurveSpacing> spacing{};  ///< of all curves
  bool yields = false;                    ///< with a spacing tolerance
  std::optional<CurveCoverage> coverage{};
  MakingFigures loops{};  ///< of the whole surface, with winding numbers
};

/// U or V on a rank.
struct CutFamily {
  std::string name;
  PieceCurves curves;
};

/// The border edge at each point's line end.
std::vector<DataArray> border_arrays(const PieceCurves& curves) {
  std::vector<std::int64_t> edges(2 * curves.lines.points.size(), -1);
  std::vector<std::int32_t> crossings(curves.lines.points.size(), -1);
  for (std::size_t line = 0; line < curves.lines.count(); ++line) {
    const std::size_t ends[] = {curves.lines.offsets[line], curves.lines.offsets[line + 1] - 1};
    for (std::size_t e = 0; e < 2; ++e) {
      const std::optional<BorderCrossing>& border = curves.borders[line][e];
      if (!border) continue;
      edges[2 * ends[e]] = static_cast<std::int64_t>(border->edge[0]);
      edges[2 * ends[e] + 1] = static_cast<std::int64_t>(border->edge[1]);
      crossings[ends[e]] = static_cast<std::int32_t>(border->number);
    }
  }
  return {make_data_array("border_edge", 2, edges),
          make_data_array("border_crossing", 1, crossings)};
}

/// Collective.
void write_cut_families(Communicator& ranks, const std::string& path, const Mesh& mesh,
                        const std::vector<CutFamily>& families) {
  // As in `write_polylines`.
  DataArrays announced;
  announced.points = border_arrays({});
  announced.points.push_back(make_data_array("normal", std::span<const Vec3>()));
  for (const char* name : {"kind", "closed", "length"}) {
    announced.cells.push_back({name, NumberType::float32, 1, {}});
  }
  std::vector<NamedLines> lines;
  for (const CutFamily& family : families) {
    lines.push_back({family.name, family.curves.lines, border_arrays(family.curves)});
  }
  write_pieces(ranks, path, mesh.origin, announced,
               [&](OutputStream& out, const std::filesystem::path& piece) {
                 write_vtp_polylines(out, piece, lines);
               });
}

/// Collective. The report of a family without joining it.
nlohmann::ordered_json to_json(Communicator& ranks, const CutFamily& family,
                               const SolvedPattern& solved) {
  const CurveLengths lengths = curve_lengths(family.curves.lines);
  std::size_t crossings = 0;
  for (const auto& borders : family.curves.borders) {
    crossings += static_cast<std::size_t>(
        std::ranges::count_if(borders, [](const auto& border) { return border.has_value(); }));
  }
  return {{"energy", solved.energy},
          {"branches", solved.quality.branches},
          {"field_singularities", solved.quality.field_singularities},
          {"curve_pieces", ranks.sum(family.curves.lines.count())},
          {"border_crossings", ranks.sum(crossings) / 2},
          {"length", ranks.sum(lengths.closed_length + lengths.open_length)}};
}

/// Collective.
JoinedFamily make_family(const char* name, const GatheredSurface& whole,
                         const PiecePatterns& patterns, const SolvedPattern& solved,
                         const MpiCurvesArguments& arguments) {
  Communicator& ranks = *whole.piece().ranks;
  const PiecePattern pattern = patterns.piece(solved, arguments);
  JoinedFamily family{name, whole_curves(whole, pattern, arguments.curves).curves};
  family.ends = family.curves.end_counts();
  family.energy = solved.energy;
  family.branches = solved.quality.branches;
  family.field_singularities = solved.quality.field_singularities;
  family.yields = solved.frequency_change.has_value();
  family.spacing = measure_spacing(whole, pattern, family.curves, solved.frequencies_wanted);
  const auto diagonal = static_cast<float>(patterns.surface->diagonal());
  const float least = arguments.min_length.on(diagonal);
  if (least > 0) {
    const std::size_t all = family.curves.lines.count();
    family.curves = longer_than(family.curves, static_cast<double>(least));
    family.short_curves = all - family.curves.lines.count();
  }
  if (arguments.path_width) {
    ranks.throw_on_all([&] {
      if (!whole.is_first()) return;
      family.coverage = measure_coverage(whole.surface().mesh, family.curves.lines,
                                         arguments.path_width->on(diagonal));
    });
  }
  reshape(family.curves.lines, arguments, diagonal);
  family.lengths = curve_lengths(family.curves.lines);
  return family;
}

nlohmann::ordered_json to_json(const JoinedFamily& family) {
  const Polylines& lines = family.curves.lines;
  const CurveLengths& lengths = family.lengths;
  nlohmann::ordered_json json = {{"energy", family.energy},
                                 {"branches", family.branches},
                                 {"field_singularities", family.field_singularities},
                                 {"curves", lines.count()},
                                 {"closed", lengths.closed},
                                 {"open", lengths.open},
                                 {"short_curves_left_out", family.short_curves},
                                 {"points", lines.points.size()},
                                 {"length", lengths.closed_length + lengths.open_length},
                                 {"ends", ends_to_json(family.ends)},
                                 {"edges_with_jogs", family.jogs},
                                 {"lengths", tool::to_json(family.lengths)}};
  add_ends(family.curves, json);
  if (family.spacing) add_spacing(*family.spacing, family.yields, json);
  if (family.coverage) {
    json["coverage"] = family.coverage->once;
    json["covered_twice"] = family.coverage->twice;
  }
  add_to_json(family.loops, json);
  return json;
}

void print(std::ostream& out, const JoinedFamily& family) {
  const CurveLengths lengths = curve_lengths(family.curves.lines);
  out << formatted("%s         %zu curves, %zu of them closed, length %g\n", family.name.c_str(),
                   family.curves.lines.count(), lengths.closed,
                   lengths.closed_length + lengths.open_length)
      << "          " << line_of_ends(family.ends)
      << lines_of({family.curves, family.short_curves, family.jogs}, "          ")
      << lines_of(family.loops);
}

void check(const CLI::App& command, const MpiCurvesArguments& arguments, Communicator& ranks) {
  if (writes_pieces(arguments)) {
    refuse_given(
        command,
        {"--fair", "--min-length", "--simplify", "--resample", "--path-width", "--tube-radius",
         "--tube-sides"},
        "lines in a .pvtp are cut at borders; write whole ones as .obj, .ply, .vtp or .csv");
  } else if (!arguments.output.empty()) {
    const CurveOutput kind = planned_curves(arguments.output, arguments.tube_radius.has_value());
    if (kind != CurveOutput::lines && kind != CurveOutput::tubes) {
      refuse_output(arguments.output,
                    "lines over many processes are written as .obj, .ply, .vtp or "
                    ".csv, or in pieces as .pvtp; 'brindle curves' without mpirun draws");
    }
  }
  if (arguments.output.empty()) {
    refuse_given(command, {"--tube-radius"}, "no tubes are written; add --output FILE");
  }
  if (!arguments.tube_radius) {
    refuse_given(command, {"--tube-sides"}, "no tubes are written; add --tube-radius L");
  }
  if (arguments.traced == TracedWaves::u) {
    refuse_given(command, {"--stripes-v", "--frequency-v"},
                 "V is not traced; add --lines v or --lines both");
  }
  check_pattern_options(command, arguments, ranks);
}

/// On rank 0.
void write_joined(const MpiCurvesArguments& arguments, const std::vector<JoinedFamily>& families,
                  float diagonal) {
  if (arguments.tube_radius) {
    const TubeOptions options{arguments.tube_radius->on(diagonal), arguments.tube_sides};
    std::vector<Ornament> ornaments;
    for (const JoinedFamily& family : families) {
      ornaments.push_back({tubes(family.curves.lines, options), family.name == "v"});
    }
    return write_tube_mesh(arguments.output, ornaments);
  }
  std::vector<NamedLines> lines;
  for (const JoinedFamily& family : families) lines.push_back({family.name, family.curves.lines});
  write_polylines(arguments.output, lines);
}

/// On rank 0. Families are joined, or empty.
void tell(const CLI::App& command, const MpiCurvesArguments& arguments,
          const std::vector<JoinedFamily>& families, const PiecePatterns& patterns,
          const nlohmann::ordered_json& report) {
  if (!arguments.output.empty() && !writes_pieces(arguments)) {
    write_joined(arguments, families, static_cast<float>(patterns.surface->diagonal()));
  }
  write_pattern_report(command, arguments, report);
  if (arguments.quiet) return;
  print_waves(std::cout, patterns.figures);
  for (const JoinedFamily& family : families) print(std::cout, family);
  for (const char* name : {"u", "v"}) {
    if (!report.contains(name) || !report[name].contains("curve_pieces")) continue;
    std::cout << formatted(
        "%s         %zu pieces of curves, length %g; they cross borders %zu "
        "times\n",
        name, report[name]["curve_pieces"].get<std::size_t>(), report[name]["length"].get<double>(),
        report[name]["border_crossings"].get<std::size_t>());
  }
  print_pattern_ranks(std::cout, report);
  if (!arguments.output.empty()) print_written(std::cout, arguments.output);
  if (!arguments.report.empty()) print_written(std::cout, arguments.report);
}

/// Collective. The loops of the surface and the winding numbers of a pattern, on rank 0.
MakingFigures loops_of(const GatheredSurface& whole, const PiecePattern& of_piece) {
  StripePattern pattern = gathered_pattern(whole, of_piece);
  MakingFigures figures;
  whole.piece().ranks->throw_on_all([&] {
    if (!whole.is_first()) return;
    pattern.corners = corner_phases(whole.surface().mesh.triangles, pattern.waves,
                                    pattern.solution.z, pattern.phase_shift);
    measure_windings(whole.surface(), pattern, figures);
  });
  return figures;
}

/// The result of all ranks.
struct MadeCurves {
  std::vector<JoinedFamily> joined;  ///< on rank 0, unless partitions are written
  nlohmann::ordered_json report;     ///< of families, by name
};

MadeCurves make_curves(Communicator& ranks, PiecePatterns& patterns,
                       const MpiCurvesArguments& arguments, ProgressDisplay& display) {
  MadeCurves made;
  std::vector<CutFamily> families;
  const GatheredSurface whole(patterns.surface->rank_surface());
  for (const auto& [name, solved] : {std::pair("u", &patterns.u), std::pair("v", &patterns.v)}) {
    if (!*solved) continue;
    const PiecePattern pattern = patterns.piece(**solved, arguments);
    MakingFigures loops;
    if (!writes_pieces(arguments)) loops = loops_of(whole, pattern);
    const std::size_t jogs = arguments.offset == 0 ? 0
                                                   : shift_phases(whole, arguments.offset,
                                                                  (*solved)->waves, (*solved)->z);
    if (writes_pieces(arguments)) {
      families.push_back({name, piece_curves(pattern, arguments.curves)});
      made.report[name] = to_json(ranks, families.back(), **solved);
      made.report[name]["edges_with_jogs"] = jogs;
      add_frequency_change(**solved, "frequency_change", made.report[name]);
      continue;
    }
    made.joined.push_back(make_family(name, whole, patterns, **solved, arguments));
    made.joined.back().jogs = jogs;
    made.joined.back().loops = std::move(loops);
    made.report[name] = to_json(made.joined.back());
    add_frequency_change(**solved, "frequency_change", made.report[name]);
    if (made.joined.back().curves.lines.count() > 0) continue;
    display.note(std::string(name) + ": no curves; ask for more stripes, or for shorter ones\n");
  }
  if (writes_pieces(arguments)) {
    enter_stage(ranks, display, "writing");
    write_cut_families(ranks, arguments.output, patterns.read.piece.mesh, families);
  }
  return made;
}

void run_mpi_curves(const CLI::App& command, const MpiCurvesArguments& arguments,
                    Communicator& ranks) {
  check(command, arguments, ranks);
  const ThreadLimit threads(arguments.solving.threads);
  PiecePatterns patterns;
  MadeCurves made;
  double extract = 0;
  {
    ProgressDisplay display(arguments.quiet || ranks.rank() != 0);
    patterns = make_piece_patterns(ranks, arguments, arguments.traced != TracedWaves::v,
                                   arguments.traced != TracedWaves::u, display);
    enter_stage(ranks, display, "curves");
    Stopwatch watch;
    made = make_curves(ranks, patterns, arguments, display);
    extract = watch.lap();
  }
  nlohmann::ordered_json report = to_json(ranks, patterns, extract);
  report.update(made.report);
  ranks.throw_on_all([&] {
    if (ranks.rank() == 0) tell(command, arguments, made.joined, patterns, report);
  });
}

void add_mpi_curves_options(CLI::App& command, MpiCurvesArguments& arguments) {
  add_pattern_options(command, arguments,
                      "the curves: whole as .obj .ply .vtp .csv, in pieces as .pvtp", "FILE");
  arguments.visit(
      [&command](const std::string& option, auto& field) { add_field(command, option, field); });
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
