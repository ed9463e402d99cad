#pragma once

#include "core/skeleton/finding.h"

#include <QString>

#include <vector>

namespace espalier {

/// What can be done about a finding by one key.
struct Remedy {
  const char* action;        // its id
  QString does;              // "grows a branch from them"
  std::vector<NodeId> nodes; // that are selected for it
};

/// @param spacing of the points [L]; 0: there is no scan
/// pre: `skeleton` has the nodes of the finding
[[nodiscard]] Remedy remedyOf(const Finding& finding, const Skeleton& skeleton, double spacing);

} // namespace espalier
