/// The benchmarks of `brindle-bench`, on Google Benchmark. Subjects must outlive their runs.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "brindle/gpu_animator.h"
#include "brindle/gpu_solver.h"
#include "brindle/headless_context.h"
#include "brindle/renderer.h"
#include "brindle/solver.h"
#include "subject.h"

namespace brindle::bench {

/// Registers `run` as `NAME/SUBJECT/threads:N`; it runs with at most so many threads.
benchmark::internal::Benchmark* add_benchmark(const std::string& name, const Subject& subject,
                                              int threads,
                                              std::function<void(benchmark::State&)> run);

/// Milliseconds of one run, and of stages of it.
struct Sample {
  double time = 0;
  std::vector<StageTime> stages = {};
};

/// Repeats `run` after one run that fills caches. Counters have the minimum and median time, and
/// the median of each stage, in milliseconds.
void repeat(benchmark::State& state, const std::function<Sample()>& run);

void show(benchmark::State& state, const Quality& quality);

struct SolverCase {
  std::string name;
  SolverOptions options;
};

/// Memory of an animator, in addition to the mesh and the field.
void add_memory(const Subject& subject);

/// From waves to phases, all fields of a subject; `solve` as in StripeOptions.
void add_solver(const Subject& subject, int threads, const SolverCase& solver,
                const SolvePhases& solve = {});

/// Frames of StripeAnimator that follow changing waves, all fields of a subject.
void add_frames(const Subject& subject, int threads);

/// Stages around the solver, spacing tolerance and smoothing, each for the first field.
void add_surroundings(const Subject& subject, int threads);

/// Inner loops of the solvers, on one thread.
void add_kernels(const Subject& subject);

#ifdef BRINDLE_HAS_GL
/// Pictures of the first field, from OpenGL buffers to pixels in memory.
void add_pictures(const Subject& subject, int threads);

/// The device of `--gpu`.
struct Gpu {
  HeadlessContext context;
  GpuSolver solver;
};

/// Solvers, and frames of GpuAnimator by stage.
void add_gpu(const Gpu& gpu, const Subject& subject, const std::vector<SolverCase>& solvers,
             int threads);

/// Repeats pictures, each from a slightly turned camera, so that nothing can be reused.
void repeat_picture(benchmark::State& state, const Renderer& renderer, RenderOptions options);
#endif

}  // namespace brindle::bench
