#include "input/solving_options.h"

#include <optional>
#include <string>
#include <string_view>

#include "brindle/phases/parsed_words.h"
#include "brindle/waves/parsed_words.h"
#include "cli/command_line.h"
#include "cli/option_values.h"

namespace brindle::tool {
namespace {

std::optional<EdgeWeights> parse_edge_weights(std::string_view name) {
  if (name == "paper") return EdgeWeights::paper;
  if (name == "cotangent") return EdgeWeights::cotangent;
  return std::nullopt;
}

}  // namespace

void add_solving_options(CLI::App& app, SolvingOptions& options) {
  SolverOptions& solver = options.stripes.solver;
  add_named_option(app, "--phase-shift", options.stripes.phase_shift, parse_phase_shift_kind);
  add_named_option(app, "--weights", options.stripes.weights, parse_edge_weights);
  add_number_option(app, "--epsilon", solver.epsilon);
  add_number_option(app, "--momentum", solver.momentum);
  app.add_option("--seed", solver.seed);
  app.add_option("--sweeps", solver.sweeps);
  app.add_option("--cycles", solver.cycles);
  app.add_option("--global-iterations", solver.global_iterations);
  add_slack_options(app, options.slack);
  app.add_option("--threads", options.threads);
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
  const SolverOptions& solver = options.stripes.solver;
  refuse_usage(command, [&](const IsGiven& given) {
    check_solver_options(given, solver.solver, solver.cycles);
  });
}

void add_solver_option(CLI::App& app, SolvingOptions& options) {
  add_named_option(app, "--solver", options.stripes.solver.solver, parse_solver);
}

}  // namespace brindle::tool
