#include "core/doubt/expected_agreement.h"

#include "core/skeleton/length_along.h"

#include <algorithm>

namespace espalier {
namespace {

/// Of the wood that a doubt is about, how much is probably wrong [L].
double wrongIn(const Doubt& doubt, const Skeleton& skeleton, const ErrorRatings& ratings) {
  double wrong = 0;
  for (const NodeId id : doubt.nodes)
    wrong += ratings.ofEdges[indexOf(id)] * edgeLength(skeleton, id);
  return wrong;
}

double missedBy(const Doubt& doubt) { // [L]
  return doubt.kind == Doubt::Kind::missing ? doubt.wrong() * doubt.length : 0;
}

} // namespace

ExpectedAgreement expectedAgreement(const Skeleton& skeleton, const ErrorRatings& ratings,
                                    const std::vector<Doubt>& doubts) {
  ExpectedAgreement expected;
  for (const NodeId id : skeleton.ids()) {
    const bool isSure = skeleton[id].review.state == ReviewState::reviewed;
    const double odds = isSure ? 0 : ratings.ofEdges[indexOf(id)];
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
  for (std::size_t i = 0; i < doubts.size(); ++i) {
    if (expected.share() >= goal) return i;
    const double wrong = std::min(wrongIn(doubts[i], skeleton, ratings), expected.wrong);
    expected.wrong -= wrong;
    expected.right += wrong + missedBy(doubts[i]);
    expected.missed = std::max(0.0, expected.missed - missedBy(doubts[i]));
  }
  return expected.share() >= goal ? doubts.size() : doubts.size() + 1;
}

} // namespace espalier
