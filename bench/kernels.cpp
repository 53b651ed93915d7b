// How fast the kernels of the solvers are on one thread, against what the machine can copy and
// gather at most in the same run.
#include <algorithm>
#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "benchmarks.h"
#include "brindle/base/stopwatch.h"
#include "brindle/phases/hierarchy.h"
#include "brindle/phases/multilevel.h"
#include "brindle/phases/sliced_kernels.h"
#include "brindle/phases/sliced_waves.h"
#include "gather.h"

namespace brindle::bench {
namespace {

// ---- What the kernels work on -------------------------------------------------------------------

struct Workload {
  Hierarchy hierarchy;
  std::vector<SlicedWave> sliced_waves;
  std::vector<float> degree;
  std::vector<Complex> gauged;
  std::vector<Complex> momentum;
  std::vector<std::uint8_t> marked;
  std::size_t vertices = 0;
  std::size_t directed_edges = 0;
  std::size_t summed_entries = 0;  ///< fine entries that add to a coarse one
  std::size_t inner_entries = 0;   ///< fine entries from a member of an aggregate to an earlier one

  Level& fine() { return hierarchy.levels[0]; }
  Level& coarse() { return hierarchy.levels[1]; }
  SliceRange all_slices() { return {0, fine().layout().slice_count()}; }
};

std::size_t count_below(const std::vector<Index>& entries, std::size_t limit) {
  return static_cast<std::size_t>(
      std::ranges::count_if(entries, [&](Index entry) { return entry < limit; }));
}

std::unique_ptr<Workload> make_workload(const Subject& subject) {
  const WaveSet& waves = subject.fields[0];
  auto work = std::make_unique<Workload>();
  work->vertices = subject.vertex_count();
  work->directed_edges = subject.surface.neighborhood->directed_edge_count();
  work->hierarchy = build_hierarchy(build_phase_graph(subject.surface.neighborhood, waves));
  descend(work->hierarchy, 2);
  const SlicedLayout& layout = work->fine().layout();
  load_waves(layout, waves.positions, waves.directions, waves.frequencies, work->sliced_waves);
  work->degree.resize(layout.slot_count());
  work->gauged.resize(work->fine().aggregation().sources.places);
  work->momentum.resize(layout.slot_count());
  work->marked.resize(work->coarse().layout().slice_count());
  const Aggregation& aggregation = work->fine().aggregation();
  work->summed_entries = static_cast<std::size_t>(
      std::ranges::count_if(aggregation.sources.entry, [](Index place) { return place != 0; }));
  work->inner_entries = count_below(aggregation.gauges.entry, layout.entry_count());
  return work;
}

// ---- The kernels --------------------------------------------------------------------------------

/// Either implementation.
struct Kernels {
  const char* name;
  CoupleSlices* couple;
  SweepSlices* sweep;
  RelaxSlices* relax;
  GaugeSlices* gauge;
  GaugeMembers* members;
  SumSlices* sum;
  ProlongSlices* prolong;
  std::uint64_t (*gather)(std::span<const Index>, std::span<const Complex>);
};

std::vector<Kernels> all_kernels() {
  return {{"portable", portable::couple_slices, portable::sweep_slices, portable::relax_slices,
           portable::gauge_slices, portable::gauge_members, portable::sum_slices,
           portable::prolong_slices, gather_portable},
#ifdef BRINDLE_HAS_HIGHWAY
          {"simd", simd::couple_slices, simd::sweep_slices, simd::relax_slices, simd::gauge_slices,
           simd::gauge_members, simd::sum_slices, simd::prolong_slices, gather_simd}
#endif
  };
}

template <class Update>
void for_each_range(const SlicedLayout& layout, const Update& update) {
  for (const SliceRange& range : layout.ranges) update(range);
}

void couple(Workload& work, const Kernels& kernels) {
  kernels.couple(work.fine().layout(), work.sliced_waves.data(), PhaseShiftKind::aligned, nullptr,
                 work.fine().couplings, work.degree.data(), work.all_slices());
}

void sweep(Workload& work, const Kernels& kernels) {
  Level& level = work.fine();
  for_each_range(level.layout(), [&](SliceRange range) {
    kernels.sweep(level.layout(), level.couplings, level.z.data(), 1, range);
  });
}

void relax(Workload& work, const Kernels& kernels) {
  Level& level = work.fine();
  for_each_range(level.layout(), [&](SliceRange range) {
    benchmark::DoNotOptimize(kernels.relax(level.layout(), level.couplings, level.z.data(), 0.2f,
                                           work.momentum.data(), range));
  });
}

void members(Workload& work, const Kernels& kernels) {
  Level& level = work.fine();
  const GaugeSchedule& rounds = level.aggregation().gauges;
  for (const SliceRange& groups : rounds.ranges) {
    kernels.members(level.couplings, rounds, level.gauge.data(), groups);
  }
}

// Gauges and sums take turns, coarse block by coarse block, so that sums find gauged couplings in
// the second cache. Timed alone, each kernel meets what the other left there.
void gauge(Workload& work, const Kernels& kernels) {
  const SlicedLayout& layout = work.fine().layout();
  const SumSchedule& sources = work.fine().aggregation().sources;
  for (Index block = 0; block < work.coarse().layout().block_count(); ++block) {
    Complex* gauged = work.gauged.data() + kLanes;
    for (const SliceRange& run : sources.runs_of(block)) {
      kernels.gauge(layout, work.fine().couplings, work.fine().gauge.data(), gauged, run);
      gauged += std::size_t{layout.column_begin[run.end] - layout.column_begin[run.begin]} * kLanes;
    }
  }
}

void sum(Workload& work, const Kernels& kernels) {
  const SlicedLayout& coarse = work.coarse().layout();
  const SumSchedule& sources = work.fine().aggregation().sources;
  for (Index block = 0; block < coarse.block_count(); ++block) {
    kernels.sum(coarse, sources.round_begin.data(), sources.entry.data(), work.gauged.data(),
                work.coarse().couplings.direct.get(), work.marked.data(), coarse.block(block));
  }
}

void prolong(Workload& work, const Kernels& kernels) {
  kernels.prolong(work.fine().gauge.data(), work.fine().aggregation().coarse_slot.data(),
                  work.coarse().z.data(), work.fine().z.data(), work.all_slices());
}

// In the order in which a sweep reads: colour by colour.
void gather(Workload& work, const Kernels& kernels) {
  const SlicedLayout& layout = work.fine().layout();
  for_each_range(layout, [&](SliceRange range) {
    const std::size_t begin = std::size_t{layout.column_begin[range.begin]} * kLanes;
    const std::size_t end = std::size_t{layout.column_begin[range.end]} * kLanes;
    benchmark::DoNotOptimize(
        kernels.gather(std::span(layout.neighbor).subspan(begin, end - begin), work.fine().z));
  });
}

// ---- What is counted ----------------------------------------------------------------------------

/// Bytes of state that an element needs at least, read and written: rows are filled up to the width
/// of their slice, but filling is not counted, it is a loss.
struct Job {
  const char* name;
  void (*run)(Workload&, const Kernels&);
  std::size_t Workload::*elements;
  double bytes;
  const char* parts;
};

constexpr double kIndex = sizeof(Index), kComplex = sizeof(Complex), kWave = sizeof(SlicedWave);

// Sums must come after gauge: they read what it wrote.
const Job kJobs[] = {
    {"gather", gather, &Workload::directed_edges, kIndex + kComplex, "an edge: index 4, z 8"},
    {"sweep", sweep, &Workload::directed_edges, kIndex + 2 * kComplex,
     "an edge: index 4, coupling 8, z 8"},
    {"relax", relax, &Workload::directed_edges, kIndex + 2 * kComplex,
     "an edge: index 4, coupling 8, z 8"},
    {"couple", couple, &Workload::directed_edges, kIndex + kWave + kComplex,
     "an edge: index 4, wave 32; writes coupling 8"},
    {"members", members, &Workload::inner_entries, 2 * kIndex + 2 * kComplex,
     "an edge to an earlier member: entry 4, index 4, coupling 8, gauge 8"},
    {"gauge", gauge, &Workload::directed_edges, kIndex + 3 * kComplex,
     "an edge: index 4, coupling 8, gauge 8; writes 8"},
    {"sum", sum, &Workload::summed_entries, kIndex + kComplex,
     "a fine edge between aggregates: entry 4, gauged coupling 8"},
    {"prolong", prolong, &Workload::vertices, kIndex + 3 * kComplex,
     "a vertex: coarse slot 4, gauge 8, coarse z 8; writes z 8"},
};

/// Times `work`, which moves `bytes`; the best run counts, because disturbances only slow it down.
void repeat_moving(benchmark::State& state, double bytes, const std::function<void()>& work) {
  repeat(state, [&] {
    Stopwatch watch;
    work();
    benchmark::ClobberMemory();
    return Sample{watch.lap()};
  });
  state.counters["bytes_per_second"] = 1000 * bytes / state.counters["min_ms"].value;
}

void run_job(benchmark::State& state, Workload& work, const Kernels& kernels, const Job& job) {
  gauge(work, kernels);
  repeat_moving(state, job.bytes * static_cast<double>(work.*job.elements),
                [&] { job.run(work, kernels); });
  state.counters["entries_per_edge"] = static_cast<double>(work.fine().layout().entry_count()) /
                                       static_cast<double>(work.directed_edges);
}

/// Copies as many bytes as a sweep's state has; both reading and writing count.
void run_copy(benchmark::State& state, const Workload& work) {
  const std::size_t size = work.directed_edges * static_cast<std::size_t>(kIndex + 2 * kComplex);
  const std::vector<char> from(size, 1);
  std::vector<char> to(size);
  repeat_moving(state, 2 * static_cast<double>(size), [&] {
    std::memcpy(to.data(), from.data(), size);
    benchmark::DoNotOptimize(to.data());
  });
}

}  // namespace

void add_kernels(const Subject& subject) {
  // Made by the first benchmark that runs.
  const auto made = std::make_shared<std::unique_ptr<Workload>>();
  const auto work = [made, &subject]() -> Workload& {
    if (!*made) *made = make_workload(subject);
    return **made;
  };
  add_benchmark("kernel_copy", subject, 1,
                [work](benchmark::State& state) { run_copy(state, work()); });
  for (const Job& job : kJobs) {
    for (const Kernels& kernels : all_kernels()) {
      add_benchmark(
          std::string("kernel_") + job.name + '_' + kernels.name, subject, 1,
          [work, kernels, &job](benchmark::State& state) { run_job(state, work(), kernels, job); });
    }
  }
}

}  // namespace brindle::bench
