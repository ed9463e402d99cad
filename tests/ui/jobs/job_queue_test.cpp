#include "ui/jobs/job_queue.h"
#include "ui/jobs/job_slot.h"

#include <QSignalSpy>
#include <QTest>
#include <gtest/gtest.h>

#include <atomic>
#include <deque>
#include <gmock/gmock.h>
#include <memory>
#include <string>
#include <vector>

namespace espalier {
namespace {

using testing::ElementsAre;

/// Jobs that run until they are let go.
class JobQueueTest : public testing::Test {
protected:
  ~JobQueueTest() override {
    for (Held& held : jobs_)
      held.isLetGo = true;
  }

  JobSlot& start(const std::string& name, JobPriority priority) {
    Held& held = jobs_.emplace_back(queue_, priority);
    held.slot.start(
        [&held](const Progress& progress) {
          held.hasBegun = true;
          while (!held.isLetGo)
            progress.check();
          return 0;
        },
        [this, name](int) { done_.push_back(name); });
    return held.slot;
  }
  /// Lets the job that was started as the `place`-th go, and waits for its end.
  void letGo(std::size_t place) {
    jobs_[place].isLetGo = true;
    EXPECT_TRUE(QTest::qWaitFor([&] { return !jobs_[place].slot.isBusy(); }));
  }
  [[nodiscard]] bool begins(std::size_t place) {
    return QTest::qWaitFor([&] { return jobs_[place].hasBegun.load(); });
  }

  struct Held {
    Held(JobQueue& queue, JobPriority priority) : slot(queue, priority) {}
    std::atomic<bool> hasBegun = false;
    std::atomic<bool> isLetGo = false;
    JobSlot slot; // ends first: its job looks at these
  };

  JobQueue queue_;
  std::deque<Held> jobs_;
  std::vector<std::string> done_;
};

TEST_F(JobQueueTest, BeginsWhatFollowsTheHandAtOnce) {
  for (int i = 0; i < 6; ++i)
    start("asked", JobPriority::asked);
  EXPECT_EQ(queue_.runningCount(), 4U);
  start("hand", JobPriority::hand);
  EXPECT_TRUE(begins(6)) << "beside as many as there are";
  EXPECT_EQ(queue_.waitingCount(), 2U);
}

TEST_F(JobQueueTest, LetsTheBackgroundWaitForWhatWasAskedFor) {
  start("one", JobPriority::background);
  start("two", JobPriority::background);
  EXPECT_EQ(queue_.runningCount(), 2U);
  start("three", JobPriority::background);
  start("four", JobPriority::background);
  start("five", JobPriority::asked);
  EXPECT_EQ(queue_.runningCount(), 3U) << "beside those two";
  EXPECT_TRUE(begins(4));
  letGo(0);
  EXPECT_EQ(queue_.runningCount(), 2U) << "the background waits while two others run";
  letGo(4);
  EXPECT_TRUE(begins(2)) << "in the order in which they were asked for";
  EXPECT_EQ(queue_.waitingCount(), 1U);
  letGo(2);
  EXPECT_TRUE(begins(3));
  letGo(1);
  letGo(3);
  EXPECT_THAT(done_, ElementsAre("one", "five", "three", "two", "four"));
  EXPECT_EQ(queue_.runningCount(), 0U);
}

TEST_F(JobQueueTest, DropsWhatWasCanceledBeforeItBegan) {
  for (int i = 0; i < 2; ++i)
    start("running", JobPriority::background);
  JobSlot& waits = start("waits", JobPriority::background);
  QSignalSpy finished(&waits, &JobSlot::finished);
  waits.cancel();
  EXPECT_EQ(queue_.waitingCount(), 0U);
  EXPECT_TRUE(waits.isCanceled());
  EXPECT_TRUE(waits.isBusy()) << "until it is said";
  EXPECT_TRUE(QTest::qWaitFor([&] { return finished.size() == 1; }));
  EXPECT_FALSE(waits.isBusy());
  letGo(0);
  EXPECT_FALSE(jobs_[2].hasBegun);
}

TEST_F(JobQueueTest, BeginsAnewWhatWasCanceledBeforeItBegan) {
  for (int i = 0; i < 2; ++i)
    start("running", JobPriority::background);
  JobSlot& waits = start("waits", JobPriority::background);
  QSignalSpy finished(&waits, &JobSlot::finished);
  waits.cancel();
  waits.start([](const Progress&) { return 0; }, [this](int) { done_.emplace_back("anew"); });
  letGo(0);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !waits.isBusy(); }));
  EXPECT_THAT(done_, ElementsAre("running", "anew"));
  EXPECT_EQ(finished.size(), 1);
}

TEST_F(JobQueueTest, GoesOnWithoutASlotThatIsGone) {
  auto gone = std::make_unique<JobSlot>(queue_, JobPriority::background);
  gone->start(
      [](const Progress& progress) -> int {
        for (;;)
          progress.check();
      },
      [](int) {});
  start("one", JobPriority::background);
  start("two", JobPriority::background);
  EXPECT_EQ(queue_.waitingCount(), 1U);
  gone.reset();
  EXPECT_TRUE(begins(1));
}

} // namespace
} // namespace espalier
