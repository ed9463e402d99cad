// Times what the user of a project waits for: that an edit is saved, and that a project opens. The
// file lies where TMPDIR says: the disk counts.
#include "core/project/content_hash.h"
#include "core/project/point_bytes.h"
#include "core/project/project.h"
#include "core/simulate/laser_scanner.h"
#include "core/simulate/plant_grower.h"

#include <benchmark/benchmark.h>

#include <unistd.h>
#include <vector>

namespace espalier {
namespace {

constexpr int nodes = 20'000;

/// Removes the folder of a benchmark with all that is in it.
struct Folder {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("espalier-bench-" + std::to_string(::getpid()));
  Folder() { std::filesystem::create_directories(path); }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
};

const Skeleton& plant() {
  static const Skeleton skeleton = growPlant({.segments = nodes}, 1);
  return skeleton;
}

/// A move of one node, then of the next ...
HistoryStep move(Skeleton& skeleton, std::size_t number) {
  SkeletonEditor editor(skeleton);
  const NodeId id{static_cast<std::uint32_t>(number % skeleton.size())};
  editor.setPosition(id, skeleton[id].position + Eigen::Vector3d(0.001, 0, 0));
  return {.text = "Move node", .author = "Anna", .time = 1, .delta = editor.commit()};
}

void saveAnEdit(benchmark::State& state) {
  const Folder folder;
  Skeleton skeleton = plant();
  Project project = Project::create(folder.path / "bench.espalier", {.skeleton = skeleton});
  std::size_t saved = 0;
  for (auto _ : state) {
    const HistoryStep step = move(skeleton, saved);
    project.record(saved, {&step, 1}, saved + 1);
    ++saved;
  }
}

/// With as many edits as the argument says.
void openProject(benchmark::State& state) {
  const Folder folder;
  const auto path = folder.path / "bench.espalier";
  {
    History history{.skeleton = plant()};
    for (std::size_t i = 0; i < static_cast<std::size_t>(state.range(0)); ++i)
      history.steps.push_back(move(history.skeleton, i));
    history.position = history.steps.size();
    Project project = Project::create(path, history);
    const PointCloud cloud(scan(plant(), {.points = 1'000'000}, 1).points);
    project.setBytes("points", bytesOf(cloud));
    state.counters["points"] = static_cast<double>(cloud.size());
    state.counters["nodes"] = static_cast<double>(history.skeleton.size());
  }
  for (auto _ : state) {
    const Project project = Project::open(path, Access::readWrite);
    benchmark::DoNotOptimize(project.history());
    benchmark::DoNotOptimize(cloudFrom(project.bytes("points")));
  }
}

/// One undone step that adds a plant of one axis, the deepest there is: opening tries it.
void openDeepPlant(benchmark::State& state) {
  const Folder folder;
  const auto path = folder.path / "bench.espalier";
  History history;
  SkeletonEditor editor(history.skeleton);
  std::optional<NodeId> last;
  for (int i = 0; i < nodes; ++i)
    last = editor.add({.position = Eigen::Vector3d(0, 0, i), .parent = last});
  history.steps.push_back({.text = "Reconstruct", .delta = editor.commit()});
  history.skeleton = {};
  (void)Project::create(path, history);
  for (auto _ : state)
    benchmark::DoNotOptimize(Project::open(path, Access::readWrite).history());
}

void hashContent(benchmark::State& state) {
  const std::string bytes(std::size_t{64} << 20, 'x');
  for (auto _ : state)
    benchmark::DoNotOptimize(contentHash(bytes));
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * bytes.size()));
}

BENCHMARK(openDeepPlant)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(hashContent)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(saveAnEdit)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(openProject)
    ->Arg(0)
    ->Arg(1000)
    ->Arg(100'000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

} // namespace
} // namespace espalier
