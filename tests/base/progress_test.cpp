#include "brindle/progress.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/base/parallel.h"

namespace brindle {
namespace {

struct Heard {
  std::vector<double> fractions;
  std::vector<std::string> steps;
  std::vector<std::string> stages;
  std::vector<std::size_t> numbers;

  Progress progress() {
    return Progress([this](const ProgressReport& report) {
      fractions.push_back(report.fraction);
      steps.emplace_back(report.step);
      numbers.push_back(report.stage);
      stages.clear();
      for (const JobStage& stage : report.stages) stages.push_back(stage.name);
      return true;
    });
  }
};

void inner_job(const Progress& progress) {
  JobStages stages(progress, {{"first", 1}, {"second", 3}});
  stages.begin("first").report(0.5);
  stages.begin("second").report(0.5);
  stages.finish();
}

void outer_job(const Progress& progress) {
  JobStages stages(progress, {{"short", 1}, {"long", 4}, {"rest", 3}});
  inner_job(stages.begin("short"));
  inner_job(stages.begin("long"));
  stages.begin("rest").report("aside", 0.25);
  stages.finish();
}

TEST(Progress, OfAJobHasOneFractionOverAllStages) {
  Heard heard;
  inner_job(heard.progress());
  EXPECT_EQ(heard.fractions, (std::vector<double>{0, 0.125, 0.25, 0.625, 1}));
  EXPECT_EQ(heard.stages, (std::vector<std::string>{"first", "second"}));
  EXPECT_EQ(heard.numbers, (std::vector<std::size_t>{0, 0, 1, 1, 1}));
}

TEST(Progress, OfJobsWithinAJobGoesOnAndListsTheOuterStages) {
  Heard heard;
  outer_job(heard.progress());
  EXPECT_EQ(heard.stages, (std::vector<std::string>{"short", "long", "rest"}));
  EXPECT_TRUE(std::is_sorted(heard.fractions.begin(), heard.fractions.end()));
  EXPECT_EQ(heard.fractions.front(), 0);
  EXPECT_EQ(heard.fractions.back(), 1);
  // Half of the second stage of "long", which is from 1/8 to 5/8.
  const auto half = std::find(heard.fractions.begin(), heard.fractions.end(), 0.125 + 0.5 * 0.625);
  ASSERT_NE(half, heard.fractions.end());
  EXPECT_EQ(heard.steps[static_cast<std::size_t>(half - heard.fractions.begin())], "second");
  EXPECT_EQ(heard.steps.end()[-2], "aside");
}

TEST(Progress, OfStepsReachesTheCallbackOfSteps) {
  std::vector<std::pair<std::string, double>> heard;
  outer_job(Progress([&](std::string_view step, double fraction) {
    heard.emplace_back(step, fraction);
    return true;
  }));
  const std::vector<std::pair<std::string, double>> inner = {
      {"first", 0}, {"first", 0.5}, {"second", 0}, {"second", 0.5}, {"second", 1}};
  std::vector<std::pair<std::string, double>> expected = {{"short", 0}};
  expected.insert(expected.end(), inner.begin(), inner.end());
  expected.emplace_back("long", 0);
  expected.insert(expected.end(), inner.begin(), inner.end());
  expected.insert(expected.end(), {{"rest", 0}, {"aside", 0.25}, {"rest", 1}});
  EXPECT_EQ(heard, expected);
}

TEST(Progress, NeverFallsWhateverStepsReport) {
  Heard heard;
  JobStages stages(heard.progress(), {{"all", 1}});
  const Progress all = stages.begin("all");
  all.report("forth", 0.75);
  all.report("back", 0.25);
  stages.finish();
  EXPECT_EQ(heard.fractions, (std::vector<double>{0, 0.75, 0.75, 1}));
}

TEST(Progress, ServesOneJobAfterTheOther) {
  Heard heard;
  const Progress progress = heard.progress();
  inner_job(progress);
  const std::vector<double> first = std::exchange(heard.fractions, {});
  inner_job(progress);
  EXPECT_EQ(heard.fractions, first);
}

TEST(Progress, OfAnotherProgressPassesOnWhatThatSays) {
  Heard heard;
  JobStages stages(heard.progress(), {{"here", 1}, {"there", 1}});
  stages.begin("here");
  const Progress there = stages.begin("there");
  inner_job(Progress([&](const ProgressReport& report) {
    there.report(report);
    return true;
  }));
  EXPECT_EQ(heard.fractions, (std::vector<double>{0, 0.5, 0.5, 0.5625, 0.625, 0.8125, 1}));
}

TEST(Progress, MayLeaveStagesOutButKnowsAllNames) {
  Heard heard;
  JobStages stages(heard.progress(), {{"a", 1}, {"b", 1}, {"c", 2}});
  stages.begin("c");
  EXPECT_EQ(heard.fractions, (std::vector<double>{0.5}));
  EXPECT_THROW(stages.begin("a"), Error);
  EXPECT_THROW(stages.begin("d"), Error);
  EXPECT_THROW(JobStages(Progress(), {}), Error);
  EXPECT_THROW(JobStages(Progress(), {{"a", 0}}), Error);
}

TEST(Progress, CanBeAskedForStages) {
  Heard heard;
  const Progress progress = heard.progress();
  EXPECT_TRUE(progress.stages().empty());
  inner_job(progress);
  ASSERT_EQ(progress.stages().size(), 2u);
  EXPECT_EQ(progress.stages()[1].name, "second");
  EXPECT_EQ(progress.stages()[1].weight, 0.75);
  EXPECT_TRUE(Progress().stages().empty());
}

TEST(Progress, CancelsAtAnyReport) {
  for (int last = 0; last < 13; ++last) {
    int left = last;
    EXPECT_THROW(outer_job(Progress([&](const ProgressReport&) { return left-- > 0; })), Cancelled);
  }
  inner_job(Progress());  // silent
}

TEST(Progress, OfATickIsThatOfTheLastReport) {
  Heard heard;
  const Progress progress = heard.progress();
  JobStages stages(progress, {{"first", 1}, {"second", 1}});
  stages.begin("first").tick();
  const Progress second = stages.begin("second");
  second.report(0.5);
  second.tick();
  EXPECT_EQ(heard.fractions, (std::vector<double>{0, 0, 0.5, 0.75, 0.75}));
  EXPECT_EQ(heard.steps.back(), "second");
  int left = 1;
  const Progress stopped([&](const ProgressReport&) { return left-- > 0; });
  stopped.tick();
  EXPECT_THROW(stopped.tick(), Cancelled);
  Progress().tick();  // silent
}

TEST(ReportedLoops, ReportAfterEverySliceAndLeaveNothingOut) {
  for (const std::size_t count : {0u, 1u, 5000u, 100'001u}) {
    std::vector<int> visits(count, 0);
    std::size_t most = 0, done = 0;
    Heard heard;
    JobStages stages(heard.progress(), {{"loop", 1}});
    const Progress loop = stages.begin("loop");
    parallel_for(count, loop, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) ++visits[i];
    });
    EXPECT_EQ(visits, std::vector<int>(count, 1));
    EXPECT_EQ(heard.fractions.size(), 1 + (count + kReportSlice - 1) / kReportSlice);
    EXPECT_TRUE(std::is_sorted(heard.fractions.begin(), heard.fractions.end()));
    reported_for(count, Progress([&](std::string_view, double) {
                   most = std::max(most, std::exchange(done, 0));
                   return true;
                 }),
                 [&](std::size_t) { ++done; });
    EXPECT_LE(std::max(most, done), kReportSlice);
  }
}

TEST(ReportedLoops, AddInTheSameOrderAsThoseThatDoNotReport) {
  const auto part = [](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i) sum += std::sin(static_cast<double>(i)) * 1e3;
    return sum;
  };
  for (const std::size_t count : {0u, 1u, 2049u, 100'000u, 123'457u}) {
    for (const std::size_t grain : {1u, 64u, 2048u, 50'000u}) {
      const auto expected = parallel_sum<double>(count, part, grain);
      EXPECT_EQ(parallel_sum<double>(count, Progress(), part, grain), expected);
      std::size_t reports = 0;
      const Progress progress([&](std::string_view, double) { return ++reports > 0; });
      EXPECT_EQ(parallel_sum<double>(count, progress, part, grain), expected);
      if (grain < kReportSlice) {
        EXPECT_GE(reports, count / kReportSlice);
      }
    }
  }
}

TEST(ReportedLoops, StopWhereTheyAreCancelled) {
  int left = 3;
  std::size_t done = 0;
  const Progress progress([&](std::string_view, double) { return left-- > 0; });
  EXPECT_THROW(reported_for(1'000'000, progress, [&](std::size_t) { ++done; }), Cancelled);
  EXPECT_EQ(done, 3 * kReportSlice);
}

}  // namespace
}  // namespace brindle
