// Times the table of nodes and a walk through the history, for a plant of 20 000 nodes.
#include "core/simulate/plant_grower.h"
#include "ui/document/plant_document.h"
#include "ui/panels/node_table_model.h"

#include <benchmark/benchmark.h>

namespace espalier {
namespace {

const Skeleton& plant() {
  static const Skeleton skeleton = // which has about 20 000 nodes
      growPlant({.segments = 3'000}, 1);
  return skeleton;
}

void openNodeTable(benchmark::State& state) {
  PlantDocument document;
  document.openSkeleton(plant(), "plant.mtg");
  for (auto round : state) {
    NodeTableModel model(document);
    model.update();
    benchmark::DoNotOptimize(model.rowCount());
  }
  state.counters["nodes"] = static_cast<double>(plant().size());
}
BENCHMARK(openNodeTable)->Unit(benchmark::kMillisecond);

void sortNodeTable(benchmark::State& state) {
  PlantDocument document;
  document.openSkeleton(plant(), "plant.mtg");
  NodeTableModel model(document);
  model.update();
  bool isUp = false;
  for (auto round : state)
    model.sort(static_cast<int>(NodeColumn::length),
               (isUp = !isUp) ? Qt::AscendingOrder : Qt::DescendingOrder);
}
BENCHMARK(sortNodeTable)->Unit(benchmark::kMillisecond);

void filterNodeTable(benchmark::State& state) {
  PlantDocument document;
  document.openSkeleton(plant(), "plant.mtg");
  NodeTableModel model(document);
  model.update();
  bool isFirst = false;
  for (auto round : state)
    model.setFilter(NodeFilter((isFirst = !isFirst) ? "length > 0.01 and order = 2" : "to do"));
}
BENCHMARK(filterNodeTable)->Unit(benchmark::kMillisecond);

/// Back by 1 000 steps, and forth again.
void goThroughHistory(benchmark::State& state) {
  PlantDocument document;
  document.openSkeleton(plant(), "plant.mtg");
  const std::vector<NodeId> ids = plant().ids();
  for (int i = 1; i <= 1000; ++i)
    document.edit("Radius", [&](SkeletonEditor& editor) {
      editor.setRadius(ids[static_cast<std::size_t>(i)], i);
    });
  for (auto round : state) {
    document.goTo(0);
    document.goTo(1000);
  }
}
BENCHMARK(goThroughHistory)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace espalier
