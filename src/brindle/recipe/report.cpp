#include "brindle/recipe/report.h"

#include <algorithm>
#include <cstdlib>
#include <ostream>
#include <string>

#include "brindle/base/text.h"
#include "brindle/threads.h"

namespace brindle {
namespace {

nlohmann::ordered_json to_json(const TextureReport& texture) {
  return {{"energy_v", texture.energy_v},
          {"branches_u", texture.branches_u},
          {"branches_v", texture.branches_v},
          {"turned_edges", texture.seams.turned},
          {"mirrored_edges", texture.seams.mirrored},
          {"unoriented_triangles", texture.seams.unoriented_triangles}};
}

nlohmann::ordered_json to_json(const TextureQuality& quality) {
  return {{"angle_distortion_mean_deg", quality.angle_mean_deg},
          {"angle_distortion_95th_deg", quality.angle_95th_deg},
          {"area_distortion_mean", quality.area_mean},
          {"area_distortion_95th", quality.area_95th}};
}

nlohmann::ordered_json to_json(const MissingWaves& missing) {
  auto json = nlohmann::ordered_json::object();
  if (missing.tensor) {
    json["tensor_vertices_near_normal"] = missing.tensor->near_normal;
    json["tensor_vertices_isotropic"] = missing.tensor->isotropic;
  }
  if (missing.without_frequency) json["vertices_without_frequency"] = *missing.without_frequency;
  if (missing.too_far) json["vertices_too_far"] = *missing.too_far;
  return json;
}

void print_smoothing(std::ostream& out, const FieldSmoothingMetrics& smoothing) {
  out << formatted(
      "field     turned by %.2f degrees (median %.2f, 95 %% below %.1f, above 20 in %.1f %%), "
      "%zu singularities of %zu\n",
      smoothing.turned_mean_deg, smoothing.turned_median_deg, smoothing.turned_p95_deg,
      100 * smoothing.turned_share_over_20deg, smoothing.singularities,
      smoothing.singularities_of_data);
  if (smoothing.filled + smoothing.unfilled > 0) {
    out << formatted("holes     %zu vertices filled, %zu too far from all data\n", smoothing.filled,
                     smoothing.unfilled);
  }
  out << formatted("coherence %.2f of data, %.2f of filled holes\n", smoothing.coherence_mean,
                   smoothing.coherence_filled_mean);
  if (smoothing.held_out > 0) {
    out << formatted("held out  %zu data, %.2f degrees from the field without them\n",
                     smoothing.held_out, smoothing.held_out_turned_mean_deg);
  }
}

nlohmann::ordered_json to_json(const FollowedReport& followed) {
  nlohmann::ordered_json json = {
      {"previous", followed.previous},
      {"lambda", std::stod(formatted("%g", followed.lambda))},  // 0.02, not 0.01999999955
      {"matched_by", followed.matched_by},
      {"vertices_unmatched", followed.vertices_unmatched},
      {"phase_step", followed.phase_step}};
  if (followed.field_turned_deg) json["field_turned_deg"] = *followed.field_turned_deg;
  return json;
}

void print_followed(std::ostream& out, const FollowedReport& followed) {
  out << formatted("follows   %s, matched by %s, %zu vertices unmatched, phase step %.4f",
                   followed.previous.c_str(), followed.matched_by.data(),
                   followed.vertices_unmatched, followed.phase_step);
  if (followed.field_turned_deg) {
    out << formatted(", field turned by %.2f degrees", *followed.field_turned_deg);
  }
  out << '\n';
}

/// Triangles in which tiles are cut, by either wave.
std::size_t branches_of_both(const TexturePattern& texture) {
  std::size_t count = 0;
  for (std::size_t t = 0; t < texture.u.corners.size(); ++t) {
    count += is_branch(texture.u.corners[t].kind) || is_branch(texture.v.corners[t].kind) ? 1 : 0;
  }
  return count;
}

void print_texture(std::ostream& out, const TextureReport& texture) {
  out << formatted(
      "texture   %zu branches along the field, %zu across it; turned round at %zu edges, "
      "mirrored at %zu, %zu triangles without orientation\n",
      texture.branches_u, texture.branches_v, texture.seams.turned, texture.seams.mirrored,
      texture.seams.unoriented_triangles);
}

void print_tiles(std::ostream& out, const TextureQuality& quality) {
  out << formatted(
      "tiles     angle off by %.2f degrees on average, 95 %% below %.2f; "
      "area by %.1f %%, 95 %% below %.1f %%\n",
      quality.angle_mean_deg, quality.angle_95th_deg, 100 * quality.area_mean,
      100 * quality.area_95th);
}

// Rounds to the digits written, without the last bits of a float: 0.02, not 0.01999999955.
double rounded(double value) { return std::stod(formatted("%.6g", value)); }

void print_branches(std::ostream& out, const Report& report) {
  const PatternQuality& quality = report.quality;
  if (report.triangles == 0) return;
  out << (report.cross
              ? formatted("branches  %zu of both waves; the cross field has %zu singularities\n",
                          quality.branches, quality.field_singularities)
              : formatted("branches  %zu, of these %zu where the field has a singularity\n",
                          quality.branches, quality.field_singularities));
}

}  // namespace

std::optional<FrequencyReport> frequency_report(const std::optional<FrequencyChange>& change,
                                                const PatternQuality& quality) {
  if (!change) return std::nullopt;
  return FrequencyReport{*change, quality.spacing_error_wanted_mean,
                         quality.branches_in_avoided_area};
}

nlohmann::ordered_json to_json(const FrequencyReport& report) {
  const FrequencyChange& change = report.change;
  nlohmann::ordered_json json = {{"ratio_min", change.ratio_min},
                                 {"ratio_mean", change.ratio_mean},
                                 {"ratio_max", change.ratio_max},
                                 {"share_at_bounds", change.share_at_bounds},
                                 {"spacing_error_wanted_mean", report.spacing_error_wanted_mean},
                                 {"sweeps", change.sweeps},
                                 {"residual", change.residual}};
  if (report.branches_in_avoided_area)
    json["branches_in_avoided_area"] = *report.branches_in_avoided_area;
  return json;
}

void print_frequency(std::ostream& out, const FrequencyReport& report) {
  const FrequencyChange& change = report.change;
  out << formatted(
      "slack     frequencies times %.3f to %.3f, %.3f on average, %.1f %% at the bounds; spacing "
      "%.1f %% from that asked for\n",
      change.ratio_min, change.ratio_max, change.ratio_mean, 100 * change.share_at_bounds,
      100 * report.spacing_error_wanted_mean);
  if (report.branches_in_avoided_area)
    out << formatted("branch_penalty      %zu branches\n", *report.branches_in_avoided_area);
}

Report make_report(const Surface& surface, const PreparationMetrics& prepared,
                   const StripePattern& pattern, Solver solver) {
  Report report;
  report.vertices = surface.own_vertex_count();
  report.triangles = surface.mesh.triangle_count();
  report.edges = surface.own_edge_count();
  report.crease_vertices = surface.creases.copied.size();
  // The stripes of a cross field lie on a mesh with split triangles.
  if (pattern.solution.z.size() == surface.mesh.vertex_count()) {
    report.slip = crease_slip(surface, pattern.waves, pattern.solution.z);
  }
  report.vertices_joined = prepared.vertices_joined;
  report.solver = solver;
  report.threads = ThreadLimit::current();
  report.iterations = pattern.solution.iterations;
  report.energy = pattern.solution.energy;
  report.quality = pattern.quality;
  report.milliseconds = pattern.milliseconds;
  report.milliseconds.load += prepared.load_milliseconds;
  report.field_milliseconds = prepared.field_milliseconds;
  report.milliseconds.topology += prepared.topology_milliseconds;
  report.waves = prepared.metrics;
  report.frequency = frequency_report(pattern.frequency_change, pattern.quality);
  report.field_rows_nonfinite = prepared.field_rows_nonfinite;
  return report;
}

Report make_report(const Surface& surface, const PreparationMetrics& prepared,
                   const TexturePattern& texture, Solver solver) {
  Report report = make_report(surface, prepared, texture.u, solver);
  const StripeMilliseconds& more = texture.v.milliseconds;
  report.milliseconds.topology += more.topology;
  report.milliseconds.frequency += more.frequency;
  report.milliseconds.couple += more.couple;
  report.milliseconds.solve += more.solve;
  report.milliseconds.cancel += more.cancel;
  report.milliseconds.pattern += more.pattern + texture.orientation_milliseconds;
  report.frequency_v = frequency_report(texture.v.frequency_change, texture.v.quality);
  report.quality.branches = branches_of_both(texture);
  report.texture = TextureReport{texture.v.solution.energy, texture.u.quality.branches,
                                 texture.v.quality.branches, texture.seams, texture.quality};
  return report;
}

Report make_report(const Surface& surface, const PreparationMetrics& prepared,
                   const CrossTexture& texture, Solver solver) {
  Report report = make_report(surface, prepared, texture.pattern.u, solver);
  report.milliseconds.pattern += texture.pattern.orientation_milliseconds;
  report.cross = texture.pattern.quality;
  return report;
}

Report make_report(const Surface& surface, const PreparationMetrics& prepared,
                   const PatternResult& pattern, Solver solver) {
  Report report = [&] {
    if (const auto* crosses = std::get_if<CrossResult>(&pattern.of)) {
      return make_report(surface, prepared, crosses->texture, solver);
    }
    if (const auto* texture = std::get_if<TexturePattern>(&pattern.of)) {
      return make_report(surface, prepared, *texture, solver);
    }
    return make_report(surface, prepared, std::get<StripePattern>(pattern.of), solver);
  }();
  add_to_json(pattern.fabrication, report.fabrication);
  report.fabrication_lines = lines_of(pattern.fabrication);
  return report;
}

std::string_view kind_of(const Mesh& mesh) { return mesh.triangles.empty() ? "points" : "mesh"; }

nlohmann::ordered_json to_json(const WaveReport& waves,
                               const std::optional<std::size_t>& field_rows_nonfinite) {
  nlohmann::ordered_json json = {
      {"frequency_min", rounded(waves.frequency_min)},
      {"frequency_max", rounded(waves.frequency_max)},
      {"stripes", rounded(waves.stripes)},
      {"edges_per_period_min", rounded(waves.edges_per_period_min)},
      {"edges_per_period_median", rounded(waves.edges_per_period_median)},
      {"vertices_without_wave", waves.without_wave}};
  if (field_rows_nonfinite) json["field_rows_nonfinite"] = *field_rows_nonfinite;
  json.update(to_json(waves.missing));
  if (waves.smoothing) json.update(to_json(*waves.smoothing));
  if (waves.frequency_smoothing) {
    json["frequency_changed_median"] = waves.frequency_smoothing->changed_median;
    json["frequencies_filled"] = waves.frequency_smoothing->filled;
  }
  return json;
}

std::string device_line(const nlohmann::ordered_json& description) {
  if (description.value("kind", "cpu") == "cpu") return "";
  return "device    " + description.value("renderer", "?") + ", OpenGL " +
         description.value("version", "?") + "\n";
}

void print_waves(std::ostream& out, const WaveReport& waves) {
  out << formatted("waves     frequency %.4g", waves.frequency_min);
  if (waves.frequency_max > waves.frequency_min) out << formatted(" to %.4g", waves.frequency_max);
  out << formatted(", %.4g stripes along the diagonal, %.3g edges a period, %.3g at the fewest\n",
                   waves.stripes, waves.edges_per_period_median, waves.edges_per_period_min);
  if (waves.without_wave > 0) {
    out << formatted("no wave   at %zu of %zu vertices\n", waves.without_wave, waves.used);
  }
  if (waves.smoothing) print_smoothing(out, *waves.smoothing);
  if (waves.frequency_smoothing) {
    out << formatted("frequency changed by %.2f %% at the median, %zu vertices filled\n",
                     100 * waves.frequency_smoothing->changed_median,
                     waves.frequency_smoothing->filled);
  }
}

nlohmann::ordered_json to_json(const Report& report) {
  const StripeMilliseconds& time = report.milliseconds;
  nlohmann::ordered_json json = report.invocation;
  json.update(nlohmann::ordered_json{
      {"kind", report.triangles == 0 ? "points" : "mesh"},
      {"vertices", report.vertices},
      {"triangles", report.triangles},
      {"edges", report.edges},
      {"vertices_joined", report.vertices_joined},
      {"crease_vertices", report.crease_vertices},
      {"solver", name_of(report.solver)},
      {"threads", report.threads},
      {"iterations", report.iterations},
      {"energy", report.energy},
      {"branches", report.quality.branches},
      {"field_singularities", report.quality.field_singularities},
      {"angle_error_mean_deg", report.quality.angle_error_mean_deg},
      {"angle_error_share_over_5deg", report.quality.angle_error_share_over_5deg},
      {"spacing_error_mean", report.quality.spacing_error_mean},
      {"milliseconds",
       {{"load", time.load},
        {"field", report.field_milliseconds},
        {"topology", time.topology},
        {"couple", time.couple},
        {"solve", time.solve},
        {"pattern", time.pattern}}},
      {"device", report.device}});
  if (report.slip) {
    json["crease_slip_mean_deg"] = report.slip->mean_deg;
    json["crease_slip_share"] = report.slip->share;
  }
  json.update(to_json(report.waves, report.field_rows_nonfinite));
  if (time.cancel > 0) json["milliseconds"]["cancel"] = time.cancel;
  if (report.draw_milliseconds) {
    json["milliseconds"]["draw"] = *report.draw_milliseconds;
    json.update(report.picture);
  }
  if (report.frequency) {
    json["milliseconds"]["frequency"] = time.frequency;
    json["frequency_change"] = to_json(*report.frequency);
  }
  if (report.triangles == 0) {
    json.erase("branches");
    json.erase("field_singularities");
  }
  if (report.texture) {
    json["texture"] = to_json(*report.texture);
    json["texture"].update(to_json(report.texture->quality));
    if (report.frequency_v) json["texture"]["frequency_change_v"] = to_json(*report.frequency_v);
  }
  if (report.cross) json["cross"] = to_json(*report.cross);
  if (report.followed) json.update(to_json(*report.followed));
  if (!report.fabrication.is_null()) json.update(report.fabrication);
  return json;
}

void print_report(std::ostream& out, const Report& report) {
  const PatternQuality& quality = report.quality;
  const StripeMilliseconds& time = report.milliseconds;
  out << formatted("surface   %zu vertices, %zu triangles, %zu edges\n", report.vertices,
                   report.triangles, report.edges)
      << formatted("solver    %s, %d iteration%s, %d thread%s\n", name_of(report.solver).data(),
                   report.iterations, report.iterations == 1 ? "" : "s", report.threads,
                   report.threads == 1 ? "" : "s")
      << device_line(report.device);
  print_waves(out, report.waves);
  if (report.frequency) print_frequency(out, *report.frequency);
  if (report.frequency_v) print_frequency(out, *report.frequency_v);
  out << formatted("energy    %.6f\n", report.energy);
  print_branches(out, report);
  if (report.slip) {
    out << formatted(
        "creases   %zu vertices more; phases differ by %.1f degrees on average, by more than %.0f "
        "along %.1f %%\n",
        report.crease_vertices, report.slip->mean_deg, kSlipDegrees, 100 * report.slip->share);
  }
  out << formatted(
      "errors    angle %.2f degrees on average, above 5 degrees in %.1f %%, "
      "spacing %.1f %%\n",
      quality.angle_error_mean_deg, 100 * quality.angle_error_share_over_5deg,
      100 * quality.spacing_error_mean);
  if (report.texture) {
    print_texture(out, *report.texture);
    print_tiles(out, report.texture->quality);
  }
  if (report.cross) print_tiles(out, *report.cross);
  if (report.followed) print_followed(out, *report.followed);
  out << report.fabrication_lines;
  out << formatted(
      "time      load %.1f, field %.1f, topology %.1f, couple %.1f, solve %.1f, pattern %.1f",
      time.load, report.field_milliseconds, time.topology, time.couple, time.solve, time.pattern);
  if (report.frequency) out << formatted(", frequency %.1f", time.frequency);
  if (time.cancel > 0) out << formatted(", cancel %.1f", time.cancel);
  if (report.draw_milliseconds) out << formatted(", draw %.1f", *report.draw_milliseconds);
  out << " ms\n";
}

void print_table(std::ostream& out, const std::vector<Report>& reports) {
  out << "            topology   couple     solve  pattern  itera-                     angle error "
         " "
         "spacing\n"
         "solver            ms       ms        ms       ms   tions    energy  branches   mean  "
         ">5 deg    error\n";
  for (const Report& report : reports) {
    const std::string branches =  // points have none
        report.triangles == 0 ? "-" : std::to_string(report.quality.branches);
    const PatternQuality& quality = report.quality;
    const StripeMilliseconds& time = report.milliseconds;
    out << formatted("%-11s %8.1f %8.1f %9.1f %8.1f %7d %9.6f %9s %6.2f %6.1f%% %7.1f%%\n",
                     name_of(report.solver).data(), time.topology, time.couple, time.solve,
                     time.pattern, report.iterations, report.energy, branches.c_str(),
                     quality.angle_error_mean_deg, 100 * quality.angle_error_share_over_5deg,
                     100 * quality.spacing_error_mean);
  }
}

nlohmann::ordered_json to_json(const FieldSmoothingMetrics& smoothing) {
  nlohmann::ordered_json json = {
      {"field_turned_mean_deg", smoothing.turned_mean_deg},
      {"field_turned_median_deg", smoothing.turned_median_deg},
      {"field_turned_p95_deg", smoothing.turned_p95_deg},
      {"field_turned_share_over_20deg", smoothing.turned_share_over_20deg},
      {"field_singularities_of_data", smoothing.singularities_of_data},
      {"vertices_with_data", smoothing.data},
      {"vertices_filled", smoothing.filled},
      {"vertices_unfilled", smoothing.unfilled},
      {"coherence_mean", smoothing.coherence_mean},
      {"coherence_filled_mean", smoothing.coherence_filled_mean}};
  if (smoothing.held_out > 0) {
    json["held_out"] = smoothing.held_out;
    json["held_out_turned_mean_deg"] = smoothing.held_out_turned_mean_deg;
  }
  return json;
}

nlohmann::ordered_json to_json(const SampleSpacing& spacing) {
  return {{"measured", spacing.samples},
          {"mean", spacing.mean},
          {"deviation", spacing.deviation},
          {"isolated_double_share", spacing.double_share}};
}

std::string why_no_curves(const std::string& family, std::size_t short_curves) {
  if (short_curves == 0) {
    return family + ": no curves: no stripe's centre runs over the surface; ask for more stripes\n";
  }
  return family + ": no curves left: all " + std::to_string(short_curves) +
         " are shorter than --min-length\n";
}

namespace {

std::string text_of(const Winding& winding) { return winding ? std::to_string(*winding) : "none"; }

std::string names_of(const FabricationMetrics& metrics,
                     const std::vector<std::size_t>& boundaries) {
  std::string names;
  for (std::size_t k = 0; k < boundaries.size(); ++k) {
    const char* const before = k == 0 ? "" : k + 1 < boundaries.size() ? ", " : " and ";
    names += before + metrics.loops[boundaries[k]].name;
  }
  return names;
}

// Lines on components whose winding numbers at boundaries do not add up, with the reason.
std::string differences(const FabricationMetrics& metrics) {
  std::string text;
  for (const WindingSum& sum : metrics.sums) {
    const std::size_t first = sum.boundaries[0], second = sum.boundaries[1];
    const bool pair = sum.boundaries.size() == 2;
    if (pair ? metrics.windings[first] == metrics.windings[second] : sum.periods == 0) continue;
    const std::string names = names_of(metrics, sum.boundaries);
    const std::string how =
        pair ? " differ" : formatted(" do not add up, by %d", std::abs(sum.periods));
    text += "   " + names + how +
            formatted(": of %zu branches and singularities, some lie between\n",
                      metrics.branches[first]);
  }
  return text;
}

}  // namespace

void add_to_json(const FabricationMetrics& metrics, nlohmann::ordered_json& json) {
  auto loops = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < metrics.loops.size(); ++i) {
    const auto number = [](const Winding& winding) {
      return winding ? nlohmann::ordered_json(*winding) : nlohmann::ordered_json(nullptr);
    };
    const Eigen::Vector3d& center = metrics.centers[i];
    nlohmann::ordered_json loop = {{"name", metrics.loops[i].name},
                                   {"length", metrics.loops[i].length},
                                   {"center", {center.x(), center.y(), center.z()}},
                                   {"winding", number(metrics.windings[i])},
                                   {"branches_of_component", metrics.branches[i]}};
    if (!metrics.windings_before.empty()) {
      loop["winding_before"] = number(metrics.windings_before[i]);
    }
    loops.push_back(std::move(loop));
  }
  if (!loops.empty()) json["loops"] = std::move(loops);
  if (!metrics.windings_before.empty()) {
    json["turned"] = {{"energy_before", metrics.energy_before},
                      {"largest_deg", metrics.largest_turn_deg},
                      {"mean_deg", metrics.mean_turn_deg},
                      {"largest_frequency_change", metrics.largest_frequency_change}};
  }
  if (metrics.cancelled_branches) {
    const CancelledBranches& cancelled = *metrics.cancelled_branches;
    json["cancelled_branches"] = {{"pairs", cancelled.pairs},
                                  {"branches_before", cancelled.branches_before},
                                  {"energy_before", cancelled.energy_before}};
  }
  if (metrics.fixed_vertices > 0) json["boundary_vertices_fixed"] = metrics.fixed_vertices;
}

