/// How dense waves are on their surface, and what is probably not meant by them.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "brindle/export.h"
#include "brindle/phase_graph.h"
#include "brindle/surface.h"

namespace BRINDLE_EXPORT brindle {

/// All but the counts are over the vertices with neighbours and a wave. Vertices without
/// neighbours, which no triangle uses, have no say in anything.
struct WaveFigures {
  std::size_t used = 0;          ///< vertices with neighbours
  std::size_t without_wave = 0;  ///< of these
  double frequency_min = 0;      ///< stripes per unit length
  double frequency_max = 0;
  double stripes = 0;  ///< of the mean frequency, along the diagonal of the bounding box
  // How many edges a wave passes within a period: the period over how far a vertex's edges run
  // along its wave, on average. Below two, neighbours are more than half a period apart. 0 if no
  // edge runs along any wave.
  double edges_per_period_min = 0;
  double edges_per_period_median = 0;
};

/// `waves` has one entry per vertex.
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

/// What a program calls what its users can do; warnings say it.
struct WarningWords {
  std::string fewer =
      "take fewer stripes, or a lower frequency, which counts stripes per unit of the mesh's own "
      "length";
  std::string subdivide = "subdivide the mesh, times:";  ///< a number follows
  std::string field = "field";                           ///< as in "a smoother field"
  std::string source = "the field";                      ///< where directions come from
  std::string detail = "FieldDetail";  ///< what sees measured fields at the scale of stripes
  std::string singularities = "FieldDetailOptions::singularities";  ///< of their number
  std::string join = "join them with make_repaired_mesh";           ///< vertices at one place
};

/// What is probably not meant, a sentence each without a full stop: waves missing at more than a
/// vertex in a hundred; stripes finer than the mesh can carry. Empty if there is nothing to say.
std::vector<std::string> wave_warnings(const WaveFigures& figures, const WarningWords& words = {});

/// The same of more branches than a triangle in ten, unless stripes are too fine anyway.
std::vector<std::string> branch_warnings(const WaveFigures& figures, std::size_t branches,
                                         std::size_t triangles, const WarningWords& words = {});

/// The same of a measured field, taken as it is, that turns round more than a triangle in a
/// hundred.
std::vector<std::string> noise_warnings(std::size_t field_singularities, std::size_t triangles,
                                        const WarningWords& words = {});

/// Throws Error if no vertex has a wave, or half of them pass a 10,000th of an edge a period or
/// less. `why` follows the reason for the first.
void check_figures(const WaveFigures& figures, const WarningWords& words = {},
                   const std::string& why = {});

}  // namespace brindle
