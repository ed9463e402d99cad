// How long every method of every step, what reads and writes points, and what registers scans still
// run after they were asked to stop: the longest wait of some tries, each asked at another moment.
// 0.1 s is what a person takes for at once.
//
//   espalier_cancel SCAN [STEP.METHOD | scan.read | register.points ...]
#include "core/align/cloud_fit.h"
#include "core/align/scan_distances.h"
#include "core/align/target_sphere.h"
#include "core/cloud/file_order.h"
#include "core/cloud/joined_clouds.h"
#include "core/io/formats.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/plant_scale.h"
#include "core/project/project.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

namespace espalier {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

using Act = std::function<void(const Progress&)>;

/// How long the act went on after it was asked to stop [s]; none if it was done before.
std::optional<double> waitOf(const Act& act, double after) {
  std::stop_source stop;
  std::atomic<bool> isOver = false;
  Clock::time_point ended;
  bool isCancelled = false;
  std::jthread run([&] {
    try {
      act(Progress(stop.get_token(), {}));
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

void measure(const std::string& name, const Act& act) {
  std::optional<double> longest;
  int tries = 0;
  for (const double after :
       {0.0, 0.02, 0.05, 0.1, 0.2, 0.35, 0.5, 0.8, 1.3, 2.1, 3.4, 5.5, 8.9, 14.4, 23.3}) {
    const auto wait = waitOf(act, after);
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

/// What is asked for by name; nothing: all.
using Wanted = std::vector<std::string>;

bool isWanted(const Wanted& wanted, const std::string& name) {
  return wanted.empty() || std::ranges::find(wanted, name) != wanted.end();
}

void measureMethods(const std::shared_ptr<const PointCloud>& cloud, const Wanted& wanted) {
  std::string before; // the step before
  for (const Step& step : pipelineSteps()) {
    for (const Method& method : step.methods) {
      const std::string name = step.name + "." + method.name;
      if (!isWanted(wanted, name)) continue;
      PipelineOptions options;
      options.set(step.name + ".method=" + method.name);
      Pipeline pipeline;
      if (!before.empty()) (void)pipeline.run(cloud, options, {}, before);
      measure(name, [&](const Progress& progress) {
        (void)pipeline.run(cloud, options, progress, step.name);
      });
    }
    before = step.name;
  }
}

/// Files of points, and the scan laid on itself, turned and moved by a tenth of its size.
void measureScans(const std::filesystem::path& file, const std::shared_ptr<const PointCloud>& cloud,
                  const Wanted& wanted) {
  const double size = cloud->bounds().sizes().maxCoeff();
  const Eigen::Isometry3d motion = Eigen::Translation3d(0.1 * size, 0, 0) *
                                   Eigen::AngleAxisd(0.05, Eigen::Vector3d::UnitZ()) *
                                   Eigen::Isometry3d::Identity();
  const std::vector<PlacedCloud> both = {
      {.cloud = cloud, .motion = Eigen::Isometry3d::Identity(), .name = "one"},
      {.cloud = cloud, .motion = motion, .name = "two"}};
  const SpatialIndex index(cloud->positions());
  const std::filesystem::path folder = std::filesystem::temp_directory_path();
  const auto written = [&](const char* end) {
    return folder / ("espalier_cancel_" + std::to_string(::getpid()) + end);
  };
  const std::vector<std::pair<std::string, Act>> acts = {
      {"scan.read", [&](const Progress& progress) { (void)readPoints(file, progress); }},
      {"scan.write_ply",
       [&](const Progress& progress) { writePoints(written(".ply"), *cloud, progress); }},
      {"scan.write_xyz",
       [&](const Progress& progress) { writePoints(written(".xyz"), *cloud, progress); }},
      {"scan.hash", [&](const Progress& progress) { (void)ScanReference::of(file, {}, progress); }},
      {"scan.index",
       [&](const Progress& progress) { (void)SpatialIndex(cloud->positions(), progress); }},
      {"scan.measure",
       [&](const Progress& progress) { (void)plantSides(*cloud, index, {}, progress); }},
      {"scan.sort", [&](const Progress& progress) { (void)sortedAsInFile(*cloud, progress); }},
      {"register.join", [&](const Progress& progress) { (void)joined(both, progress); }},
      {"register.points",
       [&](const Progress& progress) { (void)fitClouds(*cloud, *cloud, motion, {}, progress); }},
      {"register.sphere",
       [&](const Progress& progress) {
         (void)targetSphere(*cloud, index, cloud->position(cloud->size() / 2),
                            {.radius = 0.02 * size, .reach = {}}, progress);
       }},
      {"register.distances", [&](const Progress& progress) {
         (void)distancesToScan(*cloud, motion, *cloud, index, progress);
       }}};
  for (const auto& [name, act] : acts)
    if (isWanted(wanted, name)) measure(name, act);
  for (const char* end : {".ply", ".xyz"})
    std::filesystem::remove(written(end));
}

} // namespace
} // namespace espalier

int main(int argc, char** argv) {
  using namespace espalier;
  if (argc < 2) {
    std::fprintf(stderr,
                 "usage: espalier_cancel SCAN [STEP.METHOD | scan.read | register.points ...]\n");
    return 2;
  }
  try {
    const auto cloud = std::make_shared<const PointCloud>(readPoints(argv[1]).value);
    const Wanted wanted(argv + 2, argv + argc);
    measureScans(argv[1], cloud, wanted);
    measureMethods(cloud, wanted);
    return 0;
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "%s\n", problem.what());
    return 1;
  }
}
