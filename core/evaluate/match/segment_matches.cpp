#include "core/evaluate/match/segment_matches.h"

#include <cassert>

namespace espalier {
namespace {

/// By segment: the nearest matched segment that it stands on, directly or not.
Partners matchedBelow(const std::vector<Segment>& segments, const Partners& partners) {
  Partners below(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) // parents come first
    if (const auto parent = segments[i].parent)
      below[i] = partners[*parent] ? parent : below[*parent];
  return below;
}

} // namespace

Partners inverse(const Partners& partners, std::size_t others) {
  Partners result(others);
  for (std::size_t i = 0; i < partners.size(); ++i)
    if (partners[i]) result[*partners[i]] = i;
  return result;
}

std::vector<bool> conserved(const std::vector<Segment>& resultSegments,
                            const std::vector<Segment>& referenceSegments,
                            const Partners& partners) {
  assert(partners.size() == resultSegments.size());
  const Partners resultBelow = matchedBelow(resultSegments, partners);
  const Partners referenceBelow =
      matchedBelow(referenceSegments, inverse(partners, referenceSegments.size()));
  std::vector<bool> result(partners.size(), false);
  for (std::size_t i = 0; i < partners.size(); ++i) {
    if (!partners[i]) continue;
    const auto below = resultBelow[i];
    result[i] = (below ? partners[*below] : std::nullopt) == referenceBelow[*partners[i]];
  }
  return result;
}

BoxTree boxTree(const std::vector<Segment>& segments) {
  std::vector<Eigen::AlignedBox3d> boxes;
  boxes.reserve(segments.size());
  for (const Segment& segment : segments)
    boxes.push_back(segment.box);
  return BoxTree(std::move(boxes));
}

double totalLength(const std::vector<Segment>& segments) {
  double sum = 0;
  for (const Segment& segment : segments)
    sum += segment.length;
  return sum;
}

} // namespace espalier
