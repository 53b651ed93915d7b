/// Stripes as curves: their centre lines, joined over a whole surface.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "brindle/export.h"
#include "brindle/polylines.h"

namespace BRINDLE_EXPORT brindle {

/// Reasons why a curve ends.
enum class CurveEnd : std::uint8_t {
  closed,       ///< no end: the curve is closed
  boundary,     ///< an edge of one triangle
  no_wave,      ///< a triangle with a corner that has no wave
  nonmanifold,  ///< an edge of three triangles or more
  branch,       ///< a triangle around which the phase does not close
  singularity,  ///< a triangle that is a singularity of the field
  crease        ///< a crease where the phases of both sides do not meet
};
inline constexpr std::size_t kCurveEndKinds = 7;

/// Curves with the reasons of their ends.
struct StripeCurves {
  Polylines lines;
  std::vector<std::array<CurveEnd, 2>> ends;  ///< of every line: first and last point
  std::size_t joined_ends = 0;                ///< removed by `CurveOptions::join`
  std::size_t ends_at_neighbors = 0;          ///< extended by `join` into another curve
  std::size_t smooth_forks = 0;  ///< of these, smoothed to forks without an angle by `fair`
  std::size_t trimmed_ends = 0;  ///< cut back by `CurveOptions::trim`
  std::size_t trimmed_away = 0;  ///< curves that `trim` removed
  double largest_move = 0;       ///< of a point by `CurveOptions::fair`, times f

  /// Numbers of ends by kind, in the order of CurveEnd; closed curves have none.
  std::array<std::size_t, kCurveEndKinds> end_counts() const;
};

/// Options of `stripe_curves`.
struct CurveOptions {
  static constexpr float kTrim = 0.6f;  ///< leaves clean ends

  /// Joins curves that end in one branch or singularity in pairs. A curve that ends alone runs on,
  /// aslant over the surface, into a neighbour within two periods, if any; its end keeps its kind.
  bool join = false;
  /// Above 0, cuts curves that end in a branch or singularity back until no curve beside them is
  /// nearer than this share of the spacing 1/f (0 to 1). Removes curves then shorter than 1/f. Not
  /// together with `join`, whose ends run into their neighbours. Default: kTrim, or 0 with `join`.
  std::optional<float> trim = {};
  /// Above 0, removes kinks shorter than about this share of the spacing 1/f (0 to 1; 0.25 is
  /// good). Curves become smoothing splines within the surface, and no point moves by more than a
  /// tenth of 1/f. Ends stay. Ends extended by `join` leave their curves earlier and meet their
  /// neighbours without an angle where possible, and otherwise move with them. Applied after `join`
  /// and `trim`.
  float fair = 0;

  /// The share of 1/f that `trim` keeps free.
  float least_gap() const { return trim.value_or(join ? 0 : kTrim); }
};

/// The curves of at least this length.
StripeCurves longer_than(const StripeCurves& curves, double length);

}  // namespace brindle
