#include "core/reconstruct/join_gaps.h"

#include <vector>

namespace espalier {

Skeleton withJoinedGaps(const Skeleton& skeleton, const GapOptions& options,
                        const Progress& progress) {
  const Gaps gaps = gapsIn(skeleton, options, progress);
  std::vector<double> costs;
  for (const GapLink& link : gaps.links)
    costs.push_back(link.evidence.cost);
  LinkedFragments result = linkedBy(skeleton, gaps, costs);
  progress.update(1);
  return std::move(result.skeleton);
}

} // namespace espalier
