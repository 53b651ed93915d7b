#include "making_options.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "brindle/boundary_phases.h"
#include "brindle/error.h"
#include "brindle/pipeline/stripes_again.h"
#include "command_line.h"
#include "formatted.h"
#include "option_values.h"

namespace brindle::tool {
namespace {

constexpr std::size_t kMostLines = 12;  // of windings, for people

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

WantedWinding parse_winding(const std::string& option, const std::string& text) {
  const std::size_t colon = text.rfind(':');
  const std::string name = colon == std::string::npos ? "" : text.substr(0, colon);
  const std::string number = colon == std::string::npos ? text : text.substr(colon + 1);
  const std::string expected =
      "a whole number, or a loop's name and one: 1, boundary-1:0 or loop-2:-3";
  if (colon != std::string::npos && name.empty()) wrong_usage(option, expected, text);
  return {name, parse_whole(option, expected, number, text)};
}

// What was asked of boundaries, which a wave that was turned no longer is asked.
StripeOptions with_boundary(const Surface& surface, const WaveSet& waves, StripeOptions stripes,
                            const MakingOptions& options, MakingFigures& figures) {
  if (!options.anchor_boundary) return stripes;
  stripes.fixed_phases = boundary_phases(surface, waves, *options.anchor_boundary);
  figures.fixed_vertices = static_cast<std::size_t>(std::ranges::count_if(
      stripes.fixed_phases, [](const Complex& z) { return z != Complex(0); }));
  if (figures.fixed_vertices == 0) {
    throw Error(
        "--anchor-boundary: nowhere do stripes run along a boundary, within 45 degrees; turn the "
        "field by --along or --rotate, or leave out the option");
  }
  return stripes;
}

std::string text_of(const Winding& winding) { return winding ? std::to_string(*winding) : "none"; }

// Where the numbers of one piece's boundaries differ, and why.
std::string differences(const MakingFigures& figures) {
  std::string text;
  for (std::size_t i = 0; i < figures.loops.size(); ++i) {
    const SurfaceLoop& loop = figures.loops[i];
    if (!loop.boundary || !figures.windings[i]) continue;
    for (std::size_t k = i + 1; k < figures.loops.size(); ++k) {
      const SurfaceLoop& other = figures.loops[k];
      if (!other.boundary || other.component != loop.component || !figures.windings[k]) continue;
      if (*figures.windings[i] == *figures.windings[k]) break;
      text +=
          formatted("   %s and %s differ: of %zu branches and singularities, some lie between\n",
                    loop.name.c_str(), other.name.c_str(), figures.branches[i]);
      break;
    }
  }
  return text;
}

}  // namespace

void add_making_options(CLI::App& app, MakingOptions& options) {
  add_parsed_option(app, "--anchor-boundary", options.anchor_boundary, parse_number,
                    "lay the first stripe along boundaries, P periods inside (0: on the rim; 0.5: "
                    "the rim is in the middle of a gap)")
      ->type_name("P");
  add_parsed_option(app, "--merge-branches", options.merge_branches, parse_not_negative_number,
                    "remove pairs of opposite branches, as long as the energy rises by this share "
                    "of itself at most (0.1: a tenth)")
      ->type_name("SHARE");
  app.add_option_function<std::vector<std::string>>(
         "--winding",
         [&options](const std::vector<std::string>& texts) {
           options.windings.clear();
           for (const std::string& text : texts) {
             options.windings.push_back(parse_winding("--winding", text));
           }
         },
         "how many stripes wind round a loop as helices: 0 are rings, 1 a single spiral, -1 a "
         "left-handed one; turns the field by small angles. LOOP is a name of the report of "
         "'brindle curves', where there are several; repeatable")
      ->type_name("[LOOP:]K")
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
}

void check_making_options(const CLI::App& command, const MakingOptions& options, Solver solver) {
  if (options.anchor_boundary && solver != Solver::multilevel) {
    refuse_given(command, {"--anchor-boundary"}, "it is for --solver multilevel");
  }
  const bool spiral = std::ranges::any_of(options.windings, [](const WantedWinding& w) {
    return w.periods != 0 && !w.loop.starts_with("loop");
  });
  if (options.anchor_boundary && spiral) {
    throw CLI::ValidationError("--winding",
                               "with --anchor-boundary, stripes at the boundary are rings: take "
                               "--winding 0, or leave one of both out");
  }
}

namespace {

// With the phases of `stripes` fixed where a boundary asks for them.
StripePattern wound_pattern(const Surface& surface, WaveSet waves, StripeOptions& stripes,
                            const MakingOptions& options, const Progress& progress,
                            MakingFigures& figures) {
  if (options.windings.empty()) {
    stripes = with_boundary(surface, waves, stripes, options, figures);
    return stripe_pattern(surface, std::move(waves), stripes, progress);
  }
  WoundPattern wound = wind(surface, stripe_pattern(surface, std::move(waves), stripes, progress),
                            options.windings, stripes, progress);
  figures.windings_before = wound.before;
  figures.energy_before = wound.energy_before;
  figures.largest_turn_deg = wound.largest_turn_deg;
  figures.mean_turn_deg = wound.mean_turn_deg;
  figures.largest_frequency_change = wound.largest_frequency_change;
  if (!options.anchor_boundary) return std::move(wound.pattern);
  stripes = with_boundary(surface, wound.pattern.waves, stripes, options, figures);
  WaveSet turned = wound.pattern.waves;
  return stripes_again(surface, std::move(turned), wound.pattern, stripes, progress);
}

}  // namespace

StripePattern make_pattern(const Surface& surface, WaveSet waves, StripeOptions stripes,
                           const MakingOptions& options, const Progress& progress,
                           MakingFigures& figures) {
  StripePattern pattern =
      wound_pattern(surface, std::move(waves), stripes, options, progress, figures);
  if (options.merge_branches) {
    figures.merged = merge_branches(surface, pattern, static_cast<double>(*options.merge_branches),
                                    stripes, progress);
  }
  return pattern;
}

void measure_windings(const Surface& surface, const StripePattern& pattern,
                      MakingFigures& figures) {
  figures.loops = surface_loops(surface);
  figures.windings = windings(surface, figures.loops, pattern);
  for (const SurfaceLoop& loop : figures.loops) {
    figures.branches.push_back(branches_of_piece(surface, loop, pattern));
  }
}

void add_to_json(const MakingFigures& figures, nlohmann::ordered_json& json) {
  auto loops = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < figures.loops.size(); ++i) {
    const auto number = [](const Winding& winding) {
      return winding ? nlohmann::ordered_json(*winding) : nlohmann::ordered_json(nullptr);
    };
    nlohmann::ordered_json loop = {{"name", figures.loops[i].name},
                                   {"length", figures.loops[i].length},
                                   {"winding", number(figures.windings[i])},
                                   {"branches_of_its_piece", figures.branches[i]}};
    if (!figures.windings_before.empty()) {
      loop["winding_before"] = number(figures.windings_before[i]);
    }
    loops.push_back(std::move(loop));
  }
  if (!loops.empty()) json["loops"] = std::move(loops);
  if (!figures.windings_before.empty()) {
    json["turned"] = {{"energy_before", figures.energy_before},
                      {"largest_deg", figures.largest_turn_deg},
                      {"mean_deg", figures.mean_turn_deg},
                      {"largest_frequency_change", figures.largest_frequency_change}};
  }
  if (figures.merged) {
    const MergedBranches& merged = *figures.merged;
    json["merged"] = {{"pairs", merged.pairs},
                      {"branches_before", merged.branches_before},
                      {"energy_before", merged.energy_before}};
  }
  if (figures.fixed_vertices > 0) json["boundary_vertices_fixed"] = figures.fixed_vertices;
}

