// Times every kind of crown envelope, with its default options, on simulated scans of one broadleaf
// tree.
#include "core/pipeline/envelopes.h"
#include "core/pipeline/plant_scale.h"
#include "core/simulate/laser_scanner.h"
#include "core/simulate/plant_grower.h"

#include <benchmark/benchmark.h>

#include <map>

namespace espalier {
namespace {

const PointCloud& cloudOf(std::int64_t points) {
  static std::map<std::int64_t, PointCloud> all;
  PointCloud& cloud = all[points];
  if (cloud.isEmpty())
    cloud = PointCloud(scan(growPlant({.segments = 2000}, 1), {.points = points}, 1).points);
  return cloud;
}

void timeKind(benchmark::State& state, const EnvelopeKind& kind) {
  const PointCloud& cloud = cloudOf(state.range(0));
  const std::vector<double> values = envelopeValues(kind, {}, scaleOf(cloud, {}, UpAxis::z), 0);
  const Eigen::Matrix3Xd places = placesOf(cloud, {});
  for (auto _ : state)
    benchmark::DoNotOptimize(envelopeAbout(places, UpAxis::z, kind, values).volume);
  state.counters["points"] = static_cast<double>(cloud.size());
}

[[maybe_unused]] const bool areRegistered = [] {
  for (const EnvelopeKind& kind : envelopeKinds())
    benchmark::RegisterBenchmark(("envelope/" + kind.form.name).c_str(),
                                 [&kind](benchmark::State& state) { timeKind(state, kind); })
        ->Arg(100'000)
        ->Arg(1'000'000)
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
  return true;
}();

} // namespace
} // namespace espalier
