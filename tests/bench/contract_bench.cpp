// Times every contraction with its defaults on simulated scans of one broadleaf tree, and reports
// how far it leaves the points from the true axes: the table of contractions. Run it with
// --benchmark_filter=contract/
#include "core/cloud/point_cloud.h"
#include "core/graph/densities.h"
#include "core/graph/normals.h"
#include "core/graph/orientations.h"
#include "core/pipeline/pipeline.h"
#include "core/simulate/laser_scanner.h"
#include "core/simulate/plant_grower.h"
#include "core/skeleton/assign_points.h"
#include "tests/support/clouds.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <map>
#include <memory>

namespace espalier {
namespace {

/// A scan, and the plant that it is of.
struct Scanned {
  Skeleton truth;
  std::shared_ptr<const PointCloud> cloud;
  PlantScale scale;

  explicit Scanned(Eigen::Index points) : truth(growPlant({.segments = 2000}, 1)) {
    cloud = std::make_shared<const PointCloud>(scan(truth, {.points = points}, 1).points);
    scale = {pointSpacing(cloud->positions()), test::heightOf(cloud->positions(), UpAxis::z)};
  }
};

const Scanned& scanned(const benchmark::State& state) {
  static std::map<std::int64_t, std::unique_ptr<Scanned>> all;
  std::unique_ptr<Scanned>& one = all[state.range(0)];
  if (!one) one = std::make_unique<Scanned>(state.range(0));
  return *one;
}

/// Distances to the true axes, in spacings.
void reportOffAxis(benchmark::State& state, const Scanned& of, const Eigen::Matrix3Xf& places) {
  std::vector<double> off;
  for (const PointOnSkeleton& one : assignPoints(places, of.cloud->origin(), of.truth, {}))
    off.push_back(one.distance / of.scale.spacing);
  std::ranges::sort(off);
  const auto count = static_cast<double>(off.size());
  const auto near = std::ranges::upper_bound(off, 1.0) - off.begin();
  state.counters["median_off"] = off[off.size() / 2];
  state.counters["p90_off"] = off[off.size() * 9 / 10];
  state.counters["within_1"] = static_cast<double>(near) / count;
}

void contract(benchmark::State& state, const Step& step, const Method& method) {
  const Scanned& of = scanned(state);
  const std::vector<double> values = resolvedValues(step, method, {}, of.scale);
  PipelineState done;
  for (auto _ : state) {
    done = {.cloud = of.cloud,
            .isLeftOut = std::vector<bool>(static_cast<std::size_t>(of.cloud->size()), false),
            .contracted = std::make_shared<const Eigen::Matrix3Xf>(of.cloud->positions()),
            .root = findRoot(of.cloud->positions()),
            .skeleton = {}};
    method.run(done, values, {});
  }
  reportOffAxis(state, of, *done.contracted);
}

void characterize(benchmark::State& state, void (*step)(const Scanned&, const NeighborhoodGraph&)) {
  const Scanned& of = scanned(state);
  const NeighborhoodGraph graph(of.cloud->positions(), 7);
  for (auto _ : state)
    step(of, graph);
}

void sizes(benchmark::internal::Benchmark* each) {
  each->Arg(100'000)->Arg(400'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond)->UseRealTime();
}

/// Registers what the registry of methods holds.
[[maybe_unused]] const bool isRegistered = [] {
  const Step& step = stepNamed("contract");
  for (const Method& method : step.methods)
    sizes(benchmark::RegisterBenchmark(
        ("contract/" + method.name).c_str(),
        [&](benchmark::State& state) { contract(state, step, method); }));
  const auto add = [](const char* name, auto work) {
    void (*const plain)(const Scanned&, const NeighborhoodGraph&) = work;
    sizes(benchmark::RegisterBenchmark(
        name, [plain](benchmark::State& state) { characterize(state, plain); }));
  };
  add("characterize/orientations", [](const Scanned& of, const NeighborhoodGraph& graph) {
    benchmark::DoNotOptimize(
        orientations(of.cloud->positions(), graph, static_cast<float>(of.scale.height / 100)));
  });
  add("characterize/radius_densities", [](const Scanned& of, const NeighborhoodGraph& graph) {
    benchmark::DoNotOptimize(radiusDensities(graph, static_cast<float>(of.scale.height / 100)));
  });
  add("characterize/nearest_densities", [](const Scanned& of, const NeighborhoodGraph&) {
    benchmark::DoNotOptimize(nearestDensities(SpatialIndex(of.cloud->positions()), 16));
  });
  add("characterize/normals", [](const Scanned& of, const NeighborhoodGraph& graph) {
    const Eigen::Matrix3Xf& points = of.cloud->positions();
    benchmark::DoNotOptimize(
        orientedNormals(points, normals(points, nearestNeighborhoods(points, 16)), graph));
  });
  return true;
}();

} // namespace
} // namespace espalier
