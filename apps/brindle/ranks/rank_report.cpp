#include "ranks/rank_report.h"

#include <algorithm>
#include <numbers>
#include <ostream>
#include <vector>

#include "brindle/base/memory.h"
#include "brindle/base/stopwatch.h"
#include "brindle/base/text.h"
#include "brindle/distributed/surface/rank_surface.h"

namespace brindle::tool {
namespace {

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double number(const nlohmann::ordered_json& metrics, const char* key) {
  return metrics[key].get<double>();
}

double megabytes(const nlohmann::ordered_json& metrics, const char* key) {
  return 1e-6 * number(metrics, key);
}

}  // namespace

nlohmann::ordered_json rank_metrics(Communicator& ranks, const DistributedSurface& surface,
                                    const DistributedStripeAnimator& animator) {
  const Traffic traffic = surface.traffic();
  const double count = ranks.size();
  const auto memory = resident_memory();
  const DistributedMetrics of_animator = animator.metrics();
  nlohmann::ordered_json metrics = {{"count", ranks.size()},
                                    {"distributed_levels", of_animator.distributed_levels}};
  metrics["vertices_most"] = ranks.greatest(surface.rank_surface().graph.own);
  metrics["vertices_mean"] = static_cast<double>(surface.vertex_count()) / count;
  metrics["ghosts"] = ranks.sum(of_animator.ghosts);
  metrics["bytes_sent"] = ranks.sum(traffic.bytes);
  metrics["messages_sent"] = ranks.sum(traffic.messages);
  metrics["waiting_milliseconds_mean"] = ranks.sum(traffic.waiting_milliseconds) / count;
  metrics["waiting_milliseconds_most"] = ranks.greatest(traffic.waiting_milliseconds);
  metrics["memory_peak_most"] = ranks.greatest(memory ? memory->peak : std::size_t{0});
  return metrics;
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
    frequency_bytes += animator.metrics().frequency_bytes;
    frequency_halo_bytes += animator.metrics().frequency_halo_bytes;
    total += own;
    milliseconds.push_back(ranks.greatest(own));
  }
  const Traffic sent = surface.traffic().since(before);
  const double busy = std::max(0.0, total - sent.waiting_milliseconds);
  const double mean_busy = ranks.sum(busy) / ranks.size();
  nlohmann::ordered_json metrics = {{"count", count}, {"milliseconds", median(milliseconds)}};
  metrics["bytes_sent"] = static_cast<double>(ranks.sum(sent.bytes)) / count;
  metrics["halo_bytes"] = ranks.sum(std::uint64_t{animator.metrics().halo_bytes});
  metrics["waiting_milliseconds"] = ranks.sum(sent.waiting_milliseconds) / ranks.size() / count;
  const double most_busy = ranks.greatest(busy);
  metrics["imbalance"] = mean_busy > 0 ? most_busy / mean_busy : 1;
  if (!yields) return metrics;
  const auto frames = static_cast<std::uint64_t>(count);
  metrics["frequency_bytes_sent"] = ranks.sum(frequency_bytes) / frames;
  metrics["frequency_halo_bytes"] = ranks.sum(frequency_halo_bytes) / frames;
  return metrics;
}

void print_ranks(std::ostream& out, const nlohmann::ordered_json& metrics) {
  const auto levels = metrics["distributed_levels"].get<std::size_t>();
  out << formatted(
      "ranks     %d, %zu distributed level%s, %.0f vertices each, %.0f at most, %.0f ghosts in "
      "all\n",
      metrics["count"].get<int>(), levels, levels == 1 ? "" : "s", number(metrics, "vertices_mean"),
      number(metrics, "vertices_most"), number(metrics, "ghosts"));
  out << formatted(
      "sent      %.3f MB in %.0f messages; waiting %.1f ms on average, memory %.0f MB at most\n",
      megabytes(metrics, "bytes_sent"), number(metrics, "messages_sent"),
      number(metrics, "waiting_milliseconds_mean"), megabytes(metrics, "memory_peak_most"));
}

void print_frames(std::ostream& out, const nlohmann::ordered_json& metrics) {
  out << formatted(
      "frames    %d, %.2f ms each; %.3f MB sent, of these %.3f MB by sweeps; waiting %.2f ms, "
      "imbalance %.3f\n",
      metrics["count"].get<int>(), number(metrics, "milliseconds"),
      megabytes(metrics, "bytes_sent"), megabytes(metrics, "halo_bytes"),
      number(metrics, "waiting_milliseconds"), number(metrics, "imbalance"));
  if (!metrics.contains("frequency_bytes_sent")) return;
  out << formatted("slack     %.3f MB of these for frequencies, %.3f MB by their sweeps\n",
                   megabytes(metrics, "frequency_bytes_sent"),
                   megabytes(metrics, "frequency_halo_bytes"));
}

}  // namespace brindle::tool
