/// Patterns of waves: stripes, a texture or crosses, in the same steps for every program, at once
/// or frame after frame. Experimental: fields may still be added.
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
  crosses   ///< along both directions of crosses that the directions stand for
};

/// Fabrication: where stripes begin, wind and branch.
struct MakingOptions {
  std::optional<float> anchor_boundary;  ///< periods from the rim to the first stripe
  std::vector<WantedWinding> windings;
  std::optional<float> merge_branches;  ///< how much the energy may rise, as a share of it
  std::optional<float> merge_distance;  ///< periods from a branch to its opposite; nothing: 10
  bool measure_windings = false;        ///< also where none are asked for

  /// Whether they make another pattern of the waves.
  bool change_pattern() const { return anchor_boundary || !windings.empty() || merge_branches; }
};

/// Results of these options.
struct MakingFigures {
  std::vector<SurfaceLoop> loops;             ///< empty if windings were not measured
  std::vector<Winding> windings;              ///< one per loop
  std::vector<std::size_t> branches;          ///< of the piece that the loop is on
  std::vector<Eigen::Vector3d> centers;       ///< of loops, in the coordinates of files
  std::vector<WindingSum> sums;               ///< of pieces with several boundaries
  std::vector<Winding> windings_before = {};  ///< empty if none were asked for
  double energy_before = 0;
  double largest_turn_deg = 0, mean_turn_deg = 0, largest_frequency_change = 0;
  std::optional<MergedBranches> merged;
  std::size_t fixed_vertices = 0;  ///< whose phase `anchor_boundary` gives
};

/// Options of a pattern, beside its waves.
struct PatternRequest {
  PatternKind kind = PatternKind::stripes;
  StripeOptions solving = {};
  MakingOptions making = {};          ///< of textures and crosses `merge_branches` alone
  FrequencyField frequencies_v = {};  ///< of textures, as TextureOptions has them
  bool oriented = false;              ///< the same
};

struct CrossResult {
  CrossPattern cross;
  CrossTexture texture;
};

struct PatternResult {
  std::variant<StripePattern, TexturePattern, CrossResult> of;
  MakingFigures making = {};
};

/// Solves for the pattern. `waves` has one entry per vertex. Throws what `stripe_pattern`,
/// `texture_pattern`, `cross_pattern`, `wind` and `merge_branches` throw; Error for options that
/// the kind of pattern does not have, and for boundaries along which no stripes run.
PatternResult pattern_of(const Surface& surface, WaveSet waves, const PatternRequest& request,
                         const Progress& progress = {});

/// Fills in the loops of the surface and their windings.
void measure_windings(const Surface& surface, const StripePattern& pattern, MakingFigures& figures);

/// A frame of a StripeAnimator, or of another one with the same result, as a pattern of its own:
/// without corners and quality, which `measure_pattern` adds where they are asked for. `waves` are
/// those that the frame was solved for.
StripePattern pattern_of_frame(const FrameResult& frame, WaveSet waves, double energy,
                               PhaseShiftKind phase_shift);

/// A frame of `animator` that stays, with its energies.
TexturePattern pattern_of_frame(const TextureFrameResult& frame, const TextureAnimator& animator);

/// A frame of `animator` as the pattern of a CrossTexture, on `frame.mesh`. Only U is filled in: it
/// has the waves (i, 0) and the figures of both waves together.
TexturePattern pattern_of_frame(const CrossFrameResult& frame, const CrossAnimator& animator,
                                PhaseShiftKind phase_shift);

}  // namespace brindle
