#include "ranks/piece_source.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include "brindle/base/array_numbers.h"
#include "brindle/distributed/surface/rank_surface.h"
#include "brindle/distributed_pattern.h"
#include "brindle/files.h"
#include "ranks/piece_rows.h"
#include "ranks/request.h"

namespace brindle::tool {
namespace {

/// Rows of own vertices.
DataArray own_rows(const DistributedSurface& surface, const DataArray& array) {
  std::vector<Index> own;
  for (Index v = 0; v < surface.is_own().size(); ++v) {
    if (surface.is_own()[v] != 0) own.push_back(v);
  }
  return rows_of(array, own);
}

/// Own vertices and ghosts; rows with NaN are counted once, by the owner.
DataArray rows_of_nodes(const RankSurface& own, const DataArray& array) {
  const auto columns = static_cast<std::size_t>(array.components);
  const std::vector<double> rows = doubles_of(array.view());
  std::vector<double> of_nodes(columns * own.graph.node_count(),
                               std::numeric_limits<double>::quiet_NaN());
  for (std::size_t p = 0; p < own.vertex_of_piece.size(); ++p) {
    const Index v = own.vertex_of_piece[p];
    if (v < own.graph.own) std::copy_n(&rows[columns * p], columns, &of_nodes[columns * v]);
  }
  return make_data_array(array.name, array.components, of_nodes);
}

}  // namespace

PieceSource::PieceSource(Communicator& ranks, const DistributedSurface& surface,
                         const ReadPiece& read, const ArrayOptions& options,
                         const std::optional<Viewpoint>& viewpoint)
    : ranks_(ranks),
      surface_(surface),
      read_(read),
      options_(options),
      viewpoint_(viewpoint),
      waves_(surface, read.piece.mesh) {
  if (options.mesh.empty()) return;
  places_ = places();
  ArrayOptions of_whole = options;
  of_whole.max_distance =
      Length{options.max_distance.value_or(kDefaultMaxDistance).on(diagonal()), false};
  ranks.throw_on_all(
      [&] { other_ = std::make_unique<ArraySource>(places_, read.arrays, read.file, of_whole); });
}

/// The vertices, for functions that take rows vertex by vertex.
Surface PieceSource::places() const {
  const std::span<const Vec3> normals = surface_.normals();
  return {{mesh().positions, {}, mesh().origin}, nullptr, {normals.begin(), normals.end()}};
}

void PieceSource::check(const std::function<void()>& work) const {
  throw_usage_on_all(ranks_, work);
}

std::vector<DataArray> PieceSource::rows(const std::string& option, const std::string& file,
                                         const ReadRows& read) const {
  return piece_rows(ranks_, read_, option, file,
                    [&] { return read(surface_.own_vertex_count(), read_.vertex_of_row); });
}

std::size_t PieceSource::nonfinite_rows(const DataArray& array) const {
  return ranks_.sum(brindle::nonfinite_rows(own_rows(surface_, array)));
}

GlobeRadii PieceSource::globe_radii() const {
  GlobeRadii radii = brindle::globe_radii(mesh());
  for (const GlobeRadii& other : ranks_.all(radii)) {
    radii.nearest = std::min(radii.nearest, other.nearest);
    radii.farthest = std::max(radii.farthest, other.farthest);
  }
  return radii;
}

ArraySource::PerVertex PieceSource::array(const std::string& name) const {
  if (other_) {
    ArraySource::PerVertex result;
    ranks_.throw_on_all([&] { result = other_->array(name); });
    result.of_cells.reset();
    return result;
  }
  ArrayChoice choice;
  ranks_.throw_on_all([&] { choice = choice_of(read_.arrays, name, read_.file); });
  const DataArray& array = *choice.array;
  if (!choice.of_cells) return {array, nonfinite_rows(array), std::nullopt};
  return {cells_to_points(ranks_, read_.piece, array), ranks_.sum(brindle::nonfinite_rows(array)),
          array};
}

std::optional<std::size_t> PieceSource::drop_too_far(DirectionField& directions) const {
  if (!other_) return std::nullopt;
  const std::vector<std::uint8_t> counted = surface_.rank_surface().used_own();
  std::size_t count = 0;
  for (Index v = 0; v < directions.size(); ++v) {
    if (other_->is_near(v)) continue;
    directions[v] = Vec3::Zero();
    count += counted[v];
  }
  return ranks_.sum(count);
}

VertexValues PieceSource::values(const std::string& option, const std::string& text) const {
  VertexValues result;
  if (is_array(text)) {
    const DataArray found = array(parse_array(option, text)).array;
    ranks_.throw_on_all(
        [&] { result.values = scalar_values(option, found, mesh().vertex_count(), file()); });
    return result;
  }
  if (const std::string path = value_file(text); !path.empty()) {
    const DataArray found = rows(option, path, [&](std::size_t vertices, auto vertex_of_row) {
      const VertexValues read = csv_values(option, text, vertices, vertex_of_row);
      return std::vector<DataArray>{make_data_array(read.title, 1, read.values)};
    })[0];
    return {numbers_of(found.view(), option.c_str()), found.name};
  }
  if (text == "curvature") return {greatest_curvatures(surface_), text};
  ranks_.throw_on_all([&] {
    const Surface here = places();
    result = vertex_values(option, text,
                           {here, {}, file(), options_, {}, viewpoint_ ? &*viewpoint_ : nullptr});
  });
  return result;
}

DirectionField PieceSource::smooth_field(const SmoothFieldOptions& options, const Progress&) const {
  return smooth_direction_field(surface_, options);
}

DirectionField PieceSource::curvature_field(CurvatureDirection direction, const Progress&) const {
  return curvature_direction_field(surface_, direction);
}

std::vector<FieldStroke> PieceSource::strokes_of_file(const std::string& path) const {
  std::vector<double> numbers;
  ranks_.throw_on_all([&] {
    if (ranks_.rank() != 0) return;
    for (const FieldStroke& stroke : read_strokes(path)) {
      numbers.insert(numbers.end(),
                     {static_cast<double>(stroke.points.size()), stroke.radius, stroke.strength});
      for (const Eigen::Vector3d& p : stroke.points)
        numbers.insert(numbers.end(), p.begin(), p.end());
    }
  });
  numbers = ranks_.of_first(numbers);
  std::vector<FieldStroke> strokes;
  for (auto next = numbers.begin(); next != numbers.end();) {
    const auto count = static_cast<std::size_t>(*next++);
    FieldStroke& stroke = strokes.emplace_back();
    stroke.radius = *next++;
    stroke.strength = *next++;
    for (std::size_t i = 0; i < count; ++i, next += 3) {
      stroke.points.emplace_back(next[0], next[1], next[2]);
    }
  }
  return strokes;
}

std::vector<FieldAnchor> PieceSource::anchors(std::span<const FieldStroke> strokes,
                                              const Progress&) const {
  return stroke_anchors(surface_, strokes);
}

DirectionField PieceSource::vector_field(const DataArray& vectors, bool signs) const {
  DirectionField directions;
  check([&] { directions = direction_field_of(places(), vectors, signs); });
  return directions;
}

TensorField PieceSource::tensor_field(const DataArray& tensors, TensorAxis axis) const {
  const RankSurface& own = surface_.rank_surface();
  const auto nodes = static_cast<std::ptrdiff_t>(own.graph.node_count());
  const auto first = [&](const auto& all) {
    return std::vector<Vec3>(all.begin(), all.begin() + nodes);
  };
  TensorField field;
  ranks_.throw_on_all([&] {
    const Surface of_nodes{
        {first(own.mesh.positions), {}}, own.graph.adjacency, first(own.normals)};
    field = tensor_field_of(of_nodes, rows_of_nodes(own, tensors), axis);
  });
  field.directions.resize(own.vertex_count());
  own.exchange_all(std::span(field.directions));
  field.directions = own.to_piece(std::span<const Vec3>(field.directions));
  for (std::size_t TensorField::*count :
       {&TensorField::near_normal, &TensorField::isotropic, &TensorField::not_symmetric}) {
    field.*count = ranks_.sum(field.*count);
  }
  return field;
}

FrequencyField PieceSource::frequencies_by(const DataArray& values, float frequency,
                                           const FrequencyRange& range) const {
  return brindle::frequencies_by(surface_, values, frequency, range);
}

WaveMetrics PieceSource::measure(const WaveSet& waves) const {
  return measure_waves(surface_, waves);
}

}  // namespace brindle::tool
