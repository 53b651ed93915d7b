/// Patterns of waves (stripes, a texture or crosses), by the same steps in every program, also for
/// frames. Experimental: fields may still be added.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "brindle/branch_pairs.h"
#include "brindle/cross_animator.h"
#include "brindle/cross_texture.h"
#include "brindle/export.h"
#include "brindle/progress.h"
#include "brindle/stripe_animator.h"
#include "brindle/stripe_pattern.h"
#include "brindle/surface.h"
#include "brindle/texture_animator.h"
#include "brindle/texture_pattern.h"
#include "brindle/windings.h"

namespace BRINDLE_EXPORT brindle {

/// Kinds of patterns.
enum class PatternKind : std::uint8_t {
  stripes,  ///< across the directions
  texture,  ///< along the directions and across them
  crosses   ///< along both directions of a cross at every vertex
};

/// Options of fabrication: where stripes begin, wind and branch.
struct FabricationOptions {
  std::optional<float> anchor_boundary;  ///< periods from the rim to the first stripe
  std::vector<WantedWinding> windings;
  std::optional<float> cancel_branches;  ///< largest rise of the energy, as a share of it
  std::optional<float> cancel_distance;  ///< periods from a branch to its opposite; empty: 10
  bool measure_windings = false;         ///< also if none are requested

  /// Whether these options change the pattern of the waves.
  bool change_pattern() const { return anchor_boundary || !windings.empty() || cancel_branches; }
};

/// Results of these options.
struct FabricationMetrics {
  std::vector<SurfaceLoop> loops;             ///< empty if windings were not measured
  std::vector<Winding> windings;              ///< one per loop
  std::vector<std::size_t> branches;          ///< of the component that the loop is on
  std::vector<Eigen::Vector3d> centers;       ///< of loops, in file coordinates
  std::vector<WindingSum> sums;               ///< of components with several boundaries
  std::vector<Winding> windings_before = {};  ///< empty if none were requested
  double energy_before = 0;
  double largest_turn_deg = 0, mean_turn_deg = 0, largest_frequency_change = 0;
  std::optional<CancelledBranches> cancelled_branches;
  std::size_t fixed_vertices = 0;  ///< with a phase from `anchor_boundary`
};

/// Options of a pattern, besides its waves.
struct PatternRequest {
  PatternKind kind = PatternKind::stripes;
  StripeOptions solving = {};
  FabricationOptions fabrication = {};  ///< only `cancel_branches` for textures and crosses
  FrequencyField frequencies_v = {};    ///< of textures, as in TextureOptions
  bool oriented = false;                ///< of textures, as in TextureOptions
};

/// A cross pattern with its texture.
struct CrossResult {
  CrossPattern cross;
  CrossTexture texture;
};

/// A pattern of any kind.
struct PatternResult {
  std::variant<StripePattern, TexturePattern, CrossResult> of;
  FabricationMetrics fabrication = {};
};

/// Solves for the pattern. `waves` has one entry per vertex. Throws what `stripe_pattern`,
/// `texture_pattern`, `cross_pattern`, `wind` and `cancel_branches` throw; Error for options that
/// the kind of pattern does not support, and for boundaries without stripes along them.
PatternResult pattern_of(const Surface& surface, WaveSet waves, const PatternRequest& request,
                         const Progress& progress = {});

/// Fills in the loops of the surface and their windings.
void measure_windings(const Surface& surface, const StripePattern& pattern,
                      FabricationMetrics& metrics);

/// A frame of a StripeAnimator, or of another animator with the same result, as an independent
/// pattern. It has no corners and quality; `measure_pattern` adds them. `waves` are those of the
/// frame's solution.
StripePattern pattern_of_frame(const FrameResult& frame, WaveSet waves, double energy,
                               PhaseShiftKind phase_shift);

/// A frame of `animator` as an independent pattern, with its energies.
TexturePattern pattern_of_frame(const TextureFrameResult& frame, const TextureAnimator& animator);

/// A frame of `animator` as the pattern of a CrossTexture, on `frame.mesh`. Only U is filled in,
/// with the waves (i, 0) and the metrics of both waves together.
TexturePattern pattern_of_frame(const CrossFrameResult& frame, const CrossAnimator& animator,
                                PhaseShiftKind phase_shift);

}  // namespace brindle
