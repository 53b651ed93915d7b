#include "jobs/curves_report.h"

#include <numeric>
#include <ostream>

#include "brindle/base/formatted.h"
#include "brindle/base/parallel.h"
#include "brindle/base/stopwatch.h"
#include "brindle/recipe/frequency_report.h"
#include "brindle/recipe/making_report.h"
#include "brindle/recipe/report.h"

namespace brindle::tool {
namespace {

// With slack, also against the frequencies that were asked for.
nlohmann::ordered_json to_json(const CurveSpacing& spacing, bool yields) {
  nlohmann::ordered_json json = {{"measured", spacing.measured},
                                 {"mean", spacing.mean},
                                 {"deviation", spacing.deviation},
                                 {"share_within_10_percent", spacing.share_within_10_percent}};
  if (yields) {
    json["mean_wanted"] = spacing.mean_wanted;
    json["deviation_wanted"] = spacing.deviation_wanted;
    json["share_within_10_percent_wanted"] = spacing.share_within_10_percent_wanted;
  }
  return json;
}

// With slack, also against the frequencies that were chosen.
nlohmann::ordered_json to_json(const CurveGaps& gaps, bool yields) {
  nlohmann::ordered_json json = {{"measured", gaps.measured},
                                 {"least", gaps.least},
                                 {"mean", gaps.mean},
                                 {"most", gaps.most},
                                 {"least_ratio", gaps.least_ratio},
                                 {"mean_ratio", gaps.mean_ratio},
                                 {"most_ratio", gaps.most_ratio}};
  if (yields) {
    json["least_ratio_chosen"] = gaps.least_ratio_chosen;
    json["mean_ratio_chosen"] = gaps.mean_ratio_chosen;
    json["most_ratio_chosen"] = gaps.most_ratio_chosen;
  }
  return json;
}

void print_measures(std::ostream& out, const CurveFamily& family) {
  const CurveLengths& lengths = family.lengths;
  if (lengths.closed + lengths.open > 0) {
    out << formatted("   lengths: closed %g, open %g; a curve %g to %g, on average %g\n",
                     lengths.closed_length, lengths.open_length, lengths.shortest, lengths.longest,
                     lengths.mean);
  }
  if (family.spacing) {
    const CurveGaps& gaps = family.spacing->gaps;
    out << formatted("   gaps: %g to %g, on average %g: %.2f / f to %.2f / f, %.3f / f\n",
                     gaps.least, gaps.most, gaps.mean, gaps.least_ratio, gaps.most_ratio,
                     gaps.mean_ratio);
  }
  if (family.coverage) {
    out << formatted("   lines of that width cover %.1f %% of the surface, %.1f %% twice\n",
                     100 * *family.coverage, 100 * *family.covered_twice);
  }
}

void print_spacing(std::ostream& out, const CurveFamily& family) {
  const CurveSpacing& spacing = *family.spacing;
  const auto line = [&](const char* of, double mean, double deviation, double share) {
    out << formatted(
        "   spacing: %.3f / f on average, deviation %.3f, within 10 %% for %.1f %% of the "
        "length%s\n",
        mean, deviation, 100 * share, of);
  };
  if (family.pattern.frequencies_wanted.empty()) {
    return line("", spacing.mean, spacing.deviation, spacing.share_within_10_percent);
  }
  line(", of the frequencies chosen", spacing.mean, spacing.deviation,
       spacing.share_within_10_percent);
  line(", of those asked for", spacing.mean_wanted, spacing.deviation_wanted,
       spacing.share_within_10_percent_wanted);
}

}  // namespace

std::string lines_of(const CurveRemarks& remarks, const std::string& indent) {
  std::string lines;
  const StripeCurves& curves = remarks.curves;
  if (curves.joined_ends + curves.ends_at_neighbors > 0) {
    lines += indent + formatted("%zu more ends joined in pairs, %zu run on into neighbours\n",
                                curves.joined_ends, curves.ends_at_neighbors);
  }
  if (curves.trimmed_ends > 0) {
    lines += indent + formatted("%zu ends trimmed; of %zu curves nothing is left\n",
                                curves.trimmed_ends, curves.trimmed_away);
  }
  if (curves.largest_move > 0) {
    lines += indent + formatted("faired: points moved by up to %.3f / f", curves.largest_move);
    if (curves.ends_at_neighbors > 0) {
      lines += formatted(", %zu ends meet their neighbours with no angle", curves.smooth_forks);
    }
    lines += '\n';
  }
  if (remarks.short_curves > 0) {
    lines += indent + formatted("%zu shorter curves left out\n", remarks.short_curves);
  }
  if (remarks.jogs > 0) {
    lines +=
        indent + formatted("the field has no orientation: curves jog at %zu edges\n", remarks.jogs);
  }
  return lines;
}

nlohmann::ordered_json to_json(const CurveLengths& lengths) {
  return {{"closed", lengths.closed_length},
          {"open", lengths.open_length},
          {"shortest", lengths.shortest},
          {"mean", lengths.mean},
          {"longest", lengths.longest}};
}

void add_spacing(const CurveSpacing& spacing, bool yields, nlohmann::ordered_json& json) {
  json["spacing"] = to_json(spacing, yields);
  json["gaps"] = to_json(spacing.gaps, yields);
}

nlohmann::ordered_json ends_to_json(const CurveEnds& ends) {
  const auto end = [&](CurveEnd kind) { return ends[static_cast<std::size_t>(kind)]; };
  return {{"total", std::accumulate(ends.begin(), ends.end(), std::size_t{0})},
          {"boundary", end(CurveEnd::boundary)},
          {"no_wave", end(CurveEnd::no_wave)},
          {"nonmanifold", end(CurveEnd::nonmanifold)},
          {"branch", end(CurveEnd::branch)},
          {"singularity", end(CurveEnd::singularity)}};
}

std::string line_of_ends(const CurveEnds& ends) {
  const auto end = [&](CurveEnd kind) { return ends[static_cast<std::size_t>(kind)]; };
  return formatted(
      "ends: %zu at the boundary, %zu at branches, %zu at singularities, %zu beside vertices "
      "without wave, %zu at edges of three triangles or more\n",
      end(CurveEnd::boundary), end(CurveEnd::branch), end(CurveEnd::singularity),
      end(CurveEnd::no_wave), end(CurveEnd::nonmanifold));
}

void add_ends(const StripeCurves& curves, nlohmann::ordered_json& json) {
  json["joined_ends"] = curves.joined_ends;
  json["ends_at_neighbours"] = curves.ends_at_neighbors;
  json["trimmed_ends"] = curves.trimmed_ends;
  json["trimmed_away"] = curves.trimmed_away;
  json["smooth_forks"] = curves.smooth_forks;
  json["largest_move"] = curves.largest_move;
}

nlohmann::ordered_json to_json(const CurveFamily& family) {
  const Polylines& lines = family.curves.lines;
  nlohmann::ordered_json json = {
      {"energy", family.pattern.solution.energy},
      {"branches", family.pattern.quality.branches},
      {"field_singularities", family.pattern.quality.field_singularities},
      {"curves", lines.count()},
      {"closed", closed_count(lines)},
      {"open", lines.count() - closed_count(lines)},
      {"short_curves_left_out", family.short_curves},
      {"points", lines.points.size()},
      {"length", total_length(lines)},
      {"ends", ends_to_json(family.ends)},
      {"edges_with_jogs", family.jogs}};
  add_ends(family.curves, json);
  json["lengths"] = to_json(family.lengths);
  const bool yields = !family.pattern.frequencies_wanted.empty();
  if (family.spacing) add_spacing(*family.spacing, yields, json);
  if (family.coverage) json["coverage"] = *family.coverage;
  if (family.covered_twice) json["covered_twice"] = *family.covered_twice;
  add_to_json(family.making, json);
  const auto frequency = frequency_report(family.pattern.frequency_change, family.pattern.quality);
  if (frequency) json["frequency_change"] = to_json(*frequency);
  return json;
}

nlohmann::ordered_json to_json(const CurvesJob& job, const PictureOptions& picture) {
  const Surface& surface = job.prepared.surface;
  StripeMilliseconds time;
  time.load = job.prepared.load_milliseconds;
  time.topology = job.prepared.topology_milliseconds + job.edges_milliseconds;
  double extract = 0;
  nlohmann::ordered_json json = {{"vertices", surface.mesh.vertex_count()},
                                 {"triangles", surface.mesh.triangle_count()},
                                 {"edges", surface.neighborhood->edge_count()},
                                 {"vertices_joined", job.prepared.vertices_joined},
                                 {"threads", ThreadLimit::current()}};
  json.update(to_json(job.prepared.figures, job.prepared.field_rows_nonfinite));
  for (const CurveFamily& family : job.families) {
    json[family.name] = to_json(family);
    const StripeMilliseconds& own = family.pattern.milliseconds;
    time.topology += own.topology;
    time.frequency += own.frequency;
    time.couple += own.couple;
    time.solve += own.solve;
    time.pattern += own.pattern;
    extract += family.extract_milliseconds;
  }
  json["milliseconds"] = {{"load", time.load},         {"field", job.prepared.field_milliseconds},
                          {"topology", time.topology}, {"couple", time.couple},
                          {"solve", time.solve},       {"pattern", time.pattern},
                          {"extract", extract}};
  if (job.draw_milliseconds) {
    json["milliseconds"]["draw"] = *job.draw_milliseconds;
    json["picture_quality"] = quality_name(picture);
  }
  if (job.options.slack.yields()) json["milliseconds"]["frequency"] = time.frequency;
  return json;
}

void print(std::ostream& out, const CurvesJob& job) {
  print_waves(out, job.prepared.figures);
  for (const CurveFamily& family : job.families) {
    const Polylines& lines = family.curves.lines;
    out << formatted("%s  %zu curves, %zu of them closed, of %zu points, length %g\n",
                     family.name.c_str(), lines.count(), closed_count(lines), lines.points.size(),
                     total_length(lines))
        << "   " << line_of_ends(family.ends);
    out << lines_of({family.curves, family.short_curves, family.jogs}, "   ");
    print_measures(out, family);
    out << lines_of(family.making);
    if (family.spacing) print_spacing(out, family);
    out << formatted("   extracted in %.1f ms\n", family.extract_milliseconds);
  }
}

}  // namespace brindle::tool
