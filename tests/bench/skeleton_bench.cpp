// Times every method of the step "skeleton", with its default options, on contracted points of
// simulated scans of one broadleaf tree.
#include "core/pipeline/pipeline.h"
#include "core/simulate/laser_scanner.h"
#include "core/simulate/plant_grower.h"

#include <benchmark/benchmark.h>

#include <map>
#include <memory>

namespace espalier {
namespace {

std::shared_ptr<const PointCloud> cloudOf(std::int64_t points) {
  static std::map<std::int64_t, std::shared_ptr<const PointCloud>> all;
  std::shared_ptr<const PointCloud>& cloud = all[points];
  if (!cloud)
    cloud = std::make_shared<const PointCloud>(
        scan(growPlant({.segments = 2000}, 1), {.points = points}, 1).points);
  return cloud;
}

/// The steps before it are at hand from the run before.
void timeMethod(benchmark::State& state, const std::string& method) {
  const std::shared_ptr<const PointCloud> cloud = cloudOf(state.range(0));
  PipelineOptions options;
  options.methods["skeleton"] = method;
  for (auto _ : state) {
    state.PauseTiming();
    Pipeline pipeline;
    (void)pipeline.run(cloud, options, {}, "contract");
    state.ResumeTiming();
    const Reconstruction result = pipeline.run(cloud, options, {}, "skeleton");
    benchmark::DoNotOptimize(result.skeleton->size());
  }
  state.counters["points"] = static_cast<double>(cloud->size());
}

[[maybe_unused]] const bool areRegistered = [] {
  for (const Method& method : stepNamed("skeleton").methods)
    benchmark::RegisterBenchmark(
        ("skeleton/" + method.name).c_str(),
        [name = method.name](benchmark::State& state) { timeMethod(state, name); })
        ->Arg(100'000)
        ->Arg(400'000)
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
  return true;
}();

} // namespace
} // namespace espalier
