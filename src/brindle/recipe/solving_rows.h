/// Option rows of the solver, and the fields that they set.
#pragma once

#include "brindle/option_table.h"
#include "brindle/phases/parsed_words.h"
#include "brindle/recipe/row_words.h"
#include "brindle/stripe_pattern.h"
#include "brindle/waves/parsed_words.h"

namespace brindle {

constexpr auto kSolverRows =
    in_group({.group = "Solver",
              .stale = OptionStage::phases,
              .jobs = kStripe | kCurves | kSample | kCompare | kPaths | kRelief},
             {{.name = "solver",
               .words = "solver",
               .kind = OptionKind::choice,
               .form = "multilevel|relaxation|averaged|global",
               .standard = "multilevel",
               .jobs = kStripe | kCurves | kSample | kPaths | kRelief,
               .help = "the paper's relaxation or averaged, or global (default multilevel)"},
              {.name = "phase-shift",
               .words = "distance of waves",
               .kind = OptionKind::choice,
               .form = "aligned|common_source|trapezoid",
               .standard = "aligned",
               .part_of = "solver",
               .written = ",phase-shift=",
               .help = "closed form, the paper's Eq. 2, or Knöppel's (default aligned)"},
              {.name = "weights",
               .words = "weights of edges",
               .kind = OptionKind::choice,
               .form = "paper|cotangent",
               .standard = "paper",
               .part_of = "solver",
               .written = ",weights=",
               .help = "of edges: the paper's (default), or times cotangents"},
              {.name = "sweeps",
               .words = "sweeps",
               .kind = OptionKind::whole,
               .form = "N",
               .range = {.least = 0, .most = 10000},
               .slider = {0, 50},
               .part_of = "solver",
               .written = ",sweeps=",
               .jobs = kAll,
               .help = "multilevel: sweeps on each level"},
              {.name = "cycles",
               .words = "cycles",
               .kind = OptionKind::whole,
               .form = "N",
               .range = {.least = 0, .most = 10000},
               .slider = {0, 20},
               .part_of = "solver",
               .written = ",cycles=",
               .help = "multilevel descents after the solver's phases"},
              {.name = "epsilon",
               .words = "stops below",
               .kind = OptionKind::number,
               .form = "E",
               .standard = "0.02",
               .range = kNotNegative,
               .slider = {0.0001, 1, true},
               .part_of = "solver",
               .written = ",epsilon=",
               .help = "relaxation, averaged: least relative improvement (default 0.02)"},
              {.name = "momentum",
               .words = "momentum",
               .kind = OptionKind::number,
               .form = "M",
               .standard = "0.2",
               .range = {.least = 0, .most = 1, .below_most = true},
               .slider = {0, 1},
               .part_of = "solver",
               .written = ",momentum=",
               .help = "relaxation, averaged: momentum of Eq. 11 (default 0.2; 0: none)"},
              {.name = "seed",
               .words = "random start",
               .kind = OptionKind::whole,
               .form = "N",
               .standard = "0",
               .range = kNotNegative,
               .slider = {0, 100},
               .part_of = "solver",
               .written = ",seed=",
               .help = "relaxation, averaged: seed of the random start"},
              {.name = "global-iterations",
               .words = "global iterations",
               .kind = OptionKind::whole,
               .form = "N",
               .range = {.least = 1, .most = 10000},
               .slider = {1, 100},
               .part_of = "solver",
               .written = ",iterations=",
               .help = "global: inverse iterations"},
              {.name = "device",
               .words = "runs on",
               .kind = OptionKind::choice,
               .form = "cpu|gpu",
               .standard = "cpu",
               .one_process = kNeedsWhole,
               .jobs = kStripe | kAnimate,
               .help = "solve on the processor (default), or on the GPU by OpenGL 4.5"},
              {.name = "previous",
               .words = "stay near to",
               .form = "FILE",
               .files = kMeshFiles,
               .one_process = kNeedsWhole,
               .jobs = kStripe,
               .help = "stay near to the stripes of this output (.vtp, .ply) of an earlier run"},
              {.name = "lambda",
               .words = "coherence",
               .kind = OptionKind::number,
               .form = "L",
               .standard = "0.025",
               .range = kWeight,
               .slider = {0.001, 10, true},
               .one_process = kNeedsWhole,
               .part_of = "previous",
               .written = ",lambda=",
               .jobs = kStripe,
               .help = "--previous: weight of its phases (default 0.025; 0: none)"},
              {.name = "match",
               .words = "vertices match by",
               .form = "number|position|id:NAME",
               .one_process = kNeedsWhole,
               .part_of = "previous",
               .written = ",match=",
               .jobs = kStripe | kAnimate,
               .help = "match vertices with the last pattern by number, position or ids"}});

constexpr auto kThreadRows =
    in_group({.group = "Solver", .jobs = kAll}, {{.name = "threads",
                                                  .kind = OptionKind::whole,
                                                  .form = "N",
                                                  .standard = "0",
                                                  .range = {.least = 0, .most = 1024},
                                                  .help = "number of threads (default 0: all)"}});

constexpr auto kSolvingRows = joined(kSolverRows, kThreadRows);

/// Calls `visit("--option", field)` or `visit("--option", field, parse)` for all but --solver.
template <class Visit>
void visit_solving(StripeOptions& stripes, const Visit& visit) {
  SolverOptions& solver = stripes.solver;
  visit("--phase-shift", stripes.phase_shift, parse_phase_shift_kind);
  visit("--weights", stripes.weights);
  visit("--epsilon", solver.epsilon);
  visit("--momentum", solver.momentum);
  visit("--seed", solver.seed);
  visit("--sweeps", solver.sweeps);
  visit("--cycles", solver.cycles);
  visit("--global-iterations", solver.global_iterations);
}

}  // namespace brindle
