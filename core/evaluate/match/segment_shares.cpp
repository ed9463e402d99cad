#include "core/evaluate/match/segment_shares.h"

#include "core/evaluate/match/authors_comparison.h"
#include "core/evaluate/match/capped_scores.h"
#include "core/evaluate/match/comparable.h"
#include "core/evaluate/match/even_samples.h"
#include "core/evaluate/match/tolerance_curve.h"
#include "core/skeleton/edge_index.h"

#include <vector>

namespace espalier {
namespace {

/// Adds to the shares of the segments.
class Ledger {
public:
  explicit Ledger(std::size_t segments)
      : shares_(SegmentShares::Zero(shareCount, static_cast<Eigen::Index>(segments))) {}
  void add(Share share, std::size_t segment, double amount) {
    shares_(static_cast<Eigen::Index>(share), static_cast<Eigen::Index>(segment)) += amount;
  }
  [[nodiscard]] const SegmentShares& shares() const { return shares_; }

private:
  SegmentShares shares_;
};

/// By id: the segment of a node.
std::vector<std::size_t> segmentOfEach(const Skeleton& skeleton,
                                       const std::vector<Segment>& segments) {
  std::vector<std::size_t> segmentOf(skeleton.idEnd(), 0);
  for (std::size_t i = 0; i < segments.size(); ++i)
    for (const NodeId id : segments[i].nodes)
      segmentOf[indexOf(id)] = i;
  return segmentOf;
}

Eigen::Vector3d middleOf(const Segment& segment) {
  double left = segment.length / 2;
  for (std::size_t i = 1; i < segment.polyline.size(); ++i) {
    const Eigen::Vector3d edge = segment.polyline[i] - segment.polyline[i - 1];
    if (edge.norm() >= left && edge.norm() > 0)
      return segment.polyline[i - 1] + left / edge.norm() * edge;
    left -= edge.norm();
  }
  return segment.polyline.back();
}

void addAuthors(Ledger& ledger, const AuthorsComparison& authors, const EdgeIndex& reference,
                const std::vector<std::size_t>& segmentOf) {
  Partners partners(authors.resultSegments.size());
  for (std::size_t i = 0; i < authors.referenceSegments.size(); ++i) {
    ledger.add(Share::referenceLength, i, authors.referenceSegments[i].length);
    ledger.add(Share::segments, i, 1);
  }
  for (const AuthorsComparison::Match& match : authors.matches) {
    partners[match.result] = match.reference;
    ledger.add(Share::matchedResult, match.reference, authors.resultSegments[match.result].length);
    ledger.add(Share::matchedReference, match.reference,
               authors.referenceSegments[match.reference].length);
    ledger.add(Share::matches, match.reference, 1);
    ledger.add(Share::conserved, match.reference, match.isConserved ? 1 : 0);
  }
  for (std::size_t i = 0; i < partners.size(); ++i) {
    const Segment& segment = authors.resultSegments[i];
    const std::size_t owner =
        partners[i] ? *partners[i] : segmentOf[indexOf(reference.nearest(middleOf(segment))->node)];
    ledger.add(Share::resultLength, owner, segment.length);
  }
}

void addCapped(Ledger& ledger, const CappedScore& capped, const AuthorsComparison& segments) {
  for (std::size_t i = 0; i < capped.partners.size(); ++i) {
    if (!capped.partners[i]) continue;
    const std::size_t partner = *capped.partners[i];
    ledger.add(Share::cappedResult, partner, segments.resultSegments[i].length);
    ledger.add(Share::cappedReference, partner, segments.referenceSegments[partner].length);
    ledger.add(Share::cappedConserved, partner, capped.isConserved[i] ? 1 : 0);
  }
}

} // namespace

SegmentShares segmentShares(const Skeleton& result, const Skeleton& reference, double distance,
                            double step, const Progress& progress) {
  const AuthorsComparison authors = authorsComparison(result, reference, {}, progress.part(0, 0.2));
  const std::vector<std::size_t> segmentOf = segmentOfEach(reference, authors.referenceSegments);
  const EdgeIndex index(reference);
  Ledger ledger(authors.referenceSegments.size());
  addAuthors(ledger, authors, index, segmentOf);
  addCapped(ledger,
            cappedScores(result, reference, {.distances = {distance}, .step = step},
                         progress.part(0.2, 0.4))
                .front(),
            authors);

  const std::vector<EvenSample> found = evenSamples(result, step);
  const double foundLength = totalLength(result) / static_cast<double>(found.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (i % 1024 == 0)
      progress.update(0.4 + 0.3 * static_cast<double>(i) / static_cast<double>(found.size()));
    const NearestPlace place = *index.nearest(found[i].position);
    const std::size_t segment = segmentOf[indexOf(place.node)];
    ledger.add(Share::allResult, segment, foundLength);
    if (place.distance <= distance) ledger.add(Share::nearResult, segment, foundLength);
  }
  const std::vector<EvenSample> truth = evenSamples(reference, step);
  const double trueLength = totalLength(reference) / static_cast<double>(truth.size());
  const std::vector<double> distances =
      distancesTo(EdgeIndex(result), truth, progress.part(0.7, 1));
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const std::size_t segment = segmentOf[indexOf(truth[i].node)];
    ledger.add(Share::allReference, segment, trueLength);
    if (distances[i] <= distance) ledger.add(Share::nearReference, segment, trueLength);
  }
  return ledger.shares();
}

} // namespace espalier
