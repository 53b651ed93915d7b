/// Curves and samples, shown instead of stripes.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "jobs/curves_job.h"
#include "jobs/sample_job.h"
#include "jobs/stripe_job.h"
#include "pictures/glyphs.h"
#include "pictures/ornaments.h"

namespace brindle::tool {

/// Ornaments on the surface, or glyphs.
struct ShownOrnaments {
  OrnamentedSurface ornaments;                 ///< if there are no glyphs
  std::unique_ptr<const GlyphPicture> glyphs;  ///< null: ornaments
  std::shared_ptr<const Surface> surface;      ///< for glyphs
};

struct ShownCurves {
  std::vector<CurveFamily> families;
  ShownOrnaments drawn;
};

struct ShownSamples {
  TakenSamples taken;
  ShownOrnaments drawn;
};

/// Stripes with their fabrication metrics.
struct MadeStripes {
  StripePattern pattern;
  FabricationMetrics fabrication = {};
};

/// Curves of the job's stripes and of `v`, null if not requested. With all metrics, curves are
/// measured as by `brindle curves`; with few, without windings.
ShownCurves shown_curves(const CurvesArguments& arguments, const StripeJob& job,
                         const MadeStripes* v, const StripeTracer& tracer, CurveMetrics metrics,
                         JobListener& listener);

/// Samples where the job's stripes and those of `v` cross. `command` tells whether glyphs are
/// requested; their values are those of `prepared`.
ShownSamples shown_samples(const CLI::App& command, const SampleArguments& arguments,
                           const std::shared_ptr<const Preparation>& prepared, const StripeJob& job,
                           const StripePattern& v, JobListener& listener);

}  // namespace brindle::tool
