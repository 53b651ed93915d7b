/// What is shown of a pattern instead of its stripes.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "jobs/curves_job.h"
#include "jobs/sample_job.h"
#include "pictures/glyph_picture.h"
#include "pictures/ornaments.h"

namespace brindle::tool {

/// What is drawn: ornaments on the surface, or glyphs.
struct ShownOrnaments {
  OrnamentedSurface ornaments;                 ///< if there are no glyphs
  std::unique_ptr<const GlyphPicture> glyphs;  ///< null: ornaments
  std::shared_ptr<const Surface> surface;      ///< that glyphs refer to
};

struct ShownCurves {
  std::vector<CurveFamily> families;
  ShownOrnaments drawn;
};

struct ShownSamples {
  TakenSamples taken;
  ShownOrnaments drawn;
};

/// Stripes, and what became of the maker's wishes for them.
struct MadeStripes {
  StripePattern pattern;
  MakingFigures making = {};
};

/// Two patterns that cross. V is null where it is not asked for.
struct CrossingPatterns {
  const StripePattern& u;
  const StripePattern* v;
};

/// The same of curves.
struct CurvePatterns {
  const StripePattern& u;
  const MakingFigures& making_of_u;
  const MadeStripes* v;
};

/// With all figures, curves are measured as `brindle curves` does; with few, windings are not.
ShownCurves shown_curves(const CurvesArguments& arguments,
                         const std::shared_ptr<const Surface>& surface, const StripeTracer& tracer,
                         const CurvePatterns& patterns, CurveFigures figures,
                         JobListener& listener);

/// `command` says whether glyphs are asked for; their values are those of `prepared`.
ShownSamples shown_samples(const CLI::App& command, const SampleArguments& arguments,
                           const std::shared_ptr<const Preparation>& prepared,
                           const CrossingPatterns& patterns, JobListener& listener);

}  // namespace brindle::tool
