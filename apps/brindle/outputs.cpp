#include "outputs.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <ostream>
#include <span>
#include <utility>

#include "brindle/base/file_extension.h"
#include "brindle/base/output_file.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/texture_coordinates.h"
#include "command_line.h"

namespace brindle::tool {
namespace {

Output plan_output(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  if (extension == ".png") {
    check_pictures_available();
    return {path, OutputKind::picture};
  }
  if (extension == ".json") return {path, OutputKind::report};
  for (const char* mesh : {".obj", ".ply", ".vtp", ".gltf", ".glb"}) {
    if (extension == mesh) return {path, OutputKind::mesh};
  }
  if (extension == ".stl" || extension == ".off") {
    refuse_output(path, "'" + extension +
                            "' has no place for phases or texture coordinates; use .ply, .vtp or "
                            ".glb");
  }
  refuse_output(path, "unknown extension '" + extension +
                          "'; use .png for a picture, .obj, .ply, .vtp, .gltf or .glb for a mesh, "
                          ".json for a report");
}

std::vector<float> phases_of(std::span<const Complex> z) {
  std::vector<float> phases;
  for (const Complex& value : z) phases.push_back(std::arg(value));
  return phases;
}

// Phase, direction and frequency of every vertex; `suffix` sets two sets of waves apart.
void add_waves(std::vector<DataArray>& arrays, const WaveSet& waves, std::span<const Complex> z,
               const std::string& suffix = "") {
  arrays.push_back(make_data_array("phase" + suffix, 1, phases_of(z)));
  arrays.push_back(make_data_array("direction" + suffix, waves.directions));
  arrays.push_back(make_data_array("frequency" + suffix, 1, waves.frequencies));
}

// 1 at the corners of triangles where a stripe begins or ends.
std::vector<float> branches_of(const Mesh& mesh, std::span<const CornerPhases> corners) {
  std::vector<float> flags(mesh.vertex_count());
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const TriangleKind kind = corners[t].kind;
    if (kind != TriangleKind::branch && kind != TriangleKind::field_singularity) continue;
    for (const Index vertex : mesh.triangles[t]) flags[vertex] = 1;
  }
  return flags;
}

// OBJ has no place for waves.
bool holds_waves(const std::filesystem::path& path) { return lower_extension(path) != ".obj"; }

void write_pattern_mesh(const std::filesystem::path& path, const Surface& surface,
                        const StripePattern& pattern, std::span<const Index> partners) {
  const bool points = surface.mesh.triangles.empty();
  std::vector<DataArray> arrays;
  if (points) arrays.push_back(make_data_array("normal", surface.normals));
  if (holds_waves(path)) {
    add_waves(arrays, pattern.waves, pattern.solution.z);
    if (!points) {
      arrays.push_back(make_data_array("branch", 1, branches_of(surface.mesh, pattern.corners)));
    }
  }
  copy_from_partners(arrays, partners);
  write_mesh(path, surface.mesh, arrays);
}

void add_carried_waves(std::vector<DataArray>& arrays, const TexturedMesh& textured,
                       const Mesh& mesh, const StripePattern& pattern, const std::string& suffix) {
  const auto [waves, z] = carried_waves(textured, pattern.waves, pattern.solution.z);
  add_waves(arrays, waves, z, suffix);
  std::vector<float> flags = carried_values(textured, branches_of(mesh, pattern.corners), 1);
  // A barycentre is at a branch if all corners are.
  for (float& flag : flags) flag = std::floor(flag);
  arrays.push_back(make_data_array("branch" + suffix, 1, flags));
}

DataArray normals_of(const Surface& surface, const TexturedMesh& textured) {
  const std::span<const float> numbers(reinterpret_cast<const float*>(surface.normals.data()),
                                       3 * surface.normals.size());
  return make_data_array("normal", 3, carried_values(textured, numbers, 3));
}

DataArray coordinates_of(const TexturedMesh& textured) {
  std::vector<float> numbers;
  for (const auto& uv : textured.coordinates) numbers.insert(numbers.end(), {uv.x(), uv.y()});
  return make_data_array("uv", 2, numbers);
}

void write_mesh_with_texture(const std::filesystem::path& path, const Surface& surface,
                             const Texture& texture, const PictureOptions& picture,
                             std::span<const Index> partners) {
  const TexturePattern& pattern = texture.pattern;
  const TexturedMesh textured =
      texture_coordinates(surface.mesh, pattern.waves, pattern.phase_shift);
  std::vector<DataArray> arrays = {normals_of(surface, textured), coordinates_of(textured)};
  if (holds_waves(path)) {
    add_carried_waves(arrays, textured, surface.mesh, pattern.u, "");
    add_carried_waves(arrays, textured, surface.mesh, pattern.v, "_v");
  }
  copy_from_partners(arrays, partners);
  write_textured_mesh(path, textured.mesh, arrays, tile_png(texture.tile, picture));
}

}  // namespace

