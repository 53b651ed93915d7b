#include "benchmarks.h"

#include <algorithm>
#include <map>
#include <utility>

#include "brindle/base/text.h"
#include "brindle/threads.h"

namespace brindle::bench {
namespace {

double median_of(std::vector<double> values) {
  std::ranges::sort(values);
  return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

}  // namespace

benchmark::internal::Benchmark* add_benchmark(const std::string& name, const Subject& subject,
                                              int threads,
                                              std::function<void(benchmark::State&)> run) {
  const std::string full = name + '/' + subject.name + formatted("/threads:%d", threads);
  const auto limited = [&subject, threads, run = std::move(run)](benchmark::State& state) {
    const ThreadLimit limit(threads);
    run(state);
    state.counters["vertices"] = static_cast<double>(subject.vertex_count());
  };
  return benchmark::RegisterBenchmark(full.c_str(), limited)
      ->Unit(benchmark::kMillisecond)
      ->UseManualTime();
}

void repeat(benchmark::State& state, const std::function<Sample()>& run) {
  run();
  std::vector<double> times;
  std::map<std::string, std::vector<double>> stages;
  for (auto _ : state) {
    const Sample sample = run();
    state.SetIterationTime(1e-3 * sample.time);
    times.push_back(sample.time);
    for (const auto& [stage, time] : sample.stages) stages[std::string(stage)].push_back(time);
  }
  state.counters["min_ms"] = *std::ranges::min_element(times);
  state.counters["median_ms"] = median_of(times);
  for (const auto& [stage, values] : stages) state.counters[stage + "_ms"] = median_of(values);
}

void show(benchmark::State& state, const Quality& quality) {
  state.counters["energy"] = quality.energy;
  state.counters["branches"] = static_cast<double>(quality.branches);
  state.counters["angle_error_mean_deg"] = quality.angle_error_mean_deg;
}

}  // namespace brindle::bench
