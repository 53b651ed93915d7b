#include "outputs/mesh_output.h"

#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <utility>

#include "brindle/base/array_rows.h"
#include "brindle/base/file_names.h"
#include "brindle/files.h"
#include "brindle/pattern_arrays.h"
#include "brindle/texture_coordinates.h"

namespace brindle::tool {
namespace {

// OBJ files cannot hold waves.
bool holds_waves(const std::filesystem::path& path) { return lower_extension(path) != ".obj"; }

bool is_gltf(const std::filesystem::path& path) {
  const std::string kind = lower_extension(path);
  return kind == ".gltf" || kind == ".glb";
}

// Triangle arrays of a pattern, for formats that can hold them.
void add_cells(std::vector<DataArray>& cells, const std::filesystem::path& path,
               const StripePattern& pattern, const std::string& suffix) {
  if (!holds_waves(path) || is_gltf(path)) return;
  cells.push_back(branches_in_triangles(pattern, "branch" + suffix));
  cells.push_back(corner_phases_of(pattern, "corner_phase" + suffix));
}

float missing_in(const std::filesystem::path& path) {
  return is_gltf(path) ? 0 : std::numeric_limits<float>::quiet_NaN();
}

void write_with_own_vertices(const std::filesystem::path& path, const MadeMesh& made,
                             JobListener& listener) {
  const Surface& surface = made.surface;
  const StripePattern& pattern = made.result.stripes();
  const bool points = surface.mesh.triangles.empty();
  DataArrays own;
  if (points) own.points.push_back(make_data_array("normal", surface.normals));
  if (holds_waves(path)) {
    add_waves(own.points, {pattern.waves, pattern.frequencies_wanted, pattern.solution.z, ""},
              missing_in(path),
              points ? std::vector<float>() : branches_at_vertices(surface.mesh, pattern.corners));
    if (!points) add_cells(own.cells, path, pattern, "");
    add_support(own.points, made.data.support);
  }
  copy_from_partners(own.points, made.data.partners);
  if (holds_waves(path)) {
    own.points.push_back(make_data_array("original_id", 1, made.data.original_ids));
    add_turn(own.points, made.data.turn_deg, surface.mesh.vertex_count());
  }
  const DataArrays arrays = fitted(path, std::move(own), without_turn(made.data.arrays), listener);
  write_mesh(path, surface.mesh, arrays.points, arrays.cells, listener.progress());
}

void write_with_coordinates(const std::filesystem::path& path, const MadeMesh& made,
                            const PictureOptions& picture, JobListener& listener) {
  const Texture* texture = made.result.texture();
  const Progress coordinates = listener.progress().part(0, 0.5);
  const Progress writing = listener.progress().part(0.5, 1);
  const TexturedMesh textured =
      texture != nullptr ? texture_coordinates(made.surface, texture->pattern, coordinates)
                         : texture_coordinates(made.surface, made.result.stripes(),
                                               made.phase_shift, false, coordinates);
  std::vector<NamedPattern> patterns;
  if (holds_waves(path)) {
    patterns.push_back({made.result.stripes(), ""});
    if (texture != nullptr) patterns.push_back({texture->pattern.v, "_v"});
  }
  DataArrays own = textured_arrays(textured, made.surface, patterns, missing_in(path));
  if (texture != nullptr) {
    const auto broken = texture->broken(made.surface.mesh);
    if (broken) own.cells.push_back(broken_in_triangles(textured, *broken));
  }
  if (is_gltf(path)) own.cells.clear();
  if (holds_waves(path)) add_support(own.points, carried_support(textured, made.data.support));
  copy_from_partners(own.points, made.data.partners);
  if (holds_waves(path)) {
    own.points.push_back(carried_ids(textured, made.data.original_ids));
    add_turn(own.points, made.data.turn_deg, textured.mesh.vertex_count());
  }
  const DataArrays input = carried_arrays(textured, without_turn(made.data.arrays));
  const DataArrays arrays = fitted(path, std::move(own), input, listener);
  if (texture == nullptr) {
    return write_mesh(path, textured.mesh, arrays.points, arrays.cells, writing);
  }
  write_textured_mesh(path, textured.mesh, arrays.points, tile_png(texture->tile, picture),
                      arrays.cells, writing);
}

}  // namespace

bool holds_cells(const std::filesystem::path& path) { return holds_waves(path) && !is_gltf(path); }

InputData take_input_data(Preparation& prepared) {
  return {std::move(prepared.arrays), std::move(prepared.original_ids),
          std::move(prepared.partners), prepared.turn_deg, std::move(prepared.support)};
}

InputData on_cross_texture(const InputData& data, std::span<const Triangle> triangles,
                           const CrossCover& cover) {
  InputData result{{},
                   data.original_ids,
                   data.partners,
                   data.turn_deg,
                   with_barycentres(data.support, triangles, cover.singular)};
  const auto vertices = static_cast<Index>(data.original_ids.size());
  std::vector<RowBlend> points;
  for (Index v = 0; v < vertices; ++v) points.push_back({{v, v, v}, {1, 0, 0}});
  std::vector<Index> cells = cover.base;
  for (const Index t : cover.singular) {
    constexpr double kThird = 1.0 / 3;
    points.push_back({triangles[t], {kThird, kThird, kThird}});
    cells.insert(cells.end(), 3, t);
    result.original_ids.push_back(-1);
  }
  result.arrays = {blended(data.arrays.points, points), rows_of(data.arrays.cells, cells)};
  return result;
}

void write_made_mesh(const std::filesystem::path& path, const MadeMesh& made,
                     const PictureOptions& picture, JobListener& listener) {
  if (made.uv || made.result.texture() != nullptr) {
    return write_with_coordinates(path, made, picture, listener);
  }
  write_with_own_vertices(path, made, listener);
}

}  // namespace brindle::tool
