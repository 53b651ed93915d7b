/// Ways over the surface from where a curve ends to the curve beside it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "brindle/pattern/edge_beyond.h"
#include "brindle/pattern/lifted_waves.h"
#include "brindle/polylines.h"

namespace brindle {

/// From where a curve ends over the surface to a curve beside it.
struct Walk {
  enum class State : std::uint8_t {
    met,  ///< a curve
    lost,
    beyond  ///< over an edge behind which the rest of the surface has the next triangle
  };

  State state = State::lost;
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();  ///< unit, in the last triangle's plane
  double reach = 0;                                     ///< how far it may go
  double passed = 0;                                    ///< how far it has gone
  std::uint32_t triangles = 0;                          ///< how many it has gone through
  std::vector<TrianglePoint> way{};    ///< points on the edges passed; at last that on the curve
  Index edge = 0;                      ///< of `beyond`: the last one passed
  std::array<double, 2> between = {};  ///< of `beyond`: weights of that edge's ends there
};

/// Which of two walks from one end counts: the shorter of those that met a curve, or the second
/// if they are as long; nothing if none did.
std::optional<std::size_t> shorter(const Walk& first, const Walk& second);

/// Finds where curves that end alone in a branch or singularity run on to.
class EndWalks {
 public:
  /// `waves` must outlive it, and so must `beyond`, which has an entry per edge if there is more of
  /// the surface.
  explicit EndWalks(const LiftedWaves& waves, std::span<const EdgeBeyond> beyond = {});

  /// From the inner end of `piece`, one of the joined `pieces` of triangle `t`, half forward and
  /// half to either side, as far as the curve beside it or two periods. Nothing if the end is on
  /// another piece already.
  std::optional<std::array<Walk, 2>> walks(std::size_t t, const StripePiece& piece,
                                           std::span<const StripePiece> pieces) const;

  /// A walk that is `beyond` on another part of the surface, from this part's edge on, which has
  /// one triangle here. Its way begins on that edge.
  Walk go_on(const Walk& from, Index edge) const;

 private:
  struct Walker;
  struct Step;

  Step next_step(const Walker& walker) const;
  bool cross_edge(Walker& walker, int edge) const;
  void enter(Walker& walker, Index next, Index edge, const std::array<double, 2>& between) const;
  void walk(Walker& walker) const;

  const LiftedWaves& waves_;
  std::span<const EdgeBeyond> beyond_;
};

}  // namespace brindle
