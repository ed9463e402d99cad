// Times what one sees while the plant is turned, and while a node is dragged, in a plant of 20 000
// nodes over a scan of 1 M points, and weighs a thousand steps of undo. It needs OpenGL, with EGL
// no display.
#include "core/simulate/laser_scanner.h"
#include "core/simulate/plant_grower.h"
#include "core/skeleton/edits.h"
#include "ui/document/plant_document.h"
#include "ui/view/offscreen_renderer.h"
#include "ui/view/picture.h"

#include <QGuiApplication>
#include <benchmark/benchmark.h>

#include <malloc.h>

namespace espalier {
namespace {

const Skeleton& plant() {
  static const Skeleton skeleton = growPlant({.segments = 3'000}, 1); // about 20 000 nodes
  return skeleton;
}

const QGuiApplication& application() { // which OpenGL asks for
  static int none = 0;
  static const QGuiApplication instance(none, nullptr);
  return instance;
}

std::shared_ptr<const PointCloud> scanned() {
  return std::make_shared<const PointCloud>(scan(plant(), {.points = 1'000'000}, 1).points);
}

/// A frame of a moving view, with so many points.
void turnFrame(benchmark::State& state) {
  application();
  Scene scene;
  scene.setCloud(scanned());
  scene.setSkeleton(plant());
  OffscreenRenderer renderer(scene, makeSceneBuffers());
  PlantRenderer::Frame frame{.camera = cameraOf(scene, StandardView::front, 1280.0 / 740),
                             .size = {1280, 740},
                             .points = state.range(),
                             .moving = true};
  for (auto round : state) {
    frame.camera.turn(0.01, 0);
    renderer.draw(frame);
    benchmark::DoNotOptimize(renderer.image()); // waits for what was drawn
  }
}
BENCHMARK(turnFrame)->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMillisecond);

/// An edit and the frame that shows it, as each move of the mouse asks for.
void dragFrame(benchmark::State& state) {
  application();
  PlantDocument document;
  document.openSkeleton(plant(), "plant.mtg");
  Scene scene;
  scene.setCloud(scanned());
  scene.setSkeleton(document.skeleton());
  QObject::connect(&document, &PlantDocument::skeletonEdited, [&](const SkeletonDelta& delta) {
    scene.skeleton.update(document.skeleton(), delta);
  });
  OffscreenRenderer renderer(scene, makeSceneBuffers());
  const PlantRenderer::Frame frame{.camera = cameraOf(scene, StandardView::front, 1280.0 / 740),
                                   .size = {1280, 740},
                                   .points = 1'000'000};
  while (!renderer.draw(frame).complete) {
  }
  const NodeId node = document.skeleton().ids()[document.skeleton().size() / 2];
  const Eigen::Vector3d start = document.skeleton()[node].position;
  const Gesture gesture = Gesture::begin();
  double distance = 0;
  for (auto round : state) {
    distance += 0.001;
    document.edit(
        "Move", [&](SkeletonEditor& editor) { moveNode(editor, node, start.array() + distance); },
        gesture);
    renderer.draw(frame);
    benchmark::DoNotOptimize(renderer.image()); // waits for what was drawn
  }
  state.counters["nodes"] = static_cast<double>(document.skeleton().size());
  state.counters["points"] = static_cast<double>(scene.points.size());
}
BENCHMARK(dragFrame)->Unit(benchmark::kMillisecond);

/// Bytes that 1000 steps of undo hold, each a move of `range` nodes.
void undoMemory(benchmark::State& state) {
  for (auto round : state) {
    PlantDocument document;
    document.openSkeleton(plant(), "plant.mtg");
    const std::vector<NodeId> ids = document.skeleton().ids();
    const std::size_t before = mallinfo2().uordblks;
    for (std::size_t step = 0; step < 1000; ++step)
      document.edit("Move", [&](SkeletonEditor& editor) {
        for (std::size_t i = 0; i < static_cast<std::size_t>(state.range(0)); ++i) {
          const NodeId id = ids[(step * 17 + i) % ids.size()];
          moveNode(editor, id, editor.skeleton()[id].position + Eigen::Vector3d::Constant(0.001));
        }
      });
    state.counters["MB"] = static_cast<double>(mallinfo2().uordblks - before) / 1e6;
  }
}
BENCHMARK(undoMemory)->Arg(1)->Arg(10)->Arg(100)->Iterations(1)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace espalier
