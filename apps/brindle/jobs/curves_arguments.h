/// Arguments of `brindle curves`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "brindle/recipe/mark_rows.h"
#include "cli/option_values.h"
#include "input/fabrication_options.h"
#include "input/second_waves.h"
#include "outputs/outputs.h"

namespace brindle::tool {

enum class TracedWaves { u, v, both };

/// The shape of written lines.
struct LineShape {
  std::optional<Length> simplify, resample, tube_radius;
  int tube_sides = 8;
  Length min_length;                 ///< shorter lines are left out
  std::optional<Length> path_width;  ///< of drawings

  /// Calls `add("--option", field)` for each option that sets a field but those of tubes.
  template <class Add>
  void visit_lines(const Add& add) {
    add("--min-length", min_length);
    add("--simplify", simplify);
    add("--resample", resample);
    add("--path-width", path_width);
  }
};

/// Which lines are traced, and how.
struct TracingOptions : LineShape {
  TracedWaves traced = TracedWaves::u;
  float offset = 0;
  CurveOptions curves;

  /// Calls `add("--option", field)` for each option that sets a field but those of tubes.
  template <class Add>
  void visit_lines(const Add& add) {
    add("--lines", traced);
    add("--offset", offset);
    visit_curves(curves, add);
    LineShape::visit_lines(add);
  }

  /// The same for all.
  template <class Add>
  void visit(const Add& add) {
    visit_lines(add);
    add("--tube-radius", tube_radius);
    add("--tube-sides", tube_sides);
  }
};

struct CurvesArguments : JobArguments, TracingOptions {
  SecondWaveOptions second;
  FabricationOptions fabrication;
  std::optional<float> crease_deg;  ///< lines along sharper edges, and borders
};

void add_curves_options(CLI::App& command, CurvesArguments& arguments);

/// The options of a surface, its waves, the solver and the making of curves, without their shape.
void add_traced_options(CLI::App& command, CurvesArguments& arguments);

/// Throws CLI::ValidationError for options of these that are without effect beside others.
void check_traced_options(const CLI::App& command, const CurvesArguments& arguments);

/// Throws CLI::ValidationError for options without effect on these files or beside other options.
void check_curves_options(const CLI::App& command, const CurvesArguments& arguments,
                          const Outputs& outputs);

/// Reads the mesh's file if necessary, and throws Error if it has only points.
void check_curves_points(const CurvesArguments& arguments);

/// All input files.
std::vector<UsedFile> curves_inputs(const CurvesArguments& arguments);

}  // namespace brindle::tool
