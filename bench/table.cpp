#include "table.h"

#include <algorithm>
#include <cstdio>

namespace brindle::bench {
namespace {

double counter(const benchmark::UserCounters& counters, const char* name) {
  const auto found = counters.find(name);
  return found == counters.end() ? 0 : found->second.value;
}

void print_ratio(double numerator, double denominator) {
  if (denominator > 0) {
    std::printf(" %9.2f", numerator / denominator);
  } else {
    std::printf(" %9s", "-");
  }
}

}  // namespace

void Table::ReportRuns(const std::vector<Run>& runs) {
  ConsoleReporter::ReportRuns(runs);
  for (const Run& run : runs) {
    if (run.run_type != Run::RT_Iteration || !run.counters.contains("min_ms")) continue;
    const std::string& name = run.run_name.function_name;
    const std::size_t slash = name.find('/');
    rows_.push_back({name.substr(0, slash), name.substr(slash + 1), counter(run.counters, "min_ms"),
                     counter(run.counters, "median_ms"), counter(run.counters, "vertices"),
                     counter(run.counters, "bytes_per_second")});
  }
}

double Table::frame(const std::string& of) const {
  double least = 0;
  for (const Row& row : rows_) {
    if (row.of != of || row.name != "frame") continue;
    least = least == 0 ? row.min : std::min(least, row.min);
  }
  return least;
}

double Table::speed(const std::string& begin, const std::string& of) const {
  double most = 0;
  for (const Row& row : rows_) {
    if (row.of == of && row.name.starts_with(begin)) most = std::max(most, row.bytes_per_second);
  }
  return most;
}

void Table::print_times() const {
  std::printf("\n%9s %9s %9s %9s\n", "min ms", "median", "ns/vertex", "/ frame");
  for (const Row& row : rows_) {
    if (row.bytes_per_second > 0) continue;
    std::printf("%9.3f %9.3f %9.1f", row.min, row.median, 1e6 * row.min / row.vertices);
    print_ratio(row.min, frame(row.of));
    std::printf("  %s/%s\n", row.name.c_str(), row.of.c_str());
  }
}

void Table::print_kernels() const {
  std::printf("\n%9s %9s %9s\n", "GB/s", "/ gather", "/ copy");
  for (const Row& row : rows_) {
    if (row.bytes_per_second <= 0) continue;
    std::printf("%9.2f", 1e-9 * row.bytes_per_second);
    print_ratio(row.bytes_per_second, speed("kernel_gather", row.of));
    print_ratio(row.bytes_per_second, speed("kernel_copy", row.of));
    std::printf("  %s/%s\n", row.name.c_str(), row.of.c_str());
  }
}

void Table::print() const {
  const auto is_kernel = [](const Row& row) { return row.bytes_per_second > 0; };
  if (!std::ranges::all_of(rows_, is_kernel)) print_times();
  if (std::ranges::any_of(rows_, is_kernel)) print_kernels();
}

}  // namespace brindle::bench
