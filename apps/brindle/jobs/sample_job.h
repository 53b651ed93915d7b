/// The stages of `brindle sample`, shared with the window.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <nlohmann/json.hpp>

#include "brindle/samples.h"
#include "cli/job_listener.h"
#include "jobs/sample_arguments.h"
#include "outputs/make_and_write.h"

namespace brindle::tool {

inline constexpr const char* kNoSamples =
    "no samples: nowhere do stripes of both patterns cross; ask for more stripes\n";

/// Samples at the crossings of two patterns.
struct TakenSamples {
  std::vector<Sample> samples;
  std::size_t doubles = 0;  ///< number left out
  std::optional<SampleSpacing> spacing;
  double edges_milliseconds = 0;
  double extract_milliseconds = 0;
};

struct SampleJob : DrawingTime {
  Preparation prepared;
  StripePattern u, v;
  TakenSamples taken;
  GlyphInput glyphs;
  nlohmann::ordered_json ranks = {};  ///< key of the report; null: one process
};

/// Samples of existing patterns, on a mesh or on points.
TakenSamples taken_samples(const SampleArguments& arguments, const Surface& surface,
                           const StripePattern& u, const StripePattern& v, JobListener& listener);

/// Its stages, in order, for `JobListener`.
std::vector<JobStage> sample_stages(const SampleArguments& arguments);

SampleJob make_sample_job(const SampleArguments& arguments, JobListener& listener);

/// Discs at samples, for pictures without glyphs, relative to `origin`.
Ornament discs_of(std::span<const Sample> samples, const Eigen::Vector3d& origin);

/// `frequency_u` and `frequency_v`, from the samples' spacings.
std::vector<DataArray> frequency_arrays(std::span<const Sample> samples);

/// Includes the input's arrays. Throws Error if the file cannot be written.
void write_all_samples(const std::filesystem::path& path, const Mesh& mesh, const DataArrays& input,
                       std::span<const Sample> samples, JobListener& listener);

}  // namespace brindle::tool
