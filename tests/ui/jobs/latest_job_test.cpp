#include "core/base/error.h"
#include "ui/jobs/latest_job.h"

#include <QElapsedTimer>
#include <QTest>
#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <vector>

namespace espalier {
namespace {

class LatestJobTest : public testing::Test {
protected:
  void start(int number) {
    job_.start([number](const Progress&) { return number; },
               [this](int result) { results_.push_back(result); });
  }
  /// Runs until it is stopped.
  void startEndless() {
    job_.start(
        [](const Progress& progress) -> int {
          for (;;)
            progress.check();
        },
        [this](int) { results_.push_back(-1); });
  }
  void waitUntilIdle() {
    EXPECT_TRUE(QTest::qWaitFor([&] { return !job_.isBusy(); }));
  }

  std::vector<int> results_;
  LatestJob job_;
};

TEST_F(LatestJobTest, RunsOne) {
  start(1);
  EXPECT_TRUE(job_.isBusy());
  waitUntilIdle();
  EXPECT_THAT(results_, testing::ElementsAre(1));
}

TEST_F(LatestJobTest, DropsAllButTheLatest) {
  startEndless();
  for (int i = 0; i < 100; ++i)
    start(i);
  waitUntilIdle();
  EXPECT_THAT(results_, testing::ElementsAre(99)) << "what waited is dropped, never queued";
}

TEST_F(LatestJobTest, StopsAtOnce) {
  startEndless();
  QElapsedTimer elapsed;
  elapsed.start();
  job_.cancel();
  waitUntilIdle();
  EXPECT_TRUE(results_.empty());
  start(1);
  startEndless();
  job_.cancel();
  waitUntilIdle();
  EXPECT_TRUE(results_.empty()) << "nor does what it has replaced";
}

TEST_F(LatestJobTest, StartsTheNextFromWhatIsDone) {
  job_.start([](const Progress&) { return 1; },
             [this](int result) {
               results_.push_back(result);
               start(2);
             });
  waitUntilIdle();
  EXPECT_THAT(results_, testing::ElementsAre(1, 2));
}

TEST_F(LatestJobTest, LetsWhatRunsEndBeforeTheLatestOfThoseThatWait) {
  for (int i = 0; i < 100; ++i)
    job_.startNext([i](const Progress&) { return i; },
                   [this](int result) { results_.push_back(result); });
  EXPECT_TRUE(job_.isWaiting());
  waitUntilIdle();
  EXPECT_THAT(results_, testing::ElementsAre(0, 99)) << "those between are dropped, never queued";
}

TEST_F(LatestJobTest, TellsAFailureOnceAndGoesOn) {
  std::vector<std::string> failures;
  int idled = 0;
  QObject::connect(&job_, &LatestJob::failed,
                   [&](const QString& text) { failures.push_back(text.toStdString()); });
  QObject::connect(&job_, &LatestJob::idled, [&] { ++idled; });
  job_.start([](const Progress&) -> int { throw Error("no plant"); }, [](int) {});
  waitUntilIdle();
  EXPECT_THAT(failures, testing::ElementsAre("no plant"));
  EXPECT_EQ(idled, 1);
  start(2);
  waitUntilIdle();
  EXPECT_THAT(results_, testing::ElementsAre(2));
}

} // namespace
} // namespace espalier
