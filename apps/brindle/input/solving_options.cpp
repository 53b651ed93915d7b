#include "input/solving_options.h"

#include <cmath>

#include "brindle/files.h"
#include "brindle/phases/parsed_words.h"
#include "brindle/recipe/solving_rows.h"
#include "brindle/recipe/wave_rows.h"
#include "cli/command_line.h"
#include "cli/option_fields.h"

namespace brindle::tool {
namespace {

int parse_whole(const std::string& option, const std::string& expected, const std::string& number,
                const std::string& text) {
  std::size_t read = 0;
  int value = 0;
  try {
    value = std::stoi(number, &read);
  } catch (const std::exception&) {
    read = 0;
  }
  if (number.empty() || read != number.size() || std::abs(value) > 1'000'000) {
    wrong_usage(option, expected, text);
  }
  return value;
}

}  // namespace

WantedWinding parse_winding(const std::string& option, const std::string& text) {
  const std::size_t colon = text.rfind(':');
  const std::string name = colon == std::string::npos ? "" : text.substr(0, colon);
  const std::string number = colon == std::string::npos ? text : text.substr(colon + 1);
  const std::string expected =
      "a whole number, or a loop's name and one: 1, boundary-1:0 or loop-2:-3";
  if (colon != std::string::npos && name.empty()) wrong_usage(option, expected, text);
  return {name, parse_whole(option, expected, number, text)};
}

void add_fabrication_options(CLI::App& app, FabricationOptions& options) {
  visit_fabrication(options, AddField(app));
  app.add_option_function<std::vector<std::string>>(
         "--winding",
         [&options](const std::vector<std::string>& texts) {
           options.windings.clear();
           for (const std::string& text : texts) {
             options.windings.push_back(parse_winding("--winding", text));
           }
         })
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
}

void check_fabrication_options(const FabricationOptions& options, Solver solver) {
  refuse_usage([&] { check_fabrication(options, solver); });
}

void check_slack_options(const CLI::App& command, const SlackOptions& options) {
  refuse_usage(command,
               [&](const IsGiven& given) { check_avoid_branches(given, options.slack > 0); });
}

void add_slack_files(const SlackOptions& options, std::vector<UsedFile>& inputs) {
  if (!options.branch_penalty.empty())
    inputs.push_back({"--avoid-branches", options.branch_penalty});
}

Slack make_slack(const SlackOptions& options, std::size_t vertex_count,
                 std::span<const Index> vertex_of_row) {
  Slack slack = options.slack;
  if (!options.branch_penalty.empty()) {
    slack.branch_penalty =
        read_branch_penalty_csv(options.branch_penalty, vertex_count, vertex_of_row);
  }
  return slack;
}

Slack make_slack(const SlackOptions& options, const Surface& surface,
                 std::span<const Index> vertex_of_row) {
  Slack slack = make_slack(options, surface.own_vertex_count(), vertex_of_row);
  add_rows_of_copies(surface.creases, slack.branch_penalty);
  return slack;
}

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
