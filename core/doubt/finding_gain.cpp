#include "core/doubt/finding_gain.h"

#include "core/doubt/plant_share.h"
#include "core/skeleton/branch_end.h"
#include "core/skeleton/select.h"

#include <algorithm>

namespace espalier {
namespace {

using Kind = Finding::Kind;

/// How much of the length of a bare twig of so many points is wood that is missing: on the same
/// plants.
double chanceOfWood(double points, bool isCrowded) {
  if (!isCrowded) return 0.86;  // of 593
  if (points < 20) return 0.09; // of 3 942
  if (points < 50) return 0.29; // of 1 036
  return 0.35;                  // of 435
}

/// How much of the wood that findings of a kind are about, or that may be missing, is wrong: on 120
/// simulated plants that were reconstructed by default (espalier_findings --found 3000 60, and 4000
/// 60). A half where there were under 10 of a kind, as of what only edits by hand bring about.
double chanceOfError(const Finding& finding, bool isCrowded) {
  switch (finding.kind) {
  case Kind::sharpTurn:
    return 0.44; // of 735
  case Kind::crossing:
    return 0.14; // of 57
  case Kind::loop:
    return 0.57; // of 37
  case Kind::edgesWithoutPoints:
    return 0.93; // of 170
  case Kind::noOwnPoints:
    return 0.38; // of 531
  case Kind::besidePoints:
    return 0.73; // of 644
  case Kind::unexplainedPoints:
    return chanceOfWood(finding.amount, isCrowded);
  case Kind::separatePiece:
  case Kind::twoSuccessors:
  case Kind::loneBranch:
  case Kind::noLength:
  case Kind::duplicatedEdge:
  case Kind::radiusAboveParent:
  case Kind::shortFoot:
    break;
  }
  return 0.5;
}

/// Whether points without wood are mostly of leaves: of bare plants there are few such clusters for
/// each end.
bool isCrowded(const std::vector<Finding>& findings, const std::vector<Finding>& others,
               const Skeleton& skeleton) {
  constexpr double most = 0.25; // for each end
  const auto twigs = std::ranges::count(findings, Kind::unexplainedPoints, &Finding::kind) +
                     std::ranges::count(others, Kind::unexplainedPoints, &Finding::kind);
  return static_cast<double>(twigs) > most * static_cast<double>(tipCount(skeleton));
}

} // namespace

std::vector<NodeId> woodOf(const Finding& finding, const Skeleton& skeleton) {
  switch (finding.kind) {
  case Kind::separatePiece:
    return downstream(skeleton, {finding.node});
  case Kind::twoSuccessors:
    return {finding.others.begin() + 1, finding.others.end()};
  case Kind::loneBranch:
  case Kind::noLength:
  case Kind::duplicatedEdge:
  case Kind::loop:
  case Kind::radiusAboveParent:
    return {finding.node};
  case Kind::sharpTurn:
    if (skeleton[finding.node].edge == EdgeType::successor) return {finding.node};
    return runFrom(skeleton, finding.node);
  case Kind::crossing:
  case Kind::noOwnPoints:
    return runFrom(skeleton, finding.node);
  case Kind::edgesWithoutPoints:
  case Kind::besidePoints:
    return nodesOf(finding);
  case Kind::shortFoot:
  case Kind::unexplainedPoints:
    break;
  }
  return {};
}

std::vector<FindingGain> gainsOf(const std::vector<Finding>& findings, const Skeleton& skeleton,
                                 const std::vector<Finding>& others) {
  const PlantShare plant(skeleton);
  const bool areCrowded = isCrowded(findings, others, skeleton);
  std::vector<FindingGain> gains;
  gains.reserve(findings.size());
  for (const Finding& finding : findings) {
    const std::vector<NodeId> wood = woodOf(finding, skeleton);
    FindingGain one{.length = lengthOf(skeleton, wood),
                    .wrong = chanceOfError(finding, areCrowded)};
    auto ends = static_cast<double>(
        std::ranges::count_if(wood, [&](NodeId id) { return skeleton.children(id).empty(); }));
    if (finding.kind == Kind::shortFoot) one.length = finding.amount;
    if (finding.kind == Kind::unexplainedPoints) {
      one.length = 2 * finding.reach;
      ends = 1;
    }
    one.gain = one.wrong * plant.of(one.length, ends);
    gains.push_back(one);
  }
  return gains;
}

} // namespace espalier
