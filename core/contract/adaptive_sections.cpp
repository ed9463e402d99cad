#include "core/contract/adaptive_sections.h"

#include "core/base/parallel.h"
#include "core/contract/circle_center.h"
#include "core/contract/density_radii.h"
#include "core/contract/section_grower.h"
#include "core/graph/orientations.h"

#include <oneapi/tbb/enumerable_thread_specific.h>

#include <vector>

namespace espalier {
Eigen::Matrix3Xf contractedToSections(const Eigen::Matrix3Xf& points,
                                      const AdaptiveSectionOptions& options,
                                      const Progress& progress) {
  if (points.cols() < 2) return points;
  const NeighborhoodGraph graph(points, options.neighbors, progress.part(0, 0.2));
  const std::vector<float> radii = densityRadii(graph,
                                                {.densityRadius = options.densityRadius,
                                                 .least = options.leastRadius,
                                                 .most = options.mostRadius,
                                                 .curve = options.curve,
                                                 .measure = options.densityMeasure,
                                                 .levels = options.densityLevels},
                                                progress.part(0.2, 0.3));
  const std::vector<Orientation> directions = orientations(
      points, graph, static_cast<float>(options.orientationRadius), progress.part(0.3, 0.6));

  Eigen::Matrix3Xf result(3, points.cols());
  oneapi::tbb::enumerable_thread_specific<SectionGrower> growers(
      [&] { return SectionGrower(points, graph); });
  const auto contract = [&](Eigen::Index i) {
    const auto center = static_cast<std::uint32_t>(i);
    const Eigen::Vector3f& direction = directions[center].direction;
    std::vector<Eigen::Vector3f> section;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const std::uint32_t point : growers.local().around(
             center, direction, static_cast<float>(options.width), radii[center])) {
      section.emplace_back(points.col(point));
      sum += section.back().cast<double>();
    }
    Eigen::Vector3d place = sum / static_cast<double>(section.size());
    if (options.fitsCircles && !direction.isZero())
      place = circleCenter(section, direction.cast<double>().normalized(),
                           static_cast<double>(radii[center]))
                  .value_or(place);
    result.col(i) = place.cast<float>();
  };
  parallelFor(points.cols(), contract, progress.part(0.6, 1), 32);
  return result;
}

} // namespace espalier
