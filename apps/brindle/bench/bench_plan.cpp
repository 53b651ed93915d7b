#include "bench/bench_plan.h"

#include <algorithm>

#include "brindle/base/parallel.h"
#include "brindle/base/text.h"

namespace brindle::tool {
namespace {

constexpr const char* kSmallShape = "shape:molecule,resolution=15";

// Molecules of 2.5k, 5k, 10k, 20k, 48k, 100k, 200k, 400k and 800k vertices.
constexpr int kResolutions[] = {15, 22, 30, 44, 65, 93, 133, 188, 265};

std::vector<std::string> growing_shapes(bool quick) {
  std::vector<std::string> meshes;
  for (const int resolution : kResolutions) {
    meshes.push_back(formatted("shape:molecule,resolution=%d", resolution));
    if (quick && meshes.size() == 2) break;
  }
  return meshes;
}

// Of about 30k vertices each, like the paper's models.
std::vector<std::string> different_shapes(bool quick) {
  if (quick) return {"shape:torus,resolution=60", "shape:sphere,resolution=14"};
  return {"shape:sphere,resolution=55",          "shape:torus,resolution=234",
          "shape:trefoil,resolution=54",         "shape:box,resolution=48",
          "shape:molecule,resolution=51",        "shape:vessels,resolution=98",
          "shape:torus,resolution=234,noise=0.3"};
}

std::vector<std::string> default_meshes(const BenchArguments& arguments) {
  switch (arguments.figure) {
    case 13:
    case 16:
      return growing_shapes(arguments.quick);
    case 14:
      return different_shapes(arguments.quick);
    default:
      return {arguments.quick ? kSmallShape : "shape:vessels,resolution=124"};
  }
}

SolverCase multilevel() { return {"multilevel", {}}; }

SolverCase relaxation(float epsilon) {
  SolverCase result{formatted("relaxation %.2f", static_cast<double>(epsilon)), {}};
  result.options.solver = Solver::relaxation;
  result.options.epsilon = epsilon;
  return result;
}

SolverCase averaged() {
  SolverCase result{"averaged 0.02", {}};
  result.options.solver = Solver::averaged;
  return result;
}

SolverCase global(int iterations) {
  SolverCase result{formatted("global %d", iterations), {}};
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
      return {multilevel(), relaxation(0.05f), relaxation(0.02f),
              averaged(),   global(1),         global(20)};
  }
}

// 1, 2, 4 ... and all.
std::vector<int> thread_counts(int most) {
  std::vector<int> counts;
  for (int count = 1; count < most; count *= 2) counts.push_back(count);
  counts.push_back(most);
  return counts;
}

}  // namespace

BenchPlan plan_of(const BenchArguments& arguments) {
  const int all = ThreadLimit::current();
  const int most = arguments.threads > 0 ? std::min(arguments.threads, all) : all;
  BenchPlan plan;
  plan.meshes = arguments.meshes.empty() ? default_meshes(arguments) : arguments.meshes;
  plan.solvers = solvers_of(arguments.figure);
  std::erase_if(plan.solvers,
                [](const SolverCase& solver) { return !is_available(solver.options.solver); });
  plan.two_fields = arguments.figure == 13;
  plan.cross = arguments.figure == 16;
  if (arguments.figure == 0) {
    plan.subdivide = arguments.subdivide.value_or(arguments.quick ? 1 : 2);
    plan.threads = thread_counts(most);
    plan.memory = true;
    plan.picture_width = arguments.quick ? 320 : 1280;
    plan.picture_height = arguments.quick ? 180 : 720;
    plan.surroundings = plan.memory;
    plan.slack = true;
  } else {
    plan.threads = {most};
  }
  if (arguments.quick) plan.repetitions = {2, 0.1};
  if (arguments.repetitions) plan.repetitions.count = *arguments.repetitions;
  if (arguments.budget_seconds) plan.repetitions.budget_seconds = *arguments.budget_seconds;
  return plan;
}

}  // namespace brindle::tool
