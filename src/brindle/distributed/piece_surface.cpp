#include <cmath>
#include <utility>

#include "brindle/communicator.h"
#include "brindle/distributed/surface/rank_surface.h"
#include "brindle/distributed_waves.h"
#include "brindle/waves/frequency_parts.h"

namespace brindle {

bool PieceSurface::any(bool here) const { return surface_.rank_surface().ranks->any(here); }

std::size_t PieceSurface::drop_waves(DirectionField& directions,
                                     FrequencyField& frequencies) const {
  Communicator& ranks = *surface_.rank_surface().ranks;
  std::size_t dropped = 0;
  for (std::size_t v = 0; v < frequencies.size(); ++v) {
    dropped += surface_.is_own()[v] != 0 && std::isnan(frequencies[v]) && !directions[v].isZero(0);
  }
  FrequencySum all;
  for (const FrequencySum& of_rank : ranks.all(sum_of(frequencies, surface_.is_own()))) {
    all.sum += of_rank.sum;
    all.count += of_rank.count;
  }
  drop_waves_without_frequency(directions, frequencies, all.mean());
  return ranks.sum(dropped);
}

DetailedFrequencies PieceSurface::frequencies_at_detail(std::span<const float> frequencies,
                                                        const FrequencyDetailOptions& options,
                                                        const Progress& progress) const {
  return detailed_frequencies(surface_, frequencies, options, progress);
}

std::pair<DetailedField, FieldDetailFigures> PieceSurface::field_at_detail(
    const MeasuredField& measured, std::span<const float> places, const DirectionField& last,
    const FieldDetailOptions& options, const Progress& progress) const {
  DistributedDetail seen =
      detailed_field(surface_, measured, places, options, {last, {}}, progress);
  return {std::move(seen.field), seen.figures};
}

}  // namespace brindle
