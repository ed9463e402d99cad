// Times the methods that smooth, with their defaults, and the filling of holes, on simulated scans
// of one broadleaf tree. Run it with --benchmark_filter=smooth/
#include "core/cloud/point_cloud.h"
#include "core/contract/fill_holes.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/pipeline_start.h"
#include "core/pipeline/plant_scale.h"
#include "core/pipeline/smoothed_scan.h"
#include "core/simulate/laser_scanner.h"
#include "core/simulate/plant_grower.h"

#include <benchmark/benchmark.h>

#include <map>
#include <memory>

namespace espalier {
namespace {

/// A scan, and what rules follow from.
struct SmoothedTree {
  std::shared_ptr<const PointCloud> cloud;
  PlantScale scale;

  explicit SmoothedTree(Eigen::Index points)
      : cloud(std::make_shared<const PointCloud>(
            scan(growPlant({.segments = 2000}, 1), {.points = points}, 1).points)),
        scale(scaleOf(*cloud, {}, UpAxis::z)) {}
};

const SmoothedTree& treeOf(const benchmark::State& state) {
  static std::map<std::int64_t, std::unique_ptr<SmoothedTree>> all;
  std::unique_ptr<SmoothedTree>& one = all[state.range(0)];
  if (!one) one = std::make_unique<SmoothedTree>(state.range(0));
  return *one;
}

void smooth(benchmark::State& state, const Method& method) {
  const SmoothedTree& tree = treeOf(state);
  const std::vector<double> values = resolvedValues(smoothingStep(), method, {}, tree.scale);
  for (auto _ : state) {
    PipelineState smoothed = firstState(tree.cloud, PointSet());
    method.run(smoothed, values, {});
    benchmark::DoNotOptimize(smoothed.contracted);
  }
}

void fill(benchmark::State& state) {
  const SmoothedTree& tree = treeOf(state);
  const double spacing = tree.scale.spacing;
  Eigen::Index added = 0;
  for (auto _ : state)
    added = pointsInHoles(tree.cloud->positions(), LocalShape::sphere,
                          {.widest = 15 * spacing, .spacing = spacing, .radius = 6 * spacing})
                .cols();
  state.counters["added"] = static_cast<double>(added);
}

void sizesOf(benchmark::internal::Benchmark* each) {
  each->Arg(100'000)->Arg(400'000)->Unit(benchmark::kMillisecond)->UseRealTime();
}

[[maybe_unused]] const bool areSmoothed = [] {
  for (const Method& method : smoothingStep().methods)
    sizesOf(benchmark::RegisterBenchmark(("smooth/" + method.name).c_str(),
                                         [&](benchmark::State& state) { smooth(state, method); }));
  sizesOf(benchmark::RegisterBenchmark("smooth/fill", fill));
  return true;
}();

} // namespace
} // namespace espalier
