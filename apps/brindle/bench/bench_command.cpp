#include <algorithm>
#include <iostream>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/bench_plan.h"
#include "bench/bench_report.h"
#include "brindle/base/output_file.h"
#include "brindle/base/parallel.h"
#include "brindle/base/text.h"
#include "brindle/phases/coloring.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/option_fields.h"
#include "cli/progress_display.h"
#include "device/device.h"
#include "input/preparation.h"
#include "input/used_files.h"
#include "outputs/outputs.h"
#include "outputs/written_files.h"

namespace brindle::tool {
namespace {

constexpr const char* kExamples = R"(Examples:
  brindle bench --json bench.json
  brindle bench horse.ply --direction 0.31,0.9,0.27
  brindle bench horse.ply --direction 0.31,0.9,0.27 --device gpu
  brindle bench flow.vtp --field array:velocity
  brindle bench --figure 13)";

// Not parallel to a symmetry axis or plane of any built-in shape.
const Vec3 kDirection(0.31f, 0.9f, 0.27f);

struct Arguments {
  BenchArguments bench;
  DeviceKind device = DeviceKind::cpu;
  WaveOptions waves;
  std::string json;
  bool quiet = false;
};

Subject subject_of(const Arguments& arguments, const BenchPlan& plan, const std::string& mesh,
                   int subdivide, ProgressDisplay& display) {
  SurfaceOptions surface;
  surface.mesh = mesh;
  surface.subdivide = subdivide;
  refuse_points(surface, "bench");
  Preparation prepared = prepare(surface, arguments.waves, display);
  Subject subject{mesh, subdivide, std::move(prepared.surface), {}, prepared.topology_milliseconds};
  subject.fields.push_back(std::move(prepared.waves));
  if (plan.two_fields) add_crossing_field(subject);
  if (plan.cross) make_cross_field(subject);
  return subject;
}

// Loads everything before the first measurement, so that a mistyped name fails at once.
std::vector<Subject> subjects_of(const Arguments& arguments, const BenchPlan& plan,
                                 ProgressDisplay& display) {
  std::vector<Subject> subjects;
  for (const std::string& mesh : plan.meshes) {
    subjects.push_back(subject_of(arguments, plan, mesh, 0, display));
    if (plan.subdivide == 0) continue;
    subjects.push_back(subject_of(arguments, plan, mesh, plan.subdivide, display));
  }
  return subjects;
}

bool is_left_out(const SolverCase& solver, const Subject& subject, int global_limit) {
  return solver.options.solver == Solver::global &&
         subject.vertex_count() > static_cast<std::size_t>(global_limit);
}

MeshMetrics empty_metrics(const Subject& subject) {
  const Adjacency& neighborhood = *subject.surface.neighborhood;
  MeshMetrics metrics;
  metrics.mesh = subject.name;
  metrics.subdivided = subject.subdivided;
  metrics.vertices = subject.vertex_count();
  metrics.triangles = subject.surface.mesh.triangle_count();
  metrics.edges = neighborhood.edge_count();
  metrics.luby_colors = luby_coloring(neighborhood).color_count;
  metrics.greedy_colors = greedy_coloring(neighborhood).color_count;
  metrics.fields = subject.fields.size();
  metrics.neighborhood_milliseconds = subject.neighborhood_milliseconds;
  return metrics;
}

/// Empty, with a note, if pictures cannot be drawn.
std::optional<DrawMetrics> draw_metrics(const Subject& subject, const BenchPlan& plan,
                                        const Progress& progress, std::vector<std::string>& notes) {
  try {
    return measure_draw(subject, plan.picture_width, plan.picture_height, plan.repetitions,
                        progress);
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    notes.push_back(std::string("no pictures: ") + error.what());
    return std::nullopt;
  }
}

MeshMetrics metrics_of(const Subject& subject, const BenchPlan& plan, const Device& device,
                       int global_limit, ProgressDisplay& display,
                       std::vector<std::string>& notes) {
  MeshMetrics metrics = empty_metrics(subject);
  // Progress while solvers report their own stages.
  const auto progress = [&](const std::string& name) {
    return Progress(
        [&display, stage = formatted("%s, %zu vertices", name.c_str(), subject.vertex_count())](
            std::string_view, double) {
          display.stage(stage);
          return true;
        });
  };
  // First, before anything is freed and reused unnoticed.
  if (plan.memory) metrics.memory = measure_memory(subject);
  if (device.gpu() != nullptr) {
    metrics.gpu_frames = measure_gpu_frames(device, subject, plan.repetitions, progress("frames"));
  }
  for (const int threads : device.gpu() != nullptr ? std::vector<int>() : plan.threads) {
    const ThreadLimit limit(threads);
    metrics.frames.push_back(measure_frames(subject, plan.repetitions, progress("frames")));
  }
  for (const int threads : plan.surroundings ? plan.threads : std::vector<int>()) {
    const ThreadLimit limit(threads);
    metrics.surroundings.push_back(
        measure_surroundings(subject, plan.repetitions, progress("textures and fields")));
  }
  if (plan.slack && device.gpu() == nullptr) {
    const ThreadLimit limit(plan.threads.back());
    metrics.slack = measure_slack(subject, plan.repetitions, progress("slack"));
  }
  for (const SolverCase& solver : plan.solvers) {
    if (is_left_out(solver, subject, global_limit)) continue;
    for (const int threads : plan.threads) {
      // Brindle cannot limit CHOLMOD's threads.
      if (solver.options.solver == Solver::global && threads != plan.threads.back()) continue;
      const ThreadLimit limit(threads);
      metrics.solvers.push_back(
          measure_solver(subject, solver, device, plan.repetitions, progress(solver.name)));
    }
  }
  if (plan.picture_width > 0 && device.gpu() == nullptr) {
    metrics.draw = draw_metrics(subject, plan, progress("pictures"), notes);
  }
  return metrics;
}

/// Leaves only measurements with a GPU version; threads and resident memory do not apply.
void keep_what_the_gpu_has(BenchPlan& plan) {
  std::erase_if(plan.solvers, [](const SolverCase& solver) {
    return !has_solver(DeviceKind::gpu, solver.options.solver);
  });
  plan.threads = {plan.threads.back()};
  plan.memory = false;
  plan.surroundings = false;
}

BenchReport report_of(const Arguments& arguments) {
  BenchReport report;
  report.machine = this_machine();
  report.figure = arguments.bench.figure;
  BenchPlan plan = plan_of(arguments.bench);
  const Device device(arguments.device);
  report.device = device.description();
  if (device.gpu() != nullptr) {
    keep_what_the_gpu_has(plan);
    report.copy_bandwidth = copy_bandwidth();
  }
  ProgressDisplay display(arguments.quiet);
  const int limit = arguments.bench.global_limit;
  for (const Subject& subject : subjects_of(arguments, plan, display)) {
    report.meshes.push_back(metrics_of(subject, plan, device, limit, display, report.notes));
    if (std::ranges::any_of(plan.solvers, [&](const SolverCase& solver) {
          return is_left_out(solver, subject, limit);
        })) {
      report.notes.push_back(
          formatted("global left out at %zu vertices; --global-limit %zu includes it",
                    subject.vertex_count(), subject.vertex_count()));
    }
  }
  return report;
}

void check(const CLI::App& command, const Arguments& arguments) {
  check_report("--json", arguments.json);
  std::vector<UsedFile> inputs = field_files(arguments.waves);
  for (const std::string& mesh : arguments.bench.meshes) {
    for (UsedFile& file : input_files({.mesh = mesh}, arguments.waves)) {
      inputs.push_back(std::move(file));
    }
  }
  if (!arguments.json.empty()) check_files(inputs, {{"--json", arguments.json}});
  check_field_options(command, arguments.waves);
  if (arguments.bench.figure != 0) {
    refuse_given(command, {"--subdivide"}, "metrics have no finer copies");
  }
  const int figure = arguments.bench.figure;
  if (arguments.device == DeviceKind::gpu || figure == 14 || figure == 16) {
    refuse_given(command, {"--global-limit"}, "this run leaves the global solver out anyway");
  }
}

void run(const CLI::App& command, const Arguments& arguments) {
  check(command, arguments);
  const BenchReport report = report_of(arguments);
  if (!arguments.json.empty()) {
    nlohmann::ordered_json json = invocation_of(command);
    json.update(to_json(report));
    write_json(arguments.json, json);
  }
  if (arguments.quiet) return;
  print_bench_report(std::cout, report);
  if (!arguments.json.empty()) print_written(std::cout, std::filesystem::path(arguments.json));
}

double parse_seconds(const std::string& option, const std::string& text) {
  return static_cast<double>(parse_positive_number(option, text));
}

void add_bench_options(CLI::App& app, BenchArguments& bench) {
  app.add_option("MESH", bench.meshes,
                 "files or built-in shapes (default: shapes that suit the run)")
      ->type_name("");
  app.add_option("--figure", bench.figure,
                 "repeat Figure 13 (sizes), 14 (shapes) or 16 (averaged) of the paper")
      ->type_name("13|14|16")
      ->check(CLI::IsMember({13, 14, 16}));
  app.add_option("--subdivide", bench.subdivide,
                 "also measure meshes split in four K times (default 2; 0: not)")
      ->type_name("K")
      ->check(CLI::Range(0, 5));
  app.add_option("--threads", bench.threads,
                 "measure with 1, 2, 4, ... up to N threads (default 0: all)")
      ->type_name("N")
      ->check(CLI::Range(0, 1024));
  app.add_option("--repetitions", bench.repetitions,
                 "of each measurement, after one to warm up (default 20)")
      ->type_name("N")
      ->check(CLI::Range(1, 100000));
  add_parsed_option(app, "--seconds", bench.budget_seconds, parse_seconds,
                    "start no repetition after S seconds of a measurement (default 2)")
      ->type_name("S");
  app.add_option("--global-limit", bench.global_limit,
                 "leave the global solver out above N vertices (default 120000)")
      ->type_name("N")
      ->check(CLI::Range(0, 1 << 30));
  app.add_flag("--quick", bench.quick, "small shapes and two repetitions: a quick check");
}

void run_measurements(const CLI::App& command, Arguments& arguments) {
  // As in the paper's measurements (5.2).
  WaveOptions& waves = arguments.waves;
  if (!waves.direction && command.count("--field") == 0) waves.direction = kDirection;
  run(command, arguments);
}

void add_options(CLI::App& command, Arguments& arguments) {
  add_bench_options(command, arguments.bench);
  add_wave_options(command, arguments.waves);
  add_field(command, "--device", arguments.device);
  command.add_option("--json", arguments.json, "write all measurements here")
      ->type_name("FILE.json");
  command.add_flag("-q,--quiet", arguments.quiet, "print nothing but errors");
}

}  // namespace

Command add_bench_command(CLI::App& app) {
  return add_command<Arguments>(app, "bench",
                                "Times of all solvers and of frames that follow changing input",
                                kExamples, add_options, run_measurements);
}

}  // namespace brindle::tool
