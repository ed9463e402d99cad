#include "core/radius/arc_coverage.h"

#include "core/base/circle_fit.h"
#include "core/base/parallel.h"

#include <optional>

namespace espalier {

std::vector<double> arcCoverages(const Skeleton& skeleton, const IndexedPoints& points,
                                 const Progress& progress) {
  std::vector<double> coverages(skeleton.idEnd(), 0);
  const std::vector<NodeId> ids = skeleton.ids();
  const CrossSections sections(skeleton, points);
  parallelFor(
      static_cast<Eigen::Index>(ids.size()),
      [&](Eigen::Index i) {
        const NodeId id = ids[static_cast<std::size_t>(i)];
        const std::optional<CrossSection> section = sections.at(id);
        if (!section || section->points.empty()) return;
        coverages[indexOf(id)] =
            judgedCircle(Eigen::Vector2d::Zero(), skeleton[id].radius, section->points).coverage;
      },
      progress, 16);
  return coverages;
}

} // namespace espalier
