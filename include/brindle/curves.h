/// Stripes as curves: the centre lines of stripes, joined over a whole surface.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "brindle/export.h"
#include "brindle/polylines.h"

namespace BRINDLE_EXPORT brindle {

/// Why a curve ends.
enum class CurveEnd : std::uint8_t {
  closed,       ///< it does not
  boundary,     ///< an edge of one triangle
  no_wave,      ///< a triangle with a corner that has no wave
  nonmanifold,  ///< an edge of three triangles or more
  branch,       ///< a triangle around which the phase does not close
  singularity,  ///< a triangle that is a singularity of the field
  crease        ///< a crease where the phases of both sides do not meet
};
inline constexpr std::size_t kCurveEndKinds = 7;

/// Curves with the reason why each end is one.
struct StripeCurves {
  Polylines lines;
  std::vector<std::array<CurveEnd, 2>> ends;  ///< of every line, at its first and its last point
  std::size_t joined_ends = 0;                ///< that `CurveOptions::join` made go
  std::size_t ends_at_neighbors = 0;          ///< that it let run on into another curve
  std::size_t smooth_forks = 0;               ///< of these, without an angle by `fair`
  std::size_t trimmed_ends = 0;               ///< that `CurveOptions::trim` cut back
  std::size_t trimmed_away = 0;               ///< curves of which it left nothing
  double largest_move = 0;                    ///< of a point by `CurveOptions::fair`, times f

  /// How many ends are of each kind, in the order of CurveEnd; a closed curve has none.
  std::array<std::size_t, kCurveEndKinds> end_counts() const;
};

struct CurveOptions {
  /// Where several curves end in one branch or singularity, joins them in pairs. Every curve that
  /// ends alone runs on into a neighbour, aslant over the surface, if there is one within two
  /// periods; that is an end of the same kind still.
  bool join = false;
  /// Above 0, cuts curves that end in a branch or singularity back to where no curve beside them is
  /// nearer than this share of the spacing 1/f (0 to 1; 0.6 leaves clean ends), and leaves out what
  /// is then shorter than 1/f. Not together with `join`, whose ends run on into their neighbours.
  float trim = 0;
  /// Above 0, takes out kinks shorter than about this share of the spacing 1/f (0 to 1; 0.25 is
  /// good): curves become smoothing splines within the surface, and no point moves by more than a
  /// tenth of 1/f. Ends stay; those that `join` has let run on leave their curves earlier and meet
  /// their neighbours with no angle where they can, or else go along with these. After `join` and
  /// `trim`.
  float fair = 0;
};

/// The curves that are at least `length` long.
StripeCurves longer_than(const StripeCurves& curves, double length);

}  // namespace brindle
