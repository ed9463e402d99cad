#include "ui/jobs/job_runner.h"
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
  JobRunner runner;
  int inJob = niceness();
  const int before = inJob;
  runner.start(
      "Look", [](const Progress&) { return niceness(); }, [&](int nice) { inJob = nice; });
  ASSERT_TRUE(QTest::qWaitFor([&] { return !runner.isRunning(); }));
  EXPECT_GT(inJob, before);
}

} // namespace
} // namespace espalier
