// How long every method of every step still runs after it was asked to stop: the longest wait of
// some tries, each asked at another moment. 0.1 s is what a person takes for at once.
//
//   espalier_cancel SCAN [STEP.METHOD ...]
#include "core/io/formats.h"
#include "core/pipeline/pipeline.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

namespace espalier {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// How long the run went on after it was asked to stop [s]; none if it was done before.
std::optional<double> waitOf(Pipeline& pipeline, const std::shared_ptr<const PointCloud>& cloud,
                             const PipelineOptions& options, const std::string& step,
                             double after) {
  std::stop_source stop;
  std::atomic<bool> isOver = false;
  Clock::time_point ended;
  bool isCancelled = false;
  std::jthread run([&] {
    try {
      (void)pipeline.run(cloud, options, Progress(stop.get_token(), {}), step);
    } catch (const Cancelled&) {
      isCancelled = true;
    } catch (const std::exception&) { // none grows: that is not what is measured
    }
    ended = Clock::now();
    isOver = true;
  });
  const auto start = Clock::now();
  while (!isOver && secondsSince(start) < after)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  const auto asked = Clock::now();
  stop.request_stop();
  run.join();
  if (!isCancelled) return {};
  return std::chrono::duration<double>(ended - asked).count();
}

void measure(const std::shared_ptr<const PointCloud>& cloud, const std::vector<std::string>& only) {
  std::string before; // the step before
  for (const Step& step : pipelineSteps()) {
    for (const Method& method : step.methods) {
      const std::string name = step.name + "." + method.name;
      if (!only.empty() && std::ranges::find(only, name) == only.end()) continue;
      PipelineOptions options;
      options.set(step.name + ".method=" + method.name);
      Pipeline pipeline;
      if (!before.empty()) (void)pipeline.run(cloud, options, {}, before);
      std::optional<double> longest;
      int tries = 0;
      for (const double after :
           {0.0, 0.02, 0.05, 0.1, 0.2, 0.35, 0.5, 0.8, 1.3, 2.1, 3.4, 5.5, 8.9, 14.4, 23.3}) {
        const auto wait = waitOf(pipeline, cloud, options, step.name, after);
        if (!wait) break; // done by then
        longest = std::max(longest.value_or(0), *wait);
        ++tries;
      }
      if (longest)
        std::printf("%-34s %7.3f s  %2d tries%s\n", name.c_str(), *longest, tries,
                    *longest > 0.1 ? "  too long" : "");
      else
        std::printf("%-34s    done at once\n", name.c_str());
      std::fflush(stdout);
    }
    before = step.name;
  }
}

} // namespace
} // namespace espalier

int main(int argc, char** argv) {
  using namespace espalier;
  if (argc < 2) {
    std::fprintf(stderr, "usage: espalier_cancel SCAN [STEP.METHOD ...]\n");
    return 2;
  }
  try {
    measure(std::make_shared<const PointCloud>(readPoints(argv[1]).value),
            std::vector<std::string>(argv + 2, argv + argc));
    return 0;
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "%s\n", problem.what());
    return 1;
  }
}
