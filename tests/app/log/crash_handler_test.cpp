#include "app/log/crash_handler.h"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <chrono>
#include <csignal>
#include <thread>
#include <vector>

namespace espalier {
namespace {

constexpr const char* report =
    "^\nespalier: crashed: memory that is not there was used .SIGSEGV.\n$";

int overflow(const volatile char* before) { // NOLINT(misc-no-recursion)
  volatile char room[10'000] = {};          // NOLINT(modernize-avoid-c-arrays): volatile
  room[0] = before == nullptr ? char{1} : *before;
  if (room[0] == 0) return 0; // never
  return overflow(room) + room[1];
}

struct CrashHandlerDeathTest : testing::Test {
  CrashHandlerDeathTest() { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
};

TEST_F(CrashHandlerDeathTest, ReportsAStackThatOverflowsInAThreadOfAJob) {
  EXPECT_EXIT(
      {
        reportCrashes(-1);
        std::thread([] {
          reportCrashesOfThread();
          (void)overflow(nullptr);
        }).join();
      },
      testing::KilledBySignal(SIGSEGV), report);
}

TEST_F(CrashHandlerDeathTest, ReportsAStackThatOverflowsInAThreadThatHelpsAJob) {
  EXPECT_EXIT(
      {
        reportCrashes(-1);
        std::thread([] {
          reportCrashesOfThread();
          const std::thread::id own = std::this_thread::get_id();
          for (;;) // until a helper comes
            tbb::parallel_for(0, 1000, [&](int) {
              if (std::this_thread::get_id() != own) (void)overflow(nullptr);
              std::this_thread::sleep_for(std::chrono::microseconds(10));
            });
        }).join();
      },
      testing::KilledBySignal(SIGSEGV), report);
}

TEST_F(CrashHandlerDeathTest, ReportsTheFirstOfManyThreadsThatCrash) {
  EXPECT_EXIT(
      {
        reportCrashes(-1);
        std::vector<std::thread> threads;
        for (int i = 0; i < 16; ++i)
          threads.emplace_back([] { std::raise(SIGSEGV); });
        for (std::thread& thread : threads)
          thread.join();
      },
      testing::KilledBySignal(SIGSEGV), report);
}

} // namespace
} // namespace espalier
