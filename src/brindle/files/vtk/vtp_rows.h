/// Lines and samples as VTP on a stream.
#pragma once

#include <filesystem>
#include <span>

#include "brindle/base/output_file.h"
#include "brindle/files.h"

namespace brindle {

/// As `write_polylines` writes a .vtp. Throws its errors of arrays, which name `path`.
void write_vtp_polylines(OutputStream& out, const std::filesystem::path& path,
                         std::span<const NamedLines> kinds);

/// As `write_samples` writes a .vtp. Throws its errors of arrays, which name `path`.
void write_vtp_samples(OutputStream& out, const std::filesystem::path& path,
                       std::span<const Sample> samples, const Eigen::Vector3d& origin,
                       std::span<const DataArray> arrays);

}  // namespace brindle
