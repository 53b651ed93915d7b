#include "ranks/piece_detail.h"

#include <string>
#include <utility>
#include <vector>

#include "brindle/arrays.h"
#include "brindle/recipe/field_data.h"
#include "cli/command_line.h"
#include "input/field_smoothing.h"
#include "input/vertex_values.h"
#include "ranks/first_rank.h"
#include "ranks/piece_rows.h"

namespace brindle::tool {
namespace {

constexpr const char* kWeight = "--field-weight";

FieldWeight piece_weight(Communicator& ranks, const DistributedSurface& surface,
                         const ReadPiece& read, const FieldSmoothingChoice& choice,
                         const PieceField& field) {
  const bool of_triangles = ranks.any(field.data.of_triangles);
  if (is_own_weight(choice.weight)) return {choice.weight, {}};
  std::vector<float> values;
  if (is_array(choice.weight)) {
    const ArrayAtVertices found = field.arrays->array(parse_array(kWeight, choice.weight));
    if (of_triangles && found.of_cells && found.of_cells->components == 1) {
      return {"", numbers_of(found.of_cells->view(), kWeight)};
    }
    ranks.throw_on_all([&] {
      values = scalar_values(kWeight, found.array, read.piece.mesh.vertex_count(), read.file);
    });
  } else {
    const auto rows = piece_rows(ranks, read, kWeight, value_file(choice.weight), [&] {
      const VertexValues read_values =
          csv_values(kWeight, choice.weight, surface.own_vertex_count(), read.vertex_of_row);
      return std::vector<DataArray>{make_data_array("weight", 1, read_values.values)};
    });
    values = numbers_of(rows[0].view(), kWeight);
  }
  return {"", of_triangles ? corner_means(read.piece.mesh, values) : std::move(values)};
}

}  // namespace

MeasuredField piece_measured(Communicator& ranks, const DistributedSurface& surface,
                             const ReadPiece& read, const WaveOptions& options,
                             const PieceField& field) {
  MeasuredField measured;
  if (options.detail.periods == 0) return measured;
  const FieldWeight weight = piece_weight(ranks, surface, read, options.detail, field);
  together_as_used(ranks, [&] {
    refuse_usage([&] { measured = measured_field(field.data, field.directions, weight); });
  });
  return measured;
}

}  // namespace brindle::tool
