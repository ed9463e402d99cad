#include "core/base/shown.h"
#include "core/evaluate/compared_plants.h"
#include "core/evaluate/score_table.h"

#include <algorithm>
#include <functional>

namespace espalier {
namespace {

using Plants = ComparedPlants&;
using Unit = ScoreUnit;
using Value = std::optional<double>;

double ratio(double part, double whole) {
  return whole > 0 ? std::min(1.0, part / whole) : 0; // the sums round differently
}

double of(const ShareSums& sums, Share share) {
  return sums(static_cast<Eigen::Index>(share));
}

double lengthShare(const ShareSums& sums, Share result, Share reference) {
  return ratio(of(sums, result) + of(sums, reference),
               of(sums, Share::resultLength) + of(sums, Share::referenceLength));
}

double precisionOf(const ShareSums& sums) {
  return ratio(of(sums, Share::nearResult), of(sums, Share::allResult));
}

double recallOf(const ShareSums& sums) {
  return ratio(of(sums, Share::nearReference), of(sums, Share::allReference));
}

/// A score of what lies within the distance.
template <class Member> auto near(Member member) {
  return [member](Plants plants) -> Value {
    const ToleranceScore* score = plants.near();
    return score != nullptr ? Value(std::invoke(member, *score)) : Value();
  };
}

Score distanceScore(const char* key, const char* symbol, const char* help,
                    DistanceSummary ToleranceCurve::*side, double DistanceSummary::*member) {
  const bool isShare = member == &DistanceSummary::farShare;
  return {.key = key,
          .label = symbol,
          .help = help,
          .measure = measureOf("Distances"),
          .unit = isShare ? Unit::share : Unit::length,
          .better = Better::less,
          .uses = member == &DistanceSummary::farMean ? inWindow | inStudies : inWindow,
          .compute = [side, member](Plants plants) -> Value {
            return plants.tolerance().*side.*member;
          }};
}

} // namespace

std::vector<Score> segmentScores() {
  const Measure* authors = measureOf("G, T and mapping");
  const Measure* more = measureOf("Capped, over all, one to many");
  return {
      {.key = "mapping",
       .label = Shown::tr("mapping"),
       .help = Shown::tr("Share of the segments of both that are matched (authors)"),
       .measure = authors,
       .uses = inWindow | inStudies | inReport,
       .compute = [](Plants plants) -> Value { return plants.authors().mapping; }},
      {.key = "geometric",
       .label = Shown::tr("geometric index G"),
       .symbol = Shown::tr("G"),
       .help = Shown::tr("Share of the length of both that is matched (authors)"),
       .measure = authors,
       .uses =
           inWindow | inStudies | inReport | inNoiseText | inRankingText | inBrief | inKeyNumbers,
       .compute = [](Plants plants) -> Value { return plants.authors().geometric; },
       .ofShares =
           [](const ShareSums& sums) {
             return lengthShare(sums, Share::matchedResult, Share::matchedReference);
           }},
      {.key = "structural",
       .label = Shown::tr("structural index T"),
       .symbol = Shown::tr("T"),
       .help = Shown::tr("Share of the matches whose nearest matched segments below are "
                         "matched to each other (authors)"),
       .measure = authors,
       .uses = inWindow | inStudies | inReport | inNoiseText | inBrief | inKeyNumbers | onCards,
       .compute = [](Plants plants) -> Value { return plants.authors().structural; },
       .ofShares =
           [](const ShareSums& sums) {
             return ratio(of(sums, Share::conserved), of(sums, Share::matches));
           }},
      {.key = "structural_of_all",
       .label = Shown::tr("T over all segments of the reference"),
       .symbol = Shown::tr("T of all"),
       .help = Shown::tr("The same as a share of all segments of the reference"),
       .measure = more,
       .uses = inWindow | inStudies | inReport | inNoiseText | inRankingText | inBrief | onCards,
       .compute = [](Plants plants) -> Value { return plants.authors().structuralOfAll; },
       .ofShares =
           [](const ShareSums& sums) {
             return ratio(of(sums, Share::conserved), of(sums, Share::segments));
           }},
      {.key = "one_to_many",
       .label = Shown::tr("G, one to many"),
       .help = Shown::tr(
           "The same as G, where a branch may match all the pieces that spurs cut it into"),
       .measure = more,
       .uses = inStudies | inReport,
       .compute = [](Plants plants) -> Value { return plants.paths().geometric; }}};
}

std::vector<Score> cappedSegmentScores() {
  const Measure* more = measureOf("Capped, over all, one to many");
  return {
      {.key = "capped_geometric",
       .label = Shown::tr("capped G"),
       .help = Shown::tr("The same as G, matched only where they lie within the tolerance"),
       .measure = more,
       .uses = inWindow | inStudies | inNoiseText | inRankingText,
       .compute = [](Plants plants) -> Value {
         const CappedScore* capped = plants.capped();
         return capped != nullptr ? Value(capped->geometric) : Value();
       },
       .takesDistance = true,
       .ofShares =
           [](const ShareSums& sums) {
             return lengthShare(sums, Share::cappedResult, Share::cappedReference);
           }},
      {.key = "capped_structural",
       .label = Shown::tr("capped T"),
       .help = Shown::tr("The same as T of all, matched only where they lie within the tolerance"),
       .measure = more,
       .uses = inStudies,
       .compute = [](Plants plants) -> Value {
         const CappedScore* capped = plants.capped();
         return capped != nullptr ? Value(capped->structuralOfAll) : Value();
       },
       .takesDistance = true,
       .ofShares =
           [](const ShareSums& sums) {
             return ratio(of(sums, Share::cappedConserved), of(sums, Share::segments));
           }}};
}

std::vector<Score> nearnessScores() {
  const Measure* nearness = measureOf("Precision, recall, F");
  return {{.key = "precision",
           .label = Shown::tr("precision"),
           .help = Shown::tr("Share of the plant's length near the reference"),
           .measure = nearness,
           .uses = inWindow | inStudies | inKeyNumbers,
           .compute = near(&ToleranceScore::precision),
           .takesDistance = true,
           .ofShares = precisionOf},
          {.key = "recall",
           .label = Shown::tr("recall"),
           .help = Shown::tr("Share of the reference's length near the plant"),
           .measure = nearness,
           .uses = inWindow | inStudies | inKeyNumbers,
           .compute = near(&ToleranceScore::recall),
           .takesDistance = true,
           .ofShares = recallOf},
          {.key = "f",
           .label = Shown::tr("F"),
           .help = Shown::tr("Harmonic mean of precision and recall"),
           .measure = nearness,
           .uses = inWindow | inStudies | inNoiseText | inRankingText | inBrief | inKeyNumbers |
                   onCards,
           .compute = near(&ToleranceScore::f),
           .takesDistance = true,
           .ofShares = [](const ShareSums& sums) {
             return harmonicMean(precisionOf(sums), recallOf(sums));
           }}};
}

std::vector<Score> distanceScores() {
  using Curve = ToleranceCurve;
  using Summary = DistanceSummary;
  return {distanceScore("to_reference", Shown::tr("to the reference"),
                        Shown::tr("Mean distance from the plant to the reference"),
                        &Curve::toReference, &Summary::mean),
          distanceScore("to_result", Shown::tr("from the reference"),
                        Shown::tr("Mean distance from the reference to the plant"),
                        &Curve::toResult, &Summary::mean),
          distanceScore(
              "far_plant", Shown::tr("far, of the plant"),
              Shown::tr("Share of the plant's length that is farther from the reference than the "
                        "finest tolerance"),
              &Curve::toReference, &Summary::farShare),
          distanceScore("substantial_to_reference", Shown::tr("substantial distance"),
                        Shown::tr("Mean distance of that length from the reference"),
                        &Curve::toReference, &Summary::farMean),
          distanceScore(
              "far_reference", Shown::tr("far, of the reference"),
              Shown::tr("Share of the reference's length that is farther from the plant than the "
                        "finest tolerance"),
              &Curve::toResult, &Summary::farShare),
          distanceScore("substantial_to_result", Shown::tr("substantial, back"),
                        Shown::tr("Mean distance of that length from the plant"), &Curve::toResult,
                        &Summary::farMean)};
}

} // namespace espalier
