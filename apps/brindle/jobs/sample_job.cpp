#include "jobs/sample_job.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "brindle/base/elementary.h"
#include "brindle/base/stopwatch.h"
#include "brindle/files.h"
#include "brindle/pattern_warnings.h"
#include "brindle/points.h"
#include "brindle/stripe_tracer.h"
#include "outputs/carried_arrays.h"

namespace brindle::tool {
namespace {

TakenSamples all_samples(const Surface& surface, const StripePattern& u, const StripePattern& v,
                         const Progress& progress) {
  TakenSamples taken;
  Stopwatch watch;
  const StripeTracer tracer(surface, progress.part(0, 0.3));
  taken.edges_milliseconds = watch.lap();
  taken.samples = tracer.crossings(u, v, progress.part(0.3, 1));
  taken.extract_milliseconds = watch.lap();
  return taken;
}

}  // namespace

TakenSamples taken_samples(const SampleArguments& arguments, const Surface& surface,
                           const StripePattern& u, const StripePattern& v, JobListener& listener) {
  listener.stage("samples");
  TakenSamples taken = all_samples(surface, u, v, listener.progress());
  if (surface.mesh.triangles.empty() || has_point_trees()) {
    listener.stage("doubles");
    taken.doubles = drop_doubles(taken.samples, arguments.min_distance, listener.progress());
    listener.stage("spacing");
    taken.spacing = measure_sample_spacing(taken.samples, listener.progress());
  }
  if (taken.samples.empty()) listener.note(kNoSamples);
  return taken;
}

std::vector<JobStage> sample_stages(const SampleArguments& arguments) {
  std::vector<JobStage> stages = preparation_stages(arguments.surface);
  stages.insert(
      stages.end(),
      {{"stripes of u", 4}, {"stripes of v", 4}, {"samples", 4}, {"doubles", 2}, {"spacing", 2}});
  return stages;
}

SampleJob make_sample_job(const SampleArguments& arguments, JobListener& listener) {
  SampleJob job;
  Preparation& prepared = job.prepared;
  prepared =
      prepare(arguments.surface, arguments.waves, listener, viewpoint_of(*arguments.picture));
  const Surface& surface = prepared.surface;
  WaveSet waves_v = make_second_waves(first_waves(prepared), arguments.second, listener);
  const StripeOptions options = stripe_options(arguments.solving, prepared);
  listener.stage("stripes of u");
  job.u = stripe_pattern(surface, std::move(prepared.waves), options, listener.progress());
  listener.stage("stripes of v");
  job.v = stripe_pattern(surface, std::move(waves_v), options, listener.progress());
  listener.note(quality_warning(prepared.metrics, worse_of(job.u.quality, job.v.quality),
                                surface.mesh.triangle_count()));
  job.taken = taken_samples(arguments, surface, job.u, job.v, listener);
  return job;
}

namespace {

// Discs a third of the spacing wide, just above and below the surface, whose winding may be either.
void add_disc(const Sample& sample, Mesh& mesh) {
  constexpr int kCorners = 16;
  const float radius = 0.16f * std::min(sample.spacing_u, sample.spacing_v);
  const Vec3 x = sample.direction_u;
  const Vec3 y = sample.normal.cross(x);
  for (const float height : {-0.12f, 0.12f}) {
    const auto first = static_cast<Index>(mesh.positions.size());
    const Vec3 centre = sample.position + height * radius * sample.normal;
    for (int k = 0; k < kCorners; ++k) {
      const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(k) / kCorners;
      mesh.positions.push_back(centre +
                               radius * (elementary::cos(angle) * x + elementary::sin(angle) * y));
    }
    for (Index k = 1; k + 1 < kCorners; ++k) {
      mesh.triangles.push_back({first, first + k, first + k + 1});
    }
  }
}

}  // namespace

Ornament discs_of(std::span<const Sample> samples, const Eigen::Vector3d& origin) {
  Ornament discs{{}, true};
  discs.mesh.origin = origin;
  for (const Sample& sample : samples) add_disc(sample, discs.mesh);
  return discs;
}

namespace {

// Columns and arrays of all formats, which input arrays must not replace.
const std::vector<std::string> kSampleColumns = {"normal",      "direction_u", "direction_v",
                                                 "spacing_u",   "spacing_v",   "triangle",
                                                 "barycentric", "frequency_u", "frequency_v"};

// What samples have as spacings.
DataArray frequencies_of(const char* name, std::span<const Sample> samples,
                         float Sample::*spacing) {
  std::vector<float> frequencies;
  for (const Sample& sample : samples) frequencies.push_back(1 / sample.*spacing);
  return make_data_array(name, 1, frequencies);
}

}  // namespace

std::vector<DataArray> frequency_arrays(std::span<const Sample> samples) {
  return {frequencies_of("frequency_u", samples, &Sample::spacing_u),
          frequencies_of("frequency_v", samples, &Sample::spacing_v)};
}

void write_all_samples(const std::filesystem::path& path, const Mesh& mesh, const DataArrays& input,
                       std::span<const Sample> samples, JobListener& listener) {
  std::vector<DataArray> arrays = frequency_arrays(samples);
  const DataArrays held = held_beside(kSampleColumns, path, input, listener);
  std::vector<DataArray> carried = arrays_at(samples, mesh.triangles, held);
  std::move(carried.begin(), carried.end(), std::back_inserter(arrays));
  write_samples(path, samples, mesh.origin, arrays, listener.progress());
}

}  // namespace brindle::tool
