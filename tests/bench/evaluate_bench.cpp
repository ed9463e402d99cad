// Times how a skeleton is measured against another: grown plants, one with each twentieth node
// gone.
#include "core/evaluate/comparison.h"
#include "core/evaluate/light/light_interception.h"
#include "core/evaluate/match/authors_comparison.h"
#include "core/evaluate/match/edit_comparison.h"
#include "core/evaluate/registration/registration.h"
#include "core/io/formats.h"
#include "core/simulate/plant_grower.h"
#include "core/surface/generalized_cylinders.h"
#include "tests/support/shared_data.h"

#include <benchmark/benchmark.h>

namespace espalier {
namespace {

struct Pair {
  Skeleton result;
  Skeleton reference;
};

Pair pairOf(int segments) {
  Pair pair{.result = growPlant({.segments = segments}, 1), .reference = {}};
  pair.reference = pair.result;
  std::size_t count = 0;
  for (const NodeId id : pair.reference.ids()) // tips only: all else keeps what it carries
    if (pair.result.children(id).empty() && ++count % 5 == 0) pair.result.erase(id);
  return pair;
}

void editDistances(benchmark::State& state, EditCost cost, bool merges) {
  const Pair pair = pairOf(static_cast<int>(state.range(0)));
  EditComparison found;
  for (auto round : state) {
    found = editComparison(pair.result, pair.reference, {.cost = cost, .mergesPaths = merges});
    benchmark::DoNotOptimize(found);
  }
  state.counters["pairs"] = static_cast<double>(found.result.size() * found.reference.size());
}
BENCHMARK_CAPTURE(editDistances, topology, EditCost::topology, false)
    ->Arg(500)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(editDistances, shape, EditCost::shape, false)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(editDistances, shape_merged, EditCost::shape, true)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond);

void authorsIndices(benchmark::State& state) {
  const Pair pair = pairOf(static_cast<int>(state.range(0)));
  for (auto round : state)
    benchmark::DoNotOptimize(authorsComparison(pair.result, pair.reference));
}
BENCHMARK(authorsIndices)->Arg(1000)->Arg(4000)->Unit(benchmark::kMillisecond);

/// All that `evaluate` reports: to be under 15 s and 2 GB for 20 000 segments a side.
void wholeComparisons(benchmark::State& state) {
  const Pair pair = pairOf(static_cast<int>(state.range(0)));
  std::size_t segments = 0;
  for (auto round : state) {
    const Comparison comparison = compare(pair.result, pair.reference);
    segments = comparison.authors.referenceSegments.size();
    benchmark::DoNotOptimize(comparison);
  }
  state.counters["segments"] = static_cast<double>(segments);
}
BENCHMARK(wholeComparisons)->Arg(1000)->Arg(20000)->Unit(benchmark::kMillisecond);

/// The pine of the thesis against the expert's: to be under a second.
void pineComparisons(benchmark::State& state) {
  const auto automatic = test::sharedFile("puu1/thesis_automatic.mtg");
  const auto expert = test::sharedFile("puu1/expert.mtg");
  if (!automatic || !expert) return state.SkipWithError("shared data not found");
  const Skeleton result = readStructure(*automatic).value.skeleton;
  const Skeleton reference = readStructure(*expert).value.skeleton;
  for (auto round : state)
    benchmark::DoNotOptimize(compare(result, reference));
}
BENCHMARK(pineComparisons)->Unit(benchmark::kMillisecond);

/// The same pine, the reference turned by 130 degrees and tilted by 5: a turn costs under a second
/// more of the processor than a shift.
void pineRegistrations(benchmark::State& state, bool turns) {
  const auto automatic = test::sharedFile("puu1/thesis_automatic.mtg");
  const auto expert = test::sharedFile("puu1/expert.mtg");
  if (!automatic || !expert) return state.SkipWithError("shared data not found");
  const Skeleton result = readStructure(*automatic).value.skeleton;
  const Eigen::Isometry3d turn(Eigen::AngleAxisd(2.27, Eigen::Vector3d::UnitZ()) *
                               Eigen::AngleAxisd(0.087, Eigen::Vector3d::UnitX()));
  const Skeleton reference = moved(readStructure(*expert).value.skeleton, turn);
  Registration found;
  for (auto round : state)
    benchmark::DoNotOptimize(found = registration(result, reference, {.turns = turns}));
  state.counters["residual_share"] = found.residualAfter / found.reach;
}
BENCHMARK_CAPTURE(pineRegistrations, shift, false)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(pineRegistrations, turn, true)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();

/// Registration of large grown plants.
void registrations(benchmark::State& state) {
  const Pair pair = pairOf(static_cast<int>(state.range(0)));
  const Eigen::Isometry3d turn(Eigen::AngleAxisd(1.2, Eigen::Vector3d::UnitZ()));
  const Skeleton reference = moved(pair.reference, turn);
  for (auto round : state)
    benchmark::DoNotOptimize(registration(pair.result, reference));
}
BENCHMARK(registrations)
    ->Arg(1000)
    ->Arg(20000)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();

/// Light over 46 directions at four resolutions: to be under 3 s for 500 000 triangles.
void light(benchmark::State& state) {
  const Skeleton plant = growPlant({.segments = static_cast<int>(state.range(0))}, 1);
  const SurfaceMesh mesh = surfaceByGeneralizedCylinders(plant);
  for (auto round : state)
    benchmark::DoNotOptimize(lightInterception(mesh));
  state.counters["triangles"] = static_cast<double>(mesh.triangles.size());
}
BENCHMARK(light)->Arg(1000)->Arg(2200)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace espalier
