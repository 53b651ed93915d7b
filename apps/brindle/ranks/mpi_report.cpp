#include "ranks/mpi_report.h"

#include <algorithm>
#include <numbers>
#include <ostream>
#include <vector>

#include "brindle/base/stopwatch.h"
#include "brindle/base/text.h"
#include "brindle/distributed/surface/rank_surface.h"
#include "outputs/resident_memory.h"

namespace brindle::tool {
namespace {

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

RankFigures rank_figures(Communicator& ranks, const DistributedSurface& surface,
                         const DistributedStripeAnimator& animator) {
  const Traffic traffic = surface.traffic();
  const double count = ranks.size();
  const std::size_t own = surface.rank_surface().graph.own;
  const auto memory = resident_memory();
  RankFigures figures;
  figures.ranks = ranks.size();
  const DistributedFigures of_animator = animator.figures();
  figures.distributed_levels = of_animator.distributed_levels;
  figures.vertices_most = ranks.greatest(own);
  figures.vertices_mean = static_cast<double>(surface.vertex_count()) / count;
  figures.ghosts = ranks.sum(of_animator.ghosts);
  figures.bytes_sent = ranks.sum(traffic.bytes);
  figures.messages_sent = ranks.sum(traffic.messages);
  figures.waiting_milliseconds_mean = ranks.sum(traffic.waiting_milliseconds) / count;
  figures.waiting_milliseconds_most = ranks.greatest(traffic.waiting_milliseconds);
  figures.memory_peak_most = ranks.greatest(memory ? memory->peak : std::size_t{0});
  return figures;
}

FrameFigures measure_frames(Communicator& ranks, const DistributedSurface& surface,
                            DistributedStripeAnimator& animator, const WaveSet& waves, int count) {
  std::vector<double> milliseconds;
  WaveSet turned = waves;
  const Traffic before = surface.traffic();
  double total = 0;
  std::uint64_t frequency_bytes = 0, frequency_halo_bytes = 0;
  bool yields = false;
  for (int n = 1; n <= count; ++n) {
    const float radians = static_cast<float>(n) * std::numbers::pi_v<float> / 180;
    turned.directions = rotated(waves.directions, surface.normals(), radians);
    ranks.any(false);  // synchronizes the ranks
    Stopwatch watch;
    const FrameResult frame =
        animator.frame({turned.positions, turned.directions, turned.frequencies});
    const double own = watch.lap();
    yields = frame.frequency_change.sweeps > 0;
    frequency_bytes += animator.figures().frequency_bytes;
    frequency_halo_bytes += animator.figures().frequency_halo_bytes;
    total += own;
    milliseconds.push_back(ranks.greatest(own));
  }
  const Traffic sent = surface.traffic().since(before);
  const double of_ranks = ranks.size();
  const double busy = std::max(0.0, total - sent.waiting_milliseconds);
  const double mean_busy = ranks.sum(busy) / of_ranks;
  FrameFigures figures;
  figures.count = count;
  figures.milliseconds = median(milliseconds);
  figures.bytes_sent = static_cast<double>(ranks.sum(sent.bytes)) / count;
  figures.halo_bytes = ranks.sum(std::uint64_t{animator.figures().halo_bytes});
  if (yields) {
    const auto frames = static_cast<std::uint64_t>(count);
    figures.frequency = FrequencyTraffic{ranks.sum(frequency_bytes) / frames,
                                         ranks.sum(frequency_halo_bytes) / frames};
  }
  figures.waiting_milliseconds = ranks.sum(sent.waiting_milliseconds) / of_ranks / count;
  figures.imbalance = mean_busy > 0 ? ranks.greatest(busy) / mean_busy : 1;
  return figures;
}

nlohmann::ordered_json to_json(const RankFigures& figures) {
  return {{"count", figures.ranks},
          {"distributed_levels", figures.distributed_levels},
          {"vertices_most", figures.vertices_most},
          {"vertices_mean", figures.vertices_mean},
          {"ghosts", figures.ghosts},
          {"bytes_sent", figures.bytes_sent},
          {"messages_sent", figures.messages_sent},
          {"waiting_milliseconds_mean", figures.waiting_milliseconds_mean},
          {"waiting_milliseconds_most", figures.waiting_milliseconds_most},
          {"memory_peak_most", figures.memory_peak_most}};
}

nlohmann::ordered_json to_json(const FrameFigures& figures) {
  nlohmann::ordered_json json = {{"count", figures.count},
                                 {"milliseconds", figures.milliseconds},
                                 {"bytes_sent", figures.bytes_sent},
                                 {"halo_bytes", figures.halo_bytes},
                                 {"waiting_milliseconds", figures.waiting_milliseconds},
                                 {"imbalance", figures.imbalance}};
  if (figures.frequency) {
    json["frequency_bytes_sent"] = figures.frequency->bytes;
    json["frequency_halo_bytes"] = figures.frequency->halo_bytes;
  }
  return json;
}

void print_ranks(std::ostream& out, const RankFigures& figures) {
  out << formatted(
      "ranks     %d, %zu distributed level%s, %.0f vertices each, %zu at most, %zu ghosts in all\n",
      figures.ranks, figures.distributed_levels, figures.distributed_levels == 1 ? "" : "s",
      figures.vertices_mean, figures.vertices_most, figures.ghosts);
  out << formatted(
      "sent      %.3f MB in %llu messages; waiting %.1f ms on average, memory %.0f MB "
      "at most\n",
      1e-6 * static_cast<double>(figures.bytes_sent),
      static_cast<unsigned long long>(figures.messages_sent), figures.waiting_milliseconds_mean,
      1e-6 * static_cast<double>(figures.memory_peak_most));
}

void print_frames(std::ostream& out, const FrameFigures& figures) {
  out << formatted(
      "frames    %d, %.2f ms each; %.3f MB sent, of these %.3f MB by sweeps; waiting %.2f ms, "
      "imbalance %.3f\n",
      figures.count, figures.milliseconds, 1e-6 * figures.bytes_sent,
      1e-6 * static_cast<double>(figures.halo_bytes), figures.waiting_milliseconds,
      figures.imbalance);
  if (!figures.frequency) return;
  out << formatted("yielding  %.3f MB of these for frequencies, %.3f MB by their sweeps\n",
                   1e-6 * static_cast<double>(figures.frequency->bytes),
                   1e-6 * static_cast<double>(figures.frequency->halo_bytes));
}

}  // namespace brindle::tool
