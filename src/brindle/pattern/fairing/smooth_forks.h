/// Ends of curves that lie on other curves, and ways on which they get there smoothly.
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
  std::size_t segment;  ///< of the other one,
  double periods;       ///< and how far along it
};

/// All of them, in order of lines and ends.
std::vector<TouchingEnd> touching_ends(const StripeCurves& curves, const Mesh& mesh,
                                       std::span<const float> frequencies);

/// A curve that has a fork should be faired so far before it, in periods; no other curve is led
/// there.
inline constexpr double kBeforeFork = 1;

/// Leads curves smoothly to the ones that they touch. Going back from its end, a curve leaves its
/// way at the first place where it runs along the other one, no nearer than 0.6 of 1/f, and from
/// where it can go on along that one, nearer and nearer, until it meets it with no angle. Where
/// there is no such place within 4/f, or the other curve ends before, leaves its own way or turns
/// it by more than 30 degrees, it takes another neighbour, or another part of its own; where there
/// is none, it goes straight on, or a little aside, to the first curve within 2/f. Where nothing is
/// met there, it takes what turns it more, or else stays as it is.
class JunctionSmoother {
 public:
  /// All but `progress` must outlive this. Throws Cancelled if `progress` asks for it.
  /// `touches` may be those of the curves before they were faired. Other ends in branches and
  /// singularities are led to a neighbour, too, where one is.
  JunctionSmoother(const StripeCurves& curves, const std::vector<TouchingEnd>& touches,
                   const WavePattern& pattern, const SurfaceWays& ways,
                   const Progress& progress = {});
  ~JunctionSmoother();
  JunctionSmoother(const JunctionSmoother&) = delete;
  JunctionSmoother& operator=(const JunctionSmoother&) = delete;

  /// How long the ways are, in periods, that the ends of a line are led, 0 of those that stay; and
  /// the line.
  std::array<double, 2> forks_of(Index line) const;
  std::size_t smooth_forks_of(Index line) const;  ///< ends of a line, led there with no angle
  std::vector<SurfaceWays::Piece> forked(Index line) const;

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
  std::vector<std::optional<UnrolledCurve>> unrolled_;  // every line
  CurveSegments segments_;
  /// With the ends that touch nothing, as if they touched no segment of their own curve.
  std::vector<TouchingEnd> touches_;        // in order of lines and ends
  std::vector<std::optional<Fork>> forks_;  // of every touch
  bool all_are_there_ = false;              // of them, but for those that must change
};

}  // namespace brindle
