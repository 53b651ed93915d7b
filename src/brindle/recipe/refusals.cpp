#include "brindle/recipe/refusals.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "brindle/base/standard.h"
#include "brindle/base/text.h"
#include "brindle/samples.h"

namespace brindle {

void refuse_given(const IsGiven& given, const std::vector<std::string>& options,
                  std::string_view why) {
  for (const std::string& option : options) {
    if (given(option)) throw RefusedOption(option, "has no effect here: " + std::string(why));
  }
}

void check_one_process(const IsGiven& given, PatternJob job) {
  for (const OptionInfo& row : option_table()) {
    const std::string option = "--" + std::string(row.name);
    if (!row.is_for(job) || row.one_process.empty() || !given(option)) continue;
    throw RefusedOption(option, std::string(row.one_process));
  }
}

std::string taken_by(const OptionInfo& info) {
  const NumberRange& range = info.range;
  if (info.kind == OptionKind::choice) return "one of " + std::string(info.form);
  if (info.kind == OptionKind::length) {
    return std::string("a length") + (range.above_least ? " above zero," : "") +
           " like 0.02, or 1.5% of the diagonal";
  }
  if (std::isfinite(range.least) && std::isfinite(range.most)) {
    const char* least = range.above_least ? "a number above %.10g" : "a number from %.10g";
    const char* most = range.below_most ? range.above_least ? " and below %.10g" : " to below %.10g"
                       : range.above_least ? ", up to %.10g"
                                           : " to %.10g";
    return formatted(least, range.least) + formatted(most, range.most);
  }
  if (range.least == 0) {
    return range.above_least ? "a finite number above zero" : "a finite number, zero or more";
  }
  return "a finite number";
}

std::string unlike(const OptionInfo& info, const std::string& written) {
  const std::string quote = info.kind == OptionKind::whole ? "" : "'";
  return "expected " + taken_by(info) + ", got " + quote + written + quote;
}

void check_number(const std::string& option, double value, const std::string& written) {
  const OptionInfo& info = row_of(option);
  if (!info.range.contains(value)) throw RefusedOption(option, unlike(info, written));
}

void check_number(const std::string& option, double value) {
  const bool whole = row_of(option).kind == OptionKind::whole;
  check_number(option, value, formatted(whole ? "%.0f" : "%g", value));
}

void check_choice(const std::string& option, const std::string& word) {
  const OptionInfo& info = row_of(option);
  const std::string all = '|' + std::string(info.form) + '|';
  if (!word.empty() && all.find('|' + word + '|') != all.npos) return;
  throw RefusedOption(option, unlike(info, word));
}

void check_solver_options(const IsGiven& given, Solver solver, int cycles) {
  const std::string name(name_of(solver));
  if (solver != Solver::relaxation && solver != Solver::averaged) {
    refuse_given(given, {"--epsilon", "--momentum", "--seed"},
                 "it is for --solver relaxation and averaged, not for " + name);
  }
  if (solver != Solver::global) {
    refuse_given(given, {"--global-iterations"}, "it is for --solver global, not for " + name);
  }
  if (solver != Solver::multilevel && cycles == 0) {
    refuse_given(given, {"--sweeps"},
                 "it is for --solver multilevel and for --cycles, not for " + name + " alone");
  }
}

void check_avoid_branches(const IsGiven& given, bool yields) {
  if (!yields) refuse_given(given, {"--avoid-branches"}, "no frequency yields; add --slack");
}

void check_following(const IsGiven& given, bool follows, Solver solver) {
  if (!follows) {
    refuse_given(given, {"--lambda", "--match"}, "no pattern is followed; add --previous");
  } else if (solver != Solver::multilevel) {
    refuse_given(given, {"--previous"}, "it is for --solver multilevel");
  }
}

void check_fabrication(const FabricationOptions& options, Solver solver) {
  if (options.cancel_distance && !options.cancel_branches) {
    throw RefusedOption("--cancel-distance",
                        "has no effect here: no branch pairs are cancelled; add --cancel-branches");
  }
  if (!options.anchor_boundary) return;
  if (solver != Solver::multilevel) {
    throw RefusedOption("--anchor-boundary", "has no effect here: it is for --solver multilevel");
  }
  const bool spiral = ranges::any_of(options.windings, [](const WantedWinding& w) {
    return w.periods != 0 && !w.loop.starts_with("loop");
  });
  if (!spiral) return;
  throw RefusedOption("--winding",
                      "with --anchor-boundary, stripes at the boundary are rings: take "
                      "--winding 0, or leave one of both out");
}

void check_smooth_field(const IsGiven& given, float curvature_anchor, float feature_anchor) {
  if (curvature_anchor == 0) {
    refuse_given(given, {"--curvature-direction"},
                 "the field does not follow curvature; take --field curvature or add "
                 "--curvature-anchor");
  }
  if (feature_anchor == 0) {
    refuse_given(given, {"--feature-angle", "--feature-radius"},
                 "nothing draws the field to sharp edges; add --feature-anchor");
  }
}

void check_field_smoothing(const IsGiven& given, const SmoothingRequest& wanted) {
  if (!wanted.measured) {
    refuse_given(given,
                 {"--field-smoothing", "--field-weight", "--hold-out", "--field-arrows",
                  "--field-singularities"},
                 "the field was not measured; it is for arrays, files and raw-curvature");
  }
  if (!wanted.varies) refuse_given(given, {"--frequency-smoothing"}, kSameFrequency);
  if (wanted.periods == 0) {
    refuse_given(given,
                 {"--field-weight", "--hold-out", "--field-arrows", "--field-singularities",
                  "--temporal-smoothing"},
                 "the field is taken as it is given; add --field-smoothing");
  }
  if (wanted.periods == 0 && wanted.frequency_periods == 0) {
    refuse_given(given, {"--fill"},
                 "nothing is filled; add --field-smoothing or --frequency-smoothing");
  }
  if (wanted.cross) refuse_given(given, {"--field-arrows"}, "a cross has no sign");
}

void check_triangle_options(const IsGiven& given) {
  refuse_given(given, {"--feature-anchor", "--weights", "--field-singularities"},
               "points have no triangles");
}

void check_fabrication_of_textures(const IsGiven& given) {
  refuse_given(given, {"--winding", "--anchor-boundary"},
               "it is for stripes, not for textures and cross fields");
}

void check_fabrication_on_points(const IsGiven& given) {
  refuse_given(given, {"--winding", "--anchor-boundary", "--cancel-branches"},
               "points have no triangles");
}

void check_min_distance_on_points(float min_distance) {
  if (min_distance >= kDoubleShare) return;
  throw RefusedOption("--min-distance",
                      "has no effect on points below 0.25: so near to each other, what two points "
                      "find of one crossing is merged");
}

void check_view_of_points(bool shows_stripes) {
  if (shows_stripes) return;
  throw RefusedOption("--view",
                      "points have no triangles: branches and angle errors are not drawn; take "
                      "--view stripes");
}

void check_view_of_crosses(bool shows_stripes) {
  if (shows_stripes) return;
  throw RefusedOption("--view",
                      "of a cross field, branches and angle errors are not drawn; take --view "
                      "stripes");
}

void check_tile_of_crosses(const std::string& name) {
  constexpr std::array<std::string_view, 3> kTurned = {"checker", "dots", "plus"};
  if (ranges::find(kTurned, std::string_view(name)) != kTurned.end()) return;
  throw RefusedOption("--texture", "'" + name +
                                       "' does not look the same turned by 90 degrees; with "
                                       "--cross take checker, dots, plus or a picture that does");
}

}  // namespace brindle
