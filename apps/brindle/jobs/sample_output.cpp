#include "jobs/sample_output.h"

#include <ostream>
#include <span>
#include <vector>

#include "brindle/base/parallel.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/recipe/report.h"
#include "outputs/outputs.h"

namespace brindle::tool {

nlohmann::ordered_json to_json(const SampleJob& job, const PictureOptions& picture) {
  const Surface& surface = job.prepared.surface;
  const auto both = [&](double StripeMilliseconds::*part) {
    return job.u.milliseconds.*part + job.v.milliseconds.*part;
  };
  nlohmann::ordered_json json = {
      {"vertices", surface.own_vertex_count()}, {"triangles", surface.mesh.triangle_count()},
      {"edges", surface.own_edge_count()},      {"vertices_joined", job.prepared.vertices_joined},
      {"threads", ThreadLimit::current()},      {"samples", job.taken.samples.size()},
      {"doubles_left_out", job.taken.doubles},  {"branches_u", job.u.quality.branches},
      {"branches_v", job.v.quality.branches}};
  json.update(to_json(job.prepared.metrics, job.prepared.field_rows_nonfinite));
  const auto add_frequency = [&](const char* name, const StripePattern& pattern) {
    const auto frequency = frequency_report(pattern.frequency_change, pattern.quality);
    if (frequency) json[name] = to_json(*frequency);
  };
  add_frequency("frequency_change_u", job.u);
  add_frequency("frequency_change_v", job.v);
  if (job.taken.spacing) json["nearest_neighbour"] = brindle::to_json(*job.taken.spacing);
  json["milliseconds"] = {
      {"load", job.prepared.load_milliseconds},
      {"field", job.prepared.field_milliseconds},
      {"topology", job.prepared.topology_milliseconds + job.taken.edges_milliseconds +
                       both(&StripeMilliseconds::topology)},
      {"couple", both(&StripeMilliseconds::couple)},
      {"solve", both(&StripeMilliseconds::solve)},
      {"pattern", both(&StripeMilliseconds::pattern)},
      {"extract", job.taken.extract_milliseconds}};
  if (job.u.frequency_change) {
    json["milliseconds"]["frequency"] = both(&StripeMilliseconds::frequency);
  }
  if (!job.ranks.is_null()) json["ranks"] = job.ranks;
  if (job.draw_milliseconds) {
    json["milliseconds"]["draw"] = *job.draw_milliseconds;
    json.update(picture_json(picture));
  }
  return json;
}

void print(std::ostream& out, const SampleJob& job) {
  print_waves(out, job.prepared.metrics);
  out << formatted("samples   %zu, %zu more left out as too near to others\n",
                   job.taken.samples.size(), job.taken.doubles)
      << formatted("branches  %zu of U, %zu of V\n", job.u.quality.branches,
                   job.v.quality.branches);
  if (job.taken.spacing && job.taken.spacing->samples > 0) {
    out << formatted(
        "nearest   %.3f of the ideal grid's distance on average, deviation %.3f, doubles %.2f %%\n",
        job.taken.spacing->mean, job.taken.spacing->deviation,
        100 * job.taken.spacing->double_share);
  }
  out << formatted("time      extracted in %.1f ms\n", job.taken.extract_milliseconds);
}

void write_sample_file(const Output& output, const CLI::App& command,
                       const SampleArguments& arguments, const SampleJob& job,
                       JobListener& listener) {
  const Preparation& prepared = job.prepared;
  const Mesh& mesh = prepared.surface.mesh;
  const std::vector<Sample>& samples = job.taken.samples;
  const std::filesystem::path& path = output.path;
  switch (output.kind) {
    case OutputKind::samples:
      return write_all_samples(path, mesh, prepared.arrays, samples, listener);
    case OutputKind::picture: {
      if (is_styled(command)) {
        return write_glyphs(path, prepared.surface, samples, arguments.glyphs, job.glyphs,
                            *arguments.picture, listener.progress());
      }
      const Ornament discs = discs_of(samples, mesh.origin);
      return write_ornaments(path, prepared.surface, std::span(&discs, 1), *arguments.picture,
                             listener.progress());
    }
    case OutputKind::report:
      return write_report(path, command, mesh, to_json(job, *arguments.picture),
                          listener.progress());
    default:
      throw Error(shown(path.native()) + ": holds no samples of one process");
  }
}

}  // namespace brindle::tool
