/// How a smooth field goes on from the one before.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "brindle/phase_graph.h"
#include "brindle/phases/screened.h"

namespace brindle {

/// The last field at the nodes of a direction graph.
struct LastValues {
  std::vector<Complex> u;         ///< exp(i N theta), 0 where nothing is known
  std::vector<float> confidence;  ///< 0 or above
  float weight = 0;               ///< of the pull, in multiples of what all neighbours pull
  std::vector<float> noisy = {};  ///< how strongly a node is attracted by what is measured anew,
                                  ///< as curvature is; empty: not
};

/// How strongly the anchors that a graph has attract its nodes.
std::vector<float> anchor_strengths(const PhaseGraph& graph);

/// Where the new field starts; `graph.anchor`, which has what else attracts it, also gets the pull
/// towards there. The last field is smoothed together with those anchors, over a length that is a
/// good part of the surface of `vertices` in all: the zeros of a smoothed field move on with the
/// shape, where those of a field of unit length stay caught between vertices. `fill` solves for the
/// graph's field from scratch; it is asked if somewhere nothing is known. `screened` has the parts
/// of other ranks; all else then is collective, too.
std::vector<Complex> follow_last(PhaseGraph& graph, const LastValues& last, std::size_t vertices,
                                 const std::function<std::vector<Complex>()>& fill,
                                 const ScreenedOptions& screened = {});

}  // namespace brindle
