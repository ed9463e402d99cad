#include "core/base/error.h"
#include "ui/jobs/job_runner.h"

#include <QEventLoop>
#include <QSignalSpy>
#include <QThread>
#include <gtest/gtest.h>

#include <atomic>
#include <gmock/gmock.h>
#include <string>
#include <vector>

namespace espalier {
namespace {

/// Turns the event loop until the job has finished.
void waitFor(JobRunner& runner) {
  QEventLoop loop;
  QObject::connect(&runner, &JobRunner::finished, &loop, &QEventLoop::quit);
  if (runner.isRunning()) loop.exec();
}

/// Works until it is asked to stop.
int untilStopped(const Progress& progress) {
  for (;;)
    progress.check();
}

struct JobRunnerTest : testing::Test {
  JobRunner runner;
  std::vector<std::string> told;

  void SetUp() override {
    QObject::connect(&runner, &JobRunner::started, [this] { told.emplace_back("started"); });
    QObject::connect(&runner, &JobRunner::failed, [this](const QString& text) {
      told.push_back("failed: " + text.toStdString());
    });
    QObject::connect(&runner, &JobRunner::finished, [this] { told.emplace_back("finished"); });
  }
};

TEST_F(JobRunnerTest, DoesOnceItHasFinishedWhatItsResultAskedFor) {
  runner.start(
      "Read", [](const Progress&) { return 1; },
      [&](int) {
        runner.afterwards([&] {
          EXPECT_FALSE(runner.isRunning());
          told.emplace_back("afterwards");
        });
      });
  waitFor(runner);
  EXPECT_THAT(told, testing::ElementsAre("started", "finished", "afterwards"));
}

TEST_F(JobRunnerTest, DoesNothingAfterwardsIfItWasCanceledMeanwhile) {
  runner.start(
      "Read", [](const Progress&) { return 1; },
      [&](int) {
        runner.afterwards([&] { told.emplace_back("afterwards"); });
        runner.cancel();
      });
  waitFor(runner);
  EXPECT_THAT(told, testing::ElementsAre("started", "finished"));
}

TEST_F(JobRunnerTest, HandsTheResultToTheGuiThreadAndFinishesLast) {
  QThread* workedOn = nullptr;
  runner.start(
      "Add",
      [&](const Progress&) {
        workedOn = QThread::currentThread();
        return 20 + 22;
      },
      [&](int result) {
        EXPECT_EQ(QThread::currentThread(), runner.thread());
        told.push_back(std::to_string(result));
      });
  EXPECT_TRUE(runner.isRunning());
  waitFor(runner);
  EXPECT_THAT(told, testing::ElementsAre("started", "42", "finished"));
  EXPECT_NE(workedOn, runner.thread());
  EXPECT_FALSE(runner.isRunning());
}

TEST_F(JobRunnerTest, MovesAResultThatCannotBeCopied) {
  runner.start(
      "Make", [](const Progress&) { return std::make_unique<int>(3); },
      [&](std::unique_ptr<int> result) { told.push_back(std::to_string(*result)); });
  waitFor(runner);
  EXPECT_THAT(told, testing::Contains("3"));
}

TEST_F(JobRunnerTest, TellsTheMessageOfAFailure) {
  runner.start(
      "Read", [](const Progress&) -> int { throw Error("oak.xyz, line 12: no number"); },
      [&](int) { told.emplace_back("done"); });
  waitFor(runner);
  EXPECT_THAT(told,
              testing::ElementsAre("started", "failed: oak.xyz, line 12: no number", "finished"));
}

TEST_F(JobRunnerTest, DropsTheResultOfACanceledJob) {
  runner.start("Wait", untilStopped, [&](int) { told.emplace_back("done"); });
  runner.cancel();
  waitFor(runner);
  EXPECT_THAT(told, testing::ElementsAre("started", "finished"));
}

TEST_F(JobRunnerTest, DropsAResultThatIsOnItsWayWhenCanceled) {
  std::atomic<bool> isMade = false;
  struct Result {
    std::atomic<bool>* isMade;
  };
  runner.start(
      "Add",
      [&](const Progress&) {
        isMade = true;
        return Result{&isMade};
      },
      [&](Result) { told.emplace_back("done"); });
  while (!isMade)
    QThread::yieldCurrentThread(); // no events are handled meanwhile
  runner.cancel();
  waitFor(runner);
  EXPECT_THAT(told, testing::ElementsAre("started", "finished"));
}

TEST_F(JobRunnerTest, TellsTheProgressAndItsStage) {
  QSignalSpy progress(&runner, &JobRunner::progressed);
  runner.start(
      "Read",
      [](const Progress& whole) {
        whole.part(0.5, 1, "sort").update(0.5);
        return 0;
      },
      [](int) {});
  waitFor(runner);
  ASSERT_EQ(progress.size(), 1);
  EXPECT_DOUBLE_EQ(progress[0][0].toDouble(), 0.75);
  EXPECT_EQ(progress[0][1].toString(), "sort");
}

TEST_F(JobRunnerTest, RunsOneJobAfterAnother) {
  for (int job = 0; job < 3; ++job) {
    runner.start("Wait", untilStopped, [](int) {});
    runner.cancel();
    waitFor(runner);
    runner.start(
        "Count", [job](const Progress&) { return job; },
        [&](int result) { told.push_back(std::to_string(result)); });
    waitFor(runner);
  }
  EXPECT_THAT(told, testing::IsSupersetOf({"0", "1", "2"}));
}

TEST(JobRunner, IsDestroyedWhileAJobRuns) {
  std::atomic<bool> isRunning = false;
  bool isDone = false;
  {
    JobRunner runner;
    runner.start(
        "Wait",
        [&](const Progress& progress) {
          isRunning = true;
          return untilStopped(progress);
        },
        [&](int) { isDone = true; });
    while (!isRunning)
      QThread::yieldCurrentThread();
  }
  QCoreApplication::processEvents();
  EXPECT_FALSE(isDone);
}

} // namespace
} // namespace espalier
