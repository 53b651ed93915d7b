/// How dense waves are on their surface, and where there are none.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "brindle/phase_graph.h"
#include "brindle/surface.h"

namespace brindle::tool {

/// Vertices without a wave, by what a tensor's axis is to them.
struct MissingTensorWaves {
  std::size_t near_normal = 0;  ///< too near to the normal
  std::size_t isotropic = 0;    ///< not the only one with its eigenvalue
};

/// Vertices without a wave, by reasons that are known; each counts once.
struct MissingWaves {
  std::optional<MissingTensorWaves> tensor;      ///< of a field that is a tensor
  std::optional<std::size_t> without_frequency;  ///< of frequencies that are an array
  std::optional<std::size_t> too_far;            ///< of a field on another mesh

  std::size_t total() const {
    return (tensor ? tensor->near_normal + tensor->isotropic : 0) + without_frequency.value_or(0) +
           too_far.value_or(0);
  }
};

/// All but the counts are over the vertices with neighbours and a wave. Vertices without
/// neighbours, which no triangle uses, have no say in anything.
struct WaveFigures {
  std::size_t used = 0;          ///< vertices with neighbours
  std::size_t without_wave = 0;  ///< of these
  MissingWaves missing;          ///< why
  double frequency_min = 0;      ///< stripes per unit length
  double frequency_max = 0;
  double stripes = 0;  ///< of the mean frequency, along the diagonal of the bounding box
  // How many edges a wave passes within a period: the period over how far a vertex's edges run
  // along its wave, on average. Below two, neighbours are more than half a period apart.
  double edges_per_period_min = 0;
  double edges_per_period_median = 0;
};

WaveFigures measure_waves(const Surface& surface, const WaveSet& waves);

/// What the figures are told from, of the vertices that have an entry in `waves`: those of a part
/// of a surface.
struct WaveTally {
  std::size_t used = 0, without_wave = 0;
  double frequency_sum = 0, frequency_max = 0;
  double frequency_min = std::numeric_limits<double>::infinity();
  std::vector<double> edges_per_period;  ///< of vertices with a wave and an edge along it
};

WaveTally tally_waves(const Surface& surface, const WaveSet& waves);

/// The figures of a tally but edges per period; `diagonal` is that of the bounding box.
WaveFigures figures_of(const WaveTally& tally, double diagonal);

/// Throws Error if there is no wave at all, or waves are too fine for any number; `source` says
/// where the waves come from: "the field 'wind.csv'".
void check_waves(const WaveFigures& figures, const std::string& source);

/// Lines for people: where waves are missing for a reason that is known; and what is probably not
/// meant: waves missing for another reason at more than a vertex in a hundred, stripes too fine for
/// the mesh. Empty if there is nothing to say.
std::string warnings(const WaveFigures& figures, const std::string& source);

/// The same of more branches than a triangle in ten, unless stripes are too fine anyway.
std::string branch_warning(const WaveFigures& figures, std::size_t branches, std::size_t triangles);

}  // namespace brindle::tool
