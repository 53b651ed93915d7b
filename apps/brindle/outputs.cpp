#include "outputs.h"

#include <algorithm>
#include <cctype>
#include <complex>
#include <ostream>
#include <span>

#include "brindle/base/error.h"
#include "brindle/base/output_file.h"
#include "brindle/surface/mesh_io.h"

namespace brindle::tool {
namespace {

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

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
  throw Error("cannot write '" + path.string() + "': unknown extension '" + extension +
              "'; use .png for a picture, .obj, .ply, .vtp, .gltf or .glb for a mesh, .json for "
              "a report");
}

VertexAttribute directions_of(const WaveSet& waves) {
  VertexAttribute attribute{"direction", 3, {}};
  for (const Vec3& direction : waves.directions) {
    attribute.values.insert(attribute.values.end(), direction.begin(), direction.end());
  }
  return attribute;
}

VertexAttribute phases_of(const PhaseSolution& solution) {
  VertexAttribute attribute{"phase", 1, {}};
  for (const Complex& z : solution.z) attribute.values.push_back(std::arg(z));
  return attribute;
}

// 1 at the corners of triangles where a stripe begins or ends.
VertexAttribute branches_of(const Mesh& mesh, std::span<const CornerPhases> corners) {
  VertexAttribute attribute{"branch", 1, std::vector<float>(mesh.vertex_count())};
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const TriangleKind kind = corners[t].kind;
    if (kind != TriangleKind::branch && kind != TriangleKind::field_singularity) continue;
    for (const Index vertex : mesh.triangles[t]) attribute.values[vertex] = 1;
  }
  return attribute;
}

// OBJ has no place for attributes.
void write_pattern_mesh(const std::filesystem::path& path, const Mesh& mesh,
                        const StripePattern& pattern) {
  std::vector<VertexAttribute> attributes;
  if (lower_extension(path) != ".obj") {
    attributes = {phases_of(pattern.solution),
                  directions_of(pattern.waves),
                  {"frequency", 1, pattern.waves.frequencies},
                  branches_of(mesh, pattern.corners)};
  }
  write_mesh(path, mesh, attributes);
}

}  // namespace

void add_output_options(CLI::App& app, std::vector<std::string>& outputs, std::string& report,
                        bool& quiet) {
  app.add_option("-o,--output", outputs, "what to write, by extension; repeatable")
      ->type_name("FILE")
      ->expected(1)
      ->take_all();
  app.add_option("--report", report, "write the report here")->type_name("FILE.json");
  app.add_flag("-q,--quiet", quiet, "print nothing but errors");
}

std::vector<Output> plan_outputs(const std::vector<std::string>& paths) {
  std::vector<Output> outputs;
  for (const std::string& path : paths) {
    outputs.push_back(plan_output(path));
    check_output_path(path);
  }
  return outputs;
}

Output plan_report(const std::string& path) {
  check_output_path(path);
  return {path, OutputKind::report};
}

void write_output(const Output& output, const Surface& surface, const StripePattern& pattern,
                  const Report& report, const PictureOptions& picture) {
  switch (output.kind) {
    case OutputKind::picture:
      return write_picture(output.path, surface, pattern, picture);
    case OutputKind::mesh:
      return write_pattern_mesh(output.path, surface.mesh, pattern);
    case OutputKind::report:
      return write_json(output.path, to_json(report));
  }
}

void write_json(const std::filesystem::path& path, const nlohmann::ordered_json& json) {
  write_file(path, [&](std::ostream& out) { out << json.dump(2) << '\n'; });
}

}  // namespace brindle::tool
