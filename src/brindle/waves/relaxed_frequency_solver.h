/// The solver of `relaxed_frequencies`, for a whole surface or for the parts of several processes,
/// and for frames.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "brindle/base/archive.h"
#include "brindle/progress.h"
#include "brindle/spacing_tolerance.h"
#include "brindle/types.h"
#include "brindle/waves/bounded_multigrid.h"
#include "brindle/waves/frequency_rows.h"

namespace brindle {

/// S by vertex, enlarged by branch avoidance (`branch_penalty`).
std::vector<float> slack_by_vertex(const Slack& slack, std::size_t vertices);

/// w_T, by the largest `branch_penalty` of each triangle's corners. Empty without branch avoidance.
std::vector<float> penalty_weights(std::span<const Triangle> triangles,
                                   std::span<const float> branch_penalty);

/// The constant input. Vertices of other processes (ghosts) come last.
struct RelaxedFrequencySetting {
  std::vector<float> slack;           ///< by vertex
  std::vector<float> branch_penalty;  ///< by vertex, from 0 to 1; empty: 0
  FrequencyTriangles triangles;
  std::shared_ptr<const Adjacency> adjacency;
};

/// For a whole surface. Throws Error as `check_slack` does; Cancelled if `progress` cancels.
std::shared_ptr<const RelaxedFrequencySetting> relaxed_setting(const Surface& surface,
                                                               const Slack& slack,
                                                               const Progress& progress = {});

/// Sums of areas times ratios g / f: over all rows, those not at a bound, and weighted by
/// `branch_penalty`.
struct RatioSums {
  double ratio = 0, free = 0, area = 0, penalized_ratio = 0, penalized_area = 0;
  RatioSums operator+(const RatioSums& o) const {
    return {ratio + o.ratio, free + o.free, area + o.area, penalized_ratio + o.penalized_ratio,
            penalized_area + o.penalized_area};
  }
  std::array<double, 5> numbers() const {
    return {ratio, free, area, penalized_ratio, penalized_area};
  }
  static RatioSums of(const std::array<double, 5>& n) { return {n[0], n[1], n[2], n[3], n[4]}; }
  double mean() const { return area > 0 ? ratio / area : 1; }
  double penalized_mean() const {
    return penalized_area > 0 ? penalized_ratio / penalized_area : 1;
  }
};

/// Relaxes the frequencies of one frame after another. With peers, all processes must call all
/// functions except accessors and `keep`, and `progress` must throw on all or none.
class RelaxedFrequencySolver {
 public:
  /// Without a setting, all frequencies stay fixed: nothing is ever solved or kept.
  RelaxedFrequencySolver() = default;
  explicit RelaxedFrequencySolver(std::shared_ptr<const RelaxedFrequencySetting> setting,
                                  std::shared_ptr<MultigridPeers> peers = nullptr);

  bool relaxes() const { return setting_ != nullptr; }

  /// A solver for the same setting without a kept result; only without peers.
  RelaxedFrequencySolver sibling() const { return RelaxedFrequencySolver(setting_); }

  /// Changes the slack from the next `solve` on. It starts from the kept result unless
  /// `branch_penalty` changes weights of triangles. Throws Error as `check_slack` does; only
  /// without peers.
  void set_slack(const Slack& slack);

  /// The same by a setting with the same adjacency; with peers, all must call it.
  /// `weighs_as_before`: whether all triangles, also those of peers, keep their weights.
  void set_setting(std::shared_ptr<const RelaxedFrequencySetting> setting, bool weighs_as_before);
  const RelaxedFrequencySetting& setting() const { return *setting_; }

  /// The frequency per vertex, ghosts included; the span is valid until the next call but one.
  /// Values are not checked. Starts from the kept result, relative to the wanted frequencies, and
  /// then allocates nothing. `progress` gets fractions if nothing is kept. Cancelled or failed
  /// calls leave the kept result unchanged.
  std::span<const float> solve(const FrequencyInput& input, const Progress& progress = {});

  /// Keeps the last result as the next start, and its input. Does nothing if there is none to keep:
  /// before `solve`, after one that failed, or after a change of slack. Does not throw.
  void keep(const FrequencyInput& input);

  /// Whether the input equals the one kept last, with the same slack.
  bool is_kept(const FrequencyInput& input) const;

  /// Drops the kept result.
  void restart() { starts_ = true; }

  /// The kept frequencies, and their change.
  std::span<const float> frequencies() const { return frequencies_; }
  const FrequencyChange& kept_change() const { return kept_change_; }

  /// The change by the last `solve`.
  const FrequencyChange& change() const { return change_; }

  /// Saves what is kept, or restores it for the same setting. Throws Error for waves that
  /// `check_waves` rejects. Only without peers.
  void archive(Archive& archive);

 private:
  void build(const FrequencyInput& input, const Progress& progress);
  void set_bounds();
  void set_start(const Progress& progress);
  /// Progress within a step: none with peers, whose steps may differ.
  Progress inner(const Progress& progress) const { return peers_ ? Progress() : progress; }
  void relax(const Progress& progress);
  float penalty_at(std::size_t place) const;
  RatioSums ratios(float shift) const;
  RatioSums shift_to_mean();
  void set_branch_penalty(float target);
  void relax_to_means(const Progress& progress);
  void take(std::span<const float> wanted);

  std::shared_ptr<const RelaxedFrequencySetting> setting_;
  std::shared_ptr<MultigridPeers> peers_;
  std::unique_ptr<FrequencyRows> rows_;  ///< null before the first `solve`
  std::unique_ptr<BoundedMultigrid> multigrid_;
  FrequencyTerms terms_;
  std::vector<RowMass> masses_;
  std::vector<float> relaxed_, kept_;      ///< x by place, before its shift to the mean
  float target_ = 0, kept_target_ = 0;     ///< of logarithms under branch avoidance
  std::vector<float> next_, frequencies_;  ///< by vertex: of the last `solve`, and kept
  FrequencyChange change_, kept_change_;
  WaveSet kept_input_;         ///< of the kept result
  WaveSet built_for_;          ///< the kept input whose directions the levels follow
  bool has_kept_ = false;      ///< whether there is a kept result of this slack
  bool has_next_ = false;      ///< whether there is a result that is not kept
  bool settled_ = false;       ///< whether a result was kept since rows were built
  bool starts_ = true;         ///< whether there is no kept result to start from
  bool other_bounds_ = false;  ///< whether the kept result belongs to other bounds
};

}  // namespace brindle
