#include "solving_options.h"

#include <optional>
#include <string>
#include <string_view>

#include "command_line.h"
#include "option_values.h"

namespace brindle::tool {
namespace {

std::optional<EdgeWeights> parse_edge_weights(std::string_view name) {
  if (name == "paper") return EdgeWeights::paper;
  if (name == "cotangent") return EdgeWeights::cotangent;
  return std::nullopt;
}

float parse_momentum(const std::string& option, const std::string& text) {
  const float value = parse_number(option, text);
  if (value < 0 || value >= 1) wrong_usage(option, "a number from 0 to below 1", text);
  return value;
}

}  // namespace

void add_solving_options(CLI::App& app, SolvingOptions& options) {
  SolverOptions& solver = options.stripes.solver;
  add_named_option(app, "--phase-shift", options.stripes.phase_shift, parse_phase_shift_kind,
                   "aligned|common_source|trapezoid",
                   "distance between two waves: closed form (default), the paper's Eq. 2, or "
                   "Knöppel et al.'s");
  add_named_option(app, "--weights", options.stripes.weights, parse_edge_weights, "paper|cotangent",
                   "of edges: the paper's (default), or times cotangents of the triangles");
  add_parsed_option(app, "--epsilon", solver.epsilon, parse_not_negative_number,
                    "relaxation, averaged: stop at a smaller relative improvement (default 0.02)")
      ->type_name("E");
  add_parsed_option(app, "--momentum", solver.momentum, parse_momentum,
                    "relaxation, averaged: momentum of Eq. 11 (default 0.2; 0: none)")
      ->type_name("M");
  app.add_option("--seed", solver.seed, "relaxation, averaged: seed of the random start")
      ->type_name("N");
  app.add_option("--sweeps", solver.sweeps, "multilevel: sweeps on each level")
      ->type_name("N")
      ->check(CLI::Range(0, 10000));
  app.add_option("--cycles", solver.cycles,
                 "descents of the multilevel solver from the phases that the solver, whichever it "
                 "is, has found")
      ->type_name("N")
      ->check(CLI::Range(0, 10000));
  app.add_option("--global-iterations", solver.global_iterations, "global: inverse iterations")
      ->type_name("N")
      ->check(CLI::Range(1, 10000));
  add_slack_options(app, options.slack);
  app.add_option("--threads", options.threads, "0: all that the machine has (default)")
      ->type_name("N")
      ->check(CLI::Range(0, 1024));
}

AnimatorOptions frame_options(const StripeOptions& stripes) {
  AnimatorOptions options;
  options.lambda = stripes.lambda;
  options.sweeps = stripes.solver.sweeps;
  options.cycles = stripes.solver.cycles;
  options.phase_shift = stripes.phase_shift;
  return options;
}

StripeOptions stripe_options(const SolvingOptions& options, const Preparation& prepared) {
  StripeOptions stripes = options.stripes;
  stripes.slack =
      make_slack(options.slack, prepared.surface.mesh.vertex_count(), prepared.vertex_of_row);
  return stripes;
}

void check_solving_options(const CLI::App& command, const SolvingOptions& options) {
  check_slack_options(command, options.slack);
  const Solver solver = options.stripes.solver.solver;
  const std::string name(name_of(solver));
  if (solver != Solver::relaxation && solver != Solver::averaged) {
    refuse_given(command, {"--epsilon", "--momentum", "--seed"},
                 "it is for --solver relaxation and averaged, not for " + name);
  }
  if (solver != Solver::global) {
    refuse_given(command, {"--global-iterations"}, "it is for --solver global, not for " + name);
  }
  if (solver != Solver::multilevel && options.stripes.solver.cycles == 0) {
    refuse_given(command, {"--sweeps"},
                 "it is for --solver multilevel and for --cycles, not for " + name + " alone");
  }
}

void add_solver_option(CLI::App& app, SolvingOptions& options) {
  add_named_option(app, "--solver", options.stripes.solver.solver, parse_solver,
                   "multilevel|relaxation|averaged|global",
                   "multilevel (default), the paper's relaxation or averaged hierarchy, or the "
                   "global eigenvector");
}

}  // namespace brindle::tool