std::string lines_of(const FabricationMetrics& metrics) {
  std::string text;
  for (std::size_t i = 0; i < std::min(kMostWindings, metrics.loops.size()); ++i) {
    const std::string before =
        metrics.windings_before.empty() ? "" : ", before " + text_of(metrics.windings_before[i]);
    text += formatted("%s%s %s%s", i == 0 ? "   windings: " : "; ", metrics.loops[i].name.c_str(),
                      text_of(metrics.windings[i]).c_str(), before.c_str());
  }
  if (metrics.loops.size() > kMostWindings) {
    text += formatted("; and %zu more in the report", metrics.loops.size() - kMostWindings);
  }
  if (!text.empty()) text += '\n';
  return text + remarks_of(metrics);
}

std::string remarks_of(const FabricationMetrics& metrics) {
  std::string text = differences(metrics);
  if (!metrics.windings_before.empty()) {
    text += formatted(
        "   the field is turned by up to %.2f degrees, %.2f on average, frequencies by up to %.1f "
        "%%; energy %.6f before\n",
        metrics.largest_turn_deg, metrics.mean_turn_deg, 100 * metrics.largest_frequency_change,
        metrics.energy_before);
  }
  if (metrics.cancelled_branches) {
    const CancelledBranches& cancelled = *metrics.cancelled_branches;
    text += formatted(
        "   %zu branch pairs cancelled: %zu branches before, %zu after; energy "
        "%.6f before, %.6f after\n",
        cancelled.pairs, cancelled.branches_before, cancelled.branches_after,
        cancelled.energy_before, cancelled.energy_after);
  }
  return text;
}

}  // namespace brindle
