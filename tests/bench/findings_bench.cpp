// Times what follows each edit: distances of the points to the skeleton, and the checks. A tree of
// 20 000 nodes about, and scans of 150 k and 1 M points.
#include "core/simulate/laser_scanner.h"
#include "core/simulate/plant_grower.h"
#include "core/skeleton/checks.h"
#include "core/skeleton/checks_of_scan.h"
#include "core/skeleton/node_values.h"
#include "core/skeleton/point_distances.h"

#include <benchmark/benchmark.h>

#include <map>
#include <memory>

namespace espalier {
namespace {

const Skeleton& plant() {
  static const Skeleton skeleton = growPlant({.segments = 2000}, 1);
  return skeleton;
}

struct Scanned {
  std::shared_ptr<const PointCloud> cloud;
  double spacing;
};

const Scanned& scanned(const benchmark::State& state) {
  static std::map<std::int64_t, Scanned> all;
  Scanned& one = all[state.range(0)];
  if (!one.cloud) {
    one.cloud =
        std::make_shared<const PointCloud>(scan(plant(), {.points = state.range(0)}, 1).points);
    one.spacing = pointSpacing(one.cloud->positions());
  }
  return one;
}

void measureAnew(benchmark::State& state) {
  const Scanned& scan = scanned(state);
  for (auto _ : state)
    benchmark::DoNotOptimize(PointDistances(scan.cloud, scan.spacing, plant()).toSurface().data());
  state.counters["points"] = static_cast<double>(scan.cloud->size());
  state.counters["nodes"] = static_cast<double>(plant().size());
}

/// A move of one node, then of the next ...
void measureAnEdit(benchmark::State& state) {
  const Scanned& scan = scanned(state);
  Skeleton skeleton = plant();
  PointDistances distances(scan.cloud, scan.spacing, skeleton);
  const std::vector<NodeId> ids = skeleton.ids();
  std::size_t next = 0;
  for (auto _ : state) {
    SkeletonEditor editor(skeleton);
    const NodeId id = ids[next++ * 31 % ids.size()];
    editor.setPosition(id, skeleton[id].position + Eigen::Vector3d(scan.spacing, 0, 0));
    benchmark::DoNotOptimize(distances.update(skeleton, editor.commit()));
  }
}

void checkTheSkeleton(benchmark::State& state) {
  for (auto _ : state)
    benchmark::DoNotOptimize(check(plant(), scanned(state).spacing));
}

void checkAgainstTheScan(benchmark::State& state) {
  const Scanned& scan = scanned(state);
  const PointDistances distances(scan.cloud, scan.spacing, plant());
  const SpatialIndex index(scan.cloud->positions());
  for (auto _ : state) {
    benchmark::DoNotOptimize(checkAgainstScan(plant(), distances, index, scan.spacing));
  }
}

void valuesOfNodes(benchmark::State& state) {
  const Scanned& scan = scanned(state);
  const PointDistances distances(scan.cloud, scan.spacing, plant());
  for (auto _ : state)
    benchmark::DoNotOptimize(nodeValues(plant(), NodeValue::confidence, &distances, scan.spacing));
}

BENCHMARK(measureAnew)->Arg(150'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(measureAnEdit)
    ->Arg(150'000)
    ->Arg(1'000'000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(checkTheSkeleton)->Arg(150'000)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(checkAgainstTheScan)->Arg(150'000)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(valuesOfNodes)->Arg(1'000'000)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
} // namespace espalier
