// Times what one waits for while a knob turns: 20 000 points of a scan of 150 k, contracted and
// reconstructed, and the numbers that judge them. What is of the whole scan is at hand.
#include "core/evaluate/study/contraction_quality.h"
#include "core/pipeline/method_sight.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/quality_of.h"
#include "core/pipeline/region_preview.h"
#include "core/simulate/laser_scanner.h"
#include "core/simulate/plant_grower.h"

#include <benchmark/benchmark.h>

#include <memory>
#include <string>

namespace espalier {
namespace {

struct Looked {
  std::shared_ptr<const PointCloud> cloud;
  PipelineOptions options;
  Reconstruction whole;
  std::unique_ptr<RegionPreviewer> previewer;
  Ball ball;

  explicit Looked(const std::string& contraction) {
    const SimulatedScan scanned = scan(growPlant({.segments = 2000}, 1), {.points = 150'000}, 1);
    cloud = std::make_shared<const PointCloud>(scanned.points);
    options.methods["contract"] = contraction;
    whole = Pipeline().run(cloud, options);
    previewer = std::make_unique<RegionPreviewer>(cloud, PointSet(), whole.scale);
    ball = previewer->ballWith(cloud->position(cloud->size() / 2), 20'000);
    (void)previewer->reconstructed(ball, options);
  }
};

const Looked& looked() {
  static const Looked one("geodesic_centroid");
  return one;
}

void previewContraction(benchmark::State& state) {
  const Looked& one = looked();
  for (auto _ : state)
    benchmark::DoNotOptimize(one.previewer->contracted(one.ball, one.options));
}
void previewSkeleton(benchmark::State& state) {
  const Looked& one = looked();
  for (auto _ : state)
    benchmark::DoNotOptimize(one.previewer->reconstructed(one.ball, one.options));
}
void judgeRegion(benchmark::State& state) {
  const Looked& one = looked();
  const RegionPreview part = one.previewer->reconstructed(one.ball, one.options);
  const Eigen::Matrix3Xf points = one.cloud->positions()(Eigen::all, part.points);
  for (auto _ : state)
    benchmark::DoNotOptimize(contractionQuality(points, part.contracted, part.skeleton,
                                                one.cloud->origin(),
                                                {.spacing = one.whole.scale.spacing}));
}
void judgeWhole(benchmark::State& state) {
  const Looked& one = looked();
  for (auto _ : state)
    benchmark::DoNotOptimize(qualityOf(*one.cloud, one.whole, one.options));
}
void seeAtPoint(benchmark::State& state) {
  const Looked& one = looked();
  const MethodSights sights(one.cloud, one.whole.contracted, one.options, one.whole.scale);
  for (auto _ : state)
    benchmark::DoNotOptimize(sights.at(one.cloud->size() / 2));
}

BENCHMARK(previewContraction)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(previewSkeleton)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(judgeRegion)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(judgeWhole)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(seeAtPoint)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
} // namespace espalier
