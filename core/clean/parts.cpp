#include "core/clean/parts.h"

#include "core/graph/components.h"
#include "core/graph/find_root.h"

#include <algorithm>
#include <utility>

namespace espalier {

std::vector<bool> outsideParts(const Eigen::Matrix3Xf& points,
                               const std::optional<Eigen::Vector3f>& root,
                               const PartOptions& options, const Progress& progress) {
  constexpr int links = 6;
  const auto count = static_cast<std::size_t>(points.cols());
  std::vector<bool> isOutside(count, false);
  if (count == 0) return isOutside;
  const auto gap = static_cast<float>(options.widestGap);
  const NeighborhoodGraph graph = joined(NeighborhoodGraph(points, links, progress.part(0, 0.5)),
                                         points, gap, progress.part(0.5, 1));
  const Eigen::Index rooted = root ? nearestPoint(points, *root) : -1;
  std::vector<bool> isMet(count, false);
  std::vector<Eigen::Index> kept;
  for (Eigen::Index first = 0; first < points.cols(); ++first) {
    if (isMet[static_cast<std::size_t>(first)]) continue;
    std::vector<Eigen::Index> part = pointsLinkedTo(graph, first, gap, isMet);
    if (options.keep == KeptParts::large) {
      if (std::ssize(part) < options.leastPoints)
        for (const Eigen::Index point : part)
          isOutside[static_cast<std::size_t>(point)] = true;
      continue;
    }
    const bool isRooted = rooted >= 0 && options.keep == KeptParts::rooted;
    const bool isBetter =
        isRooted ? std::ranges::binary_search(part, rooted) : part.size() > kept.size();
    if (isBetter) kept = std::move(part);
  }
  if (options.keep == KeptParts::large) return isOutside;
  isOutside.assign(count, true);
  for (const Eigen::Index point : kept)
    isOutside[static_cast<std::size_t>(point)] = false;
  return isOutside;
}

} // namespace espalier
