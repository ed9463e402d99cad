#include "core/evaluate/match/type_agreement.h"

namespace espalier {

std::size_t TypeAgreement::count() const {
  return bothContinue + bothBranch + resultBranches + referenceBranches;
}

double TypeAgreement::observed() const {
  if (count() == 0) return 1;
  return static_cast<double>(bothContinue + bothBranch) / static_cast<double>(count());
}

double TypeAgreement::kappa() const {
  if (count() == 0) return 1;
  const auto all = static_cast<double>(count());
  const double result = static_cast<double>(bothBranch + resultBranches) / all;
  const double reference = static_cast<double>(bothBranch + referenceBranches) / all;
  const double byChance = result * reference + (1 - result) * (1 - reference);
  return byChance < 1 ? (observed() - byChance) / (1 - byChance) : 1;
}

TypeAgreement typeAgreement(const AuthorsComparison& comparison, const Skeleton& result,
                            const Skeleton& reference) {
  TypeAgreement agreement;
  for (const AuthorsComparison::Match& match : comparison.matches) {
    const Node& one = result[comparison.resultSegments[match.result].nodes.front()];
    const Node& other = reference[comparison.referenceSegments[match.reference].nodes.front()];
    if (!one.parent || !other.parent) continue;
    const bool isBranch = one.edge == EdgeType::branching;
    const bool isOtherBranch = other.edge == EdgeType::branching;
    ++(isBranch ? (isOtherBranch ? agreement.bothBranch : agreement.resultBranches)
                : (isOtherBranch ? agreement.referenceBranches : agreement.bothContinue));
  }
  return agreement;
}

} // namespace espalier
