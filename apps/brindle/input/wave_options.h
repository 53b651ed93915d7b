/// Directions and frequencies of waves.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "brindle/array_field.h"
#include "brindle/direction_field.h"
#include "brindle/measured_field.h"
#include "brindle/strokes.h"
#include "brindle/surface.h"
#include "brindle/tensor_field.h"
#include "cli/option_values.h"

namespace brindle::tool {

/// Options of waves from arrays of the mesh's file or of another one.
struct ArrayOptions {
  std::optional<TensorAxis> tensor;    ///< of a field that is a tensor; major if not given
  std::optional<TensorOrder> order;    ///< of a tensor's components; VTK's if not given
  std::string frequency;               ///< array of stripes per unit length
  std::string frequency_by;            ///< value that --stripes or --frequency are multiplied by
  FrequencyRange range;                ///< of the factors
  std::string mesh;                    ///< file of all arrays; empty: the mesh's own
  std::optional<Length> max_distance;  ///< to `mesh`

  /// Calls `add("--option", field)` for each option that sets a field.
  template <class Add>
  void visit(const Add& add) {
    add("--tensor", tensor);
    add("--tensor-order", order);
    add("--field-mesh", mesh);
    add("--max-distance", max_distance);
  }
};

/// Whether an option's value names an array: "array:NAME", "array:points/NAME".
bool is_array(std::string_view value);

/// The text after "array:". Throws CLI::ValidationError for other values and for an empty name.
std::string parse_array(const std::string& option, const std::string& value);

/// --tensor, --tensor-order, --frequency-by, --frequency-range, --field-mesh and --max-distance.
void add_array_options(CLI::App& app, ArrayOptions& options);

/// An array of a field as directions and tensors are read from it: in VTK's order. Throws
/// CLI::ValidationError for an order of an array that is no tensor.
DataArray ordered_array(const DataArray& array, const ArrayOptions& options);

/// Throws CLI::ValidationError for options that leave each other without effect. `field` is what
/// --field says, which may be a file.
void check_array_options(const CLI::App& command, const ArrayOptions& options,
                         const std::string& field, bool is_file);

/// Options for smoothing measured fields.
struct FieldSmoothingChoice {
  float periods = 0;          ///< P; 0: as the field is given
  std::string weight;         ///< what data count by; empty: tensors by anisotropy, others alike
  std::optional<float> fill;  ///< how far holes are filled, in periods
  bool arrows = false;        ///< vectors have a sign
  float hold_out = 0;         ///< share of the data that a check hides; 0: no check
  std::optional<int> singularities;  ///< at most so many; nothing: all stay
  float memory = 0;                  ///< of the step before, in a series
  float frequency_periods = 0;       ///< the same scale for frequencies; 0: as they are

  /// Calls `add("--option", field)` for each option that sets a field.
  template <class Add>
  void visit(const Add& add) {
    add("--field-smoothing", periods);
    add("--fill", fill);
    add("--hold-out", hold_out);
    add("--field-arrows", arrows);
    add("--field-singularities", singularities);
    add("--frequency-smoothing", frequency_periods);
  }
};

/// --field-smoothing, --field-weight, --fill, --hold-out, --field-arrows, --field-singularities and
/// --frequency-smoothing.
void add_field_smoothing_options(CLI::App& app, FieldSmoothingChoice& choice);

/// The option of `FieldSmoothingChoice::weight`.
inline constexpr const char* kWeightOption = "--field-weight";

/// Whether a weight is computed from the data themselves: "", "length" or "anisotropy".
bool is_own_weight(const std::string& weight);

/// The library's options for a field of this rotational symmetry.
FieldSmoothingOptions smoothing_options(const FieldSmoothingChoice& choice, int symmetry);

FrequencySmoothingOptions frequency_smoothing_options(const FieldSmoothingChoice& choice);

struct WaveOptions {
  std::optional<Vec3> direction;  ///< one vector for all vertices, instead of `field`
  std::string field = "smooth";   ///< "smooth", "curvature", "raw-curvature", an array or a file
  CurvatureDirection curvature_direction = CurvatureDirection::maximum;
  std::optional<float> curvature_anchor;  ///< of smooth fields; "curvature" has a default
  float feature_anchor = 0;               ///< of the smooth field
  float feature_angle_deg = 40;
  std::optional<Length> feature_radius;
  std::optional<Length> normal_radius;  ///< of the smooth field; empty: use the surface's normals
  std::string strokes;  ///< file of strokes that the smooth field follows; empty: none
  std::vector<FieldStroke> drawn_strokes;  ///< further strokes, drawn in the window
  bool cross = false;                      ///< the field is a cross field
  bool along = false;                      ///< stripes along the field, not across it
  float rotate_deg = 0;
  std::optional<float> stripes;    ///< along the diagonal of the bounding box
  std::optional<float> frequency;  ///< stripes per unit length, instead of `stripes`
  std::optional<Length> spacing;   ///< between stripes, instead of both
  std::optional<float> stripes_v;  ///< the same of the crossing stripes
  std::optional<float> frequency_v;
  bool oriented = false;       ///< for textures: keep the field's signs
  float frequency_factor = 1;  ///< multiplies all frequencies, of any source
  ArrayOptions arrays;
  FieldSmoothingChoice smoothing;

