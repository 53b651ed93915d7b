#include "input/solving_options.h"

#include "brindle/phases/parsed_words.h"
#include "brindle/recipe/solving_rows.h"
#include "cli/command_line.h"
#include "cli/option_fields.h"

namespace brindle::tool {

void add_solving_options(CLI::App& app, SolvingOptions& options) {
  visit_solving(options.stripes, AddField(app));
  add_fields(app, options.slack);
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
  stripes.slack = make_slack(options.slack, prepared.surface, prepared.vertex_of_row);
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
