/// What `brindle curves` does, stage by stage, for whoever has its arguments.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brindle/curve_measures.h"
#include "brindle/curves.h"
#include "brindle/stripe_tracer.h"
#include "cli/job_listener.h"
#include "jobs/curves_arguments.h"

namespace brindle::tool {

/// One of U and V with its curves.
struct CurveFamily {
  std::string name;  ///< "u" or "v"
  StripePattern pattern;
  StripeCurves curves;
  std::array<std::size_t, kCurveEndKinds> ends{};  ///< of all curves
  std::size_t jogs = 0;          ///< edges that moved curves do not cross straight
  std::size_t short_curves = 0;  ///< left out
  std::optional<CurveSpacing> spacing;
  std::optional<double> covered_twice;
  CurveLengths lengths;  ///< of the curves that are left
  std::optional<double> coverage;
  MakingFigures making;
  double extract_milliseconds = 0;
};

struct CurvesJob {
  Preparation prepared;
  StripeOptions options;
  std::vector<CurveFamily> families;
  double edges_milliseconds = 0;
  std::optional<double> draw_milliseconds;
};

/// How much is measured of curves. The spacing takes longer than the curves.
enum class CurveFigures {
  few,    ///< not the spacing
  brief,  ///< the spacing, too, unless that takes longer than one waits for a picture
  all
};

/// The curves of a pattern that is there; `tracer` is of the same surface.
CurveFamily traced_family(const CurvesArguments& arguments, const Surface& surface,
                          const StripeTracer& tracer, std::string name, StripePattern pattern,
                          CurveFigures figures, JobListener& listener);

/// What is asked of V: windings are those of U, but for what --wales counts.
MakingOptions making_of_v(const CurvesArguments& arguments);

/// Its stages, in their order, as `JobListener::stage` hears of them.
std::vector<JobStage> curves_stages(const CurvesArguments& arguments);

CurvesJob make_curves_job(const CurvesArguments& arguments, JobListener& listener);

/// How long all lines are together, and how many of them are closed.
double total_length(const Polylines& lines);
std::size_t closed_count(const Polylines& lines);

/// Resamples and simplifies lines on a surface whose bounding box has this diagonal.
void reshape(Polylines& lines, const LineShape& shape, float diagonal,
             const Progress& progress = {});

/// Tubes along all curves, as pictures and meshes show them.
std::vector<Ornament> tubes_of(const CurvesArguments& arguments, const Mesh& mesh,
                               std::span<const CurveFamily> families);

}  // namespace brindle::tool
