#include "session/session_export.h"

#include "brindle/base/file_extension.h"
#include "brindle/base/printable.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "cli/command_line.h"
#include "jobs/curves_output.h"
#include "pictures/drawing_file.h"
#include "pictures/styled_scene.h"

namespace brindle::tool {
namespace {

[[noreturn]] void refuse_extension(const std::filesystem::path& path, const char* known) {
  throw Error(shown(path.native()) + ": unknown extension; write " + known);
}

}  // namespace

std::string picture_refusal(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  if (extension == ".png") return "";
  if (is_drawing_file(path)) return "sessions have pictures of pixels; write .png";
  return "'" + extension + "' is no picture; write .png";
}

void export_pattern(const LiveState& state, const std::filesystem::path& path,
                    JobListener& listener) {
  const StripeArguments& arguments = state.parsed->arguments();
  const std::vector<Output> outputs =
      plan_outputs({path.string()}, "", state.job->result.texture() != nullptr);
  if (outputs.front().kind == OutputKind::picture) {
    refuse_extension(path, ".ply, .vtp, .obj, .gltf or .glb for a mesh, .json for a report");
  }
  check_files(stripe_inputs(arguments), files_of(outputs, state.job->result.texture() != nullptr));
  const MadeMesh made{*state.job->surface, state.job->result, state.job->data,
                      arguments.solving.stripes.phase_shift, false};
  Report report = state.job->report;
  report.invocation = invocation_of(state.parsed->command());
  write_output(outputs.front(), made, report, *arguments.picture, listener);
}

void export_curves(const LiveState& state, const std::filesystem::path& path,
                   JobListener& listener) {
  if (state.curves) {
    const CurvesArguments& arguments = *state.parsed->curves();
    const CurveOutput kind = planned_curves(path.string(), arguments.tube_radius.has_value());
    listener.stage("writing " + shown(path.native()));
    return write_curves(
        kind, path.string(),
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
    return write_all_samples(path.string(), surface.mesh, state.job->data.arrays,
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
