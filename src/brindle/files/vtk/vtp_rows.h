/// Lines and samples as VTP streams.
#pragma once

#include <filesystem>
#include <span>

#include "brindle/base/output_file.h"
#include "brindle/files.h"

namespace brindle {

/// The .vtp of `write_polylines`. Throws its errors, which name `path`.
void write_vtp_polylines(OutputStream& out, const std::filesystem::path& path,
                         std::span<const NamedLines> kinds);

/// The .vtp of `write_samples`. Throws its errors, which name `path`.
void write_vtp_samples(OutputStream& out, const std::filesystem::path& path,
                       std::span<const Sample> samples, const Eigen::Vector3d& origin,
                       std::span<const DataArray> arrays);

}  // namespace brindle
