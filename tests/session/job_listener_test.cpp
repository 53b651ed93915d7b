#include "cli/job_listener.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace brindle::tool {
namespace {

struct Listener : JobListener {
  std::vector<double> fractions;
  std::vector<std::string> steps;

  void note(const std::string& /*text*/) override {}

 private:
  Progress whole_progress() override {
    return Progress([this](const ProgressReport& report) {
      fractions.push_back(report.stages.empty() ? report.step_fraction : report.fraction);
      steps.emplace_back(report.step);
      return true;
    });
  }
};

void work(const Progress& progress) {
  JobStages stages(progress, {{"half", 1}, {"other half", 1}});
  stages.begin("half");
  stages.begin("other half");
  stages.finish();
}

TEST(JobListener, GivesAPlannedJobOneFraction) {
  Listener listener;
  listener.plan({{"first", 1}, {"second", 3}});
  listener.stage("first");
  work(listener.progress());
  listener.stage("second");
  work(listener.progress());
  EXPECT_EQ(listener.fractions, (std::vector<double>{0, 0, 0.125, 0.25, 0.25, 0.25, 0.625, 1}));
}

TEST(JobListener, TakesWhatWasNotPlannedForAStepOfThePresentStage) {
  Listener listener;
  listener.plan({{"first", 1}, {"second", 1}});
  listener.stage("first");
  listener.stage("aside");
  listener.stage("second");
  EXPECT_EQ(listener.steps, (std::vector<std::string>{"first", "aside", "second"}));
  EXPECT_EQ(listener.fractions, (std::vector<double>{0, 0, 0.5}));
}

TEST(JobListener, GivesFramesTheirSharesOfTheirStage) {
  Listener listener;
  listener.plan({{"surface", 1}, {"frames", 1}});
  listener.stage("surface");
  listener.stage("frames");
  for (int frame = 0; frame < 2; ++frame) {
    listener.narrow(0.5 * frame, 0.5 * frame + 0.5);
    work(listener.progress());
    listener.stage("a picture");  // what a frame is drawn with has no end of the stage to itself
  }
  EXPECT_EQ(listener.fractions,
            (std::vector<double>{0, 0.5, 0.5, 0.625, 0.75, 0.75, 0.75, 0.875, 1, 1}));
}

TEST(JobListener, WithoutAPlanGivesEveryStageItsOwnFraction) {
  Listener listener;
  listener.stage("first");
  work(listener.progress());
  work(listener.progress());
  EXPECT_EQ(listener.fractions, (std::vector<double>{0, 0, 0.5, 1, 0, 0.5, 1}));
}

}  // namespace
}  // namespace brindle::tool
