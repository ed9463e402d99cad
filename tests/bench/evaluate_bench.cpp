// Times how a skeleton is measured against another: grown plants, one with each twentieth node
// gone.
#include "core/evaluate/authors_comparison.h"
#include "core/evaluate/edit_comparison.h"
#include "core/simulate/plant_grower.h"

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

} // namespace
} // namespace espalier
