#include <limits>

#include <pybind11/stl.h>

#include "arrays.h"
#include "brindle/base/array_rows.h"
#include "brindle/error.h"
#include "brindle/pattern_arrays.h"
#include "brindle/recipe/json_text.h"
#include "brindle/texture_coordinates.h"
#include "brindle/threads.h"
#include "job.h"
#include "pattern_data.h"
#include "stored.h"

namespace brindle::python {
namespace {

std::optional<FrequencyField> crossing_frequencies(const SurfaceData& surface, py::handle stripes,
                                                   py::handle frequency) {
  const Mesh& mesh = surface.surface.mesh;
  if (!frequency.is_none()) {
    const Table table = table_of(frequency, "frequency[1]");
    if (!table.is_number) check_rows(table.array, mesh, "frequency[1]");
    const std::vector<float> numbers = numbers_of(table.view, "frequency[1]");
    return table.is_number ? constant_frequency_field(numbers.front(), mesh.vertex_count())
                           : numbers;
  }
  if (stripes.is_none()) return std::nullopt;
  const Table table = table_of(stripes, "stripes[1]");
  if (!table.is_number)
    throw Error("stripes[1]: expected one number; frequency[1] may be an array");
  const float count = numbers_of(table.view, "stripes[1]").front();
  return constant_frequency_field(frequency_of_stripes(count, bounding_box(mesh).diagonal()),
                                  mesh.vertex_count());
}

TexturePointer texture(const SurfacePointer& surface, py::handle directions, py::handle count,
                       py::handle frequency, py::handle count_v, py::handle frequency_v,
                       bool oriented, const FieldOrigin& origin, const Solving& solving,
                       const py::object& progress) {
  if (surface->is_points()) throw Error("points have no triangles to lay a texture on");
  WavesIn in = waves_of_arrays(*surface, directions, count, frequency, origin);
  PatternRequest request{PatternKind::texture, solving.stripes, solving.fabrication};
  request.frequencies_v =
      crossing_frequencies(*surface, count_v, frequency_v).value_or(FrequencyField());
  request.oriented = oriented;
  if (origin.frequency_smoothing.periods > 0 && !frequency_v.is_none() &&
      !table_of(frequency_v, "frequency[1]").is_number) {
    request.frequencies_v =
        seen_frequencies(surface->surface, std::move(request.frequencies_v), origin).frequencies;
  }
  return Job(progress, solving.threads).run([&](const Progress& reports) {
    const Solver solver = request.solving.solver.solver;
    PatternResult laid = pattern_of(surface->surface, std::move(in.waves), request, reports);
    TexturePattern& pattern = std::get<TexturePattern>(laid.of);
    auto made = std::make_shared<TextureData>();
    const brindle::Report report =
        brindle::make_report(surface->surface, in.prepared, laid, solver);
    made->report = brindle::to_json(report);
    made->surface = surface;
    made->cancelled_branches = laid.fabrication.cancelled_branches;
    made->metrics = in.prepared.metrics;
    made->quality = report.quality;
    made->phase_shift = pattern.phase_shift;
    made->waves = std::move(pattern.waves);
    made->u = stripes_data(surface, std::move(pattern.u), in.prepared, solver);
    made->v = stripes_data(surface, std::move(pattern.v), in.prepared, solver);
    return made;
  });
}

// Rows of the original surface's arrays, for triangles and barycentres of the texture's.
DataArrays split_arrays(const SurfaceData& from, const CrossCover& cover,
                        std::span<const Index> triangle_origins) {
  std::vector<RowBlend> points;
  for (Index v = 0; v < from.surface.mesh.vertex_count(); ++v) {
    points.push_back({{v, v, v}, {1, 0, 0}});
  }
  constexpr double kThird = 1.0 / 3;
  for (const Index t : cover.singular) {
    points.push_back({from.surface.mesh.triangles[t], {kThird, kThird, kThird}});
  }
  return {blended(from.arrays.points, points), rows_of(from.arrays.cells, triangle_origins)};
}

// Every entry twice, for the two nodes of a vertex.
std::vector<float> doubled(const std::vector<float>& values) {
  std::vector<float> twice;
  for (const float value : values) twice.insert(twice.end(), 2, value);
  return twice;
}

// The surface's data for the nodes of its double cover: two per vertex.
SurfacePointer cover_data(const SurfaceData& from, const CrossCover& cover, Surface&& surface) {
  auto data = std::make_shared<SurfaceData>();
  data->name = from.name;
  std::vector<Index> vertex_of_node, base = cover.base;
  for (Index v = 0; v < from.surface.mesh.vertex_count(); ++v) {
    vertex_of_node.insert(vertex_of_node.end(), 2, v);
    data->original_ids.insert(data->original_ids.end(), 2, from.original_ids[v]);
  }
  base.insert(base.end(), cover.base.begin(), cover.base.end());
  data->arrays = {rows_of(from.arrays.points, vertex_of_node), rows_of(from.arrays.cells, base)};
  for (const Index partner : from.partners) {
    data->partners.insert(data->partners.end(), {2 * partner, 2 * partner + 1});
  }
  data->surface = std::move(surface);
  return data;
}

TexturePointer crosses(const SurfacePointer& surface, py::handle directions, py::handle count,
                       py::handle frequency, const FieldOrigin& origin, const Solving& solving,
                       const py::object& progress) {
  if (surface->is_points()) throw Error("points have no triangles to lay crosses on");
  WavesIn in = waves_of_arrays(*surface, directions, count, frequency, origin);
  return Job(progress, solving.threads).run([&](const Progress& reports) {
    const StripeOptions& options = solving.stripes;
    PatternResult laid = pattern_of(surface->surface, std::move(in.waves),
                                    {PatternKind::crosses, options, solving.fabrication}, reports);
    auto& [cross, texture] = std::get<CrossResult>(laid.of);
    auto made = std::make_shared<TextureData>();
    const brindle::Report report =
        brindle::make_report(surface->surface, in.prepared, laid, options.solver.solver);
    made->report = brindle::to_json(report);
    made->cancelled_branches = laid.fabrication.cancelled_branches;
    made->metrics = in.prepared.metrics;
    made->quality = report.quality;
    made->phase_shift = options.phase_shift;
    made->waves = std::move(texture.pattern.waves);
    made->triangle_origins = cross.cover.base;
    for (const Index t : cross.cover.singular) {
      made->triangle_origins.insert(made->triangle_origins.end(), 3, t);
    }
    made->surface = std::make_shared<SurfaceData>();
    made->surface->name = surface->name;
    made->surface->arrays = split_arrays(*surface, cross.cover, made->triangle_origins);
    made->surface->surface = std::move(texture.surface);
    made->surface->partners = surface->partners;
    made->surface->original_ids = surface->original_ids;
    made->surface->original_ids.resize(made->surface->surface.mesh.vertex_count(), -1);
    brindle::PreparationMetrics on_cover = in.prepared;
    on_cover.support = {doubled(in.prepared.support.coherence),
                        doubled(in.prepared.support.filled)};
    made->cover = stripes_data(cover_data(*surface, cross.cover, std::move(cross.surface)),
                               std::move(cross.pattern), on_cover, options.solver.solver);
    in.prepared.support = brindle::with_barycentres(
        std::move(in.prepared.support), surface->surface.mesh.triangles, cross.cover.singular);
    made->u = stripes_data(made->surface, std::move(texture.pattern.u), in.prepared,
                           options.solver.solver);
    made->v = stripes_data(made->surface, std::move(texture.pattern.v), in.prepared,
                           options.solver.solver);
    made->singular = std::move(cross.cover.singular);
    return made;
  });
}

py::array corner_uv(const TextureData& data) {
  std::vector<float> uv =
      without_lock([&] { return corner_texture_coordinates(data.waves, data.phase_shift); });
  return owned<float>(std::move(uv), {static_cast<py::ssize_t>(data.waves.triangle_count()), 3, 2});
}

// A mesh with texture coordinates, for Python.
struct TexturedData {
  TexturedMesh textured;
  SurfacePointer from;
  std::vector<std::pair<StripesPointer, std::string>> patterns;  ///< with the suffix of each
};

std::shared_ptr<TexturedData> textured_mesh(const TextureData& data) {
  return until_interrupted([&](const Progress& progress) {
    return std::make_shared<TexturedData>(TexturedData{
        texture_coordinates(data.surface->surface.mesh, data.waves, data.phase_shift, progress),
        data.surface,
        {{data.u, ""}, {data.v, "_v"}}});
  });
}

std::shared_ptr<TexturedData> textured_stripes(const StripesPointer& data) {
  if (data->surface->is_points()) throw Error("points have no triangles, and so no coordinates");
  return until_interrupted([&](const Progress& progress) {
    return std::make_shared<TexturedData>(
        TexturedData{texture_coordinates(data->surface->surface, data->pattern,
                                         data->pattern.phase_shift, false, progress),
                     data->surface,
                     {{data, ""}}});
  });
}

// The patterns' arrays, then the surface's with other names.
py::tuple textured_arrays_of(const TexturedData& data) {
  DataArrays own = without_lock([&] {
    std::vector<brindle::NamedPattern> patterns;
    for (const auto& [stripes, suffix] : data.patterns) {
      patterns.push_back({stripes->pattern, suffix});
    }
    DataArrays arrays = brindle::textured_arrays(data.textured, data.from->surface, patterns,
                                                 std::numeric_limits<float>::quiet_NaN());
    if (!data.patterns.empty()) {
      const FieldSupport& support = data.patterns.front().first->prepared.support;
      brindle::add_support(arrays.points, brindle::carried_support(data.textured, support));
    }
    copy_from_partners(arrays.points, data.from->partners);
    arrays.points.push_back(brindle::carried_ids(data.textured, data.from->original_ids));
    if (!data.patterns.empty()) {
      brindle::add_turn(arrays.points, data.patterns.front().first->prepared.turn_deg,
                        data.textured.mesh.vertex_count());
    }
    return arrays;
  });
  DataArrays input = carried_arrays(data.textured, brindle::without_turn(data.from->arrays));
  const auto joined = [](std::vector<DataArray>& first, std::vector<DataArray>& second) {
    py::dict arrays = dict_owning(std::move(first));
    for (const auto& [name, array] : dict_owning(std::move(second))) {
      if (!arrays.contains(name)) arrays[name] = array;
    }
    return arrays;
  };
  return py::make_tuple(joined(own.points, input.points), joined(own.cells, input.cells));
}

void bind_textured(py::module_& module) {
  py::class_<TexturedData, std::shared_ptr<TexturedData>> type(module, "TexturedMesh");
  def_rows(
      type, "local_vertices",
      [](const auto& data) -> auto& { return data.textured.mesh.positions; });
  def_rows(
      type, "faces", [](const auto& data) -> auto& { return data.textured.mesh.triangles; });
  def_rows(
      type, "uv", [](const auto& data) -> auto& { return data.textured.coordinates; });
  def_rows(
      type, "vertex_origins", [](const auto& data) -> auto& { return data.textured.origins; });
  def_rows(
      type, "face_origins",
      [](const auto& data) -> auto& { return data.textured.triangle_origins; });
  type.def_property_readonly("origin",
                             [](const TexturedData& data) {
                               const Eigen::Vector3d& origin = data.textured.mesh.origin;
                               return py::make_tuple(origin.x(), origin.y(), origin.z());
                             })
      .def("arrays", textured_arrays_of);
}

}  // namespace

void bind_textures(py::module_& module) {
  bind_textured(module);
  py::class_<TextureData, TexturePointer> type(module, "Texture");
  bind_pickle(type);
  def_rows(
      type, "face_origins", [](const auto& data) -> auto& { return data.triangle_origins; });
  def_rows(
      type, "singular_faces", [](const auto& data) -> auto& { return data.singular; });
  type.def_readonly("surface", &TextureData::surface)
      .def_property_readonly(
          "u", [](const TextureData& data) { return data.is_cross() ? nullptr : data.u; })
      .def_property_readonly(
          "v", [](const TextureData& data) { return data.is_cross() ? nullptr : data.v; })
      .def_readonly("double_cover", &TextureData::cover)
      .def_property_readonly("is_cross", &TextureData::is_cross)
      .def("cancelled_branches",
           [](const TextureData& data) { return cancelled_branches_of(data.cancelled_branches); })
      .def("corner_uv", corner_uv)
      .def("mesh", textured_mesh)
      .def(
          "warnings",
          [](const TextureData& data, const std::string& source) {
            return brindle::warnings(data.metrics, source) +
                   brindle::quality_warning(data.metrics, data.quality,
                                            data.surface->surface.mesh.triangle_count());
          },
          py::arg("source"))
      .def(
          "report",
          [](const TextureData& data, const std::string& invocation) {
            nlohmann::ordered_json json = nlohmann::ordered_json::parse(invocation);
            json.update(data.report);
            return brindle::json_text(json);
          },
          py::arg("invocation"));
  module.def("texture", texture, py::arg("surface").none(false), py::arg("directions"),
             py::arg("stripes"), py::arg("frequency"), py::arg("stripes_v"), py::arg("frequency_v"),
             py::arg("oriented"), py::arg("origin"), py::arg("solving"), py::arg("progress"));
  module.def("crosses", crosses, py::arg("surface").none(false), py::arg("directions"),
             py::arg("stripes"), py::arg("frequency"), py::arg("origin"), py::arg("solving"),
             py::arg("progress"));
  module.def("textured_stripes", textured_stripes, py::arg("stripes"));
}

}  // namespace brindle::python
