#include "jobs/curves_report.h"

#include <iterator>
#include <numeric>
#include <ostream>
#include <span>
#include <utility>

#include "brindle/base/parallel.h"
#include "brindle/base/stopwatch.h"
#include "brindle/base/text.h"
#include "brindle/recipe/report.h"

namespace brindle::tool {
namespace {

/// A list of metrics of one family.
class MetricList {
 public:
  explicit MetricList(std::string family) : family_(std::move(family)) {}

  /// A row of its own: "curves of u".
  template <class Value>
  void top(const char* key, const std::string& words, Value value) {
    all_.push_back({key, words + " of " + family_, value, 1, false});
  }
  /// An indented row, only if not zero: "  shortest (u)". The text shows the value times `scale`.
  template <class Value>
  void part(const char* key, const std::string& words, Value value, double scale = 1) {
    all_.push_back({key, "  " + words + " (" + family_ + ")", value, scale, true});
  }
  template <class Value>
  void unseen(const char* key, Value value) {
    all_.push_back({key, "", value, 1, false});
  }
  void append(std::vector<CurveMetric> more) {
    all_.insert(all_.end(), std::make_move_iterator(more.begin()),
                std::make_move_iterator(more.end()));
  }
  std::vector<CurveMetric> take() { return std::move(all_); }

