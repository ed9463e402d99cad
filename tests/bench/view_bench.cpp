// Times what the 3D view answers tools, in a plant of 20 000 nodes over a scan of 1 M points. It
// draws nothing and needs no display.
#include "core/pipeline/pipeline.h"
#include "core/simulate/laser_scanner.h"
#include "core/simulate/plant_grower.h"
#include "ui/view/area.h"
#include "ui/view/picture.h"

#include <benchmark/benchmark.h>

namespace espalier {
namespace {

constexpr double width = 1280;
constexpr double height = 740;

struct Seen {
  Scene scene;
  std::optional<ScreenMap> screen;

  Seen() {
    const Skeleton grown = growPlant({.segments = 2000}, 1);
    scene.setCloud(
        std::make_shared<const PointCloud>(scan(grown, {.points = 1'000'000}, 1).points));
    scene.setSkeleton(grown);
    screen.emplace(cameraOf(scene, StandardView::front, width / height),
                   Eigen::Vector2d(width, height));
  }
};

const Seen& seen() {
  static const Seen one;
  return one;
}

void time(benchmark::State& state, const auto& ask) {
  const Seen& one = seen();
  const QPolygonF box{QRectF(0, 0, width, height)}; // all there is
  std::size_t found = 0;
  for (auto _ : state) {
    const auto result = ask(one, box);
    found = result.size();
    benchmark::DoNotOptimize(result);
  }
  state.counters["points"] = static_cast<double>(one.scene.points.size());
  state.counters["nodes"] = static_cast<double>(one.scene.skeleton.nodes().size());
  state.counters["found"] = static_cast<double>(found);
}

void nodesInFront(benchmark::State& state) {
  time(state, [](const Seen& one, const QPolygonF& box) {
    return nodesInside(one.scene, *one.screen, box, Depth::front);
  });
}
void nodesThrough(benchmark::State& state) {
  time(state, [](const Seen& one, const QPolygonF& box) {
    return nodesInside(one.scene, *one.screen, box, Depth::through);
  });
}
void pointsInFront(benchmark::State& state) {
  time(state, [](const Seen& one, const QPolygonF& box) {
    return pointsInside(one.scene, *one.screen, box, Depth::front);
  });
}
void pointsThrough(benchmark::State& state) {
  time(state, [](const Seen& one, const QPolygonF& box) {
    return pointsInside(one.scene, *one.screen, box, Depth::through);
  });
}

BENCHMARK(nodesInFront)->Unit(benchmark::kMillisecond);
BENCHMARK(nodesThrough)->Unit(benchmark::kMillisecond);
BENCHMARK(pointsInFront)->Unit(benchmark::kMillisecond);
BENCHMARK(pointsThrough)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace espalier
