#include "ranks/piece_fields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "brindle/array_field.h"
#include "brindle/base/array_numbers.h"
#include "brindle/base/array_rows.h"
#include "brindle/distributed/surface/rank_surface.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/progress.h"
#include "brindle/recipe/field_data.h"
#include "brindle/strokes.h"
#include "brindle/tensor_field.h"
#include "brindle/waves/frequency_parts.h"
#include "input/csv_field.h"
#include "ranks/first_rank.h"
#include "ranks/piece_rows.h"

namespace brindle::tool {
namespace {

/// The partition as a Surface, for functions that take rows vertex by vertex.
Surface with_normals(const DistributedSurface& surface, const ReadPiece& read) {
  const std::span<const Vec3> normals = surface.normals();
  return {{read.piece.mesh.positions, {}}, nullptr, {normals.begin(), normals.end()}};
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

/// Directions are aligned within a rank; ghosts have the owner's.
PieceField tensor_field(Communicator& ranks, const DistributedSurface& surface,
                        const DataArray& array, const ArrayOptions& options) {
  const RankSurface& own = surface.rank_surface();
  const auto nodes = static_cast<std::ptrdiff_t>(own.graph.node_count());
  const auto first = [&](const auto& all) {
    return std::vector<Vec3>(all.begin(), all.begin() + nodes);
  };
  TensorField tensor;
  ranks.throw_on_all([&] {
    const Surface of_nodes{
        {first(own.mesh.positions), {}}, own.graph.adjacency, first(own.normals)};
    tensor = tensor_field_of(of_nodes, rows_of_nodes(own, array),
                             options.tensor.value_or(TensorAxis::major));
  });
  tensor.directions.resize(own.vertex_count());
  own.exchange_all(std::span(tensor.directions));
  PieceField field;
  field.directions = own.to_piece(std::span<const Vec3>(tensor.directions));
  field.missing.tensor =
      MissingTensorWaves{ranks.sum(tensor.near_normal), ranks.sum(tensor.isotropic)};
  if (!options.tensor) {
    field.notes += "the array '" + array.name +
                   "' is a tensor: waves run along its major axis; --tensor chooses\n";
  }
  if (const std::size_t count = ranks.sum(tensor.not_symmetric); count > 0) {
    field.notes += "at " + std::to_string(count) + " vertices the tensor '" + array.name +
                   "' is not symmetric: its symmetric part counts\n";
  }
  return field;
}

[[noreturn]] void refuse_tensor(const std::string& why) {
  throw CLI::ValidationError("--tensor", "has no effect here: " + why);
}

PieceField array_field(Communicator& ranks, const DistributedSurface& surface,
                       const ReadPiece& read, const DataArray& given, const WaveOptions& options) {
  DataArray array;
  together_as_used(ranks, [&] { array = ordered_array(given, options.arrays); });
  PieceField field;
  if (is_tensor(array)) field = tensor_field(ranks, surface, array, options.arrays);
  field.data.array = array;
  if (is_tensor(array)) return field;
  together_as_used(ranks, [&] {
    if (options.arrays.tensor) {
      refuse_tensor("the array '" + array.name + "' has " + std::to_string(array.components) +
                    " numbers in a row, and is no tensor");
    }
    field.directions = direction_field_of(with_normals(surface, read), array, has_signs(options));
  });
  return field;
}

/// Named columns: the field, and frequencies if there are any.
PieceField columns_field(Communicator& ranks, const DistributedSurface& surface,
                         const ReadPiece& read, const WaveOptions& options,
                         const std::vector<DataArray>& columns) {
  PieceField field = array_field(ranks, surface, read, columns[0], options);
  field.rows_nonfinite = ranks.sum(nonfinite_rows(own_rows(surface, columns[0])));
  if (columns.size() == 1) return field;
  ranks.throw_on_all([&] { field.frequencies = frequencies_of(columns[1], field.directions); });
  field.may_have_gaps = true;
  return field;
}

/// Unnamed columns: vectors, then frequencies.
PieceField rows_field(Communicator& ranks, const DistributedSurface& surface,
                      const std::vector<DataArray>& columns) {
  PieceField field;
  field.data.array = columns[0];
  field.directions =
      tangent_directions(vectors_of(columns[0].view(), "vectors"), surface.normals());
  field.rows_nonfinite = ranks.sum(nonfinite_rows(own_rows(surface, columns[0])));
  if (columns.size() > 1) field.frequencies = numbers_of(columns[1].view(), "frequencies");
  if (columns.size() > 2) field.frequencies_v = numbers_of(columns[2].view(), "frequencies");
  return field;
}

/// On rank 0.
struct FieldColumns {
  std::vector<DataArray> columns;  ///< the field, then frequencies
  bool named = false;              ///< an array that may be a tensor or vectors
  bool of_globe = false;           ///< east and north components
};

FieldColumns read_columns(const WaveOptions& options, const ReadPiece& read, std::size_t vertices) {
  const CsvFieldName name = csv_field_name(options.field);
  FieldColumns result;
  if (std::optional<CsvField> csv = read_csv_field(name)) {
    result.of_globe = csv->of_globe;
    check_rows_per_vertex(csv->array, vertices);
    result.columns.push_back(std::move(csv->array));
    if (csv->frequency) result.columns.push_back(std::move(*csv->frequency));
    result.named = true;
    return result;
  }
  if (options.arrays.tensor) refuse_tensor("the field '" + name.path + "' has vectors alone");
  const FieldFile file = read_field_csv(name.path, vertices, read.vertex_of_row);
  result.columns.push_back(make_data_array("vectors", std::span<const Vec3>(file.vectors)));
  for (const std::vector<float>* numbers : {&file.frequencies, &file.frequencies_v}) {
    if (!numbers->empty()) result.columns.push_back(make_data_array("frequency", 1, *numbers));
  }
  return result;
}

/// For a globe, of which all partitions are a part.
DataArray piece_globe_vectors(Communicator& ranks, const ReadPiece& read,
                              const DataArray& east_north) {
  GlobeRadii radii = globe_radii(read.piece.mesh);
  for (const GlobeRadii& other : ranks.all(radii)) {
    radii.nearest = std::min(radii.nearest, other.nearest);
    radii.farthest = std::max(radii.farthest, other.farthest);
  }
  DataArray vectors;
  ranks.throw_on_all([&] { vectors = globe_vectors(read.piece.mesh, east_north, radii); });
  return vectors;
}

PieceField file_field(Communicator& ranks, const DistributedSurface& surface, const ReadPiece& read,
                      const WaveOptions& options) {
  bool named = false, of_globe = false;
  auto columns = piece_rows(ranks, read, "--field", csv_field_name(options.field).path, [&] {
    FieldColumns file = read_columns(options, read, surface.own_vertex_count());
    named = file.named;
    of_globe = file.of_globe;
    return std::move(file.columns);
  });
  if (ranks.any(of_globe)) columns[0] = piece_globe_vectors(ranks, read, columns[0]);
  if (!ranks.any(named)) return rows_field(ranks, surface, columns);
  return columns_field(ranks, surface, read, options, columns);
}

/// Strokes read by rank 0, on all ranks.
std::vector<FieldStroke> strokes_of(Communicator& ranks, const std::string& path) {
  std::vector<double> numbers;
  ranks.throw_on_all([&] {
    if (ranks.rank() != 0) return;
    for (const FieldStroke& stroke : read_strokes(path)) {
      numbers.insert(numbers.end(),
                     {static_cast<double>(stroke.points.size()), stroke.radius, stroke.strength});
      for (const Eigen::Vector3d& p : stroke.points)
        numbers.insert(numbers.end(), p.begin(), p.end());
    }
  });
  numbers = ranks.of_first(numbers);
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

std::vector<FieldAnchor> read_anchors(Communicator& ranks, const DistributedSurface& surface,
                                      const std::string& path) {
  const std::vector<FieldStroke> strokes = strokes_of(ranks, path);
  try {
    return stroke_anchors(surface, strokes);
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    throw Error(path + ": " + error.what());
  }
}

}  // namespace

PieceField make_piece_field(Communicator& ranks, const DistributedSurface& surface,
                            const ReadPiece& read, const WaveOptions& options) {
  const auto arrays = std::make_shared<const PieceArrays>(ranks, surface, read, options.arrays);
  PieceField field;
  if (options.direction) {
    field.directions = projected_direction_field(*options.direction, surface.normals());
  } else if (is_smooth(options)) {
    const auto diagonal = static_cast<float>(surface.diagonal());
    SmoothFieldOptions smooth;
    smooth.curvature_anchor = curvature_anchor(options);
    smooth.curvature_direction = options.curvature_direction;
    smooth.feature_anchor = options.feature_anchor;
    smooth.feature_angle_deg = options.feature_angle_deg;
    if (options.feature_radius) smooth.feature_radius = options.feature_radius->on(diagonal);
    if (options.normal_radius) smooth.normal_radius = options.normal_radius->on(diagonal);
    if (!options.strokes.empty()) smooth.anchors = read_anchors(ranks, surface, options.strokes);
    field.directions = smooth_direction_field(surface, smooth);
  } else if (options.field == "raw-curvature") {
    field.directions = curvature_direction_field(surface, options.curvature_direction);
  } else if (is_array(options.field)) {
    ArrayAtVertices found = arrays->array(parse_array("--field", options.field));
    field = array_field(ranks, surface, read, found.array, options);
    field.rows_nonfinite = found.rows_nonfinite;
    if (found.of_cells && !is_tensor(found.array)) field.data = {std::move(*found.of_cells), true};
  } else {
    field = file_field(ranks, surface, read, options);
  }
  field.notes = arrays->notes() + field.notes;
  field.arrays = arrays;
  return field;
}

}  // namespace brindle::tool
