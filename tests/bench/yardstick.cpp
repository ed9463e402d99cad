// Times and memory of the steps that PlantGL has, too, with the parameters that PlantScan3D gives
// them, on one real scan made denser: to be held against PlantGL run on the same machine, with
// the same parameters and the same points.
//
//   espalier_yardstick SCAN [POINTS ...]      without POINTS: 400000 and 1000000
//   espalier_yardstick SCAN --write OUT.xyz POINTS      the points, to be read by another program
//
// Times are the best of three runs (one, of what takes over 5 s), in seconds; "cpu" is the time of
// all threads. "MB" is what memory grew by at most during a run. Points come sorted along a curve,
// as on import; the first row is what sorting them costs where they were shuffled.
#include "core/base/random.h"
#include "core/cloud/point_cloud.h"
#include "core/graph/components.h"
#include "core/graph/geodesic.h"
#include "core/graph/neighborhoods.h"
#include "core/graph/orientations.h"
#include "core/io/formats.h"
#include "core/pipeline/pipeline.h"

#include <chrono>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <functional>
#include <initializer_list>
#include <malloc.h>
#include <memory>
#include <string>
#include <vector>

namespace espalier {
namespace {

/// The scan with points between neighbors added at random until there are `count`; in the order of
/// the scan, each new one behind the one it was made at.
RawPoints denser(const PointCloud& cloud, Eigen::Index count) {
  const Neighborhoods near = nearestNeighborhoods(cloud.positions(), 6);
  const double spacing = pointSpacing(cloud.positions());
  Random random(7);
  std::vector<std::vector<Eigen::Vector3d>> made(static_cast<std::size_t>(cloud.size()));
  for (Eigen::Index i = cloud.size(); i < count; ++i) {
    const auto at = static_cast<std::size_t>(random.below(made.size()));
    const auto others = near.of(static_cast<Eigen::Index>(at));
    const Eigen::Vector3d here =
        cloud.positions().col(static_cast<Eigen::Index>(at)).cast<double>();
    const Eigen::Vector3d there =
        cloud.positions().col(others[random.below(others.size())]).cast<double>();
    made[at].push_back(here + random.uniform() * (there - here) +
                       0.2 * spacing * random.uniform() * random.direction());
  }
  RawPoints raw;
  for (std::size_t i = 0; i < made.size(); ++i) {
    raw.positions.emplace_back(cloud.positions().col(static_cast<Eigen::Index>(i)).cast<double>());
    raw.positions.insert(raw.positions.end(), made[i].begin(), made[i].end());
  }
  return raw;
}

struct Cost {
  double wall = 0;      // [s]
  double cpu = 0;       // [s], of all threads
  double megabytes = 0; // that memory grew by at most
};

/// A line of what the kernel knows of this process, as VmHWM, the greatest memory so far.
double megabytesOf(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(key + ":")) return std::stod(line.substr(key.size() + 1)) / 1024;
  return 0;
}

Cost costOf(const std::function<void()>& work) {
  using Clock = std::chrono::steady_clock;
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5"; // forgets the greatest memory so far (man proc)
  const double before = megabytesOf("VmRSS");
  const auto start = Clock::now();
  const std::clock_t cpu = std::clock();
  work();
  return {std::chrono::duration<double>(Clock::now() - start).count(),
          static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC, megabytesOf("VmHWM") - before};
}

Cost bestOf(const std::function<void()>& work) {
  Cost best = costOf(work);
  for (int i = 1; i < 3 && best.wall < 5; ++i)
    if (const Cost cost = costOf(work); cost.wall < best.wall) best = cost;
  return best;
}

void print(const char* step, const char* parameters, const Cost& cost) {
  std::printf("  %-30s %8.2f %8.2f %7.0f  %s\n", step, cost.wall, cost.cpu, cost.megabytes,
              parameters);
  std::fflush(stdout);
}

/// A step of the pipeline with all that comes before it, which is none but what is set.
struct Row {
  const char* step;
  const char* last; // step of the pipeline that is run
  std::initializer_list<const char*> settings;
  const char* parameters;
};

const Row rows[] = {
    {"Euclidean contraction",
     "contract",
     {"contract.method=euclidean_ball", "contract.radius=0.01 heights"},
     "radius height/100"},
    {"geodesic contraction",
     "contract",
     {"contract.method=geodesic_centroid", "contract.neighbors=16", "contract.radius=0.01 heights",
      "contract.circles=false"},
     "k 16, radius height/100, means"},
    {"section contraction",
     "contract",
     {"contract.method=adaptive_sections", "contract.neighbors=16",
      "contract.density_radius=0.01 heights", "contract.least_radius=0.0157 heights",
      "contract.most_radius=0.0628 heights", "contract.orientation_radius=0.01 heights",
      "contract.width=2 spacings", "contract.circles=false"},
     "k 16, density and direction within height/100, radius pi height/200 to /50, width 2 "
     "spacings, means"},
    {"Xu, whole",
     "skeleton",
     {"contract.method=none", "skeleton.method=geodesic_bins", "skeleton.neighbors=20",
      "skeleton.bin_width=0.02 heights"},
     "k 20, bins of height/50"},
    {"graph colonization, whole",
     "skeleton",
     {"contract.method=none", "skeleton.method=graph_colonization", "skeleton.neighbors=20",
      "skeleton.least_step=0.005 heights", "skeleton.greatest_step=0.02 heights"},
     "k 20, steps of height/200 to /50"},
    {"space colonization",
     "skeleton",
     {"contract.method=none", "skeleton.method=space_colonization", "skeleton.thick_wood=0",
      "skeleton.least_step=0.02 heights", "skeleton.greatest_step=0.02 heights",
      "skeleton.reach=2.5", "skeleton.kill=0.9"},
     "steps of height/50, reach 2.5, kill 0.9, about the new node"},
    {"Livny, whole",
     "skeleton",
     {"contract.method=none", "skeleton.method=branch_structure", "skeleton.neighbors=7",
      "skeleton.rounds=3", "skeleton.radius_share=0.1", "skeleton.least_edge=0.15",
      "skeleton.overlap=0.5", "skeleton.thick_wood=0"},
     "k 7, 3 rounds, radius share 0.1, least edge 0.15, overlap 0.5"},
    {"default, whole", "", {}, "as without options, cleaning and radii too"},
};

void measureRow(const std::shared_ptr<const PointCloud>& cloud, const Row& row) {
  try {
    PipelineOptions options;
    if (row.settings.size() > 0) options.set("clean.method=none");
    for (const char* setting : row.settings)
      options.set(setting);
    print(row.step, row.parameters,
          bestOf([&] { (void)Pipeline().run(cloud, options, {}, row.last); }));
  } catch (const std::exception& problem) {
    std::printf("  %-30s %s\n", row.step, problem.what());
  }
}

/// The points as if they had been scanned in no order.
RawPoints shuffled(RawPoints raw) {
  Random random(3);
  for (std::size_t i = raw.positions.size(); i > 1; --i)
    std::swap(raw.positions[i - 1], raw.positions[random.below(i)]);
  return raw;
}

void measure(const PointCloud& scan, Eigen::Index count) {
  const RawPoints raw = denser(scan, count);
  std::printf("%td points\n", static_cast<std::ptrdiff_t>(raw.positions.size()));
  const auto cloud = std::make_shared<const PointCloud>(raw);
  const Eigen::Matrix3Xf& points = cloud->positions();
  const RawPoints unsorted = shuffled(raw);
  print("sorting shuffled points", "on import", bestOf([&] { (void)PointCloud(unsorted); }));

  print("k nearest", "k 20", bestOf([&] { (void)nearestNeighborhoods(points, 20); }));
  print("graph", "k 16", bestOf([&] { (void)NeighborhoodGraph(points, 16); }));
  const NeighborhoodGraph graph(points, 16);
  print("joining components", "k 16", bestOf([&] { (void)joined(graph, points); }));
  const NeighborhoodGraph whole = joined(graph, points);
  print("orientation", "of the linked points, k 16",
        bestOf([&] { (void)orientations(points, whole, 0); }));
  print("shortest paths", "k 16, from the root",
        bestOf([&] { (void)geodesics(whole, {findRoot(points)}); }));
  for (const Row& row : rows)
    measureRow(cloud, row);
}

void write(const PointCloud& scan, const char* file, Eigen::Index count) {
  std::ofstream out(file);
  out.precision(12);
  for (const Eigen::Vector3d& place : denser(scan, count).positions)
    out << place.x() << ' ' << place.y() << ' ' << place.z() << '\n';
}

} // namespace
} // namespace espalier

int main(int argc, char** argv) {
  using namespace espalier;
  if (argc < 2) {
    std::fprintf(stderr, "usage: espalier_yardstick SCAN [--write OUT.xyz] [POINTS ...]\n");
    return 2;
  }
  try {
    const PointCloud scan = readPoints(argv[1]).value;
    if (argc == 5 && std::string(argv[2]) == "--write") {
      write(scan, argv[3], std::stol(argv[4]));
      return 0;
    }
    std::vector<Eigen::Index> counts;
    for (int i = 2; i < argc; ++i)
      counts.push_back(std::stol(argv[i]));
    if (counts.empty()) counts = {400'000, 1'000'000};
    std::printf("  %-30s %8s %8s %7s  %s\n", "", "wall", "cpu", "MB", "parameters");
    for (const Eigen::Index count : counts)
      measure(scan, count);
    return 0;
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "%s\n", problem.what());
    return 1;
  }
}
