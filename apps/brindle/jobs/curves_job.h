/// The stages of `brindle curves`, shared with the window.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "brindle/curve_measures.h"
#include "brindle/curves.h"
#include "brindle/stripe_tracer.h"
#include "cli/job_listener.h"
#include "jobs/curves_arguments.h"
#include "outputs/make_and_write.h"

namespace brindle::tool {

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
