#include "ui/jobs/job_slot.h"
#include "ui/jobs/yield_to_window.h"

#include <QTest>
#include <gtest/gtest.h>

#include <sys/resource.h>
#include <thread>

namespace espalier {
namespace {

int niceness() {
  return getpriority(PRIO_PROCESS, 0); // of this thread
}

TEST(YieldToWindow, IsInheritedAndLeavesOtherThreadsAsTheyAre) {
  const int before = niceness();
  int inner = before;
  std::jthread([&] {
    yieldToWindow();
    std::jthread([&] { inner = niceness(); }).join();
  }).join();
  EXPECT_GT(inner, before);
  EXPECT_EQ(niceness(), before);
}

TEST(YieldToWindow, IsDoneByJobs) {
  JobQueue queue;
  JobSlot slot(queue, JobPriority::asked);
  int inJob = niceness();
  const int before = inJob;
  slot.start(
      "Look", [](const Progress&) { return niceness(); }, [&](int nice) { inJob = nice; });
  ASSERT_TRUE(QTest::qWaitFor([&] { return !slot.isBusy(); }));
  EXPECT_GT(inJob, before);
}

} // namespace
} // namespace espalier
