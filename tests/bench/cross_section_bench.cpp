// Times what one waits for at a node's cross-section: on a simulated scan of one broadleaf tree of
// 100 k points, and on the shared puu1 with its expert's structure, where that is at hand.
#include "core/io/formats.h"
#include "core/pipeline/pipeline.h"
#include "core/radius/section_circle.h"
#include "core/simulate/laser_scanner.h"
#include "core/simulate/plant_grower.h"
#include "tests/support/shared_data.h"

#include <benchmark/benchmark.h>

#include <memory>
#include <utility>

namespace espalier {
namespace {

/// A scan, what finds its points, and a skeleton over it.
struct Plant {
  PointCloud cloud;
  Skeleton skeleton;
  SpatialIndex index{cloud.positions()};
  double spacing = pointSpacing(cloud.positions());
  std::vector<NodeId> ids = skeleton.ids();

  Plant(PointCloud scan, Skeleton over) : cloud(std::move(scan)), skeleton(std::move(over)) {}
  Plant(const Plant&) = delete;
  Plant& operator=(const Plant&) = delete;
  ~Plant() = default;

  [[nodiscard]] IndexedPoints points() const {
    return {cloud.positions(), cloud.origin(), index, spacing};
  }
};

const Plant* simulated() {
  static const Plant plant = [] {
    RawPoints raw = scan(growPlant({.segments = 2000}, 1), {.points = 100'000}, 1).points;
    Skeleton skeleton = *Pipeline().run(std::make_shared<const PointCloud>(raw)).skeleton;
    return Plant(PointCloud(std::move(raw)), std::move(skeleton));
  }();
  return &plant;
}

/// Null where it is not at hand.
const Plant* puu1() {
  static const std::unique_ptr<const Plant> plant = []() -> std::unique_ptr<const Plant> {
    const auto points = test::sharedFile("puu1/scan.ply");
    const auto expert = test::sharedFile("puu1/expert.mtg");
    if (!points || !expert) return nullptr;
    return std::make_unique<const Plant>(readPoints(*points).value,
                                         readStructure(*expert).value.skeleton);
  }();
  return plant.get();
}

using Which = const Plant* (*)();

/// Times `act(plant, node)`, over all nodes in turn.
template <class Act> void timeNodes(benchmark::State& state, Which which, const Act& act) {
  const Plant* plant = which();
  if (plant == nullptr) {
    state.SkipWithError("shared data not found: puu1");
    return;
  }
  std::size_t next = 0;
  for (auto _ : state) {
    auto result = act(*plant, plant->ids[next++ % plant->ids.size()]);
    benchmark::DoNotOptimize(result);
  }
  state.counters["nodes"] = static_cast<double>(plant->ids.size());
}

/// As when a node is selected: everything anew but the index of the points.
void sectionAnew(benchmark::State& state, Which which) {
  timeNodes(state, which, [](const Plant& plant, NodeId id) {
    return CrossSections(plant.skeleton, plant.points()).at(id);
  });
}

/// The same with the circle, which is shown at once.
void sectionAndCircleAnew(benchmark::State& state, Which which) {
  timeNodes(state, which, [](const Plant& plant, NodeId id) {
    const auto section = CrossSections(plant.skeleton, plant.points()).at(id);
    return section ? measuredCircle(*section, RadiusMeasure::circle) : NoRadius::noSection;
  });
}

/// All nodes, as when all are selected.
void allCircles(benchmark::State& state, Which which) {
  const Plant* plant = which();
  if (plant == nullptr) {
    state.SkipWithError("shared data not found: puu1");
    return;
  }
  double refused = 0;
  for (auto _ : state) {
    const CrossSections sections(plant->skeleton, plant->points());
    const SectionRadii radii = sectionRadii(sections, plant->ids, RadiusMeasure::circle);
    refused = static_cast<double>(plant->ids.size() - radii.radii.size());
  }
  state.counters["nodes"] = static_cast<double>(plant->ids.size());
  state.counters["refused"] = refused;
}

BENCHMARK_CAPTURE(sectionAnew, simulated, simulated)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(sectionAnew, puu1, puu1)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(sectionAndCircleAnew, simulated, simulated)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(sectionAndCircleAnew, puu1, puu1)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(allCircles, simulated, simulated)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(allCircles, puu1, puu1)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace espalier
