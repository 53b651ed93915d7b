#include "session/shown_pattern.h"

#include <span>
#include <utility>

#include "pictures/picture.h"

namespace brindle::tool {

ShownCurves shown_curves(const CurvesArguments& arguments, const StripeJob& job,
                         const MadeStripes* v, const StripeTracer& tracer, CurveMetrics metrics,
                         JobListener& listener) {
  ShownCurves shown;
  const Surface& surface = *job.surface;
  const auto add = [&](const char* name, const StripePattern& pattern,
                       const FabricationMetrics& fabrication) {
    CurveFamily& family = shown.families.emplace_back(
        traced_family(arguments, surface, tracer, name, pattern, metrics, listener));
    family.fabrication = fabrication;
    const bool winds = metrics != CurveMetrics::few && fabrication.loops.empty();
    if (winds) measure_windings(surface, pattern, family.fabrication);
  };
  if (arguments.traced != TracedWaves::v) add("u", job.result.stripes(), job.fabrication);
  if (arguments.traced != TracedWaves::u) add("v", v->pattern, v->fabrication);
  shown.drawn.ornaments = ornamented(surface, tubes_of(arguments, surface.mesh, shown.families),
                                     render_options(arguments.picture, surface.mesh.origin));
  return shown;
}

namespace {

ShownOrnaments drawn_samples(const CLI::App& command, const SampleArguments& arguments,
                             const std::shared_ptr<const Preparation>& prepared,
                             std::span<const Sample> samples, JobListener& listener) {
  ShownOrnaments drawn;
  const Surface& surface = prepared->surface;
  if (!is_styled(command)) {
    const Ornament discs = discs_of(samples, surface.mesh.origin);
    drawn.ornaments = ornamented(surface, std::span(&discs, 1),
                                 render_options(arguments.picture, surface.mesh.origin));
    return drawn;
  }
  GlyphInput input = read_glyph_input(arguments.glyphs, *prepared, arguments.surface,
                                      arguments.waves, arguments.picture);
  input.picture = read_glyph_picture(arguments.glyphs);
  drawn.surface = {prepared, &surface};
  drawn.glyphs = std::make_unique<const GlyphPicture>(surface, samples, arguments.glyphs, input,
                                                      arguments.picture, listener.progress());
  return drawn;
}

}  // namespace

ShownSamples shown_samples(const CLI::App& command, const SampleArguments& arguments,
                           const std::shared_ptr<const Preparation>& prepared, const StripeJob& job,
                           const StripePattern& v, JobListener& listener) {
  ShownSamples shown;
  shown.taken = taken_samples(arguments, prepared->surface, job.result.stripes(), v, listener);
  shown.drawn = drawn_samples(command, arguments, prepared, shown.taken.samples, listener);
  return shown;
}

}  // namespace brindle::tool
