#include "app/window/review/sealed_facts.h"

#include "core/base/spatial_index.h"
#include "core/evaluate/compared_plants.h"
#include "core/evaluate/scores.h"
#include "core/skeleton/checks.h"
#include "core/skeleton/checks_of_scan.h"
#include "core/skeleton/review_coverage.h"

#include <QCoreApplication>

#include <algorithm>
#include <string_view>

namespace espalier {
namespace {

struct SealedFactsText {
  Q_DECLARE_TR_FUNCTIONS(Seal)
};

bool hasLength(const Skeleton& skeleton) {
  return coverage(skeleton).totalLength() > 0;
}

void checkPoints(const ToSeal& from, SealedFacts& facts, const Progress& progress) {
  const PointDistances distances(from.points, from.spacing, from.plant, progress.part(0, 0.5));
  const double reach = from.limits.pointReach * exactness(distances, from.spacing, from.limits);
  facts.state.points = distances.toSurface().size();
  facts.state.unexplained = static_cast<std::size_t>(
      std::ranges::count_if(distances.toSurface(), [&](float far) { return far > reach; }));
  const SpatialIndex index(from.points->positions(), progress);
  const std::vector<Finding> found = checkAgainstScan(from.plant, distances, index, from.spacing,
                                                      from.limits, progress.part(0.5, 1));
  facts.findings.insert(facts.findings.end(), found.begin(), found.end());
}

} // namespace

SealedAgreement agreement(const std::string& with, const Skeleton& result,
                          const Skeleton& reference, double tolerance, const Progress& progress) {
  const double distance = resolved({.distance = tolerance}, reference).distance;
  ComparedPlants plants(result, reference,
                        {.tolerance = {.distances = {distance}}, .placeDistance = distance},
                        progress);
  const auto score = [&](std::string_view key) { return scoreOf(key).compute(plants); };
  return {.with = with,
          .distance = distance,
          .precision = score("precision").value_or(0),
          .recall = score("recall").value_or(0),
          .f = score(leadingScore).value_or(0),
          .structural = score("structural")};
}

SealedFacts sealedFacts(const ToSeal& from, const Progress& progress) {
  SealedFacts facts;
  facts.findings = check(from.plant, from.spacing, from.limits);
  if (from.points) checkPoints(from, facts, progress.part(0, 0.4));
  if (!hasLength(from.plant)) return facts;
  if (hasLength(from.beginning.skeleton))
    facts.state.automatic =
        agreement((from.beginning.isReconstructed ? SealedFactsText::tr("the reconstruction")
                                                  : SealedFactsText::tr("what was opened"))
                      .toStdString(),
                  from.beginning.skeleton, from.plant, 0, progress.part(0.4, 0.7));
  if (from.reference && hasLength(*from.reference)) {
    const Skeleton laid =
        moved(*from.reference,
              referenceMotion(from.plant, *from.reference, from.how, progress.part(0.7, 0.8)));
    facts.state.other =
        agreement(from.referenceName, from.plant, laid, from.how.tolerance, progress.part(0.8, 1));
  }
  return facts;
}

} // namespace espalier
