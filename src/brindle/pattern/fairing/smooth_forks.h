/// Ends of curves that lie on other curves, and smooth junctions (forks) with them.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "brindle/curves.h"
#include "brindle/pattern/fairing/curve_segments.h"
#include "brindle/pattern/fairing/unrolled_curve.h"
#include "brindle/progress.h"

namespace brindle {

/// An end that lies on another curve, or on another part of its own.
struct TouchingEnd {
  Index line;
  std::size_t end;  ///< 0 or 1
  Index other;
  std::size_t segment;  ///< of the other curve
  double periods;       ///< position along the other curve
};

/// All touching ends, in order of lines and ends.
std::vector<TouchingEnd> touching_ends(const StripeCurves& curves, const Mesh& mesh,
                                       std::span<const float> frequencies);

/// The length before a fork, in periods, that is faired again; no other curve joins there.
inline constexpr double kBeforeFork = 1;

/// Joins curves smoothly to the curves that they touch (forks). Going back from its end, a curve is
/// redirected where it first runs along the other one, at least 0.6 / f away. From there it
/// approaches that curve and meets it tangentially. This needs such a place within 4 / f. The other
/// curve must not end before, be redirected itself, or turn the fork by more than 30 degrees.
/// Otherwise another neighbour, or another part of the same curve, is tried. Next come straight
/// paths, ahead or slightly to the side, to the first curve within 2 / f. Last come forks that turn
/// more; without any, the end stays unchanged.
class JunctionSmoother {
 public:
  /// All arguments but `progress` must outlive this. `touches` may be those of the curves before
  /// fairing. Other ends in branches and singularities are also joined to a neighbour, if there is
  /// one. Throws Cancelled if `progress` cancels.
  JunctionSmoother(const StripeCurves& curves, const std::vector<TouchingEnd>& touches,
                   const WavePattern& pattern, const SurfaceWays& ways,
                   const Progress& progress = {});
  ~JunctionSmoother();
  JunctionSmoother(const JunctionSmoother&) = delete;
  JunctionSmoother& operator=(const JunctionSmoother&) = delete;

  /// Lengths of the forks at both ends of a line, in periods; 0 without a fork.
  std::array<double, 2> forks_of(Index line) const;
  std::size_t smooth_forks_of(Index line) const;  ///< the number of smooth forks of a line
  std::vector<SurfaceWays::Piece> forked(Index line) const;  ///< the line with its forks

 private:
  struct Fork;
  struct Course;
  struct Meeting;

  const UnrolledCurve& unrolled(Index line) const { return *unrolled_[line]; }
  std::optional<Fork> fork(const TouchingEnd& touch, std::size_t choice) const;
  std::optional<Fork> fork_beside(const TouchingEnd& touch, double most_turn) const;
  std::vector<TouchingEnd> neighbors_of(const TouchingEnd& touch) const;
  std::optional<Fork> fork_on(const Course& course, double length) const;
  std::optional<Fork> straight_on(const TouchingEnd& touch, double aside) const;
  std::optional<Meeting> meeting(const TouchingEnd& touch, double own, const Eigen::Vector3d& from,
                                 const Eigen::Vector3d& to, const Eigen::Vector3d& upward) const;
  std::array<std::size_t, 2> touches_of(Index line) const;
  std::optional<std::size_t> left_by(const TouchingEnd& touch) const;
  void solve_conflicts();

  const StripeCurves& curves_;
  const WavePattern& pattern_;
  const SurfaceWays& ways_;
  std::vector<std::optional<UnrolledCurve>> unrolled_;  // by line
  CurveSegments segments_;
  /// Includes ends that touch nothing, with their own curve and no segment.
  std::vector<TouchingEnd> touches_;        // in order of lines and ends
  std::vector<std::optional<Fork>> forks_;  // by touch
  bool all_are_there_ = false;              // all forks, except those that must change
};

}  // namespace brindle
