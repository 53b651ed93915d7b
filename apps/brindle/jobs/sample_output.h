/// Files and reports of `brindle sample`.
#pragma once

#include <iosfwd>
#include <string>

#include <nlohmann/json.hpp>

#include "jobs/sample_job.h"

namespace brindle::tool {

nlohmann::ordered_json to_json(const SampleJob& job, const PictureOptions& picture);

/// The same as text.
void print(std::ostream& out, const SampleJob& job);

/// Writes any kind but pieces. Throws Error if the file cannot be written.
void write_sample_file(const Output& output, const CLI::App& command,
                       const SampleArguments& arguments, const SampleJob& job,
                       JobListener& listener);

}  // namespace brindle::tool
