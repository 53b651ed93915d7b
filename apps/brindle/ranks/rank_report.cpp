#include "ranks/rank_report.h"

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

double number(const nlohmann::ordered_json& figures, const char* key) {
  return figures[key].get<double>();
}

double megabytes(const nlohmann::ordered_json& figures, const char* key) {
  return 1e-6 * number(figures, key);
}

}  // namespace

nlohmann::ordered_json rank_figures(Communicator& ranks, const DistributedSurface& surface,
                                    const DistributedStripeAnimator& animator) {
  const Traffic traffic = surface.traffic();
  const double count = ranks.size();
  const auto memory = resident_memory();
  const DistributedFigures of_animator = animator.figures();
  nlohmann::ordered_json figures = {{"count", ranks.size()},
                                    {"distributed_levels", of_animator.distributed_levels}};
  figures["vertices_most"] = ranks.greatest(surface.rank_surface().graph.own);
  figures["vertices_mean"] = static_cast<double>(surface.vertex_count()) / count;
  figures["ghosts"] = ranks.sum(of_animator.ghosts);
  figures["bytes_sent"] = ranks.sum(traffic.bytes);
  figures["messages_sent"] = ranks.sum(traffic.messages);
  figures["waiting_milliseconds_mean"] = ranks.sum(traffic.waiting_milliseconds) / count;
  figures["waiting_milliseconds_most"] = ranks.greatest(traffic.waiting_milliseconds);
  figures["memory_peak_most"] = ranks.greatest(memory ? memory->peak : std::size_t{0});
  return figures;
}

nlohmann::ordered_json measure_frames(Communicator& ranks, const DistributedSurface& surface,
                                      DistributedStripeAnimator& animator, const WaveSet& waves,
                                      int count) {
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
  const double busy = std::max(0.0, total - sent.waiting_milliseconds);
  const double mean_busy = ranks.sum(busy) / ranks.size();
  nlohmann::ordered_json figures = {{"count", count}, {"milliseconds", median(milliseconds)}};
  figures["bytes_sent"] = static_cast<double>(ranks.sum(sent.bytes)) / count;
  figures["halo_bytes"] = ranks.sum(std::uint64_t{animator.figures().halo_bytes});
  figures["waiting_milliseconds"] = ranks.sum(sent.waiting_milliseconds) / ranks.size() / count;
  const double most_busy = ranks.greatest(busy);
  figures["imbalance"] = mean_busy > 0 ? most_busy / mean_busy : 1;
  if (!yields) return figures;
  const auto frames = static_cast<std::uint64_t>(count);
  figures["frequency_bytes_sent"] = ranks.sum(frequency_bytes) / frames;
  figures["frequency_halo_bytes"] = ranks.sum(frequency_halo_bytes) / frames;
  return figures;
}

void print_ranks(std::ostream& out, const nlohmann::ordered_json& figures) {
  const auto levels = figures["distributed_levels"].get<std::size_t>();
  out << formatted(
      "ranks     %d, %zu distributed level%s, %.0f vertices each, %.0f at most, %.0f ghosts in "
      "all\n",
      figures["count"].get<int>(), levels, levels == 1 ? "" : "s", number(figures, "vertices_mean"),
      number(figures, "vertices_most"), number(figures, "ghosts"));
  out << formatted(
      "sent      %.3f MB in %.0f messages; waiting %.1f ms on average, memory %.0f MB at most\n",
      megabytes(figures, "bytes_sent"), number(figures, "messages_sent"),
      number(figures, "waiting_milliseconds_mean"), megabytes(figures, "memory_peak_most"));
}

void print_frames(std::ostream& out, const nlohmann::ordered_json& figures) {
  out << formatted(
      "frames    %d, %.2f ms each; %.3f MB sent, of these %.3f MB by sweeps; waiting %.2f ms, "
      "imbalance %.3f\n",
      figures["count"].get<int>(), number(figures, "milliseconds"),
      megabytes(figures, "bytes_sent"), megabytes(figures, "halo_bytes"),
      number(figures, "waiting_milliseconds"), number(figures, "imbalance"));
  if (!figures.contains("frequency_bytes_sent")) return;
  out << formatted("yielding  %.3f MB of these for frequencies, %.3f MB by their sweeps\n",
                   megabytes(figures, "frequency_bytes_sent"),
                   megabytes(figures, "frequency_halo_bytes"));
}

}  // namespace brindle::tool
