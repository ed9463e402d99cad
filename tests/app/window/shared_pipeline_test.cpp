#include "app/window/preview/shared_pipeline.h"
#include "tests/support/cloud_of.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <stop_token>
#include <string_view>
#include <thread>
#include <utility>

namespace espalier {
namespace {

TEST(SharedPipeline, IsNoLongerWaitedForByWhoIsAskedToStop) {
  SharedPipeline pipeline;
  const auto cloud = test::cloudOf(test::forkCloud());
  std::promise<void> hasBegun;
  std::promise<void> letGo;
  bool isHeld = false;
  const Progress held({}, [&](double, std::string_view) {
    if (std::exchange(isHeld, true)) return;
    hasBegun.set_value();
    letGo.get_future().wait();
  });
  std::jthread first([&] { static_cast<void>(pipeline.run(cloud, {}, held)); });
  hasBegun.get_future().wait();
  std::stop_source stop;
  std::future<bool> second = std::async(std::launch::async, [&] {
    try {
      static_cast<void>(pipeline.run(cloud, {}, Progress(stop.get_token(), {})));
      return false;
    } catch (const Cancelled&) {
      return true;
    }
  });
  EXPECT_EQ(second.wait_for(std::chrono::milliseconds(50)), std::future_status::timeout);
  stop.request_stop();
  EXPECT_TRUE(second.get()) << "though the first still works";
  letGo.set_value();
}

} // namespace
} // namespace espalier
