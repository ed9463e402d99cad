#include "core/simulate/laser_scanner.h"
#include "core/simulate/plant_grower.h"
#include "python/bindings.h"
#include "python/held.h"
#include "python/job.h"
#include "python/words.h"

#include <pybind11/stl.h>

#include <optional>
#include <utility>

namespace espalier::python {
namespace {

std::pair<HeldScan, HeldSkeleton> simulate(std::uint64_t seed, const std::string& architecture,
                                           double height, int segments, Eigen::Index points,
                                           int stations, const std::optional<double>& noise,
                                           double foliage, int threads, const py::object& report) {
  const GrowthOptions growth{
      .architecture = architectureIn(architecture), .height = height, .segments = segments};
  ScannerOptions scanner{.points = points, .stations = stations};
  if (noise) scanner.rangeNoise = *noise;
  scanner.foliage = foliageOf(growth.architecture, foliage);
  return resultOf(report, threads, [&](const Progress& progress) {
    auto truth =
        std::make_shared<const Skeleton>(growPlant(growth, seed, progress.part(0, 0.3, "Grow")));
    SimulatedScan scanned = scan(*truth, scanner, seed, progress.part(0.3, 0.95, "Scan"));
    auto cloud = std::make_shared<const PointCloud>(std::move(scanned.points),
                                                    progress.part(0.95, 1, "Sort"));
    return std::pair(HeldScan{std::move(cloud), {}}, HeldSkeleton{.skeleton = std::move(truth)});
  });
}

} // namespace

void bindSimulate(py::module_& module) {
  const GrowthOptions growth;
  const ScannerOptions scanner;
  module.def(
      "simulate", &simulate, py::arg("seed") = 1, py::kw_only(),
      py::arg("architecture") = "broadleaf", py::arg("height") = growth.height,
      py::arg("segments") = growth.segments, py::arg("points") = scanner.points,
      py::arg("stations") = scanner.stations, py::arg("noise") = py::none(),
      py::arg("foliage") = 0.0, py::arg("threads") = 0, py::arg("progress") = py::none(),
      documented(
          "simulate(seed=1, *, architecture='broadleaf', height=4.0, segments=800, "
          "points=100000, stations=4, noise=None, foliage=0.0, threads=0, progress=None)",
          "A scan of a plant that was grown, and the plant: the same as `espalier simulate`\n"
          "makes of this seed.\n\n"
          "architecture: broadleaf, conifer, shrub or herb. height: in any unit. segments:\n"
          "unbranched chains at least. points: wanted, of all stations together. noise:\n"
          "standard deviation of the range; None: extent / 2500. foliage: 1 as the kind of\n"
          "plant bears it. threads and progress: as of reconstruct().")
          .c_str());
}

} // namespace espalier::python
