#include <algorithm>
#include <cstdio>
#include <deque>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "benchmarks.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/phases/sliced_kernels.h"
#include "brindle/threads.h"
#include "table.h"

namespace brindle::bench {
namespace {

constexpr const char* kExamples = R"(Examples:
  brindle-bench --benchmark_out=bench.json
  brindle-bench horse.ply --benchmark_filter='^(frame|multilevel|global)'
  brindle-bench --figure 13

Options of Google Benchmark:)";

struct Arguments {
  std::vector<std::string> meshes;  ///< files or shapes; empty: built-in shapes
  int figure = 0;                   ///< of the paper; 0: all benchmarks
  int subdivide = 2;                ///< subdivisions of the finer copy of a mesh
  int threads = 0;                  ///< at most; 0: all that the machine has
  float stripes = 40;               ///< along the diagonal
  int global_limit = 120000;        ///< largest vertex count for the global solver
  bool gpu = false;
};

void add_options(CLI::App& app, Arguments& arguments) {
  app.add_option("MESH", arguments.meshes, "files or built-in shapes (default: shape:vessels)");
  const auto figure =
      app.add_option("--figure", arguments.figure,
                     "repeat Figure 13 (sizes), 14 (shapes) or 16 (averaged) of the paper")
          ->type_name("13|14|16")
          ->check(CLI::IsMember({13, 14, 16}));
  app.add_option("--subdivide", arguments.subdivide,
                 "also measure meshes split in four K times (default 2; 0: not)")
      ->type_name("K")
      ->check(CLI::Range(0, 5))
      ->excludes(figure);
  app.add_option("--threads", arguments.threads,
                 "measure with 1, 2, 4, ... up to N threads (default 0: all)")
      ->type_name("N")
      ->check(CLI::Range(0, 1024));
  app.add_option("--stripes", arguments.stripes, "stripes along the diagonal (default 40)")
      ->type_name("N")
      ->check(CLI::Range(1e-3f, 1e6f));
  const auto limit = app.add_option("--global-limit", arguments.global_limit,
                                    "leave the global solver out above N vertices (default 120000)")
                         ->type_name("N")
                         ->check(CLI::Range(0, 1 << 30));
  app.add_flag("--gpu", arguments.gpu, "measure on the GPU instead")->excludes(limit);
}

// Molecules of 2.5k, 5k, 10k, 20k, 48k, 100k, 200k, 400k and 800k vertices.
std::vector<std::string> growing_shapes() {
  std::vector<std::string> meshes;
  for (const int resolution : {15, 22, 30, 44, 65, 93, 133, 188, 265}) {
    meshes.push_back(formatted("shape:molecule,resolution=%d", resolution));
  }
  return meshes;
}

std::vector<std::string> default_meshes(int figure) {
  if (figure == 13 || figure == 16) return growing_shapes();
  if (figure == 0) return {"shape:vessels,resolution=124"};
  // Of about 30k vertices each, like the paper's models.
  return {"shape:sphere,resolution=55",          "shape:torus,resolution=234",
          "shape:trefoil,resolution=54",         "shape:box,resolution=48",
          "shape:molecule,resolution=51",        "shape:vessels,resolution=98",
          "shape:torus,resolution=234,noise=0.3"};
}

SolverCase relaxation(float epsilon) {
  SolverCase result{formatted("relaxation_%.2f", static_cast<double>(epsilon)), {}};
  result.options.solver = Solver::relaxation;
  result.options.epsilon = epsilon;
  return result;
}

SolverCase averaged() {
  SolverCase result{"averaged_0.02", {}};
  result.options.solver = Solver::averaged;
  return result;
}

SolverCase global(int iterations) {
  SolverCase result{formatted("global_%d", iterations), {}};
  result.options.solver = Solver::global;
  result.options.global_iterations = iterations;
  return result;
}

std::vector<SolverCase> solvers_of(int figure) {
  switch (figure) {
    case 13:
      return {global(1), relaxation(0.05f), relaxation(0.02f)};
    case 14:
      return {relaxation(0.05f), relaxation(0.02f)};
    case 16:
      return {relaxation(0.02f), averaged()};
    default:
      return {{"multilevel", {}}, relaxation(0.05f), relaxation(0.02f),
              averaged(),         global(1),         global(20)};
  }
}

Fields fields_of(int figure) {
  return figure == 13 ? Fields::two : figure == 16 ? Fields::crosses : Fields::one;
}

// 1, 2, 4 ... and all. Metrics of the paper and the GPU's have the last alone.
std::vector<int> thread_counts(const Arguments& arguments) {
  const int all = ThreadLimit::current();
  const int most = arguments.threads > 0 ? std::min(arguments.threads, all) : all;
  std::vector<int> counts;
  if (arguments.figure == 0 && !arguments.gpu) {
    for (int count = 1; count < most; count *= 2) counts.push_back(count);
  }
  counts.push_back(most);
  return counts;
}

// Loads all meshes, so that a mistyped name fails at once.
std::deque<Subject> subjects_of(const Arguments& arguments) {
  std::deque<Subject> subjects;
  const auto& meshes =
      arguments.meshes.empty() ? default_meshes(arguments.figure) : arguments.meshes;
  for (const std::string& mesh : meshes) {
    const auto add = [&](int subdivisions) {
      subjects.push_back(
          make_subject(mesh, subdivisions, fields_of(arguments.figure), arguments.stripes));
    };
    add(0);
    if (arguments.figure == 0 && arguments.subdivide > 0) add(arguments.subdivide);
  }
  return subjects;
}

void add_on_processor(const Arguments& arguments, const Subject& subject) {
  const bool all = arguments.figure == 0;
  const std::vector<int> threads = thread_counts(arguments);
  // First, before anything is freed and reused unnoticed.
  if (all) add_memory(subject);
  for (const int count : threads) {
    add_frames(subject, count);
    if (all) add_surroundings(subject, count);
  }
  for (const SolverCase& solver : solvers_of(arguments.figure)) {
    if (!is_available(solver.options.solver)) continue;
    const bool is_global = solver.options.solver == Solver::global;
    if (is_global && subject.vertex_count() > static_cast<std::size_t>(arguments.global_limit)) {
      std::fprintf(stderr, "%s is left out at %zu vertices; --global-limit %zu includes it\n",
                   solver.name.c_str(), subject.vertex_count(), subject.vertex_count());
      continue;
    }
    for (const int count : threads) {
      // Brindle cannot limit CHOLMOD's threads.
      if (!is_global || count == threads.back()) add_solver(subject, count, solver);
    }
  }
  if (all) add_kernels(subject);
#ifdef BRINDLE_HAS_GL
  if (all) add_pictures(subject, threads.back());
#endif
}

int run(const Arguments& arguments) {
  const std::deque<Subject> subjects = subjects_of(arguments);
  Table table;
#ifdef BRINDLE_HAS_GL
  const std::unique_ptr<Gpu> gpu = arguments.gpu ? std::make_unique<Gpu>() : nullptr;
  if (gpu) {
    benchmark::AddCustomContext("gpu", describe(gl_device()));
  }
  for (const Subject& subject : subjects) {
    if (gpu) {
      add_gpu(*gpu, subject, solvers_of(arguments.figure), thread_counts(arguments).back());
    } else {
      add_on_processor(arguments, subject);
    }
  }
#else
  if (arguments.gpu) throw Error("this build has no OpenGL; configure with -DBRINDLE_GL=ON");
  for (const Subject& subject : subjects) add_on_processor(arguments, subject);
#endif
#ifdef BRINDLE_HAS_HIGHWAY
  benchmark::AddCustomContext("instruction_set", simd::target_name());
#endif
  // Complains on its own where no name matches the filter.
  if (benchmark::RunSpecifiedBenchmarks(&table) == 0) return 2;
  table.print();
  return 0;
}

void print_help() {
  Arguments arguments;
  CLI::App app("Times of solvers and of frames that follow changing input", "brindle-bench");
  add_options(app, arguments);
  app.footer(kExamples);
  std::fputs(app.help().c_str(), stdout);
  benchmark::PrintDefaultHelp();
}

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv, print_help);
  Arguments arguments;
  CLI::App app;
  add_options(app, arguments);
  try {
    app.parse(argc, argv);
    if (arguments.figure > 13 && app.count("--global-limit") > 0) {
      throw CLI::ValidationError("--global-limit", "this figure leaves the global solver out");
    }
    return run(arguments);
  } catch (const CLI::ParseError& error) {
    std::fprintf(stderr, "brindle-bench: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "brindle-bench: %s\n", error.what());
    return 1;
  }
}

}  // namespace
}  // namespace brindle::bench

int main(int argc, char** argv) { return brindle::bench::main(argc, argv); }
