#include "outputs/outputs.h"

#include <algorithm>
#include <cstdint>
#include <ostream>
#include <string>
#include <utility>

#include "brindle/base/file_names.h"
#include "brindle/base/output_file.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/pattern_arrays.h"
#include "brindle/recipe/json_text.h"
#include "cli/command_line.h"
#include "input/vertex_values.h"
#include "pictures/drawing_file.h"

namespace brindle::tool {
namespace {

namespace fs = std::filesystem;

// 0 for a device.
std::uintmax_t size_of(const fs::path& file) {
  std::error_code error;
  const std::uintmax_t size = fs::file_size(file, error);
  return error ? 0 : size;
}

std::string readable(std::uintmax_t size) {
  const auto bytes = static_cast<double>(size);
  if (bytes < 1e3) return formatted("%.0f bytes", bytes);
  if (bytes < 1e6) return formatted("%.1f kB", 1e-3 * bytes);
  if (bytes < 1e9) return formatted("%.1f MB", 1e-6 * bytes);
  return formatted("%.1f GB", 1e-9 * bytes);
}

}  // namespace

void print_written(std::ostream& out, const fs::path& file) {
  print_written(out, std::span(&file, 1));
}

void print_written(std::ostream& out, std::span<const fs::path> files) {
  if (files.empty()) return;
  std::uintmax_t size = 0;
  for (const fs::path& file : files) size += size_of(file);
  out << "wrote " << shown(files.front().native());
  if (files.size() == 1 && is_device(files.front())) {
    out << '\n';
    return;
  }
  if (files.size() > 1) out << " to " << shown(files.back().native());
  out << " (" << (files.size() > 1 ? formatted("%zu files, ", files.size()) : "") << readable(size)
      << ")\n";
}

OutputKind planned_stripes(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  if (extension == ".png") return OutputKind::picture;
  if (is_drawing_file(path)) {
    check_drawing_file(path);
    return OutputKind::drawing;
  }
  if (extension == ".json") return OutputKind::report;
  for (const char* mesh : {".obj", ".ply", ".vtp", ".gltf", ".glb"}) {
    if (extension == mesh) return OutputKind::mesh;
  }
  if (extension == ".stl" || extension == ".off") {
    refuse_output(path, "'" + extension +
                            "' has no place for phases or texture coordinates; use .ply, .vtp or "
                            ".glb");
  }
  refuse_output(
      path, "unknown extension '" + extension +
                "'; use .png for a picture, .svg or .pdf for a drawing, .obj, .ply, .vtp, .gltf "
                "or .glb for a mesh, "
                ".json for a report");
}

void check_drawing_file(const std::filesystem::path& path) {
  const std::string why = drawing_refusal(path);
  if (!why.empty()) refuse_output(path, why);
}

void add_output_options(CLI::App& app, JobArguments& arguments) {
  app.add_option("-o,--output", arguments.outputs)
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);  // what follows is MESH
  app.add_option("--report", arguments.report);
  app.add_flag("-q,--quiet", arguments.quiet);
}

std::vector<UsedFile> job_inputs(const JobArguments& arguments) {
  std::vector<UsedFile> inputs = input_files(arguments.surface, arguments.waves);
  add_slack_files(arguments.solving.slack, inputs);
  return inputs;
}

bool has(const Outputs& outputs, OutputKind kind) {
  return std::ranges::find(outputs, kind, &Output::kind) != outputs.end();
}

bool draws(const Outputs& outputs) {
  return has(outputs, OutputKind::picture) || has(outputs, OutputKind::drawing);
}

Outputs plan_outputs(const std::vector<UsedFile>& inputs, const std::vector<std::string>& paths,
                     const std::string& report, const PlanOutput& plan, bool texture) {
  Outputs outputs;
  for (const std::string& path : paths) {
    Output& output = outputs.emplace_back(Output{path, plan(path)});
    if (!texture || output.kind != OutputKind::mesh) continue;
    output.beside = textured_mesh_files(path);
    output.beside.pop_back();  // itself
  }
  for (const UsedFile& file : files_of(outputs)) check_output_path(file.path);
  check_report("--report", report);
  if (!report.empty()) outputs.push_back({report, OutputKind::report, "--report"});
  check_files(inputs, files_of(outputs));
  std::stable_partition(outputs.begin(), outputs.end(),
                        [](const Output& output) { return output.kind != OutputKind::report; });
  return outputs;
}

