/// The results of a run beside each other.
#pragma once

#include <string>
#include <vector>

#include <benchmark/benchmark.h>

namespace brindle::bench {

/// Prints results as they come, and keeps them.
class Table : public benchmark::ConsoleReporter {
 public:
  Table() : ConsoleReporter(OO_None) {}
  void ReportRuns(const std::vector<Run>& runs) override;

  /// Minima and medians, times per vertex, and ratios to frames of the same mesh and threads; for
  /// kernels bytes per second, and ratios to copying and gathering.
  void print() const;

 private:
  struct Row {
    std::string name;
    std::string of;              ///< mesh and threads
    double min = 0, median = 0;  ///< ms
    double vertices = 0;
    double bytes_per_second = 0;  ///< 0: no kernel
  };
  void print_times() const;
  void print_kernels() const;
  /// The shortest frame of this mesh and threads, in ms; 0 if none ran.
  double frame(const std::string& of) const;
  /// The most bytes per second of kernels whose names begin so; 0 if none ran.
  double speed(const std::string& begin, const std::string& of) const;

  std::vector<Row> rows_;
};

}  // namespace brindle::bench
