// Curves and samples: rank 0 extracts them from the whole surface, as one process does.
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
#include "brindle/corner_phases.h"
#include "brindle/distributed/gathered_pattern.h"
#include "brindle/files/vtk/vtp_file.h"
#include "brindle/pattern_warnings.h"
#include "brindle/stripe_tracer.h"
#include "cli/command_line.h"
#include "cli/progress_display.h"
#include "jobs/curves_output.h"
#include "jobs/curves_report.h"
#include "jobs/sample_job.h"
#include "pictures/glyphs.h"
#include "ranks/piece_output.h"
#include "ranks/pvtp_pieces.h"
#include "ranks/rank_patterns.h"
#include "ranks/rank_report.h"

namespace brindle::tool {
namespace {

/// U, V or both on a partition.
struct RankFamilies {
  RankPreparation prepared;
  std::vector<std::pair<std::string, RankPattern>> patterns;

  /// U's, or V's without U.
  const RankPattern& front() const { return patterns.front().second; }
};

template <class Arguments>
RankFamilies solve_families(const RankRun& run, const Arguments& arguments, bool with_u,
                            bool with_v, JobListener& listener) {
  RankFamilies made{prepare_piece(run, arguments, false, listener), {}};
  RankPreparation& prepared = made.prepared;
  WaveSet v;
  if (with_v) v = rank_waves_of_v(prepared, arguments.second);
  const auto add = [&](const char* name, WaveSet& waves) {
    made.patterns.emplace_back(
        name, solve_piece(run, prepared, std::move(waves), arguments.solving, listener));
  };
  if (with_u) add("u", prepared.waves);
  if (with_v) add("v", v);
  PatternQuality quality;
  for (const auto& [name, solved] : made.patterns) {
    quality = worse_of(quality, solved.pattern.quality);
  }
  listener.note(quality_warning(prepared.metrics, quality, prepared.surface->triangle_count()));
  return made;
}

/// Collective. As `plan_outputs`, also for pieces.
Outputs plan_rank_outputs(const RankRun& run, const JobArguments& arguments,
                          const std::vector<UsedFile>& own_inputs, const PlanOutput& plan) {
  const std::vector<UsedFile> inputs = rank_inputs(run, arguments.surface, own_inputs);
  Outputs outputs = plan_outputs(inputs, arguments.outputs, arguments.report,
                                 [&](const std::filesystem::path& path) {
                                   return is_pvtp(path) ? OutputKind::pieces : plan(path);
                                 });
  for (const Output& output : outputs) {
    if (output.kind != OutputKind::pieces) continue;
    check_files(inputs, files_of_pieces(output.path, run.ranks.size()));
    check_pieces(run.ranks, output.path);
  }
  return outputs;
}

/// Collective. Writes pieces by `write_pieces_to`, and on rank 0 all others by `write`.
void write_files(const RankRun& run, const Outputs& outputs, JobListener& listener,
                 const auto& write_pieces_to, const auto& write) {
  for (const Output& output : outputs) {
    enter_stage(run, listener, "writing");
    if (output.kind == OutputKind::pieces) {
      write_pieces_to(output.path);
    } else {
      run.ranks.throw_on_all([&] {
        if (run.is_first()) write(output);
      });
    }
  }
}

/// Collective. Rank 0 prints the metrics and what was written.
void tell(const RankRun& run, bool quiet, const auto& job, const Outputs& outputs) {
  run.ranks.throw_on_all([&] {
    if (!run.is_first() || quiet) return;
    print(std::cout, job);
    print_ranks(std::cout, job.ranks);
    print_written(std::cout, outputs);
  });
}

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

/// Collective. The curves of rank 0, cut at borders.
void write_cut_curves(const RankRun& run, const std::filesystem::path& path,
                      const GatheredSurface& whole, const CurvesJob& job,
                      std::span<const std::string> names) {
  // As in `write_polylines`.
  DataArrays announced;
  announced.points = border_arrays({});
  announced.points.push_back(make_data_array("normal", std::span<const Vec3>()));
  for (const char* name : {"kind", "closed", "length"}) {
    announced.cells.push_back({name, NumberType::float32, 1, {}});
  }
  std::vector<PieceCurves> cut;
  for (std::size_t f = 0; f < names.size(); ++f) {
    cut.push_back(cut_curves(whole, run.is_first() ? job.families[f].curves : StripeCurves()));
  }
  std::vector<NamedLines> lines;
  for (std::size_t f = 0; f < names.size(); ++f) {
    lines.push_back({names[f], cut[f].lines, border_arrays(cut[f])});
  }
  write_pieces(run.ranks, path, whole.piece().mesh.origin, announced,
               [&](OutputStream& out, const std::filesystem::path& piece) {
                 write_vtp_polylines(out, piece, lines);
               });
}

Outputs checked_curves(const RankRun& run, const CLI::App& command,
                       const CurvesArguments& arguments) {
  if (std::ranges::any_of(arguments.outputs, is_pvtp)) {
    refuse_given(command, {"--fair", "--simplify", "--resample"},
                 "lines in a .pvtp are cut at borders; write whole ones as .obj, .ply, .vtp or "
                 ".csv");
  }
  check_rank_options(arguments.waves, arguments.solving);
  Outputs outputs = plan_rank_outputs(
      run, arguments, curves_inputs(arguments), [&](const std::filesystem::path& path) {
        return planned_curves(path, arguments.tube_radius.has_value());
      });
  check_curves_options(command, arguments, outputs);
  return outputs;
}

/// Collective. Traced on rank 0.
CurveFamily whole_family(const RankRun& run, const GatheredSurface& whole,
                         const RankFamilies& solved, std::size_t number,
                         const std::optional<StripeTracer>& tracer,
                         const CurvesArguments& arguments, JobListener& listener) {
  const auto& [name, of_piece] = solved.patterns[number];
  StripePattern pattern = whole_pattern(whole, solved.prepared, of_piece);
  CurveFamily family;
  run.ranks.throw_on_all([&, &name = name] {
    if (!run.is_first()) return;
    const Surface& surface = whole.surface();
    pattern.corners = corner_phases(surface.mesh.triangles, pattern.waves, pattern.solution.z,
                                    pattern.phase_shift);
    FabricationMetrics fabrication;
    measure_windings(surface, pattern, fabrication);
    family = traced_family(arguments, surface, *tracer, name, std::move(pattern), CurveMetrics::all,
                           listener);
    family.fabrication = std::move(fabrication);
  });
  return family;
}

Outputs checked_samples(const RankRun& run, const CLI::App& command,
                        const SampleArguments& arguments) {
  check_rank_options(arguments.waves, arguments.solving);
  Outputs outputs = plan_rank_outputs(run, arguments, sample_inputs(arguments), planned_sample);
  check_sample_options(command, arguments, outputs);
  return outputs;
}

/// Collective. The samples of rank 0, each on the rank of its triangle.
void write_sample_pieces(const RankRun& run, const std::filesystem::path& path,
                         const GatheredSurface& whole, std::span<const Sample> samples) {
  // As in `write_samples`.
  DataArrays announced;
  for (const char* name : {"normal", "direction_u", "direction_v", "barycentric"}) {
    announced.points.push_back({name, NumberType::float32, 3, {}});
  }
  for (const char* name : {"spacing_u", "spacing_v", "frequency_u", "frequency_v"}) {
    announced.points.push_back({name, NumberType::float32, 1, {}});
  }
  announced.points.push_back({"triangle", NumberType::uint32, 1, {}});
  const std::vector<TriangleOfPiece> triangles = whole.triangles_of_pieces();
  std::vector<std::vector<Sample>> of_ranks(static_cast<std::size_t>(run.ranks.size()));
  for (Sample sample : samples) {
    const auto& [rank, triangle] = triangles[sample.triangle];
    sample.triangle = triangle;
    of_ranks[static_cast<std::size_t>(rank)].push_back(sample);
  }
  const std::vector<Sample> own = run.ranks.swap_lists(of_ranks)[0];
  const Eigen::Vector3d& origin = whole.piece().mesh.origin;
  write_pieces(run.ranks, path, origin, announced,
               [&](OutputStream& out, const std::filesystem::path& piece) {
                 write_vtp_samples(out, piece, own, origin, frequency_arrays(own));
               });
}

}  // namespace

void run_curves_over(const RankRun& run, const CLI::App& command,
                     const CurvesArguments& arguments) {
  const Outputs outputs = checked_curves(run, command, arguments);
  const ThreadLimit threads(arguments.solving.threads);
  CurvesJob job;
  {
    ProgressDisplay display(arguments.quiet || !run.is_first());
    const RankFamilies solved = solve_families(run, arguments, arguments.traced != TracedWaves::v,
                                               arguments.traced != TracedWaves::u, display);
    enter_stage(run, display, "curves");
    const GatheredSurface whole(solved.prepared.surface->rank_surface());
    std::optional<StripeTracer> tracer;
    run.ranks.throw_on_all([&] {
      if (!run.is_first()) return;
      Stopwatch watch;
      tracer.emplace(whole.surface(), display.progress());
      job.edges_milliseconds = watch.lap();
      job.prepared = whole_preparation(whole, solved.prepared);
      job.options.slack = arguments.solving.slack.slack;
    });
    std::vector<std::string> names;
    for (std::size_t f = 0; f < solved.patterns.size(); ++f) {
      names.push_back(solved.patterns[f].first);
      job.families.push_back(whole_family(run, whole, solved, f, tracer, arguments, display));
    }
    job.ranks = rank_metrics(run.ranks, *solved.prepared.surface, solved.front().animator);
    write_files(
        run, outputs, display,
        [&](const std::filesystem::path& path) { write_cut_curves(run, path, whole, job, names); },
        [&](const Output& output) { write_curves_file(output, command, arguments, job, display); });
  }
  tell(run, arguments.quiet, job, outputs);
}

void run_sample_over(const RankRun& run, const CLI::App& command,
                     const SampleArguments& arguments) {
  const Outputs outputs = checked_samples(run, command, arguments);
  const ThreadLimit threads(arguments.solving.threads);
  SampleJob job;
  {
    ProgressDisplay display(arguments.quiet || !run.is_first());
    const RankFamilies solved = solve_families(run, arguments, true, true, display);
    enter_stage(run, display, "samples");
    const GatheredSurface whole(solved.prepared.surface->rank_surface());
    job.u = whole_pattern(whole, solved.prepared, solved.patterns[0].second);
    job.v = whole_pattern(whole, solved.prepared, solved.patterns[1].second);
    run.ranks.throw_on_all([&] {
      if (!run.is_first()) return;
      job.prepared = whole_preparation(whole, solved.prepared);
      job.taken = taken_samples(arguments, whole.surface(), job.u, job.v, display);
    });
    job.ranks = rank_metrics(run.ranks, *solved.prepared.surface, solved.front().animator);
    write_files(
        run, outputs, display,
        [&](const std::filesystem::path& path) {
          write_sample_pieces(run, path, whole, job.taken.samples);
        },
        [&](const Output& output) { write_sample_file(output, command, arguments, job, display); });
  }
  tell(run, arguments.quiet, job, outputs);
}

}  // namespace brindle::tool
