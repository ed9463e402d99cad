#include "core/base/error.h"
#include "ui/jobs/job_slot.h"

#include <QElapsedTimer>
#include <QEventLoop>
#include <QSignalSpy>
#include <QTest>
#include <QThread>
#include <gtest/gtest.h>

#include <atomic>
#include <gmock/gmock.h>
#include <string>
#include <vector>

namespace espalier {
namespace {

/// Turns the event loop until the job has finished.
void waitFor(JobSlot& slot) {
  QEventLoop loop;
  QObject::connect(&slot, &JobSlot::finished, &loop, &QEventLoop::quit);
  if (slot.isBusy()) loop.exec();
}

/// Works until it is asked to stop.
int untilStopped(const Progress& progress) {
  for (;;)
    progress.check();
}

struct JobSlotTest : testing::Test {
  JobQueue queue;
  JobSlot slot{queue, JobPriority::asked};
  std::vector<std::string> events;

  void SetUp() override {
    QObject::connect(&slot, &JobSlot::started, [this] { events.emplace_back("started"); });
    QObject::connect(&slot, &JobSlot::failed, [this](const QString& text) {
      events.push_back("failed: " + text.toStdString());
    });
    QObject::connect(&slot, &JobSlot::finished, [this] { events.emplace_back("finished"); });
  }
};

TEST_F(JobSlotTest, DoesOnceItHasFinishedWhatItsResultAskedFor) {
  slot.start(
      "Read", [](const Progress&) { return 1; },
      [&](int) {
        slot.afterwards([&] {
          EXPECT_FALSE(slot.isBusy());
          events.emplace_back("afterwards");
        });
      });
  waitFor(slot);
  EXPECT_THAT(events, testing::ElementsAre("started", "finished", "afterwards"));
}

TEST_F(JobSlotTest, DoesNothingAfterwardsIfItWasCanceledMeanwhile) {
  slot.start(
      "Read", [](const Progress&) { return 1; },
      [&](int) {
        slot.afterwards([&] { events.emplace_back("afterwards"); });
        slot.cancel();
      });
  waitFor(slot);
  EXPECT_THAT(events, testing::ElementsAre("started", "finished"));
}

TEST_F(JobSlotTest, HandsTheResultToTheGuiThreadAndFinishesLast) {
  QThread* workedOn = nullptr;
  slot.start(
      "Add",
      [&](const Progress&) {
        workedOn = QThread::currentThread();
        return 20 + 22;
      },
      [&](int result) {
        EXPECT_EQ(QThread::currentThread(), slot.thread());
        events.push_back(std::to_string(result));
      });
  EXPECT_TRUE(slot.isBusy());
  waitFor(slot);
  EXPECT_THAT(events, testing::ElementsAre("started", "42", "finished"));
  EXPECT_NE(workedOn, slot.thread());
  EXPECT_FALSE(slot.isBusy());
}

TEST_F(JobSlotTest, MovesAResultThatCannotBeCopied) {
  slot.start(
      "Make", [](const Progress&) { return std::make_unique<int>(3); },
      [&](std::unique_ptr<int> result) { events.push_back(std::to_string(*result)); });
  waitFor(slot);
  EXPECT_THAT(events, testing::Contains("3"));
}

TEST_F(JobSlotTest, ReportsTheMessageOfAFailure) {
  slot.start(
      "Read", [](const Progress&) -> int { throw Error("oak.xyz, line 12: no number"); },
      [&](int) { events.emplace_back("done"); });
  waitFor(slot);
  EXPECT_THAT(events,
              testing::ElementsAre("started", "failed: oak.xyz, line 12: no number", "finished"));
}

TEST_F(JobSlotTest, DropsTheResultOfACanceledJob) {
  slot.start("Wait", untilStopped, [&](int) { events.emplace_back("done"); });
  slot.cancel();
  waitFor(slot);
  EXPECT_THAT(events, testing::ElementsAre("started", "finished"));
}

TEST_F(JobSlotTest, DropsAResultThatIsMadeAlreadyWhenCanceled) {
  std::atomic<bool> isMade = false;
  struct Result {
    std::atomic<bool>* isMade;
  };
  slot.start(
      "Add",
      [&](const Progress&) {
        isMade = true;
        return Result{&isMade};
      },
      [&](Result) { events.emplace_back("done"); });
  while (!isMade)
    QThread::yieldCurrentThread(); // no events are handled meanwhile
  slot.cancel();
  waitFor(slot);
  EXPECT_THAT(events, testing::ElementsAre("started", "finished"));
}

TEST_F(JobSlotTest, DestroysOnTheGuiThreadWhatWasToBeDone) {
  struct Owner {
    QThread*& endedOn;
    ~Owner() { endedOn = QThread::currentThread(); }
  };
  for (const bool isCanceled : {false, true}) {
    QThread* endedOn = nullptr;
    slot.start(
        "Wait", [=](const Progress& progress) { return isCanceled ? untilStopped(progress) : 1; },
        [owner = std::unique_ptr<Owner>(new Owner{endedOn})](int) {});
    if (isCanceled) slot.cancel();
    waitFor(slot);
    EXPECT_EQ(endedOn, slot.thread()) << (isCanceled ? "canceled" : "done");
  }
}

TEST_F(JobSlotTest, ReportsTheProgressAndItsStage) {
  QSignalSpy progress(&slot, &JobSlot::progressed);
  slot.start(
      "Read",
      [](const Progress& whole) {
        whole.part(0.5, 1, "sort").update(0.5);
        return 0;
      },
      [](int) {});
  waitFor(slot);
  ASSERT_EQ(progress.size(), 1);
  EXPECT_DOUBLE_EQ(progress[0][0].toDouble(), 0.75);
  EXPECT_EQ(progress[0][1].toString(), "sort");
}

TEST_F(JobSlotTest, RunsOneJobAfterAnother) {
  for (int job = 0; job < 3; ++job) {
    slot.start("Wait", untilStopped, [](int) {});
    slot.cancel();
    waitFor(slot);
    slot.start(
        "Count", [job](const Progress&) { return job; },
        [&](int result) { events.push_back(std::to_string(result)); });
    waitFor(slot);
  }
  EXPECT_THAT(events, testing::IsSupersetOf({"0", "1", "2"}));
}

TEST(JobSlot, IsDestroyedWhileAJobRuns) {
  std::atomic<bool> isRunning = false;
  bool isDone = false;
  JobQueue queue;
  {
    JobSlot slot(queue, JobPriority::asked);
    slot.start(
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

TEST_F(JobSlotTest, StopsWhatRunsForTheNewest) {
  slot.start("Wait", untilStopped, [&](int) { events.emplace_back("first"); });
  slot.start(
      "Count", [](const Progress&) { return 2; }, [&](int) { events.emplace_back("second"); });
  EXPECT_TRUE(slot.isWaiting());
  waitFor(slot);
  EXPECT_THAT(events, testing::ElementsAre("started", "second", "finished")) << "busy all along";
  EXPECT_FALSE(slot.isCanceled());
}

class NewestOfJobSlot : public testing::Test {
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
  JobQueue queue_;
  JobSlot job_{queue_, JobPriority::hand};
};

TEST_F(NewestOfJobSlot, RunsOne) {
  start(1);
  EXPECT_TRUE(job_.isBusy());
  waitUntilIdle();
  EXPECT_THAT(results_, testing::ElementsAre(1));
}

TEST_F(NewestOfJobSlot, DropsAllButTheLatest) {
  startEndless();
  for (int i = 0; i < 100; ++i)
    start(i);
  waitUntilIdle();
  EXPECT_THAT(results_, testing::ElementsAre(99)) << "what waited is dropped, never queued";
}

TEST_F(NewestOfJobSlot, StopsAtOnce) {
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

TEST_F(NewestOfJobSlot, StartsTheNextFromWhatIsDone) {
  job_.start([](const Progress&) { return 1; },
             [this](int result) {
               results_.push_back(result);
               start(2);
             });
  waitUntilIdle();
  EXPECT_THAT(results_, testing::ElementsAre(1, 2));
}

TEST_F(NewestOfJobSlot, LetsWhatRunsEndBeforeTheLatestOfThoseThatWait) {
  for (int i = 0; i < 100; ++i)
    job_.startNext([i](const Progress&) { return i; },
                   [this](int result) { results_.push_back(result); });
  EXPECT_TRUE(job_.isWaiting());
  waitUntilIdle();
  EXPECT_THAT(results_, testing::ElementsAre(0, 99)) << "those between are dropped, never queued";
}

TEST_F(NewestOfJobSlot, ReportsAFailureOnceAndGoesOn) {
  std::vector<std::string> failures;
  int finished = 0;
  QObject::connect(&job_, &JobSlot::failed,
                   [&](const QString& text) { failures.push_back(text.toStdString()); });
  QObject::connect(&job_, &JobSlot::finished, [&] { ++finished; });
  job_.start([](const Progress&) -> int { throw Error("no plant"); }, [](int) {});
  waitUntilIdle();
  EXPECT_THAT(failures, testing::ElementsAre("no plant"));
  EXPECT_EQ(finished, 1);
  start(2);
  waitUntilIdle();
  EXPECT_THAT(results_, testing::ElementsAre(2));
}

} // namespace
} // namespace espalier
