/// The files that `brindle stripe` writes.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "picture.h"
#include "report.h"
#include "stripe_result.h"

namespace brindle::tool {

enum class OutputKind { picture, mesh, report };

struct Output {
  std::filesystem::path path;
  OutputKind kind;
};

/// --output, --report and --quiet.
void add_output_options(CLI::App& app, std::vector<std::string>& outputs, std::string& report,
                        bool& quiet);

/// What each path asks for, by its extension: .png a picture, .obj .ply .vtp .gltf .glb a mesh,
/// .json a report. Throws Error if an extension is unknown, this build cannot write it, or a file
/// could not be written there: better now than after a long job. With a texture, meshes may have
/// files beside them (`textured_mesh_files`).
std::vector<Output> plan_outputs(const std::vector<std::string>& paths, bool texture);

/// As `plan_outputs`, for a path that is a report whatever its extension.
Output plan_report(const std::string& path);

/// Whether points without triangles can be written there.
bool holds_points(const std::filesystem::path& path);

/// Vertices that were joined with others are given what their `partners` (`Preparation`) have.
void write_output(const Output& output, const Surface& surface, const StripeResult& result,
                  const Report& report, const PictureOptions& picture,
                  std::span<const Index> partners = {});

/// Writes indented JSON.
void write_json(const std::filesystem::path& path, const nlohmann::ordered_json& json);

}  // namespace brindle::tool
