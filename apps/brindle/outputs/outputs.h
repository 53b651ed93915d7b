/// Output files of all commands: planned before a long job, made, and written.
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "brindle/base/stopwatch.h"
#include "brindle/base/text.h"
#include "brindle/data_arrays.h"
#include "brindle/recipe/report.h"
#include "cli/job_listener.h"
#include "cli/progress_display.h"
#include "input/solving_options.h"
#include "input/surface_options.h"
#include "input/used_files.h"
#include "input/wave_options.h"
#include "pictures/picture.h"
#include "pictures/style_options.h"

namespace brindle::tool {

/// A line `wrote FILE (size)`.
void print_written(std::ostream& out, const std::filesystem::path& file);

/// The same for many files of one kind, as one line.
void print_written(std::ostream& out, std::span<const std::filesystem::path> files);

/// The content of a file. `lines`, `tubes`: of curves; `pieces`: a .pvtp over MPI ranks.
enum class OutputKind { picture, drawing, mesh, lines, tubes, samples, report, pieces };

struct Output {
  std::filesystem::path path;
  OutputKind kind;
  std::string option = "--output";                 ///< that gives it
  std::vector<std::filesystem::path> beside = {};  ///< further files, which are written with it
};
using Outputs = std::vector<Output>;

/// Whether one of the files has this kind.
bool has(const Outputs& outputs, OutputKind kind);

/// Whether there is a picture or a drawing.
bool draws(const Outputs& outputs);

/// The arguments of all commands that make patterns.
struct JobArguments {
  SurfaceOptions surface;
  WaveOptions waves;
  SolvingOptions solving;
  PictureOptions picture;
  std::vector<std::string> outputs;
  std::string report;
  bool quiet = false;
};

/// --output, --report and --quiet.
void add_output_options(CLI::App& app, JobArguments& arguments);

/// Input files of the surface, the field and the solver.
std::vector<UsedFile> job_inputs(const JobArguments& arguments);

/// The kind of a file of `brindle stripe`: .png a picture, .svg .pdf a drawing, .obj .ply .vtp
/// .gltf .glb a mesh, .json a report. Throws CLI::ValidationError for other extensions, and for
/// drawings that this build cannot write.
OutputKind planned_stripes(const std::filesystem::path& path);

/// Gives an output its kind, by its path; throws CLI::ValidationError for files that cannot be
/// written.
using PlanOutput = std::function<OutputKind(const std::filesystem::path& path)>;

/// Plans files by `plan`; `report` is one more unless it is empty. Reports are last. With a
/// texture, meshes may have files beside them (`textured_mesh_files`). Throws CLI::ValidationError
/// as `plan` and `check_files` do, Error for files that are not writable.
Outputs plan_outputs(const std::vector<UsedFile>& inputs, const std::vector<std::string>& paths,
                     const std::string& report, const PlanOutput& plan, bool texture = false);

/// All files, including those beside others.
std::vector<UsedFile> files_of(const Outputs& outputs);

void print_written(std::ostream& out, const Outputs& outputs);

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

/// Throws for wrong usage of --output: `path` cannot be written because of `why`.
[[noreturn]] void refuse_output(const std::filesystem::path& path, const std::string& why);

/// Throws CLI::ValidationError for a .pvtp, which ranks alone write.
void refuse_pieces(const std::vector<std::string>& outputs);

/// Rejects .pdf in builds without Cairo.
void check_drawing_file(const std::filesystem::path& path);

/// Writes a report after `invocation_of` the command and the kind of its surface.
void write_report(const std::filesystem::path& path, const CLI::App& command, const Mesh& mesh,
                  const nlohmann::ordered_json& report, const Progress& progress);

/// Writes indented JSON. `progress` can cancel a write to a blocked pipe.
void write_json(const std::filesystem::path& path, const nlohmann::ordered_json& json,
                const Progress& progress = {});

/// The joined own and input arrays (`join_arrays`) that the file can hold. Notes renamed arrays,
/// then left-out ones.
DataArrays fitted(const std::filesystem::path& path, DataArrays own, const DataArrays& input,
                  JobListener& listener);

/// The input arrays that a file of lines or samples can hold besides its `own` columns; of point
/// and triangle arrays with one name, those of points. Notes left-out arrays, then renamed ones.
DataArrays held_beside(std::span<const std::string> own, const std::filesystem::path& path,
                       const DataArrays& arrays, JobListener& listener);

/// The time for pictures, by `drawn`.
struct DrawingTime {
  std::optional<double> draw_milliseconds;

  void drawn(OutputKind kind, double milliseconds) {
    if (kind != OutputKind::picture) return;
    draw_milliseconds = draw_milliseconds.value_or(0) + milliseconds;
  }
};

/// Returns the result of `make(display)`, after `write(output, result, display)` for all files.
/// `stages` are those of `make`. `drawn(output.kind, milliseconds)` of the result receives the time
/// that each file took.
auto make_and_write(const CLI::App& command, const Outputs& outputs, bool quiet,
                    std::vector<JobStage> stages, const auto& make, const auto& write) {
  const auto writing = [](const Output& output) {
    return "writing " + shown(output.path.native());
  };
  ProgressDisplay display(quiet, &command);
  for (const Output& output : outputs) stages.push_back({writing(output), 2});
  display.plan(std::move(stages));
  auto result = make(display);
  for (const Output& output : outputs) {
    display.stage(writing(output));
    Stopwatch watch;
    write(output, result, display);
    result.drawn(output.kind, watch.lap());
  }
  return result;
}

}  // namespace brindle::tool