std::vector<UsedFile> files_of(const Outputs& outputs) {
  std::vector<UsedFile> files;
  for (const Output& output : outputs) {
    for (const std::filesystem::path& path : output.beside) {
      files.push_back({output.option, path, lower_extension(path) == ".png"});
    }
    files.push_back({output.option, output.path});
  }
  return files;
}

void print_written(std::ostream& out, const Outputs& outputs) {
  for (const UsedFile& file : files_of(outputs)) print_written(out, file.path);
}

void refuse_light_option(const CLI::App& command, const WaveOptions& waves, std::string_view why) {
  if (!depends_on_light(waves.arrays.frequency_by)) refuse_given(command, {"--light-from"}, why);
}

void check_light_option(const CLI::App& command, const StyleOptions& style,
                        const WaveOptions& waves) {
  if (!style.flat || style.follows_light()) return;
  refuse_light_option(command, waves, "--flat draws without light; leave it out");
}

void refuse_camera_options(const CLI::App& command, const WaveOptions& waves,
                           std::string_view why) {
  refuse_light_option(command, waves, why);
  refuse_given(command, {"--slice"}, why);
  if (depends_on_camera(waves.arrays.frequency_by)) return;
  refuse_given(command, {"--camera", "--projection", "--size", "--scale"}, why);
  if (!depends_on_up(waves.arrays.frequency_by)) refuse_given(command, {"--up"}, why);
}

void refuse_picture_options(const CLI::App& command, const WaveOptions& waves,
                            std::string_view why) {
  refuse_camera_options(command, waves, why);
  refuse_given(command, {"--quality", "--colors", "--view", "--stripe-width"}, why);
}

bool holds_points(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  return extension == ".ply" || extension == ".vtp";
}

void refuse_output(const std::filesystem::path& path, const std::string& why) {
  throw CLI::ValidationError("--output", "cannot write '" + shown(path.native()) + "': " + why);
}

void refuse_pieces(const std::vector<std::string>& outputs) {
  for (const std::string& path : outputs) {
    if (lower_extension(path) != ".pvtp") continue;
    refuse_output(path, "it has a piece per MPI rank; start brindle by mpirun, or write .vtp");
  }
}

void write_report(const std::filesystem::path& path, const CLI::App& command, const Mesh& mesh,
                  const nlohmann::ordered_json& report, const Progress& progress) {
  nlohmann::ordered_json json = invocation_of(command);
  json["kind"] = kind_of(mesh);
  json.update(report);
  write_json(path, json, progress);
}

void write_json(const std::filesystem::path& path, const nlohmann::ordered_json& json,
                const Progress& progress) {
  write_file(
      path, [&](OutputStream& out) { out << json_text(json, 2) << '\n'; }, progress);
}

namespace {

void note(const std::vector<std::string>& sentences, JobListener& listener) {
  for (const std::string& sentence : sentences) listener.note(sentence + "\n");
}

}  // namespace

DataArrays fitted(const std::filesystem::path& path, DataArrays own, const DataArrays& input,
                  JobListener& listener) {
  std::vector<std::string> notes;
  FittedArrays result = fitted_arrays(path, join_arrays(std::move(own), input, notes));
  note(notes, listener);
  note(result.left_out, listener);
  return std::move(result.arrays);
}

DataArrays held_beside(std::span<const std::string> own, const std::filesystem::path& path,
                       const DataArrays& arrays, JobListener& listener) {
  DataArrays held;
  const bool replaced = hold_pattern(arrays.points);
  const auto add = [&](std::vector<DataArray>& to, const std::vector<DataArray>& from) {
    for (auto& [array, renamed] : arrays_beside(own, from, replaced)) {
      if (find_array(held.points, array.name) != nullptr) continue;
      const std::vector<std::string> why = fitted_arrays(path, {{array}, {}}).left_out;
      note(why, listener);
      if (!why.empty()) continue;
      if (!renamed.empty()) note({renamed}, listener);
      to.push_back(std::move(array));
    }
  };
  add(held.points, arrays.points);
  add(held.cells, arrays.cells);
  return held;
}

}  // namespace brindle::tool