void add_output_options(CLI::App& app, std::vector<std::string>& outputs, std::string& report,
                        bool& quiet) {
  app.add_option("-o,--output", outputs, "what to write, by extension; repeatable")
      ->type_name("FILE")
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);  // what follows is MESH
  app.add_option("--report", report, "write the report here")->type_name("FILE.json");
  app.add_flag("-q,--quiet", quiet, "print nothing but errors");
}

std::vector<Output> plan_outputs(const std::vector<std::string>& paths, const std::string& report,
                                 bool texture) {
  std::vector<Output> outputs;
  for (const std::string& path : paths) outputs.push_back(plan_output(path));
  for (const UsedFile& file : files_of(outputs, texture)) check_output_path(file.path);
  check_report("--report", report);
  if (!report.empty()) outputs.push_back({report, OutputKind::report, "--report"});
  std::stable_partition(outputs.begin(), outputs.end(),
                        [](const Output& output) { return output.kind != OutputKind::report; });
  return outputs;
}

std::vector<UsedFile> files_of(const std::vector<Output>& outputs, bool texture) {
  std::vector<UsedFile> files;
  for (const Output& output : outputs) {
    if (texture && output.kind == OutputKind::mesh) {
      for (const std::filesystem::path& path : textured_mesh_files(output.path)) {
        files.push_back({output.option, path, lower_extension(path) == ".png"});
      }
    } else {
      files.push_back({output.option, output.path});
    }
  }
  return files;
}

void refuse_picture_options(const CLI::App& command, std::string_view why) {
  refuse_given(command, {"--camera", "--up", "--size", "--colors", "--view", "--stripe-width"},
               why);
}

bool holds_points(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  return extension == ".ply" || extension == ".vtp";
}

void write_output(const Output& output, const Surface& surface, const StripeResult& result,
                  const Report& report, const PictureOptions& picture,
                  std::span<const Index> partners) {
  switch (output.kind) {
    case OutputKind::picture:
      return write_picture(output.path, surface, result, picture);
    case OutputKind::mesh:
      if (const Texture* texture = result.texture()) {
        return write_mesh_with_texture(output.path, surface, *texture, picture, partners);
      }
      return write_pattern_mesh(output.path, surface, result.stripes(), partners);
    case OutputKind::report:
      return write_json(output.path, to_json(report));
  }
}

void refuse_output(const std::filesystem::path& path, const std::string& why) {
  throw CLI::ValidationError("--output", "cannot write '" + path.string() + "': " + why);
}

void write_report(const std::filesystem::path& path, const CLI::App& command, const Mesh& mesh,
                  const nlohmann::ordered_json& report) {
  nlohmann::ordered_json json = invocation_of(command);
  json["kind"] = kind_of(mesh);
  json.update(report);
  write_json(path, json);
}

void write_json(const std::filesystem::path& path, const nlohmann::ordered_json& json) {
  write_file(path, [&](std::ostream& out) { out << json.dump(2) << '\n'; });
}

}  // namespace brindle::tool
