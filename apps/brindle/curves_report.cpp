#include "curves_report.h"

#include <numeric>
#include <ostream>

#include "brindle/base/parallel.h"
#include "brindle/base/stopwatch.h"
#include "formatted.h"
#include "frequency_report.h"
#include "report.h"

namespace brindle::tool {
namespace {

nlohmann::ordered_json to_json(const CurveSpacing& spacing) {
  return {{"measured", spacing.measured},
          {"mean", spacing.mean},
          {"deviation", spacing.deviation},
          {"share_within_10_percent", spacing.share_within_10_percent}};
}

nlohmann::ordered_json to_json(const CurveGaps& gaps) {
  return {{"measured", gaps.measured},
          {"least", gaps.least},
          {"mean", gaps.mean},
          {"most", gaps.most},
          {"least_ratio", gaps.least_ratio},
          {"mean_ratio", gaps.mean_ratio},
          {"most_ratio", gaps.most_ratio}};
}

nlohmann::ordered_json to_json(const CurveLengths& lengths) {
  return {{"closed", lengths.closed_length},
          {"open", lengths.open_length},
          {"shortest", lengths.shortest},
          {"mean", lengths.mean},
          {"longest", lengths.longest}};
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
    out << formatted("   lines of that width cover %.1f %% of the surface\n",
                     100 * *family.coverage);
  }
}

}  // namespace

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
      {"joined_ends", family.curves.joined_ends},
      {"ends_at_neighbours", family.curves.ends_at_neighbors},
      {"edges_with_jogs", family.jogs}};
  json["lengths"] = to_json(family.lengths);
  if (family.spacing) json["spacing"] = to_json(*family.spacing);
  if (family.spacing) json["gaps"] = to_json(family.spacing->gaps);
  if (family.coverage) json["coverage"] = *family.coverage;
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
    if (family.curves.joined_ends + family.curves.ends_at_neighbors > 0) {
      out << formatted("   %zu more ends joined in pairs, %zu run on into neighbours\n",
                       family.curves.joined_ends, family.curves.ends_at_neighbors);
    }
    if (family.short_curves > 0) {
      out << formatted("   %zu shorter curves left out\n", family.short_curves);
    }
    if (family.jogs > 0) {
      out << formatted("   the field has no orientation: curves jog at %zu edges\n", family.jogs);
    }
    print_measures(out, family);
    out << lines_of(family.making);
    if (family.spacing) {
      out << formatted(
          "   spacing: %.3f / f on average, deviation %.3f, within 10 %% for %.1f %% of the "
          "length\n",
          family.spacing->mean, family.spacing->deviation,
          100 * family.spacing->share_within_10_percent);
    }
    out << formatted("   extracted in %.1f ms\n", family.extract_milliseconds);
  }
}

}  // namespace brindle::tool
