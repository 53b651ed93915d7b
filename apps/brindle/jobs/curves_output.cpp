#include "jobs/curves_output.h"

#include <utility>
#include <vector>

#include "brindle/base/file_names.h"
#include "brindle/base/output_file.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/feature_lines.h"
#include "brindle/files.h"
#include "brindle/mesh.h"
#include "brindle/mesh_data.h"
#include "jobs/curves_report.h"
#include "outputs/outputs.h"
#include "pictures/drawing_file.h"

namespace brindle::tool {

OutputKind planned_curves(const std::filesystem::path& path, bool tubes) {
  const std::string kind = lower_extension(path);
  if (kind == ".json") return OutputKind::report;
  if (is_drawing_file(path) || kind == ".png") {
    check_drawing_file(path);
    return is_drawing_file(path) ? OutputKind::drawing : OutputKind::picture;
  }
  const bool mesh = kind == ".gltf" || kind == ".glb";
  if (mesh && !tubes) {
    refuse_output(path, "brindle writes no lines into " + kind +
                            "; use .obj, .ply, .vtp or .csv, or ask for tubes with --tube-radius");
  }
  if (tubes && kind == ".csv") {
    refuse_output(path,
                  ".csv holds no tubes; use .obj, .ply, .vtp, .gltf or .glb, or leave out "
                  "--tube-radius");
  }
  if (mesh || is_polyline_format(path)) return tubes ? OutputKind::tubes : OutputKind::lines;
  refuse_output(path, "unknown extension '" + kind +
                          "'; use .obj, .ply, .vtp or .csv for lines, .gltf or .glb for tubes, "
                          ".svg or .pdf for a drawing, .png for a picture, .json for a report");
}

void write_tube_mesh(const std::filesystem::path& path, const std::vector<Ornament>& ornaments) {
  Mesh all;
  for (const Ornament& ornament : ornaments) append(ornament.mesh, all);
  if (all.triangles.empty())
    throw Error("cannot write '" + shown(path.native()) + "': there are no curves");
  write_mesh(path, all);
}

namespace {

// Columns and arrays of all formats, which input arrays must not replace.
const std::vector<std::string> kCurveColumns = {"kind",   "curve",    "closed",      "length",
                                                "normal", "triangle", "barycentric", "frequency"};

// Where each point is on the mesh, and what is there.
std::vector<DataArray> arrays_of(const std::vector<TrianglePoint>& places,
                                 const FrequencyField& frequencies, const Mesh& mesh,
                                 DataArrays input) {
  std::vector<Index> triangles;
  std::vector<float> barycentric;
  for (const TrianglePoint& place : places) {
    triangles.push_back(place.triangle);
    for (const double share : place.barycentric) barycentric.push_back(static_cast<float>(share));
  }
  std::vector<DataArray> arrays = {make_data_array("triangle", 1, triangles),
                                   make_data_array("barycentric", 3, barycentric)};
  input.points.insert(input.points.begin(), make_data_array("frequency", 1, frequencies));
  for (DataArray& array : arrays_at(places, mesh.triangles, input)) {
    arrays.push_back(std::move(array));
  }
  return arrays;
}

void write_lines(const std::filesystem::path& path, const TracedSurface& traced,
                 JobListener& listener) {
  const DataArrays input = held_beside(kCurveColumns, path, traced.arrays, listener);
  const Surface& surface = traced.surface;
  std::vector<NamedLines> lines;
  const auto add = [&](const std::string& name, const Polylines& named, const WaveSet& waves) {
    lines.push_back({name, named, arrays_of(named.places, waves.frequencies, surface.mesh, input)});
  };
  for (const CurveFamily& family : traced.families) {
    add(family.name, family.curves.lines, family.pattern.waves);
  }
  Polylines creases;
  if (traced.arguments.crease_deg) {
    creases = crease_lines(surface.mesh, surface.normals, *traced.arguments.crease_deg);
    add("creases", creases, traced.families.front().pattern.waves);
  }
  write_polylines(path, lines, listener.progress());
}

}  // namespace

void write_curves(const Output& output, const TracedSurface& traced, JobListener& listener) {
  const auto& [arguments, surface, arrays, families] = traced;
  const std::filesystem::path& path = output.path;
  std::vector<FamilyLines> lines;
  for (const CurveFamily& family : families) {
    lines.push_back({family.name, family.curves.lines, family.name == "v"});
  }
  switch (output.kind) {
    case OutputKind::lines:
      return write_lines(path, traced, listener);
    case OutputKind::tubes:
      return write_tube_mesh(path, tubes_of(arguments, surface.mesh, families));
    case OutputKind::drawing:
      return write_line_drawing(path, surface, lines, arguments.picture, listener.progress());
    case OutputKind::picture:
      return write_ornaments(path, surface, tubes_of(arguments, surface.mesh, families),
                             arguments.picture, listener.progress());
    default:
      throw Error(shown(path.native()) + ": holds no curves of one process");
  }
}

void write_curves_file(const Output& output, const CLI::App& command,
                       const CurvesArguments& arguments, const CurvesJob& job,
                       JobListener& listener) {
  const Preparation& prepared = job.prepared;
  if (output.kind == OutputKind::report) {
    return write_report(output.path, command, prepared.surface.mesh,
                        to_json(job, arguments.picture), listener.progress());
  }
  write_curves(output, {arguments, prepared.surface, prepared.arrays, job.families}, listener);
}

}  // namespace brindle::tool
