#pragma once

#include "core/evaluate/match/authors_comparison.h"
#include "core/skeleton/skeleton.h"

#include <cstddef>

namespace espalier {

/// Whether two structures agree on what continues an axis and what branches.
struct TypeAgreement {
  std::size_t bothContinue = 0;
  std::size_t bothBranch = 0;
  std::size_t resultBranches = 0;    // the reference continues
  std::size_t referenceBranches = 0; // the result continues

  [[nodiscard]] std::size_t count() const;
  [[nodiscard]] double observed() const; // share that agrees, in [0, 1]; 1 of none
  /// The same beyond what chance would do: 1 agrees in all, 0 as by chance, below it less.
  /// Where both know one type only, they agree in all: 1.
  /// Source: J. Cohen, "A coefficient of agreement for nominal scales", Educational and
  /// Psychological Measurement 20, 1960.
  [[nodiscard]] double kappa() const;
};

/// Over the matched segments of a comparison, by the edges that attach their first nodes; roots
/// do not count. pre: `comparison` is of these two
[[nodiscard]] TypeAgreement typeAgreement(const AuthorsComparison& comparison,
                                          const Skeleton& result, const Skeleton& reference);

} // namespace espalier
