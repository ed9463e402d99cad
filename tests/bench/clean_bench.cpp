// Times cleaning and cutting a simulated plot of three trees on a slope, with a pole and a wire:
// 200 k and 1 M points, by the preset `plot`, and each filter by itself.
#include "core/clean/ground.h"
#include "core/clean/outliers.h"
#include "core/clean/parts.h"
#include "core/clean/plants.h"
#include "core/clean/pole.h"
#include "core/clean/thinning.h"
#include "core/clean/wire.h"
#include "core/pipeline/cleaned_scan.h"
#include "core/pipeline/presets.h"
#include "core/simulate/plot.h"

#include <benchmark/benchmark.h>

#include <map>
#include <memory>

namespace espalier {
namespace {

struct BenchPlot {
  std::shared_ptr<const PointCloud> cloud;
  PlantScale scale;
  SimulatedPlot simulated;

  explicit BenchPlot(Eigen::Index points) {
    PlotOptions options;
    options.scanner.points = points;
    simulated = simulatePlot(options, 1);
    cloud = std::make_shared<const PointCloud>(simulated.points);
    scale = scaleOf(*cloud, {}, UpAxis::z);
  }
};

const BenchPlot& plotOf(const benchmark::State& state) {
  static std::map<std::int64_t, std::unique_ptr<BenchPlot>> all;
  std::unique_ptr<BenchPlot>& one = all[state.range(0)];
  if (!one) one = std::make_unique<BenchPlot>(state.range(0));
  return *one;
}

template <class Work> void time(benchmark::State& state, const Work& work) {
  const BenchPlot& plot = plotOf(state);
  for (auto _ : state)
    benchmark::DoNotOptimize(work(plot));
  state.counters["points"] = static_cast<double>(plot.cloud->size());
}

#define PLOT_BENCHMARK(name)                                                                       \
  BENCHMARK(name)                                                                                  \
      ->Arg(200'000)                                                                               \
      ->Arg(1'000'000)                                                                             \
      ->Unit(benchmark::kMillisecond)                                                              \
      ->MeasureProcessCPUTime()                                                                    \
      ->UseRealTime()

void cutPlotByPreset(benchmark::State& state) {
  time(state, [](const BenchPlot& plot) {
    return cutPlot(plot.cloud, {}, presetNamed("plot")->options).plants.size();
  });
}
PLOT_BENCHMARK(cutPlotByPreset);

void clothOnGround(benchmark::State& state) {
  time(state, [](const BenchPlot& plot) {
    return groundBelow(plot.cloud->positions(), resolved(GroundOptions{}, plot.scale))
        .heights.size();
  });
}
PLOT_BENCHMARK(clothOnGround);

void searchForPoles(benchmark::State& state) {
  time(state, [](const BenchPlot& plot) {
    return polesIn(plot.cloud->positions(), resolved(PoleOptions{}, plot.scale)).size();
  });
}
PLOT_BENCHMARK(searchForPoles);

void searchForWires(benchmark::State& state) {
  time(state, [](const BenchPlot& plot) {
    return wiresIn(plot.cloud->positions(), resolved(WireOptions{}, plot.scale)).size();
  });
}
PLOT_BENCHMARK(searchForWires);

void cutAtStems(benchmark::State& state) {
  time(state, [](const BenchPlot& plot) {
    return plantsOf(*plot.cloud, {}, UpAxis::z, plot.scale, plot.simulated.bases).sizes.size();
  });
}
PLOT_BENCHMARK(cutAtStems);

void leaveOutStatisticalOutliers(benchmark::State& state) {
  time(state, [](const BenchPlot& plot) {
    return statisticalOutliers(SpatialIndex(plot.cloud->positions()), {}).size();
  });
}
PLOT_BENCHMARK(leaveOutStatisticalOutliers);

void leaveOutSparsestPoints(benchmark::State& state) {
  time(state, [](const BenchPlot& plot) {
    return sparsestPoints(SpatialIndex(plot.cloud->positions()), {}).size();
  });
}
PLOT_BENCHMARK(leaveOutSparsestPoints);

void leaveOutLooseParts(benchmark::State& state) {
  time(state, [](const BenchPlot& plot) {
    return outsideParts(plot.cloud->positions(), {}, {.widestGap = 8 * plot.scale.spacing}).size();
  });
}
PLOT_BENCHMARK(leaveOutLooseParts);

void thinByVoxels(benchmark::State& state) {
  time(state, [](const BenchPlot& plot) {
    return thinnedByVoxels(plot.cloud->positions(), {.edge = 2 * plot.scale.spacing}).size();
  });
}
PLOT_BENCHMARK(thinByVoxels);

void thinBySpacing(benchmark::State& state) {
  time(state, [](const BenchPlot& plot) {
    return thinnedBySpacing(plot.cloud->positions(), {.spacing = 2 * plot.scale.spacing}).size();
  });
}
PLOT_BENCHMARK(thinBySpacing);

} // namespace
} // namespace espalier
