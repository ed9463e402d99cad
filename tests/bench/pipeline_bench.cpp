// Times each step from scan to radii on simulated scans of one broadleaf tree: 100 k, 400 k and 1 M
// points. Compare ratios within one run: machines differ.
#include "core/cloud/isolated_points.h"
#include "core/cloud/point_cloud.h"
#include "core/contract/geodesic_centroid.h"
#include "core/graph/components.h"
#include "core/graph/find_root.h"
#include "core/graph/geodesic.h"
#include "core/graph/neighborhood_graph.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/scan_measures.h"
#include "core/radius/assigned_radii.h"
#include "core/radius/fused_radii.h"
#include "core/radius/length_pipe_model.h"
#include "core/radius/recenter_on_cylinders.h"
#include "core/reconstruct/geodesic_bins.h"
#include "core/reconstruct/join_gaps.h"
#include "core/simulate/laser_scanner.h"
#include "core/simulate/plant_grower.h"
#include "core/skeleton/assemble_axes.h"
#include "core/skeleton/prune.h"
#include "core/skeleton/recenter.h"
#include "core/skeleton/simplify_axes.h"
#include "core/skeleton/slide_insertions.h"

#include <benchmark/benchmark.h>

#include <map>
#include <memory>

namespace espalier {
namespace {

/// All that the steps take, made once per size.
struct Workpiece {
  RawPoints raw;
  std::shared_ptr<const PointCloud> cloud;
  double spacing = 0;
  Eigen::Matrix3Xf contracted;
  Skeleton skeleton;