  /// Calls `add("--option", field)` for the options of all stripe patterns.
  template <class Add>
  void visit(const Add& add) {
    add("--field", field);
    add("--curvature-direction", curvature_direction);
    add("--curvature-anchor", curvature_anchor);
    add("--feature-anchor", feature_anchor);
    add("--feature-angle", feature_angle_deg);
    add("--feature-radius", feature_radius);
    add("--normal-radius", normal_radius);
    add("--strokes", strokes);
    add("--rotate", rotate_deg);
    add("--along", along);
    add("--stripes", stripes);
    add("--spacing", spacing);
  }

  /// The same for textures.
  template <class Add>
  void visit_texture(const Add& add) {
    add("--oriented", oriented);
    add("--stripes-v", stripes_v);
    add("--frequency-v", frequency_v);
  }
};

/// Whether the field is `smooth_direction_field`, with any curvature anchor.
bool is_smooth(const WaveOptions& options);
float curvature_anchor(const WaveOptions& options);

/// Whether vectors of the field have signs: opposite ones cancel.
bool has_signs(const WaveOptions& options);

/// The rotational symmetry of the field: 1 for arrows, 2 for lines, 4 for crosses.
int symmetry_of(const WaveOptions& options);

/// Turn of the waves from their field, in degrees: --rotate and --along.
float turn_deg(const WaveOptions& options);

/// Whether the field counts as measured: an array, a file or raw curvature.
bool is_measured(const WaveOptions& options);

/// Whether the next step's field starts from this one: it is smooth, or has temporal smoothing.
bool goes_on_from_last(const WaveOptions& options);

/// Whether the field comes from a file of its own.
bool is_field_file(const WaveOptions& options);

/// Whether an option sets frequencies per vertex.
bool says_frequencies(const WaveOptions& options);

/// Whether an option says one frequency for all vertices.
bool says_one_frequency(const WaveOptions& options);

/// Throws CLI::ValidationError: there is one for all.
[[noreturn]] void refuse_frequency_smoothing();

/// Whether frequencies may differ between vertices: from an array, a file or a value.
bool may_vary(const WaveOptions& options);

/// The field in messages: "the field 'wind.csv'".
std::string source_of(const WaveOptions& options);

/// Whether options use arrays of the mesh's own file.
bool needs_own_arrays(const WaveOptions& options);

/// --cross.
CLI::Option* add_cross_option(CLI::App& app, WaveOptions& options);

/// All options except for crossing stripes.
void add_wave_options(CLI::App& app, WaveOptions& options);

/// Throws CLI::ValidationError for options without effect on the chosen field, and for a field that
/// is neither known nor a file.
void check_field_options(const CLI::App& command, const WaveOptions& options);

/// Throws CLI::ValidationError for given options that need triangles.
void refuse_triangle_options(const CLI::App& command);

/// The uniform frequency of the options; the default is 40 stripes.
float constant_frequency(const Mesh& mesh, const WaveOptions& options);

/// The same for a bounding box with this diagonal.
float constant_frequency(float diagonal, const WaveOptions& options);

}  // namespace brindle::tool
