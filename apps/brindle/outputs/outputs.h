/// The files that `brindle stripe` writes.
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
  std::string option = "--output";  ///< that asks for it
};

/// --output, --report and --quiet.
void add_output_options(CLI::App& app, std::vector<std::string>& outputs, std::string& report,
                        bool& quiet);

/// What each path asks for, by its extension: .png a picture, .obj .ply .vtp .gltf .glb a mesh,
/// .json a report; reports last, `report` among them unless it is empty. Throws
/// CLI::ValidationError if an extension is unknown, Error if this build cannot write it or a file
/// could not be written there: better now than after a long job. With a texture, meshes may have
/// files beside them (`textured_mesh_files`).
std::vector<Output> plan_outputs(const std::vector<std::string>& paths, const std::string& report,
                                 bool texture);

/// All files that are written with the outputs, those beside meshes too.
std::vector<UsedFile> files_of(const std::vector<Output>& outputs, bool texture);

/// Throws CLI::ValidationError for options of pictures that were given: `why` there is none. Those
/// of the camera count anyway where frequencies depend on it, and --up where they follow heights.
void refuse_picture_options(const CLI::App& command, const WaveOptions& waves,
                            std::string_view why);

/// The same of --light-from alone, which counts anyway where frequencies follow the light.
void refuse_light_option(const CLI::App& command, const WaveOptions& waves, std::string_view why);

/// Throws CLI::ValidationError where pictures of this style have no light that --light-from would
/// move.
void check_light_option(const CLI::App& command, const StyleOptions& style,
                        const WaveOptions& waves);

/// The same of --camera, --up, --size and --light-from alone.
void refuse_camera_options(const CLI::App& command, const WaveOptions& waves, std::string_view why);

/// Whether points without triangles can be written there.
bool holds_points(const std::filesystem::path& path);

void write_output(const Output& output, const MadeMesh& made, const Report& report,
                  const PictureOptions& picture, JobListener& listener);

/// The wrong use of --output: `path` cannot be written, and `why`.
[[noreturn]] void refuse_output(const std::filesystem::path& path, const std::string& why);

/// Refuses a .pdf where this build cannot write it.
void check_drawing_file(const std::filesystem::path& path);

/// Writes a report behind `invocation_of` the command and the kind of surface that it worked on.
void write_report(const std::filesystem::path& path, const CLI::App& command, const Mesh& mesh,
                  const nlohmann::ordered_json& report, const Progress& progress);

/// Writes indented JSON. `progress` hears of a pipe that nobody reads.
void write_json(const std::filesystem::path& path, const nlohmann::ordered_json& json,
                const Progress& progress = {});

}  // namespace brindle::tool
