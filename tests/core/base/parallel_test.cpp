#include "core/base/parallel.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace espalier {
namespace {

TEST(ParallelFor, RunsEachBodyOnce) {
  std::vector<int> runs(100000, 0);
  parallelFor(100000, [&](Eigen::Index i) { ++runs[static_cast<std::size_t>(i)]; });
  EXPECT_EQ(runs, std::vector<int>(100000, 1));
}

TEST(ParallelFor, PassesOnWhatABodyThrows) {
  const auto body = [](Eigen::Index i) {
    if (i == 777) throw std::runtime_error("bad");
  };
  EXPECT_THROW(parallelFor(1000, body), std::runtime_error);
}

TEST(ParallelFor, StopsInTheMiddleWhenAsked) {
  std::stop_source source;
  const Progress progress(source.get_token(), {});
  std::atomic<int> runs = 0;
  const auto body = [&](Eigen::Index) {
    if (++runs == 1000) source.request_stop();
  };
  EXPECT_THROW(parallelFor(10000000, body, progress, 16), Cancelled);
  EXPECT_LT(runs, 2000);
}

TEST(ParallelFor, OfNothingDoesNothing) {
  EXPECT_NO_THROW(parallelFor(0, [](Eigen::Index) { FAIL(); }));
}

} // namespace
} // namespace espalier
