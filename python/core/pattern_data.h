/// Patterns and all that they were made with.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/pybind11.h>

#include "brindle/branch_pairs.h"
#include "brindle/cross_texture.h"
#include "brindle/stripe_pattern.h"
#include "brindle/texture_pattern.h"
#include "brindle/windings.h"
#include "preparation_figures.h"
#include "report.h"
#include "surface_data.h"

namespace brindle::python {

/// How to solve.
struct Solving {
  StripeOptions stripes;
  int threads = 0;
  std::optional<float> anchor_boundary;  ///< periods from the rim to the first stripe
  std::vector<WantedWinding> windings;
  std::optional<double> merge_branches;  ///< share by which the energy may rise for it
};

/// A number or an array of one per vertex, and where branches are unwelcome; None for nothing.
Slack slack_of(py::handle slack, py::handle calm);

/// Python hands these around; nobody changes one.
struct StripesData {
  SurfacePointer surface;
  StripePattern pattern;
  tool::PreparationFigures prepared;
  Solver solver = Solver::multilevel;
  int threads = 0;  ///< that were in force
  std::optional<tool::FollowedReport> followed;
  std::optional<WoundPattern> wound;  ///< what it took to have the windings wanted; without pattern
  std::optional<MergedBranches> merged;
};
using StripesPointer = std::shared_ptr<StripesData>;

/// Texture coordinates along two stripe patterns, or along the waves of a cross field.
struct TextureData {
  SurfacePointer surface;  ///< that corners belong to
  StripesPointer u, v;     ///< nothing for a cross field
  StripesPointer cover;    ///< of a cross field: both waves, on its covering
  TextureWaves waves;
  PhaseShiftKind phase_shift = PhaseShiftKind::aligned;
  std::vector<Index> triangle_origins;  ///< of a cross field: in the surface that was handed over
  std::vector<Index> singular;          ///< of a cross field: triangles of that surface
  tool::WaveFigures figures;
  std::size_t branches = 0;
  nlohmann::ordered_json report;  ///< without the invocation

  bool is_cross() const { return cover != nullptr; }
};
using TexturePointer = std::shared_ptr<TextureData>;

/// Waves of arrays.
struct WavesIn {
  WaveSet waves;
  tool::PreparationFigures prepared;
};

/// Where waves come from, for messages, and what is known of an array that they were made of.
struct FieldOrigin {
  std::string source;  ///< "the array 'velocity'"
  std::optional<std::size_t> rows_nonfinite;
  std::optional<std::pair<std::size_t, std::size_t>> tensor;  ///< near the normal, isotropic
};

/// `directions` are of any length, a row per vertex, projected into the tangent planes: but unit
/// tangent vectors stay as they are, so that fields that Brindle made are not rounded once more.
/// One of `stripes` and `frequency`, a number or one per vertex where not finite means no wave, is
/// given. Throws Error, as the tool does, if there is no wave at all.
WavesIn waves_of(const SurfaceData& surface, py::handle directions, py::handle stripes,
                 py::handle frequency, const FieldOrigin& origin);

void bind_solving(py::module_& module);
void bind_patterns(py::module_& module);
void bind_textures(py::module_& module);
void bind_curves(py::module_& module);
void bind_animators(py::module_& module);
void bind_texture_animator(py::module_& module);
void bind_loops(py::module_& module);
void bind_files(py::module_& module);
void bind_pictures(py::module_& module);

}  // namespace brindle::python
