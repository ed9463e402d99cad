#include "core/doubt/expected_agreement.h"

#include "core/skeleton/length_along.h"

#include <algorithm>

namespace espalier {
namespace {

bool isReviewed(const Skeleton& skeleton, NodeId id) {
  return skeleton[id].review.state == ReviewState::reviewed;
}

double missedBy(const Doubt& doubt) { // [L]
  return doubt.kind == Doubt::Kind::missing ? doubt.wrong() * doubt.length : 0;
}

} // namespace

ExpectedAgreement expectedAgreement(const Skeleton& skeleton, const ErrorRatings& ratings,
                                    const std::vector<Doubt>& doubts) {
  ExpectedAgreement expected;
  for (const NodeId id : skeleton.ids()) {
    const double odds = isReviewed(skeleton, id) ? 0 : ratings.ofEdges[indexOf(id)];
    const double length = edgeLength(skeleton, id);
    expected.right += (1 - odds) * length;
    expected.wrong += odds * length;
  }
  for (const Doubt& doubt : doubts)
    expected.missed += missedBy(doubt);
  return expected;
}

std::size_t answersFor(double goal, const Skeleton& skeleton, const ErrorRatings& ratings,
                       const std::vector<Doubt>& doubts) {
  ExpectedAgreement expected = expectedAgreement(skeleton, ratings, doubts);
  std::vector<bool> isSure(skeleton.idEnd(), false); // reviewed, or answered by those before
  for (const NodeId id : skeleton.ids())
    isSure[indexOf(id)] = isReviewed(skeleton, id);
  for (std::size_t i = 0; i < doubts.size(); ++i) {
    if (expected.share() >= goal) return i;
    double wrong = 0;
    for (const NodeId id : doubts[i].nodes) {
      if (isSure[indexOf(id)]) continue;
      isSure[indexOf(id)] = true;
      wrong += ratings.ofEdges[indexOf(id)] * edgeLength(skeleton, id);
    }
    wrong = std::min(wrong, expected.wrong);
    expected.wrong -= wrong;
    expected.right += wrong + missedBy(doubts[i]);
    expected.missed = std::max(0.0, expected.missed - missedBy(doubts[i]));
  }
  return expected.share() >= goal ? doubts.size() : doubts.size() + 1;
}

} // namespace espalier
