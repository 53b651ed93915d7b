/// `brindle curves`: its arguments, and the curves.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "brindle/curve_measures.h"
#include "brindle/curves.h"
#include "brindle/recipe/mark_rows.h"
#include "brindle/stripe_tracer.h"
#include "cli/job_listener.h"
#include "cli/option_values.h"
#include "input/second_waves.h"
#include "input/solving_options.h"
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

/// The curves of U or V.
struct CurveFamily {
  std::string name;  ///< "u" or "v"
  StripePattern pattern;
  StripeCurves curves;
  std::array<std::size_t, kCurveEndKinds> ends{};  ///< of all curves
  std::size_t jogs = 0;                            ///< edges at which moved curves have a jog
  std::size_t short_curves = 0;                    ///< number left out
  std::optional<CurveSpacing> spacing;
  std::optional<double> covered_twice;
  CurveLengths lengths;  ///< of the remaining curves
  std::optional<double> coverage;
  FabricationMetrics fabrication;
  double extract_milliseconds = 0;
};

struct CurvesJob : DrawingTime {
  Preparation prepared;
  StripeOptions options;
  std::vector<CurveFamily> families;
  double edges_milliseconds = 0;
  nlohmann::ordered_json ranks = {};  ///< key of the report; null: one process
};

/// The extent of measurements on curves. The spacing takes longer than the curves.
enum class CurveMetrics {
  few,    ///< without the spacing
  brief,  ///< with the spacing if it is fast enough for interactive use
  all
};

/// The curves of an existing pattern; `tracer` is for the same surface.
CurveFamily traced_family(const CurvesArguments& arguments, const Surface& surface,
                          const StripeTracer& tracer, std::string name, StripePattern pattern,
                          CurveMetrics metrics, JobListener& listener);

/// The options of V: U's windings, except for the loop of --wales.
FabricationOptions fabrication_of_v(const CurvesArguments& arguments);

/// Its stages, in order, for `JobListener`.
std::vector<JobStage> curves_stages(const CurvesArguments& arguments);

CurvesJob make_curves_job(const CurvesArguments& arguments, JobListener& listener);

/// Total length of all lines, and the number of closed ones.
double total_length(const Polylines& lines);
std::size_t closed_count(const Polylines& lines);

/// Resamples and simplifies lines on a surface with this bounding-box diagonal.
void reshape(Polylines& lines, const LineShape& shape, float diagonal,
             const Progress& progress = {});

/// Tubes along all curves, for pictures and meshes.
std::vector<Ornament> tubes_of(const CurvesArguments& arguments, const Mesh& mesh,
                               std::span<const CurveFamily> families);

}  // namespace brindle::tool
