#include "core/base/paced_check.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

#include <stop_token>

namespace espalier {
namespace {

TEST(PacedCheck, LooksAtOnce) {
  EXPECT_TRUE(test::stopsWhenAsked([](const Progress& p) { PacedCheck(p).after(1); }));
}

// However few are counted at a time, and also of many at once.
TEST(PacedCheck, LooksAgainAfterAMillionSteps) {
  for (const std::size_t atATime : {1, 1000, 5'000'000}) {
    std::stop_source stop;
    const Progress progress(stop.get_token(), {});
    PacedCheck check(progress);
    check.after(atATime);
    stop.request_stop();
    std::size_t done = 0;
    EXPECT_THROW(
        while (done < 10'000'000) {
          done += atATime;
          check.after(atATime);
        },
        Cancelled)
        << atATime;
    EXPECT_LT(done, 5'000'001) << atATime;
  }
}

TEST(PacedCheck, LeavesAloneWhatIsNotStopped) {
  const Progress progress;
  PacedCheck check(progress);
  EXPECT_NO_THROW(check.after(100'000'000));
}

} // namespace
} // namespace espalier
