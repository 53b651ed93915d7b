/// `brindle sample`: its arguments, the samples and their files.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "brindle/samples.h"
#include "cli/job_listener.h"
#include "input/second_waves.h"
#include "outputs/outputs.h"
#include "pictures/glyphs.h"

namespace brindle::tool {

struct SampleArguments : JobArguments {
  SecondWaveOptions second;
  GlyphOptions glyphs;
  float min_distance = 0.25f;
};

/// The kind of output of a path. Throws CLI::ValidationError with a remedy for files that cannot
/// hold samples.
OutputKind planned_sample(const std::filesystem::path& path);

void add_sample_options(CLI::App& command, SampleArguments& arguments);

/// Throws CLI::ValidationError for options without effect on these files or beside other options,
/// and for what cannot be drawn.
void check_sample_options(const CLI::App& command, const SampleArguments& arguments,
                          const Outputs& outputs);

/// The same for options that point clouds do not support; reads the mesh's file if necessary.
void check_sample_points(const CLI::App& command, const SampleArguments& arguments,
                         const Outputs& outputs);

/// All input files.
std::vector<UsedFile> sample_inputs(const SampleArguments& arguments);

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

nlohmann::ordered_json to_json(const SampleJob& job, const PictureOptions& picture);

/// The same as text.
void print(std::ostream& out, const SampleJob& job);

/// Writes any kind but pieces. Throws Error if the file cannot be written.
void write_sample_file(const Output& output, const CLI::App& command,
                       const SampleArguments& arguments, const SampleJob& job,
                       JobListener& listener);

}  // namespace brindle::tool
