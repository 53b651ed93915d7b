#include "wave_settings.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include <brindle/distributed_waves.h>
#include <brindle/error.h>
#include <brindle/frequency_field.h>
#include <brindle/measured_field.h>
#include <brindle/smooth_field.h>
#include <brindle/types.h>

#include "vtk_data.h"

namespace brindle::paraview {
namespace {

constexpr float kCurvatureAnchor = 0.1f;  // as in `brindle stripe --field curvature`

/// Numbers, or magnitudes of vectors.
std::vector<float> lengths_of(const DataArray& array) {
  const std::vector<double> numbers = doubles_of(array);
  const auto columns = static_cast<std::size_t>(array.components);
  std::vector<float> lengths;
  for (std::size_t row = 0; row < array.rows(); ++row) {
    const double* first = &numbers[columns * row];
    double length = columns == 1 ? *first : 0;
    for (std::size_t c = 0; columns > 1 && c < columns; ++c) length = std::hypot(length, first[c]);
    lengths.push_back(static_cast<float>(length));
  }
  return lengths;
}

/// Those of all sources but FrequencySource::by_array.
FrequencyField make_frequencies(const Surface& surface, const WaveSettings& settings,
                                float diagonal, const DirectionField& directions,
                                const DataArray* numbers) {
  const std::size_t count = surface.mesh.vertex_count();
  if (settings.frequency_source == FrequencySource::array) {
    return frequencies_of(*numbers, directions);
  }
  if (settings.frequency_source == FrequencySource::per_length) {
    return constant_frequency_field(settings.frequency, count);
  }
  return constant_frequency_field(settings.frequency_source == FrequencySource::spacing
                                      ? frequency_of_spacing(settings.spacing)
                                      : frequency_of_stripes(settings.stripes, diagonal),
                                  count);
}

/// The data of the field: cell data unchanged, as lines or arrows of triangles.
MeasuredField measured_data(const Surface& surface, const WaveArrays& arrays,
                            const DirectionField& directions) {
  const bool of_triangles = arrays.cell_vectors != nullptr && !is_tensor(*arrays.vectors);
  const FieldData data{of_triangles ? *arrays.cell_vectors : *arrays.vectors, of_triangles};
  FieldWeight weight;
  if (arrays.weights != nullptr && of_triangles && arrays.cell_weights != nullptr) {
    weight.values = lengths_of(*arrays.cell_weights);
  } else if (arrays.weights != nullptr) {
    weight.values = lengths_of(*arrays.weights);
    if (of_triangles) weight.values = corner_means(surface.mesh, weight.values);
  }
  const auto is_below_zero = [](float value) { return value < 0; };
  if (std::ranges::any_of(weight.values, is_below_zero)) {
    throw Error("Field Weight: there are weights below zero");
  }
  return measured_field(data, directions, weight);
}

/// `made` are those of computed fields.
DirectionField directions_of(const Surface& surface, const WaveSettings& settings,
                             DirectionField made, const DataArray* vectors) {
  if (settings.field == FieldSource::direction) {
    return projected_direction_field(settings.direction, surface.normals);
  }
  if (settings.field != FieldSource::array) return made;
  if (vectors == nullptr) throw Error("choose an array of vectors for the field");
  if (!is_tensor(*vectors)) return direction_field_of(surface, *vectors);
  return tensor_field_of(surface, *vectors, settings.tensor_axis).directions;
}

}  // namespace

DirectionField made_directions(const Surface& surface, const WaveSettings& settings,
                               const RankPiece* piece, DirectionField last) {
  SmoothFieldOptions options;
  options.last.directions = std::move(last);
  if (settings.field == FieldSource::curvature) options.curvature_anchor = kCurvatureAnchor;
  options.curvature_direction = settings.curvature_direction;
  if (piece != nullptr) return smooth_direction_field(piece->surface(), options);
  return smooth_direction_field(surface, options);
}

WaveResult make_waves(const Surface& surface, const WaveSettings& settings, DirectionField made,
                      const WaveArrays& arrays, const DirectionField& last,
                      const RankPiece* piece) {
  const Ranks ranks = piece != nullptr ? piece->ranks() : Ranks();
  const auto diagonal = static_cast<float>(
      piece != nullptr ? piece->surface().diagonal() : bounding_box(surface.mesh).diagonal());
  const bool by_array = settings.frequency_source == FrequencySource::by_array;
  WaveInput found;
  found.last = last;
  found.may_have_gaps = settings.needs_frequency_array();
  float frequency = 0;  // before the factors of an array
  ranks.throw_on_all([&] {
    found.directions = directions_of(surface, settings, std::move(made), arrays.vectors);
    if (settings.needs_frequency_array() && arrays.frequencies == nullptr) {
      throw Error("choose an array for the frequency");
    }
    if (by_array) {
      frequency = frequency_of_stripes(settings.stripes, diagonal);
    } else {
      found.frequencies =
          make_frequencies(surface, settings, diagonal, found.directions, arrays.frequencies);
    }
  });
  if (by_array) {
    found.frequencies =
        piece != nullptr
            ? frequencies_by(piece->surface(), *arrays.frequencies, frequency, settings.range)
            : frequencies_by(surface, *arrays.frequencies, frequency, settings.range);
  }
  ranks.throw_on_all([&] {
    if (settings.request.smoothing.periods == 0) return;
    found.measured = measured_data(surface, arrays, found.directions);
  });
  if (piece == nullptr) return waves_of(WholeSurface(surface), settings.request, std::move(found));
  WaveResult result =
      waves_of(PieceSurface(piece->surface(), surface.mesh), settings.request, std::move(found));
  piece->from_owners(std::span(result.waves.directions));
  piece->from_owners(std::span(result.waves.frequencies));
  return result;
}

}  // namespace brindle::paraview
