/// Files of a live pattern, as the tool's other commands write them.
#pragma once

#include <filesystem>
#include <string>

#include "cli/job_listener.h"
#include "session/live_pattern.h"

namespace brindle::tool {

/// Why no picture of a session is written to a file of this name; empty if one is: a .png.
std::string picture_refusal(const std::filesystem::path& path);

/// A mesh (.ply .vtp .obj .gltf .glb) or a report (.json), as `brindle stripe --output`. Throws
/// CLI::ValidationError for another extension, and what writing throws.
void export_pattern(const LiveState& state, const std::filesystem::path& path,
                    JobListener& listener);

/// The stripes' centre lines, as `brindle curves --output` in .vtp .ply .obj or .csv; of a texture,
/// those along the field. With the options of curves where these are shown, tubes among them, else
/// without any. Throws Error for points without triangles and for another extension.
void export_curves(const LiveState& state, const std::filesystem::path& path,
                   JobListener& listener);

/// Points where the stripes and those across them meet, as `brindle sample --output` in .csv .ply
/// or .vtp; those that are shown, or else those without options. Solves then for the stripes across
/// unless there is a texture. Throws Error for another extension and in a build without nanoflann.
void export_samples(const LiveState& state, const std::filesystem::path& path,
                    JobListener& listener);

}  // namespace brindle::tool