 private:
  std::string family_;
  std::vector<CurveMetric> all_;
};

std::vector<CurveMetric> end_metrics(const CurveEnds& ends, const std::string& family) {
  const auto end = [&](CurveEnd kind) { return ends[static_cast<std::size_t>(kind)]; };
  MetricList metrics(family);
  metrics.top("ends.total", "ends", std::accumulate(ends.begin(), ends.end(), std::size_t{0}));
  metrics.part("ends.boundary", "at the boundary", end(CurveEnd::boundary));
  metrics.part("ends.no_wave", "where no wave is", end(CurveEnd::no_wave));
  metrics.part("ends.nonmanifold", "at triple edges", end(CurveEnd::nonmanifold));
  metrics.part("ends.crease", "at creases", end(CurveEnd::crease));
  metrics.part("ends.branch", "at branches", end(CurveEnd::branch));
  metrics.part("ends.singularity", "at singularities", end(CurveEnd::singularity));
  return metrics.take();
}

/// Changes of ends and points.
std::vector<CurveMetric> change_metrics(const StripeCurves& curves, const std::string& family) {
  MetricList metrics(family);
  metrics.part("joined_ends", "joined in pairs", curves.joined_ends);
  metrics.part("ends_at_neighbours", "run on into others", curves.ends_at_neighbors);
  metrics.part("trimmed_ends", "trimmed", curves.trimmed_ends);
  metrics.part("trimmed_away", "gone, trimmed", curves.trimmed_away);
  metrics.part("smooth_forks", "with no angle", curves.smooth_forks);
  metrics.part("largest_move", "moved, times f", curves.largest_move);
  return metrics.take();
}

std::vector<CurveMetric> length_metrics(const CurveLengths& lengths, const std::string& family) {
  MetricList metrics(family);
  metrics.part("lengths.closed", "of closed ones", lengths.closed_length);
  metrics.part("lengths.open", "of open ones", lengths.open_length);
  metrics.part("lengths.shortest", "shortest", lengths.shortest);
  metrics.part("lengths.mean", "average", lengths.mean);
  metrics.part("lengths.longest", "longest", lengths.longest);
  return metrics.take();
}

// With a spacing tolerance, also relative to the requested frequencies.
void add_spacing_metrics(const CurveSpacing& spacing, bool yields, MetricList& metrics) {
  metrics.unseen("spacing.measured", spacing.measured);
  metrics.top("spacing.mean", "spacing", spacing.mean);
  metrics.part("spacing.deviation", "deviation", spacing.deviation);
  metrics.part("spacing.share_within_10_percent", "% within 10 %", spacing.share_within_10_percent,
               100);
  if (!yields) return;
  metrics.part("spacing.mean_wanted", "as asked for", spacing.mean_wanted);
  metrics.part("spacing.deviation_wanted", "its deviation", spacing.deviation_wanted);
  metrics.part("spacing.share_within_10_percent_wanted", "its % within 10 %",
               spacing.share_within_10_percent_wanted, 100);
}

// With a spacing tolerance, also relative to the chosen frequencies.
void add_gap_metrics(const CurveGaps& gaps, bool yields, MetricList& metrics) {
  metrics.unseen("gaps.measured", gaps.measured);
  metrics.top("gaps.mean", "gaps", gaps.mean);
  metrics.part("gaps.least", "least gap", gaps.least);
  metrics.part("gaps.most", "widest gap", gaps.most);
  metrics.part("gaps.least_ratio", "least, times f", gaps.least_ratio);
  metrics.part("gaps.mean_ratio", "mean, times f", gaps.mean_ratio);
  metrics.part("gaps.most_ratio", "widest, times f", gaps.most_ratio);
  if (!yields) return;
  metrics.part("gaps.least_ratio_chosen", "least, f chosen", gaps.least_ratio_chosen);
  metrics.part("gaps.mean_ratio_chosen", "mean, f chosen", gaps.mean_ratio_chosen);
  metrics.part("gaps.most_ratio_chosen", "widest, f chosen", gaps.most_ratio_chosen);
}

std::vector<CurveMetric> spacing_metrics(const CurveSpacing& spacing, bool yields,
                                         const std::string& family) {
  MetricList metrics(family);
  add_spacing_metrics(spacing, yields, metrics);
  add_gap_metrics(spacing.gaps, yields, metrics);
  return metrics.take();
}

/// Inserts metrics at their keys.
void add_to_json(std::span<const CurveMetric> metrics, nlohmann::ordered_json& json) {
  for (const CurveMetric& metric : metrics) {
    const std::size_t dot = metric.key.find('.');
    (dot == std::string::npos ? json[metric.key]
                              : json[metric.key.substr(0, dot)][metric.key.substr(dot + 1)]) =
        metric.value;
  }
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

std::vector<CurveMetric> metrics_of(const CurveFamily& family) {
  const Polylines& lines = family.curves.lines;
  const StripePattern& pattern = family.pattern;
  MetricList metrics(family.name);
  metrics.unseen("energy", pattern.solution.energy);
  metrics.unseen("branches", pattern.quality.branches);
  metrics.unseen("field_singularities", pattern.quality.field_singularities);
  metrics.top("curves", "curves", lines.count());
  metrics.top("closed", "closed ones", closed_count(lines));
  metrics.unseen("open", lines.count() - closed_count(lines));
  metrics.part("short_curves_left_out", "shorter, left out", family.short_curves);
  metrics.unseen("points", lines.points.size());
  metrics.top("length", "length", total_length(lines));
  metrics.append(length_metrics(family.lengths, family.name));
  metrics.append(end_metrics(family.ends, family.name));
  metrics.append(change_metrics(family.curves, family.name));
  metrics.part("edges_with_jogs", "edges with jogs", family.jogs);
  if (family.coverage) metrics.part("coverage", "% covered", *family.coverage, 100);
  if (family.covered_twice) metrics.part("covered_twice", "% twice", *family.covered_twice, 100);
  if (family.spacing) {
    metrics.append(
        spacing_metrics(*family.spacing, !pattern.frequencies_wanted.empty(), family.name));
  }
  return metrics.take();
}

nlohmann::ordered_json to_json(const CurveLengths& lengths) {
  nlohmann::ordered_json json;
  add_to_json(length_metrics(lengths, ""), json);
  return json["lengths"];
}

void add_spacing(const CurveSpacing& spacing, bool yields, nlohmann::ordered_json& json) {
  add_to_json(spacing_metrics(spacing, yields, ""), json);
}

nlohmann::ordered_json ends_to_json(const CurveEnds& ends) {
  nlohmann::ordered_json json;
  add_to_json(end_metrics(ends, ""), json);
  return json["ends"];
}

std::string line_of_ends(const CurveEnds& ends) {
  const auto end = [&](CurveEnd kind) { return ends[static_cast<std::size_t>(kind)]; };
  return formatted(
      "ends: %zu at the boundary, %zu at branches, %zu at singularities, %zu beside vertices "
      "without wave, %zu at edges of three triangles or more, %zu at creases\n",
      end(CurveEnd::boundary), end(CurveEnd::branch), end(CurveEnd::singularity),
      end(CurveEnd::no_wave), end(CurveEnd::nonmanifold), end(CurveEnd::crease));
}

void add_ends(const StripeCurves& curves, nlohmann::ordered_json& json) {
  add_to_json(change_metrics(curves, ""), json);
}

nlohmann::ordered_json to_json(const CurveFamily& family) {
  nlohmann::ordered_json json;
  add_to_json(metrics_of(family), json);
  add_to_json(family.fabrication, json);
  const auto frequency = frequency_report(family.pattern.frequency_change, family.pattern.quality);
  if (frequency) json["frequency_change"] = to_json(*frequency);
  return json;
}

nlohmann::ordered_json to_json(const ReportedCurves& curves, const PictureOptions& picture) {
  const Surface& surface = curves.surface;
  const PreparationMetrics& prepared = curves.prepared;
  StripeMilliseconds time;
  time.load = prepared.load_milliseconds;
  time.topology = prepared.topology_milliseconds + curves.edges_milliseconds;
  double extract = 0;
  nlohmann::ordered_json json = {{"vertices", surface.own_vertex_count()},
                                 {"triangles", surface.mesh.triangle_count()},
                                 {"edges", surface.own_edge_count()},
                                 {"vertices_joined", prepared.vertices_joined},
                                 {"threads", ThreadLimit::current()}};
  json.update(to_json(prepared.metrics, prepared.field_rows_nonfinite));
  for (const CurveFamily& family : curves.families) {
    json[family.name] = to_json(family);
    const StripeMilliseconds& own = family.pattern.milliseconds;
    time.topology += own.topology;
    time.frequency += own.frequency;
    time.couple += own.couple;
    time.solve += own.solve;
    time.pattern += own.pattern;
    time.cancel += own.cancel;
    extract += family.extract_milliseconds;
  }
  json["milliseconds"] = {{"load", time.load},         {"field", prepared.field_milliseconds},
                          {"topology", time.topology}, {"couple", time.couple},
                          {"solve", time.solve},       {"pattern", time.pattern},
                          {"extract", extract}};
  if (curves.draw_milliseconds) {
    json["milliseconds"]["draw"] = *curves.draw_milliseconds;
    json.update(picture_json(picture));
  }
  if (curves.yields) json["milliseconds"]["frequency"] = time.frequency;
  if (time.cancel > 0) json["milliseconds"]["cancel"] = time.cancel;
  return json;
}

nlohmann::ordered_json to_json(const CurvesJob& job, const PictureOptions& picture) {
  nlohmann::ordered_json json = to_json(
      ReportedCurves{job.prepared.surface, job.prepared, job.families, job.options.slack.relaxes(),
                     job.edges_milliseconds, job.draw_milliseconds},
      picture);
  if (!job.ranks.is_null()) json["ranks"] = job.ranks;
  return json;
}

void print(std::ostream& out, const CurvesJob& job) {
  print_waves(out, job.prepared.metrics);
  for (const CurveFamily& family : job.families) {
    const Polylines& lines = family.curves.lines;
    out << formatted("%s  %zu curves, %zu of them closed, of %zu points, length %g\n",
                     family.name.c_str(), lines.count(), closed_count(lines), lines.points.size(),
                     total_length(lines))
        << "   " << line_of_ends(family.ends);
    out << lines_of({family.curves, family.short_curves, family.jogs}, "   ");
    print_measures(out, family);
    out << lines_of(family.fabrication);
    if (family.spacing) print_spacing(out, family);
    out << formatted("   extracted in %.1f ms\n", family.extract_milliseconds);
  }
}

}  // namespace brindle::tool
