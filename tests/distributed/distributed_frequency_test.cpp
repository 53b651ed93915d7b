#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "brindle/distributed/levels/rank_rows.h"
#include "brindle/distributed/surface/rank_surface.h"
#include "brindle/distributed_stripes.h"
#include "brindle/error.h"
#include "brindle/spacing_tolerance.h"
#include "brindle/stripe_pattern.h"
#include "brindle/threads.h"
#include "brindle/waves/frequency_rows.h"
#include "ranks.h"
#include "torn_mesh.h"
#include "waves/least_squares_reference.h"

namespace brindle {
namespace {

using namespace testing_support;

constexpr float kSlack = 0.25f;

WaveSet turned_by(const WavySurface& whole, float radians) {
  WaveSet waves = whole.waves;
  waves.directions = rotated(waves.directions, whole.normals, radians);
  return waves;
}

/// All ranks solve together.
DistributedOptions with_slack(const Slack& slack = kSlack) {
  DistributedOptions options;
  options.plan_below = 0;
  options.gather_below = 300;
  options.slack = slack;
  return options;
}

/// All ranks' frequencies over those asked for, by vertex of the whole.
Eigen::VectorXd ratios(const Parts& parts, const DistributedSurface& surface,
                       std::span<const float> frequencies, const WaveSet& waves) {
  const std::vector<float> all = parts.gathered(frequencies.data(), 1, surface.is_own());
  Eigen::VectorXd x(static_cast<Eigen::Index>(all.size()));
  for (std::size_t v = 0; v < all.size(); ++v) {
    x[static_cast<Eigen::Index>(v)] =
        static_cast<double>(all[v]) / static_cast<double>(waves.frequencies[v]);
  }
  return x;
}

/// Of one process.
Eigen::VectorXd ratios_alone(const WavySurface& whole, const WaveSet& waves, const Slack& slack) {
  const FrequencyField g =
      relaxed_frequencies({whole.mesh, whole.neighborhood, whole.normals}, waves, slack)
          .frequencies;
  Eigen::VectorXd x(static_cast<Eigen::Index>(g.size()));
  for (std::size_t v = 0; v < g.size(); ++v) {
    x[static_cast<Eigen::Index>(v)] =
        static_cast<double>(g[v]) / static_cast<double>(waves.frequencies[v]);
  }
  return x;
}

TEST(DistributedFrequency, OfOneRankHasTheBitsOfTheLibrary) {
  if (rank_count() > 1) GTEST_SKIP() << "of one rank";
  const Parts parts(wavy_surface("molecule,resolution=40", kAxis, 40));
  const Surface whole = make_surface(parts.whole.mesh);
  Slack uneven = kSlack, penalized = kSlack;
  for (const Vec3& p : whole.mesh.positions) {
    uneven.by_vertex.push_back(p.x() > 0 ? 0.3f : 0.05f);
    penalized.branch_penalty.push_back(p.y() > 0 ? 1.0f : 0.0f);
  }
  for (const Slack& slack : {Slack(kSlack), uneven, penalized}) {
    StripeAnimator expected(whole, with_slack(slack));
    DistributedStripeAnimator animator(parts.surface(), with_slack(slack));
    for (const float angle : {0.0f, 0.1f, 0.1f, 3.0f}) {
      const WaveSet waves = turned_by(parts.whole, angle);
      const FrameResult one = expected.frame(frame_of(waves));
      const FrameResult same = animator.frame(frame_of(waves));
      EXPECT_EQ(one.unchanged, same.unchanged);
      EXPECT_TRUE(same_bits(one.z, same.z));
      EXPECT_TRUE(same_bits(one.frequencies, same.frequencies));
      EXPECT_EQ(one.frequency_change.residual, same.frequency_change.residual);
      EXPECT_EQ(one.frequency_change.ratio_mean, same.frequency_change.ratio_mean);
      EXPECT_EQ(expected.energy(), animator.energy());
    }
  }
}

TEST(DistributedFrequency, OfOneRankMeasuresWhatThePatternSays) {
  if (rank_count() > 1) GTEST_SKIP() << "of one rank";
  const Parts parts(wavy_surface("trefoil,resolution=40", kAxis, 40));
  StripeOptions options;
  options.slack = kSlack;
  for (const Vec3& p : parts.whole.mesh.positions) {
    options.slack.branch_penalty.push_back(p.y() > 0 ? 1.0f : 0.0f);
  }
  const StripePattern pattern =
      stripe_pattern(make_surface(parts.whole.mesh), parts.whole.waves, options);
  DistributedStripeAnimator animator(parts.surface(), with_slack(options.slack));
  animator.frame(frame_of(parts.whole.waves));
  const PatternQuality quality = animator.measure().quality;
  EXPECT_EQ(quality.branches, pattern.quality.branches);
  EXPECT_EQ(quality.branches_in_avoided_area, pattern.quality.branches_in_avoided_area);
  EXPECT_EQ(quality.spacing_error_mean, pattern.quality.spacing_error_mean);
  EXPECT_EQ(quality.spacing_error_wanted_mean, pattern.quality.spacing_error_wanted_mean);
}

/// Weighted by area.
double mean_of(const LeastFrequencies& exact, const Eigen::VectorXd& x) {
  return exact.problem.mass.dot(x) / exact.problem.mass.sum();
}

/// What all triangles and vertices are measured with.
struct Scale {
  double unit = 0, faithfulness = 0, constant = 0;
};

Scale scale_of(const FrequencyTriangles& triangles, const Adjacency& adjacency,
               const FrequencyInput& input, MultigridPeers* peers) {
  const FrequencyRows rows(triangles, adjacency, input, peers);
  FrequencyTerms terms;
  terms.triangles.resize(rows.triangles().corners.size());
  rows.set_terms(input, peers, terms);
  double constant = terms.constant;
  if (peers != nullptr) peers->sum({&constant, 1});
  return {static_cast<double>(terms.unit), static_cast<double>(terms.faithfulness), constant};
}

TEST(DistributedFrequency, CountsEveryTriangleAndVertexOnce) {
  WavySurface whole = wavy_surface("torus,resolution=30", kAxis, 20);
  for (std::size_t v = 0; v < whole.mesh.vertex_count(); ++v) {
    whole.mesh.positions[v].x() += 3;
    whole.waves.frequencies[v] *= 1 + 0.5f * static_cast<float>(v % 7);
  }
  const FrequencyInput all{whole.mesh.positions, whole.waves.directions, whole.waves.frequencies};
  const Scale expected =
      scale_of({whole.mesh.triangles, {}, {}}, *whole.neighborhood, all, nullptr);
  for (const Cut& cut : cuts()) {
    SCOPED_TRACE(cut.name);
    const Parts parts(whole, cut.rank_of_triangle(whole.mesh));
    const DistributedSurface surface = parts.surface();
    const RankSurface& own = surface.rank_surface();
    std::vector<Vec3> directions(own.vertex_count());
    std::vector<float> frequencies(own.vertex_count());
    for (std::size_t p = 0; p < parts.ids.size(); ++p) {
      directions[own.vertex_of_piece[p]] = whole.waves.directions[parts.ids[p]];
      frequencies[own.vertex_of_piece[p]] = whole.waves.frequencies[parts.ids[p]];
    }
    own.exchange_all(std::span(directions));
    own.exchange_all(std::span(frequencies));
    RankRows peers(*own.ranks, own.graph, 200);
    const auto setting = rank_relaxed_setting(own, kSlack);
    const Scale scale = scale_of(setting->triangles, *setting->adjacency,
                                 {own.mesh.positions, directions, frequencies}, &peers);
    EXPECT_NEAR(scale.unit, expected.unit, 1e-6 * expected.unit);
    EXPECT_NEAR(scale.faithfulness, expected.faithfulness, 1e-5 * expected.faithfulness);
    EXPECT_NEAR(scale.constant, expected.constant, 1e-5 * expected.constant);
  }
}

TEST(DistributedFrequency, HasLeastEnergyHoweverASurfaceIsCut) {
  for (const char* shape : {"torus,resolution=36", "box,resolution=10"}) {
    const WavySurface whole = wavy_surface(shape, kAxis, 20);
    const LeastFrequencies exact(whole.mesh, whole.waves, kSlack);
    expect_least(exact, ratios_alone(whole, whole.waves, kSlack));
    for (const Cut& cut : cuts()) {
      for (const std::size_t gather_below : {std::size_t{0}, std::size_t{400}}) {
        SCOPED_TRACE(std::string(shape) + ", " + cut.name + ", gathered below " +
                     std::to_string(gather_below));
        const Parts parts(whole, cut.rank_of_triangle(whole.mesh));
        const DistributedSurface surface = parts.surface();
        DistributedOptions options = with_slack();
        options.gather_below = gather_below;
        DistributedStripeAnimator animator(surface, options);
        const FrameResult frame = animator.frame(frame_of(parts.of_piece(whole.waves)));
        const Eigen::VectorXd x = ratios(parts, surface, frame.frequencies, whole.waves);
        expect_least(exact, x);
        EXPECT_NEAR(frame.frequency_change.ratio_min, x.minCoeff(), 1e-6);
        EXPECT_NEAR(frame.frequency_change.ratio_max, x.maxCoeff(), 1e-6);
        EXPECT_NEAR(frame.frequency_change.ratio_mean, mean_of(exact, x), 1e-6);
        EXPECT_LT(frame.frequency_change.residual, 0.05);
      }
    }
  }
}

/// Sheets that meet in an edge, in parts, a vertex of no triangle, one without a wave.
TEST(DistributedFrequency, TakesAnyTopology) {
  Mesh mesh = torn_mesh();
  mesh.positions.emplace_back(5, 5, 5);
  WavySurface whole = wavy_surface(std::move(mesh), kAxis, 25);
  for (std::size_t v = 0; v < whole.waves.directions.size(); ++v) {
    const float angle = 2 * whole.mesh.positions[v].z();
    if (whole.normals[v].isZero(0)) continue;
    whole.waves.directions[v] =
        tangent_direction(Vec3(std::cos(angle), 0.4f, std::sin(2 * angle)), whole.normals[v]);
  }
  whole.waves.directions[7].setZero();
  const LeastFrequencies exact(whole.mesh, whole.waves, kSlack);
  for (const Cut& cut : cuts()) {
    SCOPED_TRACE(cut.name);
    const Parts parts(whole, cut.rank_of_triangle(whole.mesh));
    const DistributedSurface surface = parts.surface();
    DistributedOptions options = with_slack();
    options.gather_below = 200;
    DistributedStripeAnimator animator(surface, options);
    const FrameResult frame = animator.frame(frame_of(parts.of_piece(whole.waves)));
    const Eigen::VectorXd x = ratios(parts, surface, frame.frequencies, whole.waves);
    expect_least(exact, x);
    EXPECT_EQ(x[x.size() - 1], 1);
    EXPECT_EQ(x[7], 1);
    // All ranks that have a vertex have its owner's frequency.
    for (std::size_t v = 0; v < parts.ids.size(); ++v) {
      const auto ratio = static_cast<double>(frame.frequencies[v]) /
                         static_cast<double>(whole.waves.frequencies[parts.ids[v]]);
      EXPECT_EQ(ratio, x[static_cast<Eigen::Index>(parts.ids[v])]);
    }
  }
}

TEST(DistributedFrequency, KeepsToSlackAndPenaltiesOfTheOwners) {
  const WavySurface whole = wavy_surface("trefoil,resolution=40", kAxis, 30);
  Slack slack;
  for (const Vec3& p : whole.mesh.positions) {
    slack.by_vertex.push_back(p.x() > 0 ? 0.3f : 0.0f);
    slack.branch_penalty.push_back(p.z() > 0 ? 1.0f : 0.0f);
  }
  const Eigen::VectorXd alone = ratios_alone(whole, whole.waves, slack);
  const Parts parts(whole);
  const DistributedSurface surface = parts.surface();
  Slack of_piece;
  of_piece.by_vertex = parts.of_piece(slack.by_vertex);
  of_piece.branch_penalty = parts.of_piece(slack.branch_penalty);
  // What is said of others' vertices does not count.
  for (std::size_t v = 0; v < parts.ids.size(); ++v) {
    if (!surface.is_own()[v]) of_piece.by_vertex[v] = of_piece.branch_penalty[v] = 0.7f;
  }
  DistributedOptions options = with_slack(of_piece);
  options.gather_below = 500;
  DistributedStripeAnimator animator(surface, options);
  const FrameResult frame = animator.frame(frame_of(parts.of_piece(whole.waves)));
  const Eigen::VectorXd x = ratios(parts, surface, frame.frequencies, whole.waves);
  for (Eigen::Index v = 0; v < x.size(); ++v) {
    const auto i = static_cast<std::size_t>(v);
    const double most =
        1 + static_cast<double>(slack.by_vertex[i] * (1 + 2 * slack.branch_penalty[i]));
    EXPECT_LE(x[v], most * (1 + 1e-6));
    EXPECT_GE(x[v], (1 - 1e-6) / most);
  }
  // Cycles end where they gain little, which leaves them apart by this much in smooth changes.
  EXPECT_LT((x - alone).cwiseAbs().mean(), 0.01);
  EXPECT_GT(x.maxCoeff(), 1.2);

  // What ranks report is what the library says of the same phases.
  WaveSet chosen = whole.waves;
  chosen.frequencies = parts.gathered(frame.frequencies.data(), 1, surface.is_own());
  const std::vector<Complex> z = parts.gathered(frame.z, surface.is_own());
  const auto corners = corner_phases(whole.mesh.triangles, chosen, z, PhaseShiftKind::aligned);
  const DistributedMeasures measures = animator.measure();
  const PatternQuality quality = measure_quality(whole.mesh, chosen, corners);
  const PatternQuality wanted = measure_quality(whole.mesh, whole.waves, corners);
  EXPECT_EQ(measures.quality.branches, quality.branches);
  EXPECT_NEAR(measures.quality.spacing_error_mean, quality.spacing_error_mean, 1e-6);
  EXPECT_NEAR(measures.quality.spacing_error_wanted_mean, wanted.spacing_error_mean, 1e-6);
  std::size_t in_calm = 0;
  for (std::size_t t = 0; t < corners.size(); ++t) {
    const auto& [a, b, c] = whole.mesh.triangles[t];
    in_calm += is_branch(corners[t].kind) &&
               slack.branch_penalty[a] + slack.branch_penalty[b] + slack.branch_penalty[c] >= 1.5f;
  }
  EXPECT_EQ(measures.quality.branches_in_avoided_area, in_calm);
}

TEST(DistributedFrequency, HasTheSameBitsInEveryRun) {
  const Parts parts(wavy_surface("molecule,resolution=40", kAxis, 60));
  const WaveSet own = parts.of_piece(parts.whole.waves);
  const WaveSet next = parts.of_piece(turned_by(parts.whole, 0.1f));
  std::vector<float> first;
  for (int run = 0; run < 3; ++run) {
    const ThreadLimit threads(1 + run);
    DistributedOptions options = with_slack();
    options.gather_below = 1000;
    DistributedStripeAnimator animator(parts.surface(), options);
    animator.frame(frame_of(own));
    const FrameResult frame = animator.frame(frame_of(next));
    if (run == 0) first.assign(frame.frequencies.begin(), frame.frequencies.end());
    EXPECT_TRUE(same_bits(std::span<const float>(first), frame.frequencies));
  }
}

TEST(DistributedFrequency, FramesKeepUpWithFieldsThatTurn) {
  const Parts parts(wavy_surface("torus,resolution=40", kAxis, 20));
  const DistributedSurface surface = parts.surface();
  DistributedOptions options = with_slack();
  options.gather_below = 300;
  DistributedStripeAnimator animator(surface, options);
  for (int n = 0; n < 8; ++n) {
    const WaveSet waves = turned_by(parts.whole, 0.02f * static_cast<float>(n));
    const FrameResult frame = animator.frame(frame_of(parts.of_piece(waves)));
    EXPECT_LE(frame.frequency_change.sweeps, n == 0 ? 80 : 6);
    expect_least(LeastFrequencies(parts.whole.mesh, waves, kSlack),
                 ratios(parts, surface, frame.frequencies, parts.whole.waves));
  }
  const WaveSet last = parts.of_piece(turned_by(parts.whole, 0.02f * 7));
  const FrameResult again = animator.frame(frame_of(last));
  EXPECT_TRUE(again.unchanged);
  EXPECT_EQ(again.frequencies.size(), parts.ids.size());
  animator.restart();
  EXPECT_GT(animator.frame(frame_of(last)).frequency_change.sweeps, 6);
}

/// On surfaces with several blocks of rows and levels a rank: energies are those of one process,
/// and as few stripes begin or end.
TEST(DistributedFrequency, LeavesAsFewBranchesAsOneProcess) {
  std::size_t alone = 0, plain = 0, relaxed = 0;
  for (const char* shape : {"trefoil", "torus", "molecule"}) {
    const WavySurface whole = wavy_surface(shape, kAxis, 60);
    const Parts parts(whole);
    const DistributedSurface surface = parts.surface();
    for (const float slack : {0.0f, kSlack}) {
      DistributedOptions distributed = with_slack(slack);
      distributed.gather_below = 1000;
      DistributedStripeAnimator animator(surface, distributed);
      const FrameResult frame = animator.frame(frame_of(parts.of_piece(whole.waves)));
      (slack > 0 ? relaxed : plain) += animator.measure().quality.branches;
      if (slack == 0) continue;
      const auto x = ratios(parts, surface, frame.frequencies, whole.waves);
      if (rank() != 0) continue;
      const LeastSquares problem = least_squares(whole.mesh, whole.waves);
      const auto energy_of = [&](const Eigen::VectorXd& ratio) {
        return problem.energy((ratio.array().log() + 1).matrix());
      };
      const double energy = energy_of(ratios_alone(whole, whole.waves, kSlack));
      EXPECT_NEAR(energy_of(x), energy, 0.02 * energy);
      StripeOptions options;
      options.slack = kSlack;
      alone += stripe_pattern(make_surface(whole.mesh), whole.waves, options).quality.branches;
    }
  }
  EXPECT_LT(static_cast<double>(relaxed), 0.7 * static_cast<double>(plain));
  if (rank() != 0) return;
  std::printf("%zu branches, %zu in one process\n", relaxed, alone);
  EXPECT_NEAR(static_cast<double>(relaxed), static_cast<double>(alone),
              0.1 * static_cast<double>(alone));
}

TEST(DistributedFrequency, IsCancelledOnAllRanksByOneAndLeavesNoTrace) {
  const Parts parts(wavy_surface("torus,resolution=60", kAxis, 30));
  const DistributedSurface surface = parts.surface();
  DistributedOptions options = with_slack();
  options.cycles = 3;
  options.gather_below = 500;
  DistributedStripeAnimator animator(surface, options), undisturbed(surface, options);
  const WaveSet own = parts.of_piece(parts.whole.waves);
  const WaveSet next = parts.of_piece(turned_by(parts.whole, 0.4f));
  const auto stop_in = [](std::string_view where, double from) {
    return Progress([where, from](std::string_view stage, double fraction) {
      return rank() != rank_count() - 1 || stage != where || fraction < from;
    });
  };
  EXPECT_THROW(animator.frame(frame_of(next), stop_in("frequency", 0.02)), Cancelled);
  EXPECT_THROW(animator.frame(frame_of(next), stop_in("cycles", 0.5)), Cancelled);
  EXPECT_THROW(animator.energy(), Error);
  const auto expect_same = [&](const WaveSet& waves) {
    const FrameResult frame = animator.frame(frame_of(waves));
    const FrameResult same = undisturbed.frame(frame_of(waves));
    EXPECT_TRUE(same_bits(frame.z, same.z));
    EXPECT_TRUE(same_bits(frame.frequencies, same.frequencies));
  };
  expect_same(own);
  EXPECT_THROW(animator.frame(frame_of(next), stop_in("cycles", 0.5)), Cancelled);
  const PatternQuality quality = animator.measure().quality, same = undisturbed.measure().quality;
  EXPECT_EQ(quality.spacing_error_mean, same.spacing_error_mean);
  EXPECT_EQ(quality.spacing_error_wanted_mean, same.spacing_error_wanted_mean);
  EXPECT_TRUE(animator.frame(frame_of(own)).unchanged);
  expect_same(next);
}

TEST(DistributedFrequency, RefusesOnAllRanksWhatOneRankGetsWrong) {
  const Parts parts(wavy_surface("sphere,resolution=20", kAxis, 20));
  const DistributedSurface surface = parts.surface();
  const bool is_wrong = rank() == rank_count() - 1;
  const auto refuses = [&](const Slack& slack, const std::string& message) {
    try {
      DistributedStripeAnimator(surface, with_slack(slack));
      ADD_FAILURE() << "accepted";
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
    }
  };
  refuses(is_wrong ? -1.0f : 0.1f, "finite number of 0");
  Slack slack = 0.1f;
  slack.branch_penalty.assign(parts.ids.size(), 0.5f);
  if (is_wrong) slack.branch_penalty[3] = 2;
  refuses(slack, "avoid_branches of vertex 3");
  if (is_wrong) slack.branch_penalty.assign(1, 0.5f);
  refuses(slack, "one to each");
  if (rank_count() == 1) return;
  if (is_wrong) slack.branch_penalty.clear();
  refuses(slack, "all pieces");
}

/// With one distributed level: sweeps over it and which of its nodes are free, 4 bytes a ghost
/// each; then the gathered level's numbers alone.
TEST(DistributedFrequency, SendsNoMoreThanItsHaloNeeds) {
  if (rank_count() == 1) GTEST_SKIP() << "of several ranks";
  const Parts parts(wavy_surface("torus", kAxis, 40));
  const DistributedSurface surface = parts.surface();
  DistributedOptions options = with_slack();
  options.gather_below = surface.vertex_count();
  DistributedStripeAnimator animator(surface, options);
  animator.frame(frame_of(parts.of_piece(parts.whole.waves)));
  const FrameResult frame = animator.frame(frame_of(parts.of_piece(turned_by(parts.whole, 0.1f))));
  const DistributedMetrics own = animator.metrics();
  std::uint64_t of_rank[3] = {own.frequency_bytes, own.frequency_halo_bytes, own.ghosts}, all[3];
  MPI_Allreduce(of_rank, all, 3, MPI_UINT64_T, MPI_SUM, MPI_COMM_WORLD);
  const auto cycles = static_cast<std::uint64_t>(frame.frequency_change.sweeps) / 2;
  const std::uint64_t of_finest = 4 * all[2] * 3 * cycles;
  EXPECT_GE(all[1], of_finest);
  EXPECT_LE(all[1], of_finest + 4 * all[2] * cycles);  // the gathered level has fewer ghosts
  // Its matrix once or twice, seven numbers a node, and right sides and solutions.
  const std::uint64_t nodes = surface.vertex_count() / 3;
  EXPECT_LT(all[0] - all[1], 4 * nodes * (2 * 8 + 2 * cycles));
}

}  // namespace
}  // namespace brindle