std::string lines_of(const MakingFigures& figures) {
  std::string text;
  for (std::size_t i = 0; i < std::min(kMostLines, figures.loops.size()); ++i) {
    const std::string before =
        figures.windings_before.empty() ? "" : ", before " + text_of(figures.windings_before[i]);
    text += formatted("%s%s %s%s", i == 0 ? "   windings: " : "; ", figures.loops[i].name.c_str(),
                      text_of(figures.windings[i]).c_str(), before.c_str());
  }
  if (figures.loops.size() > kMostLines) {
    text += formatted("; and %zu more in the report", figures.loops.size() - kMostLines);
  }
  if (!text.empty()) text += '\n';
  text += differences(figures);
  if (!figures.windings_before.empty()) {
    text += formatted(
        "   the field is turned by up to %.2f degrees, %.2f on average, frequencies by up to %.1f "
        "%%; energy %.6f before\n",
        figures.largest_turn_deg, figures.mean_turn_deg, 100 * figures.largest_frequency_change,
        figures.energy_before);
  }
  if (figures.merged) {
    const MergedBranches& merged = *figures.merged;
    text += formatted(
        "   %zu pairs of branches merged: %zu branches before, %zu after; energy "
        "%.6f before, %.6f after\n",
        merged.pairs, merged.branches_before, merged.branches_after, merged.energy_before,
        merged.energy_after);
  }
  return text;
}

}  // namespace brindle::tool
