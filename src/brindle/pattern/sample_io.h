/// Samples to files.
#pragma once

#include <filesystem>
#include <span>

#include "brindle/pattern/sampling.h"

namespace brindle {

/// Whether `write_samples` knows the path's extension.
bool is_sample_format(const std::filesystem::path& path);

/// Writes all that a Sample has, whole or not at all, by the path's extension: .csv a row per
/// sample, .ply (binary) a vertex per sample, .vtp a point per sample. In .vtp the triangle's
/// number is a float, exact up to 16,777,216 triangles. Positions are relative to `origin`, which
/// is that of the mesh, and written where they stand. Throws Error for another extension and what
/// write_file throws.
void write_samples(const std::filesystem::path& path, std::span<const Sample> samples,
                   const Eigen::Vector3d& origin = Eigen::Vector3d::Zero());

}  // namespace brindle
