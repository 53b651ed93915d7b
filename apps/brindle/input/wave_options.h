/// Where the waves run and how dense they are.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "brindle/direction_field.h"
#include "brindle/strokes.h"
#include "brindle/surface.h"
#include "cli/option_values.h"
#include "input/array_options.h"
#include "input/field_detail.h"

namespace brindle::tool {

struct WaveOptions {
  std::optional<Vec3> direction;  ///< a global vector, instead of `field`
  std::string field = "smooth";   ///< "smooth", "curvature", "raw-curvature", an array or a file
  CurvatureDirection curvature_direction = CurvatureDirection::maximum;
  std::optional<float> curvature_anchor;  ///< of the smooth field; "curvature" has one anyway
  float feature_anchor = 0;               ///< of the smooth field
  float feature_angle_deg = 40;
  std::optional<Length> feature_radius;
  std::optional<Length> normal_radius;  ///< of the smooth field; nothing: its normals are its own
  std::string strokes;  ///< file of strokes that the smooth field follows; empty: none
  std::vector<FieldStroke> drawn_strokes;  ///< further ones, that were drawn and not read
  bool cross = false;                      ///< the field is a cross field
  bool along = false;                      ///< stripes run along the field, not across it
  float rotate_deg = 0;
  std::optional<float> stripes;    ///< along the diagonal of the bounding box
  std::optional<float> frequency;  ///< stripes per unit length, instead of `stripes`
  std::optional<Length> spacing;   ///< between stripes, instead of both
  std::optional<float> stripes_v;  ///< the same of the crossing stripes
  std::optional<float> frequency_v;
  bool oriented = false;       ///< of a texture: the field's signs are meant
  float frequency_factor = 1;  ///< multiplies all frequencies, whoever says them
  ArrayOptions arrays;
  FieldDetailChoice detail;

  /// Calls `add("--option", field)` for what all patterns of stripes have.
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

/// Whether the field is `smooth_direction_field`, drawn to curvature with this weight or not.
bool is_smooth(const WaveOptions& options);
float curvature_anchor(const WaveOptions& options);

/// Whether vectors of the field run one way, and not both: opposite ones cancel each other.
bool has_signs(const WaveOptions& options);

/// How many directions of the field are alike: 1 of arrows, 2 of lines, 4 of crosses.
int symmetry_of(const WaveOptions& options);

/// Degrees that waves are turned by against their field: --rotate and --along.
float turn_deg(const WaveOptions& options);

/// Whether the field was measured, as far as anyone can tell: it is an array, a file, or curvature
/// as it is.
bool is_measured(const WaveOptions& options);

/// Whether the field of a next step goes on from this one's: it is smooth, or has a memory.
bool goes_on_from_last(const WaveOptions& options);

/// Whether the field comes from a file of its own.
bool is_field_file(const WaveOptions& options);

/// Whether an option says a frequency for every vertex.
bool says_frequencies(const WaveOptions& options);

/// Whether an option says one frequency for all vertices.
bool says_one_frequency(const WaveOptions& options);

/// Throws CLI::ValidationError: there is one for all.
[[noreturn]] void refuse_frequency_detail();

/// Whether vertices may have different frequencies: those of an array, a file or a value.
bool may_vary(const WaveOptions& options);

/// What a message calls the field: "the field 'wind.csv'".
std::string source_of(const WaveOptions& options);

/// Whether arrays of the mesh's own file are asked for.
bool needs_own_arrays(const WaveOptions& options);

/// --cross.
CLI::Option* add_cross_option(CLI::App& app, WaveOptions& options);

/// All options but those of crossing stripes.
void add_wave_options(CLI::App& app, WaveOptions& options);

/// Throws CLI::ValidationError for options that the chosen field takes no notice of, and for a
/// field that is neither known nor a file.
void check_field_options(const CLI::App& command, const WaveOptions& options);

/// Throws CLI::ValidationError for options that were given and need triangles: points have none.
void refuse_triangle_options(const CLI::App& command);

/// The frequency that the options ask for everywhere; 40 stripes if they ask for none.
float constant_frequency(const Mesh& mesh, const WaveOptions& options);

/// The same for a surface whose bounding box has this diagonal.
float constant_frequency(float diagonal, const WaveOptions& options);

}  // namespace brindle::tool
