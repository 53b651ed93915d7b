#include "session/session_export.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "brindle/base/file_names.h"
#include "brindle/base/output_file.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/render/slice_refusal.h"
#include "cli/command_line.h"
#include "cli/option_values.h"
#include "jobs/curves_output.h"
#include "jobs/curves_report.h"
#include "outputs/outputs.h"
#include "pictures/drawing_file.h"
#include "pictures/styled_output.h"

namespace brindle::tool {
namespace {

[[noreturn]] void refuse_extension(const std::filesystem::path& path, const char* known) {
  throw Error(shown(path.native()) + ": unknown extension; write " + known);
}

/// Options measured in pixels of the picture.
std::vector<std::string> pixel_widths(const SessionDocument& document) {
  std::vector<std::string> names;
  const OptionValues given = shown_options(document);
  for (const OptionInfo* option : session_options(document.shown)) {
    const std::string name(option->name);
    if (option->unit == "pixels" && given.contains(name)) names.push_back(name);
  }
  return names;
}

/// A width range in pixels.
std::optional<WidthRange> pixel_range(const SessionDocument& document) {
  const ParsedSession parsed(document);
  std::optional<WidthRange> range = parsed.arguments().style.width_range;
  if (range && range->unit != WidthUnit::pixels) range.reset();
  return range;
}

void scale_widths(SessionDocument& document, double scale) {
  const std::optional<WidthRange> range = pixel_range(document);
  for (const std::string& name : pixel_widths(document)) {
    std::string& width = options_with(name, document).at(name).front();
    width = formatted("%.6g", scale * static_cast<double>(parse_number("--" + name, width)));
  }
  if (!range) return;
  options_with("width-range", document)["width-range"] = {
      formatted("%.6gpx..%.6gpx", scale * static_cast<double>(range->first),
                scale * static_cast<double>(range->last))};
}

/// The growth of the visible content: pictures fit it to their narrower side.
double growth(PictureSize from, PictureSize to) {
  return std::min(static_cast<double>(to.width) / from.width,
                  static_cast<double>(to.height) / from.height);
}

}  // namespace

std::string picture_refusal(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  if (extension == ".png") return "";
  if (is_drawing_file(path)) return "this picture has pixels; write .png";
  return "'" + extension + "' is no picture; write .png";
}

bool has_pixel_widths(const SessionDocument& document) {
  return !pixel_widths(document).empty() || pixel_range(document).has_value();
}

SessionDocument with_changes(const SessionDocument& document, const PictureChanges& changes) {
  SessionDocument result = document;
  if (changes.size) {
    check_image_size(changes.size->width, changes.size->height);
    result.size = *changes.size;
  }
  if (changes.scaled_widths) {
    if (!has_pixel_widths(document)) {
      throw Error("no width is measured in pixels, so that all grows with the size anyway");
    }
    scale_widths(result, growth(document.size, result.size));
  }
  if (changes.transparent) options_with("transparent", result)["transparent"] = {};
  check_document(result);
  return result;
}

SessionDocument planned_picture(const SessionDocument& document, const PictureChanges& changes,
                                const std::filesystem::path& path) {
  SessionDocument changed = with_changes(document, changes);
  const ParsedSession parsed(changed);
  check_picture_files(parsed, {path});
  check_output_path(path);
  check_files(parsed.inputs(), {{"--output", path}});
  return changed;
}

void PictureWriter::write(const std::shared_ptr<const LiveState>& state,
                          const std::filesystem::path& path, JobListener& listener) {
  listener.stage("writing " + shown(path.native()));
  if (is_drawing_file(path)) {
    if (state->curves) return export_curves(*state, path, listener);
    return write_stripes({path, OutputKind::drawing}, state->parsed->command(),
                         state->parsed->arguments(), *state->job, state->style.get(), listener);
  }
  if (!picture_) picture_.emplace();
  const Progress progress = listener.progress();
  const Image image = picture_->draw(state, quality_, progress.part(0, kDrawn));
  check_slice(picture_->nothing_left(*state));
  write_png(path, image, progress.part(kDrawn, 1), dpi_);
}

void export_picture(const SessionDocument& document, const std::filesystem::path& path, double dpi,
                    JobListener& listener) {
  listener.plan({{"solving", 6}, {"writing " + shown(path.native()), 4}});
  listener.stage("solving");
  LivePattern pattern;
  pattern.update(document, Follow::afresh, listener.progress());
  PictureWriter(PictureQuality::final, dpi).write(pattern.state(), path, listener);
}

void export_pattern(const LiveState& state, const std::filesystem::path& path,
                    JobListener& listener) {
  const StripeArguments& arguments = state.parsed->arguments();
  const Outputs outputs = plan_outputs(stripe_inputs(arguments), {path.string()}, "",
                                       planned_stripes, state.job->result.texture() != nullptr);
  if (draws(outputs)) {
    refuse_extension(path, ".ply, .vtp, .obj, .gltf or .glb for a mesh, .json for a report");
  }
  write_stripes(outputs.front(), state.parsed->command(), arguments, *state.job, nullptr, listener);
}

namespace {

/// With all metrics. Their lines are already reshaped.
std::vector<CurveFamily> measured_curves(const LiveState& state, JobListener& listener) {
  CurvesArguments arguments = *state.parsed->curves();
  arguments.offset = 0;
  const Surface& surface = *state.job->surface;
  const StripeTracer tracer(surface);
  std::vector<CurveFamily> families;
  for (const CurveFamily& family : state.curves->families) {
    CurveFamily& measured = families.emplace_back(traced_family(
        arguments, surface, tracer, family.name, family.pattern, CurveMetrics::all, listener));
    measured.jogs = family.jogs;
    measured.fabrication = family.fabrication;
    if (measured.fabrication.loops.empty()) {
      measure_windings(surface, family.pattern, measured.fabrication);
    }
  }
  return families;
}

void write_curves_report(const LiveState& state, const std::filesystem::path& path,
                         JobListener& listener) {
  const bool measured = std::ranges::all_of(
      state.curves->families, [](const CurveFamily& family) { return family.spacing.has_value(); });
  std::vector<CurveFamily> anew;
  if (!measured) anew = measured_curves(state, listener);
  const std::span<const CurveFamily> families = measured ? state.curves->families : anew;
  const Surface& surface = *state.job->surface;
  const bool yields = !families.front().pattern.frequencies_wanted.empty();
  write_report(path, state.parsed->command(), surface.mesh,
               to_json(ReportedCurves{surface, *state.prepared, families, yields},
                       state.parsed->curves()->picture),
               listener.progress());
}

}  // namespace

void export_curves(const LiveState& state, const std::filesystem::path& path,
                   JobListener& listener) {
  if (state.curves) {
    const CurvesArguments& arguments = *state.parsed->curves();
    const OutputKind kind = planned_curves(path, arguments.tube_radius.has_value());
    check_output_path(path);
    listener.stage("writing " + shown(path.native()));
    if (kind == OutputKind::report) return write_curves_report(state, path, listener);
    return write_curves(
        {path, kind},
        {arguments, *state.job->surface, state.job->data.arrays, state.curves->families}, listener);
  }
  if (!is_polyline_format(path)) refuse_extension(path, ".vtp, .ply, .obj or .csv");
  listener.stage("curves");
  const StripeCurves curves = stripe_curves(*state.job->surface, state.job->result.stripes());
  const std::vector<NamedLines> lines = {{"u", curves.lines}};
  listener.stage("writing " + shown(path.native()));
  write_polylines(path, lines);
}

void export_samples(const LiveState& state, const std::filesystem::path& path,
                    JobListener& listener) {
  if (!is_sample_format(path)) refuse_extension(path, ".csv, .ply or .vtp");
  const Surface& surface = *state.job->surface;
  if (state.samples) {
    listener.stage("writing " + shown(path.native()));
    return write_all_samples(path, surface.mesh, state.job->data.arrays,
                             state.samples->taken.samples, listener);
  }
  const StripePattern& u = state.job->result.stripes();
  std::optional<StripePattern> across;
  if (state.job->result.texture() == nullptr) {
    across = stripe_pattern(surface, waves_across(u.waves, surface.normals),
                            state.parsed->arguments().solving.stripes, listener.progress());
  }
  listener.stage("samples");
  const StripePattern& v = across ? *across : state.job->result.texture()->pattern.v;
  const std::vector<Sample> samples = stripe_samples(surface, u, v);
  listener.stage("writing " + shown(path.native()));
  write_samples(path, samples, surface.mesh.origin);
}

}  // namespace brindle::tool
