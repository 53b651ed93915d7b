/// The output files of `brindle stripe`.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "brindle/recipe/report.h"
#include "input/used_files.h"
#include "input/wave_options.h"
#include "outputs/mesh_output.h"
#include "pictures/style_options.h"

namespace brindle::tool {

enum class OutputKind { picture, mesh, report };

struct Output {
  std::filesystem::path path;
  OutputKind kind;
  std::string option = "--output";  ///< that gives it
};

/// --output, --report and --quiet.
void add_output_options(CLI::App& app, std::vector<std::string>& outputs, std::string& report,
                        bool& quiet);

/// The kind of each output by its extension: .png a picture, .obj .ply .vtp .gltf .glb a mesh,
/// .json a report; reports are last and include `report` unless it is empty. Before a long job,
/// throws CLI::ValidationError for unknown extensions and Error for files that this build cannot
/// write or that are not writable. With a texture, meshes may have files beside them
/// (`textured_mesh_files`).
std::vector<Output> plan_outputs(const std::vector<std::string>& paths, const std::string& report,
                                 bool texture);

/// All output files, including those beside meshes.
std::vector<UsedFile> files_of(const std::vector<Output>& outputs, bool texture);

/// Throws CLI::ValidationError for given picture options; `why` is the reason that they have no
/// effect. Camera options stay valid if frequencies depend on the camera, --up if they depend on
/// heights.
void refuse_picture_options(const CLI::App& command, const WaveOptions& waves,
                            std::string_view why);

/// The same for --light-from alone, which is valid if frequencies depend on the light.
void refuse_light_option(const CLI::App& command, const WaveOptions& waves, std::string_view why);

/// Throws CLI::ValidationError for --light-from if pictures of this style have no light.
void check_light_option(const CLI::App& command, const StyleOptions& style,
                        const WaveOptions& waves);

/// The same for --camera, --up, --size and --light-from alone.
void refuse_camera_options(const CLI::App& command, const WaveOptions& waves, std::string_view why);

/// Whether the format can hold points without triangles.
bool holds_points(const std::filesystem::path& path);

void write_output(const Output& output, const MadeMesh& made, const Report& report,
                  const PictureOptions& picture, JobListener& listener);

/// Throws for wrong usage of --output: `path` cannot be written because of `why`.
[[noreturn]] void refuse_output(const std::filesystem::path& path, const std::string& why);

/// Rejects .pdf in builds without Cairo.
void check_drawing_file(const std::filesystem::path& path);

/// Writes a report after `invocation_of` the command and the kind of its surface.
void write_report(const std::filesystem::path& path, const CLI::App& command, const Mesh& mesh,
                  const nlohmann::ordered_json& report, const Progress& progress);

/// Writes indented JSON. `progress` can cancel a write to a blocked pipe.
void write_json(const std::filesystem::path& path, const nlohmann::ordered_json& json,
                const Progress& progress = {});

}  // namespace brindle::tool
