// Times traces across 1 m of the scan of the pine of the thesis, and what they share. Skipped
// unless the environment variable ESPALIER_SHARED_DATA names the folder of puu1/scan.ply.
#include "core/io/formats.h"
#include "core/reconstruct/trace.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <utility>

namespace espalier {
namespace {

const std::shared_ptr<const PointCloud>& pine() {
  static const std::shared_ptr<const PointCloud> cloud = [] {
    const char* folder = std::getenv("ESPALIER_SHARED_DATA");
    const std::filesystem::path path =
        std::filesystem::path(folder ? folder : "") / "puu1/scan.ply";
    return exists(path) ? std::make_shared<const PointCloud>(readPoints(path).value) : nullptr;
  }();
  return cloud;
}

void graphOfAScan(benchmark::State& state) {
  if (!pine()) return state.SkipWithError("shared data not found");
  for (auto _ : state)
    benchmark::DoNotOptimize(TraceGraph(pine()));
}
BENCHMARK(graphOfAScan)->Unit(benchmark::kMillisecond);

/// The two points that are nearest to 1 m apart, of a few spread through the scan.
std::pair<Eigen::Vector3d, Eigen::Vector3d> meterApart(const PointCloud& cloud) {
  const Eigen::Vector3d from = cloud.position(cloud.size() / 2);
  Eigen::Vector3d to = from;
  for (Eigen::Index i = 0; i < cloud.size(); i += 97) {
    const auto off = [&](const Eigen::Vector3d& place) {
      return std::abs((place - from).norm() - 1000); // the scan is in mm
    };
    if (off(cloud.position(i)) < off(to)) to = cloud.position(i);
  }
  return {from, to};
}

void traceAcrossAMeter(benchmark::State& state) {
  if (!pine()) return state.SkipWithError("shared data not found");
  const TraceGraph graph(pine());
  const auto [from, to] = meterApart(*pine());
  const TraceOptions options = {.step = 44, .alternatives = static_cast<int>(state.range(0))};
  for (auto _ : state)
    benchmark::DoNotOptimize(graph.between({from}, {to}, options));
}
BENCHMARK(traceAcrossAMeter)->Arg(0)->Arg(2)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace espalier