  explicit Workpiece(Eigen::Index points) {
    raw = scan(growPlant({.segments = 2000}, 1), {.points = points}, 1).points;
    cloud = std::make_shared<const PointCloud>(raw);
    const Reconstruction result = Pipeline().run(cloud);
    spacing = result.scale.spacing;
    contracted = *result.contracted;
    skeleton = *result.skeleton;
  }
  [[nodiscard]] const Eigen::Matrix3Xf& positions() const { return cloud->positions(); }
};

const Workpiece& workpiece(const benchmark::State& state) {
  static std::map<std::int64_t, std::unique_ptr<Workpiece>> all;
  std::unique_ptr<Workpiece>& one = all[state.range(0)];
  if (!one) one = std::make_unique<Workpiece>(state.range(0));
  return *one;
}

/// Times `step(workpiece)`.
template <class Step> void time(benchmark::State& state, const Step& step) {
  const Workpiece& piece = workpiece(state);
  for (auto _ : state) {
    auto result = step(piece);
    benchmark::DoNotOptimize(result);
  }
  state.counters["points"] = static_cast<double>(piece.cloud->size());
  state.counters["per_s"] = benchmark::Counter(static_cast<double>(piece.cloud->size()),
                                               benchmark::Counter::kIsIterationInvariantRate);
}

void sortPoints(benchmark::State& state) {
  time(state, [](const Workpiece& piece) { return PointCloud(piece.raw); });
}
void spacing(benchmark::State& state) {
  time(state, [](const Workpiece& piece) { return pointSpacing(piece.positions()); });
}
void measureScan(benchmark::State& state) {
  time(state, [](const Workpiece& piece) { return scanMeasures(*piece.cloud, {}, UpAxis::z); });
}
void clean(benchmark::State& state) {
  time(state, [](const Workpiece& piece) {
    return isolatedPoints(SpatialIndex(piece.positions()),
                          {.neighbors = 8, .distance = 8 * piece.spacing});
  });
}
void graph12(benchmark::State& state) {
  time(state, [](const Workpiece& piece) { return NeighborhoodGraph(piece.positions(), 12); });
}
void joinComponents(benchmark::State& state) {
  const NeighborhoodGraph parts(workpiece(state).positions(), 12);
  time(state, [&](const Workpiece& piece) { return joined(parts, piece.positions()); });
}
void shortestPaths(benchmark::State& state) {
  const NeighborhoodGraph parts(workpiece(state).positions(), 12);
  time(state,
       [&](const Workpiece& piece) { return geodesics(parts, {findRoot(piece.positions())}); });
}
void contractToCentroids(benchmark::State& state) {
  time(state, [](const Workpiece& piece) {
    return contractedToGeodesicCentroids(piece.positions(),
                                         {.neighbors = 7, .radius = 7.5 * piece.spacing});
  });
}
void geodesicBins(benchmark::State& state) {
  time(state, [](const Workpiece& piece) {
    return skeletonByGeodesicBins(piece.contracted, findRoot(piece.positions()),
                                  {.neighbors = 12, .binWidth = 7.5 * piece.spacing});
  });
}
void prune(benchmark::State& state) {
  time(state, [](const Workpiece& piece) {
    return withoutSpurs(piece.skeleton, {.length = 14 * piece.spacing});
  });
}
void assembleAxes(benchmark::State& state) {
  time(state, [](const Workpiece& piece) { return withAssembledAxes(piece.skeleton); });
}
void recenter(benchmark::State& state) {
  time(state, [](const Workpiece& piece) {
    return recentered(piece.skeleton, piece.positions(), piece.cloud->origin());
  });
}
void radii(benchmark::State& state) {
  time(state, [](const Workpiece& piece) {
    return meanPointDistances(piece.skeleton, piece.positions(), piece.cloud->origin());
  });
}
void cylinders(benchmark::State& state) {
  time(state, [](const Workpiece& piece) {
    const AssignedPoints points(piece.skeleton, piece.positions(), piece.cloud->origin());
    return cylinderRadii(cylindersAbout(piece.skeleton, points, {.spacing = piece.spacing}),
                         piece.spacing);
  });
}
void fuseRadii(benchmark::State& state) {
  const Workpiece& piece = workpiece(state);
  const AssignedPoints points(piece.skeleton, piece.positions(), piece.cloud->origin());
  const auto measured = cylinderRadii(
      cylindersAbout(piece.skeleton, points, {.spacing = piece.spacing}), piece.spacing);
  time(state, [&](const Workpiece& same) {
    const auto model = fittedLengthPipe(same.skeleton, measured);
    return fusedRadii(same.skeleton, measured, radiiOf(same.skeleton, model.value()));
  });
}
void recenterOnCylinders(benchmark::State& state) {
  time(state, [](const Workpiece& piece) {
    return recenteredOnCylinders(piece.skeleton, piece.positions(), piece.cloud->origin(),
                                 {.cylinders = {.spacing = piece.spacing}});
  });
}
void joinGaps(benchmark::State& state) {
  time(state, [](const Workpiece& piece) {
    return withJoinedGaps(piece.skeleton,
                          {.widest = 14 * piece.spacing, .reach = 40 * piece.spacing});
  });
}
void slideInsertions(benchmark::State& state) {
  time(state, [](const Workpiece& piece) { return withSlidInsertions(piece.skeleton); });
}
void simplifyAxes(benchmark::State& state) {
  time(state,
       [](const Workpiece& piece) { return withSimpleAxes(piece.skeleton, piece.spacing / 2); });
}
void wholePipeline(benchmark::State& state) {
  time(state, [](const Workpiece& piece) { return Pipeline().run(piece.cloud); });
}

void sizes(benchmark::internal::Benchmark* each) {
  each->Arg(100'000)->Arg(400'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond)->UseRealTime();
}

BENCHMARK(sortPoints)->Apply(sizes);
BENCHMARK(spacing)->Apply(sizes);
BENCHMARK(measureScan)->Apply(sizes);
BENCHMARK(clean)->Apply(sizes);
BENCHMARK(graph12)->Apply(sizes);
BENCHMARK(joinComponents)->Apply(sizes);
BENCHMARK(shortestPaths)->Apply(sizes);
BENCHMARK(contractToCentroids)->Apply(sizes);
BENCHMARK(geodesicBins)->Apply(sizes);
BENCHMARK(prune)->Apply(sizes);
BENCHMARK(assembleAxes)->Apply(sizes);
BENCHMARK(recenter)->Apply(sizes);
BENCHMARK(radii)->Apply(sizes);
BENCHMARK(cylinders)->Apply(sizes);
BENCHMARK(fuseRadii)->Apply(sizes);
BENCHMARK(recenterOnCylinders)->Apply(sizes);
BENCHMARK(joinGaps)->Apply(sizes);
BENCHMARK(slideInsertions)->Apply(sizes);
BENCHMARK(simplifyAxes)->Apply(sizes);
BENCHMARK(wholePipeline)->Apply(sizes);

} // namespace
} // namespace espalier
